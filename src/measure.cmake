# What markers measure: cameras, poses, boards, calibration. It uses OpenCV; its headers do not.
find_package(OpenCV REQUIRED COMPONENTS core calib3d)
file(GLOB measure_sources CONFIGURE_DEPENDS boards/*.cpp camera/*.cpp pose/*.cpp)
add_part(measure opencv_core opencv_calib3d)
target_include_directories(runmark_measure_objects SYSTEM PRIVATE ${OpenCV_INCLUDE_DIRS})
