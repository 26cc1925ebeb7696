#pragma once

#include <cstddef>

namespace place_recognition {

/// Measures the memory that this process allocates during the object's lifetime. At most one may
/// exist at a time.
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
