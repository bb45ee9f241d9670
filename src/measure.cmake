# What markers measure: cameras, poses, boards, calibration. It uses OpenCV; its headers do not.
find_package(OpenCV REQUIRED COMPONENTS core calib3d)
find_package(yaml-cpp REQUIRED)
find_package(nlohmann_json REQUIRED)
file(GLOB measure_sources CONFIGURE_DEPENDS boards/*.cpp calibration/*.cpp camera/*.cpp pose/*.cpp)
add_part(measure opencv_core opencv_calib3d yaml-cpp)
target_link_libraries(runmark_measure_objects PRIVATE nlohmann_json::nlohmann_json)
runmark_compile_quickly(runmark_measure_objects -O1)
target_include_directories(runmark_measure_objects SYSTEM PRIVATE ${OpenCV_INCLUDE_DIRS})
