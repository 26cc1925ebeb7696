# What `catkin_make install` and `cmake --install` copy beside the libraries of the layers.
install(DIRECTORY include/${PROJECT_NAME}/
  DESTINATION include/${PROJECT_NAME} FILES_MATCHING PATTERN "*.h")

install(DIRECTORY config DESTINATION share/${PROJECT_NAME})

if(PLACE_RECOGNITION_ROS)
  install(TARGETS auto_labeler bag_reader place_labeler place_recognizer place_to_pose place_tool
    trainer
    RUNTIME DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})
  catkin_install_python(PROGRAMS scripts/place_monitor.py scripts/play_bag.py
    DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})
  install(DIRECTORY label_page launch DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION}
    PATTERN __pycache__ EXCLUDE)
  install(FILES nodelet_plugins.xml DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION})
else()
  set_target_properties(place_tool PROPERTIES INSTALL_RPATH "$ORIGIN/../lib")
  install(TARGETS place_tool RUNTIME DESTINATION bin)
endif()
