# place_recognition_add_layer(NAME [EXPORTED] SOURCES file... [USES target...] [PRIVATE target...])
#
# The library target place_recognition_NAME of src/NAME. USES are targets that its headers show,
# PRIVATE ones that only its sources know. EXPORTED: a part of place_recognition::core.
function(place_recognition_add_layer name)
  cmake_parse_arguments(ARG "EXPORTED" "" "SOURCES;USES;PRIVATE" ${ARGN})
  set(target place_recognition_${name})
  add_library(${target} ${ARG_SOURCES})
  target_include_directories(${target} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src>
    $<INSTALL_INTERFACE:include>)
  target_link_libraries(${target} PUBLIC ${ARG_USES} PRIVATE ${ARG_PRIVATE})
  set_target_properties(${target} PROPERTIES INSTALL_RPATH "$ORIGIN")
  set(export)
  if(ARG_EXPORTED)
    set(export EXPORT place_recognition_core)
    set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
    add_library(place_recognition::${name} ALIAS ${target})
  endif()
  install(TARGETS ${target} ${export}
    ARCHIVE DESTINATION lib
    LIBRARY DESTINATION lib
    RUNTIME DESTINATION bin)
endfunction()
