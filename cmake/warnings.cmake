# What every target of the project is compiled with. No fused multiply-add: x86, ARM and the RTL must
# agree bit for bit.
add_library(runmark_flags INTERFACE)
target_compile_options(runmark_flags INTERFACE
  -ffp-contract=off
  $<$<COMPILE_LANGUAGE:CXX>:-Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion
  -Wold-style-cast -Wnon-virtual-dtor -Woverloaded-virtual -Wdouble-promotion>
  $<$<COMPILE_LANGUAGE:C>:-Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion>
  # GCC 12 sees overlapping copies in "text" + std::string (GCC bug 105651).
  $<$<COMPILE_LANG_AND_ID:CXX,GNU>:-Wno-restrict>)
if(RUNMARK_WERROR)
  target_compile_options(runmark_flags INTERFACE -Werror)
endif()

# Under sanitizers -O2 takes twice as long to compile. -O1 for code whose own speed matters little, -O0 for what
# mainly includes long headers.
function(runmark_compile_quickly target level)
  if(CMAKE_CXX_FLAGS MATCHES "-fsanitize")
    target_compile_options(${target} PRIVATE ${level})
  endif()
endfunction()
