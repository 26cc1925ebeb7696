#pragma once

#include <string>

#include "place_recognition/error.h"

namespace place_recognition {

/// Returns the message of the Error that `work`, a function without arguments, throws; empty if it
/// throws nothing.
template <class Work>
std::string errorOf(const Work& work) {
  try {
    work();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

}  // namespace place_recognition
