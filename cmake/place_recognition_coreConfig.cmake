# find_package(place_recognition_core) defines the target place_recognition::core.
include(CMakeFindDependencyMacro)
find_dependency(Threads)
find_dependency(Eigen3 NO_MODULE)
find_dependency(OpenCV COMPONENTS core)
find_dependency(yaml-cpp)
include(${CMAKE_CURRENT_LIST_DIR}/place_recognition_coreTargets.cmake)
