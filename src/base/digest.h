#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace place_recognition {

/// FNV-1a of 64 bits: tells contents apart; no protection against somebody who forges them.
/// Chained by handing the result of the last call on.
std::uint64_t digest(std::string_view bytes, std::uint64_t before = 0xcbf29ce484222325u);

/// As 16 hexadecimal digits.
std::string hexadecimal(std::uint64_t number);

}  // namespace place_recognition
