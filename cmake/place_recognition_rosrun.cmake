# rosrun ignores programs below PACKAGE/build, which is where ./scripts/build puts the development
# space. So there the package is registered as build/package: the files that ROS looks for at run
# time, as links. A workspace of its user's is left as it is.
if(CMAKE_BINARY_DIR STREQUAL "${PROJECT_SOURCE_DIR}/build")
  set(package_folder ${CMAKE_BINARY_DIR}/package)
  file(MAKE_DIRECTORY ${package_folder})
  foreach(entry package.xml nodelet_plugins.xml action cfg config launch msg scripts srv)
    file(CREATE_LINK ${PROJECT_SOURCE_DIR}/${entry} ${package_folder}/${entry} SYMBOLIC)
  endforeach()
  file(WRITE ${CATKIN_DEVEL_PREFIX}/.catkin ${package_folder})
endif()
