#pragma once

namespace place_recognition {

/// Part `number` of `count` of some work, 1..count.
struct Part {
  int number = 1;
  int count = 1;
};

}  // namespace place_recognition
