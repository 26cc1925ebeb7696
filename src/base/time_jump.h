#pragma once

namespace place_recognition {

/// A larger step back of the stamps of a stream, s, begins a new stream.
constexpr double kTimeJump = 1;

}  // namespace place_recognition
