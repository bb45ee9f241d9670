# Markers and boards on paper, drawn with cairo.
find_path(CAIRO_INCLUDE_DIR cairo-pdf.h PATH_SUFFIXES cairo REQUIRED)
find_library(CAIRO_LIBRARY cairo REQUIRED)
file(GLOB print_sources CONFIGURE_DEPENDS printing/*.cpp)
# By name, so that the installed package has no path of this machine in it.
add_part(print cairo)
target_include_directories(runmark_print_objects SYSTEM PRIVATE ${CAIRO_INCLUDE_DIR})
