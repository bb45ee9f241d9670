# `cpack --config CPackConfig.cmake` makes a Debian package of what `cmake --install` installs.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME runmark)
set(CPACK_PACKAGE_CONTACT "The runmark developers <developers@runmark.invalid>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_PACKAGE_DESCRIPTION
    "Command line, window and library: ArUco, AprilTag and markers of one's own are found while the rows of a
picture go by once, in fixed memory.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)  # what the programs need, from what they are linked with
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "libopencv-dev, libhwy-dev, libyaml-cpp-dev, libcairo2-dev")  # to link with it
include(CPack)
