# Markers and boards on paper, drawn with cairo.
find_package(PkgConfig REQUIRED)
pkg_check_modules(CAIRO REQUIRED IMPORTED_TARGET cairo cairo-pdf cairo-svg)
file(GLOB print_sources CONFIGURE_DEPENDS printing/*.cpp)
# By name, so that the installed package needs no pkg-config.
add_part(print cairo)
target_include_directories(runmark_print_objects SYSTEM PRIVATE ${CAIRO_INCLUDE_DIRS})
