# What `cmake --install` puts where: the library, its headers, a CMake package, a pkg-config file and the
# manual page. The command line is installed by tools/.
include(CMakePackageConfigHelpers)

# Parts with needs of their own: find_package(runmark COMPONENTS measure), pkg-config runmark_measure.
set(parts)
if(RUNMARK_MEASURE)
  list(APPEND parts measure)
endif()
if(RUNMARK_PRINT)
  list(APPEND parts print)
endif()
list(TRANSFORM parts PREPEND runmark_ OUTPUT_VARIABLE part_targets)
install(TARGETS runmark runmark_c ${part_targets} EXPORT runmark_targets
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/runmark ${PROJECT_BINARY_DIR}/include/runmark
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN "*.h")

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/runmark)
install(EXPORT runmark_targets NAMESPACE runmark:: FILE runmark-targets.cmake DESTINATION ${package_dir})
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/runmark-config.cmake.in
  ${PROJECT_BINARY_DIR}/runmark-config.cmake INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/runmark-config-version.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/runmark-config.cmake ${PROJECT_BINARY_DIR}/runmark-config-version.cmake
  DESTINATION ${package_dir})

# Its paths are relative to the file itself, so that the tree can be moved.
file(RELATIVE_PATH pc_prefix /prefix/${CMAKE_INSTALL_LIBDIR}/pkgconfig /prefix)
# Who links the static library links Highway too.
set(pc_requires Requires)
if(BUILD_SHARED_LIBS)
  set(pc_requires Requires.private)
endif()
set(c_api_needs runmark)
if(RUNMARK_MEASURE)
  set(c_api_needs runmark_measure)
endif()
foreach(pc IN ITEMS runmark.pc runmark_c.pc)
  configure_file(${PROJECT_SOURCE_DIR}/cmake/${pc}.in ${PROJECT_BINARY_DIR}/${pc} @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/${pc} DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
endforeach()
set(measure_description "Poses, boards and calibration from square fiducial markers")
set(measure_requires "opencv4, yaml-cpp")
set(print_description "Square fiducial markers on paper at true size")
set(print_requires cairo)
foreach(part IN LISTS parts)
  set(part_description "${${part}_description}")
  set(part_requires ${${part}_requires})
  configure_file(${PROJECT_SOURCE_DIR}/cmake/runmark_part.pc.in ${PROJECT_BINARY_DIR}/runmark_${part}.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/runmark_${part}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
endforeach()

install(FILES ${PROJECT_SOURCE_DIR}/LICENSE ${PROJECT_SOURCE_DIR}/NOTICE DESTINATION ${CMAKE_INSTALL_DOCDIR})
if(RUNMARK_TOOLS)
  set(man_page ${PROJECT_BINARY_DIR}/runmark.1)
  add_custom_command(OUTPUT ${man_page}
    COMMAND ${CMAKE_COMMAND} -DRUNMARK=$<TARGET_FILE:runmark_cli> -DPROJECT_VERSION=${PROJECT_VERSION}
            -DINPUT=${PROJECT_SOURCE_DIR}/docs/man/runmark.1.in -DOUTPUT=${man_page}
            -P ${PROJECT_SOURCE_DIR}/cmake/man_page.cmake
    DEPENDS runmark_cli runmark_view ${PROJECT_SOURCE_DIR}/docs/man/runmark.1.in ${PROJECT_SOURCE_DIR}/cmake/man_page.cmake
    VERBATIM)
  add_custom_target(man_page ALL DEPENDS ${man_page})
  install(FILES ${man_page} DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
endif()
