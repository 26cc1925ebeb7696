# place_recognition_add_layer(NAME SOURCES file... [USES target...] [PRIVATE target...])
#
# The library target place_recognition_NAME of src/NAME. USES are targets that its headers show,
# PRIVATE ones that only its sources know.
function(place_recognition_add_layer name)
  cmake_parse_arguments(ARG "" "" "SOURCES;USES;PRIVATE" ${ARGN})
  set(target place_recognition_${name})
  add_library(${target} ${ARG_SOURCES})
  target_include_directories(${target} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src>)
  target_link_libraries(${target} PUBLIC ${ARG_USES} PRIVATE ${ARG_PRIVATE})
  install(TARGETS ${target}
    ARCHIVE DESTINATION lib
    LIBRARY DESTINATION lib
    RUNTIME DESTINATION bin)
endfunction()
