# catkin: the ROS packages in use, and the messages, services, actions and dynamic parameters.

# Debian's and Ubuntu's ROS is built for the system's Python, which need not come first on PATH.
foreach(python PYTHON_EXECUTABLE Python3_EXECUTABLE)
  if(NOT ${python})
    set(${python} /usr/bin/python3 CACHE FILEPATH "Python that ROS is installed for")
  endif()
endforeach()
# The environment of the tests is frozen with the folders that exist now.
file(MAKE_DIRECTORY ${CMAKE_BINARY_DIR}/devel/lib/python3/dist-packages)

find_package(catkin REQUIRED COMPONENTS
  actionlib actionlib_msgs cv_bridge diagnostic_msgs diagnostic_updater dynamic_reconfigure
  geometry_msgs image_transport message_generation nav_msgs nodelet pluginlib rosbag_storage roscpp sensor_msgs
  std_msgs std_srvs tf2_ros visualization_msgs)

include(place_recognition_rosrun)

add_message_files(FILES ModelInfo.msg PlaceRecognition.msg PlaceScore.msg)
add_service_files(FILES LoadModel.srv Recognize.srv RoomPose.srv SayPlace.srv)
include(place_recognition_retrain)
add_action_files(FILES Train.action)
generate_messages(DEPENDENCIES actionlib_msgs geometry_msgs sensor_msgs std_msgs)
generate_dynamic_reconfigure_options(cfg/PlaceRecognizer.cfg)

# Include paths are set target by target, not by include_directories(). Other packages depend on the
# library and on the messages, not on what the nodes use.
#catkin_lint: ignore unused_include_path
catkin_package(
  INCLUDE_DIRS include
  LIBRARIES place_recognition_base place_recognition_labels place_recognition_report
    place_recognition_datasets place_recognition_features place_recognition_learning
    place_recognition_recognition place_recognition_tuning
  CATKIN_DEPENDS actionlib_msgs geometry_msgs message_runtime sensor_msgs std_msgs
  DEPENDS EIGEN3 OpenCV
  CFG_EXTRAS place_recognition-extras.cmake)

# What the targets of src/ros share; the library below it neither includes nor links ROS.
add_library(place_recognition_catkin INTERFACE)
#catkin_lint: ignore_once external_interface_path
target_include_directories(place_recognition_catkin SYSTEM INTERFACE ${catkin_INCLUDE_DIRS})
target_link_libraries(place_recognition_catkin INTERFACE ${catkin_LIBRARIES})
add_dependencies(place_recognition_catkin
  ${${PROJECT_NAME}_EXPORTED_TARGETS} ${catkin_EXPORTED_TARGETS})
