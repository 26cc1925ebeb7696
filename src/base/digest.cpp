#include "base/digest.h"

#include <cinttypes>
#include <cstdio>

namespace place_recognition {

std::uint64_t digest(std::string_view bytes, std::uint64_t before) {
  for (const char byte : bytes) {
    before = (before ^ static_cast<unsigned char>(byte)) * 0x100000001b3u;
  }
  return before;
}

std::string hexadecimal(std::uint64_t number) {
  char text[17];
  std::snprintf(text, sizeof(text), "%016" PRIx64, number);
  return text;
}

}  // namespace place_recognition
