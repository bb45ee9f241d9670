# The RTL, translated to C++ by Verilator 5 for tests, the fuzzer and runmark-rtl.
find_package(verilator 5 HINTS $ENV{VERILATOR_ROOT} /usr/share/verilator QUIET)
set(rtl_dir ${PROJECT_SOURCE_DIR}/fpga/rtl)
set(verilator_arguments -Wall -O3 --x-initial unique --x-assign unique --assert -Wno-UNOPTFLAT -Wno-UNUSEDSIGNAL)

# Adds `module` to the library `target` as the class `prefix`, with further arguments, its parameters among them.
function(runmark_verilate target prefix module)
  cmake_parse_arguments(PARSE_ARGV 3 model "TRACED" "" "")
  if(model_TRACED)
    set(traced TRACE_FST)
  else()
    set(traced "")
  endif()
  verilate(${target} PREFIX ${prefix} TOP_MODULE ${module} SOURCES ${rtl_dir}/${module}.sv INCLUDE_DIRS ${rtl_dir}
           VERILATOR_ARGS ${verilator_arguments} ${model_UNPARSED_ARGUMENTS} ${traced})
  # Dozens of short files, which take longer to begin than to compile: those of a model together, but for its interface
  # and its traces, whose functions are named alike in all models. A model's objects are its own, so that mutants can
  # take their place.
  get_target_property(together ${target} SOURCES)
  list(FILTER together INCLUDE REGEX "/${prefix}[.]dir/")
  list(FILTER together EXCLUDE REGEX "Trace|/${prefix}[.]cpp$")
  set_source_files_properties(${together} PROPERTIES UNITY_GROUP ${prefix})
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
endfunction()
