#pragma once

#include <stdexcept>

namespace place_recognition {

/// Reports bad input: a file, message or configuration. The message is one sentence for a person:
/// what is wrong, where, and what to do. Broken preconditions inside the package are asserts
/// instead.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace place_recognition
