# Finds libsvm (Debian's libsvm-dev); defines the target libsvm::libsvm.
find_path(libsvm_INCLUDE_DIR NAMES svm.h PATH_SUFFIXES libsvm)
find_library(libsvm_LIBRARY NAMES svm)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(libsvm REQUIRED_VARS libsvm_LIBRARY libsvm_INCLUDE_DIR)
if(libsvm_FOUND AND NOT TARGET libsvm::libsvm)
  add_library(libsvm::libsvm UNKNOWN IMPORTED)
  set_target_properties(libsvm::libsvm PROPERTIES
    IMPORTED_LOCATION "${libsvm_LIBRARY}"
    INTERFACE_INCLUDE_DIRECTORIES "${libsvm_INCLUDE_DIR}")
endif()
