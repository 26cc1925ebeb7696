#include "recognition/model_container.h"

#include <zlib.h>

#include <cassert>
#include <cstdint>
#include <cstdio>

#include "place_recognition/error.h"

namespace place_recognition {
namespace {

// The line end shows at once if a transfer "as text" changed the file.
constexpr std::string_view kMagic = "PLACES\r\n";
constexpr std::uint32_t kFormatVersion = 1;
constexpr std::size_t kVersionAt = 8, kLengthAt = 12, kChecksumAt = 20, kHeaderSize = 24;

void appendLittleEndian(std::string& bytes, std::uint64_t value, int width) {
  for (int i = 0; i < width; ++i) bytes += static_cast<char>(value >> (8 * i) & 0xff);
}

std::uint64_t littleEndian(std::string_view bytes, std::size_t at, int width) {
  std::uint64_t value = 0;
  for (int i = 0; i < width; ++i) {
    value |= std::uint64_t{static_cast<unsigned char>(bytes[at + i])} << (8 * i);
  }
  return value;
}

std::uint32_t checksum(std::string_view bytes) {
  return static_cast<std::uint32_t>(
      crc32_z(0, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()));
}

}  // namespace

std::string packContainer(std::string_view payload) {
  std::string bytes;
  bytes.reserve(kHeaderSize + payload.size());
  bytes += kMagic;
  appendLittleEndian(bytes, kFormatVersion, 4);
  appendLittleEndian(bytes, payload.size(), 8);
  appendLittleEndian(bytes, checksum(payload), 4);
  return bytes += payload;
}

std::string_view unpackContainer(std::string_view bytes, const std::string& where) {
  if (bytes.substr(0, kMagic.size()) != kMagic) {
    throw Error(where +
                " is not a place_recognition model; give a file that was made by training.");
  }
  if (bytes.size() < kHeaderSize) {
    throw Error(where + " is cut short after " + std::to_string(bytes.size()) +
                " bytes; restore a backup (place_tool restore) or train the model again.");
  }
  const std::uint64_t format = littleEndian(bytes, kVersionAt, 4);
  if (format != kFormatVersion) {
    throw Error(where + " has format version " + std::to_string(format) +
                " where this program reads " + std::to_string(kFormatVersion) +
                "; train the model again with this version.");
  }
  const std::string_view payload = bytes.substr(kHeaderSize);
  const std::uint64_t length = littleEndian(bytes, kLengthAt, 8);
  if (payload.size() != length) {
    throw Error(where + " holds " + std::to_string(payload.size()) +
                " bytes of model where it should hold " + std::to_string(length) +
                "; restore a backup (place_tool restore) or train the model again.");
  }
  if (checksum(payload) != littleEndian(bytes, kChecksumAt, 4)) {
    throw Error(where +
                " is damaged (its checksum does not fit); restore a backup (place_tool restore) or "
                "train the "
                "model again.");
  }
  return payload;
}

std::string containerVersion(std::string_view bytes) {
  assert(bytes.size() >= kHeaderSize);
  char text[9];
  std::snprintf(text, sizeof(text), "%08x",
                static_cast<unsigned>(littleEndian(bytes, kChecksumAt, 4)));
  return text;
}

}  // namespace place_recognition
