# Beside catkin's variables: place_recognition::core, which knows no ROS, and place_recognition::ros,
# the same with the messages.
if(NOT TARGET place_recognition::core)
  find_package(place_recognition_core REQUIRED NO_MODULE
    HINTS ${place_recognition_DIR}/../../../lib/cmake/place_recognition_core)
endif()
if(NOT TARGET place_recognition::ros)
  add_library(place_recognition::ros INTERFACE IMPORTED)
  set_target_properties(place_recognition::ros PROPERTIES
    INTERFACE_INCLUDE_DIRECTORIES "${place_recognition_INCLUDE_DIRS}"
    INTERFACE_LINK_LIBRARIES "place_recognition::core;${place_recognition_LIBRARIES}")
endif()
