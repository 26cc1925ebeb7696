# Retrain.srv has the goal and the result of Train.action: the fields of a training are listed there alone.
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS action/Train.action)
file(READ action/Train.action retrain)
string(FIND "${retrain}" "\n---\n" feedback REVERSE)
string(SUBSTRING "${retrain}" 0 ${feedback} retrain)

set(retrain_folder ${CATKIN_DEVEL_PREFIX}/share/${PROJECT_NAME}/srv)
file(WRITE ${CMAKE_BINARY_DIR}/Retrain.srv
  "# As the action ~train, but waits for the end: for rosservice call.\n${retrain}\n")
configure_file(${CMAKE_BINARY_DIR}/Retrain.srv ${retrain_folder}/Retrain.srv COPYONLY)  # if it differs
add_service_files(DIRECTORY ${retrain_folder} FILES Retrain.srv NOINSTALL)
install(FILES ${retrain_folder}/Retrain.srv DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION}/srv)
