#pragma once

#include <cstdint>

namespace place_recognition {

/// Multiplies and adds 8-bit numbers at the peak rate of the instructions that the fastest of
/// matchVariants() uses. Works only in registers, without reading memory. Returns the number of
/// products added; `seed` prevents evaluation at compile time.
std::int64_t multiplyAddAtPeak(std::int64_t rounds, std::int32_t& seed);

}  // namespace place_recognition
