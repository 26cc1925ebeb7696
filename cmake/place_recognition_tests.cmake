# Real pictures for the tests; where the folder is absent, those tests skip themselves.
set(PLACE_RECOGNITION_TEST_DATA "${PROJECT_SOURCE_DIR}/../shared/data" CACHE PATH
  "Folder of real pictures for the tests")

find_package(GTest REQUIRED)
find_program(ROSTEST NAMES rostest)
# Debian's and Ubuntu's, for which ROS is installed.
find_program(PYTHON3 NAMES python3 PATHS /usr/bin NO_DEFAULT_PATH)

# Tests are built by the target `tests`, not by `all`.
if(NOT TARGET tests)
  add_custom_target(tests)
endif()

# place_recognition_add_test(NAME SOURCES file... [LIBRARIES target...])
#
# A gtest program, run by ctest as NAME.
function(place_recognition_add_test name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LIBRARIES" ${ARGN})
  add_executable(${name} EXCLUDE_FROM_ALL ${ARG_SOURCES})
  add_dependencies(tests ${name})
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/test)
  target_link_libraries(${name} PRIVATE ${ARG_LIBRARIES} GTest::GTest GTest::Main Threads::Threads)
  place_recognition_set_test_options(${name})
  add_test(NAME ${name} COMMAND ${name})
  place_recognition_set_test_environment(${name})
endfunction()

# The package's asserts stay on in the tests' own code, which compiles in three quarters of the time
# with -O1.
function(place_recognition_set_test_options name)
  target_compile_options(${name} PRIVATE -UNDEBUG -O1)
endfunction()

function(place_recognition_set_test_environment name)
  set(timeout 300)
  if(PLACE_RECOGNITION_SANITIZE)
    set(timeout 1200)  # a sanitizer makes a test up to ten times slower
  endif()
  set_tests_properties(${name} PROPERTIES TIMEOUT ${timeout} ENVIRONMENT
    "PLACE_RECOGNITION_TEST_DATA=${PLACE_RECOGNITION_TEST_DATA};PLACE_RECOGNITION_SOURCE_DIR=${PROJECT_SOURCE_DIR}")
endfunction()

# place_recognition_add_rostest(NAME LAUNCH_FILE SOURCES file... [LIBRARIES target...]
#                               [DEPENDENCIES target...])
#
# A gtest program NAME (named in the launch file) that runs beside nodes, which are DEPENDENCIES.
# The launch file's argument `home` is a fresh folder for ROS_HOME.
function(place_recognition_add_rostest name launch_file)
  cmake_parse_arguments(ARG "" "" "SOURCES;LIBRARIES;DEPENDENCIES" ${ARGN})
  add_executable(${name} EXCLUDE_FROM_ALL ${ARG_SOURCES})
  add_dependencies(tests ${name} ${ARG_DEPENDENCIES})
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/test)
  target_link_libraries(${name} PRIVATE ${ARG_LIBRARIES} GTest::GTest Threads::Threads)
  place_recognition_set_test_options(${name})
  set(home ${CMAKE_CURRENT_BINARY_DIR}/${name}_home)
  add_test(NAME ${name}_home COMMAND ${CMAKE_COMMAND} -E remove_directory ${home})
  add_test(NAME ${name} COMMAND ${CATKIN_ENV} ${PYTHON_EXECUTABLE} ${ROSTEST}
    --pkgdir=${PROJECT_SOURCE_DIR} --package=${PROJECT_NAME} --results-filename=${name}.xml
    --results-base-dir=${CMAKE_BINARY_DIR}/rostest_results
    ${CMAKE_CURRENT_SOURCE_DIR}/${launch_file} home:=${home})
  place_recognition_set_test_environment(${name})
  set_tests_properties(${name}_home PROPERTIES FIXTURES_SETUP ${name})
  set_tests_properties(${name} PROPERTIES FIXTURES_REQUIRED ${name})
endfunction()
