# add_part(NAME LIBRARY...) makes the installed library runmark::NAME of the ${NAME_sources}: a part that needs the
# core and other libraries. runmark_NAME_inside is for tests and tools that look inside it.
function(add_part name)
  add_library(runmark_${name}_objects OBJECT ${${name}_sources})
  target_include_directories(runmark_${name}_objects
    PUBLIC ${PROJECT_SOURCE_DIR}/include ${PROJECT_BINARY_DIR}/include PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
  target_link_libraries(runmark_${name}_objects PRIVATE runmark_flags)

  add_library(runmark_${name} $<TARGET_OBJECTS:runmark_${name}_objects>)
  add_library(runmark::${name} ALIAS runmark_${name})
  target_link_libraries(runmark_${name} PUBLIC runmark PRIVATE ${ARGN})
  set_target_properties(runmark_${name} PROPERTIES EXPORT_NAME ${name}
    VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
  if(BUILD_SHARED_LIBS)
    target_link_options(runmark_${name} PRIVATE -Wl,--version-script=${symbols_map} -Wl,--no-undefined)
    set_target_properties(runmark_${name} PROPERTIES LINK_DEPENDS ${symbols_map})
    add_library(runmark_${name}_inside STATIC EXCLUDE_FROM_ALL $<TARGET_OBJECTS:runmark_${name}_objects>)
    target_link_libraries(runmark_${name}_inside PUBLIC runmark_internal PRIVATE ${ARGN})
  else()
    add_library(runmark_${name}_inside INTERFACE)
    target_link_libraries(runmark_${name}_inside INTERFACE runmark_${name} runmark_internal)
  endif()
endfunction()
