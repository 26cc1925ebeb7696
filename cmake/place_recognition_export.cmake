# The CMake package place_recognition_core: the target place_recognition::core, without ROS. With ROS,
# catkin's package place_recognition brings it along; see place_recognition-extras.cmake.
#catkin_lint: ignore missing_file
include(CMakePackageConfigHelpers)

add_library(place_recognition_core INTERFACE)
target_link_libraries(place_recognition_core INTERFACE
  place_recognition_datasets place_recognition_recognition place_recognition_tuning)
set_target_properties(place_recognition_core PROPERTIES EXPORT_NAME core)
add_library(place_recognition::core ALIAS place_recognition_core)

set(folder lib/cmake/place_recognition_core)
set(version_file ${CMAKE_CURRENT_BINARY_DIR}/place_recognition_coreConfigVersion.cmake)
write_basic_package_version_file(${version_file} COMPATIBILITY SameMinorVersion)
install(TARGETS place_recognition_core EXPORT place_recognition_core)
install(EXPORT place_recognition_core DESTINATION ${folder}
  NAMESPACE place_recognition:: FILE place_recognition_coreTargets.cmake)
install(FILES cmake/place_recognition_coreConfig.cmake ${version_file} DESTINATION ${folder})

if(PLACE_RECOGNITION_ROS)  # the same for packages of one workspace
  set(folder ${CATKIN_DEVEL_PREFIX}/${folder})
  export(EXPORT place_recognition_core
    NAMESPACE place_recognition:: FILE ${folder}/place_recognition_coreTargets.cmake)
  file(COPY cmake/place_recognition_coreConfig.cmake ${version_file} DESTINATION ${folder})
endif()
