# Real pictures for the tests; where the folder is absent, those tests skip themselves.
set(PLACE_RECOGNITION_TEST_DATA "${PROJECT_SOURCE_DIR}/../shared/data" CACHE PATH
  "Folder of real pictures for the tests")

find_package(GTest REQUIRED)

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
  # The package's asserts stay on in the tests' own code.
  target_compile_options(${name} PRIVATE -UNDEBUG)
  add_test(NAME ${name} COMMAND ${name})
  place_recognition_set_test_environment(${name})
endfunction()

function(place_recognition_set_test_environment name)
  set_tests_properties(${name} PROPERTIES TIMEOUT 300 ENVIRONMENT
    "PLACE_RECOGNITION_TEST_DATA=${PLACE_RECOGNITION_TEST_DATA};PLACE_RECOGNITION_SOURCE_DIR=${PROJECT_SOURCE_DIR}")
endfunction()
