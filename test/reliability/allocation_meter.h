#pragma once

#include <cstddef>

namespace place_recognition {

/// Watches the memory that this process takes while it lives; one at a time.
class AllocationMeter {
 public:
  AllocationMeter();
  ~AllocationMeter();
  AllocationMeter(const AllocationMeter&) = delete;
  AllocationMeter& operator=(const AllocationMeter&) = delete;

  std::size_t largest() const;  ///< bytes of the largest single request
  std::size_t peak() const;     ///< most bytes held at once, beyond those held at the start
};

}  // namespace place_recognition
