#pragma once

#include <cstdint>

namespace place_recognition {

/// Multiplies and adds of 8-bit numbers as fast as the instructions of the fastest of
/// matchVariants() can, in registers alone: nothing is read. Returns how many products were added;
/// `seed` keeps the compiler from doing them beforehand.
std::int64_t multiplyAddAtPeak(std::int64_t rounds, std::int32_t& seed);

}  // namespace place_recognition
