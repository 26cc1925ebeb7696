#include "recognition/model/model_container.h"

#include <zlib.h>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <cstring>

#include "base/require.h"
#include "place_recognition/error.h"

namespace place_recognition {
namespace {

static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__, "numbers are stored as in memory");

struct Header {
  char magic[8];
  std::uint32_t format;
  std::uint32_t message_bytes;
  std::uint64_t numbers_bytes;
  std::uint32_t numbers_checksum;
  std::uint32_t checksum;  ///< of the preceding part of the header, and of the message
};
static_assert(sizeof(Header) == 32, "without gaps");

// The line break reveals a transfer in text mode, which alters it.
constexpr char kMagic[] = "PLACES\r\n";
constexpr std::uint32_t kFormat = 3;

/// CRC-32 of bytes that follow bytes with the checksum `before`.
std::uint32_t checksum(std::uint32_t before, const void* data, std::size_t size) {
  return static_cast<std::uint32_t>(crc32_z(before, static_cast<const unsigned char*>(data), size));
}

std::uint32_t checksumOf(const Header& header, std::string_view message) {
  const std::uint32_t of_header = checksum(0, &header, offsetof(Header, checksum));
  return checksum(of_header, message.data(), message.size());
}

void readBytes(std::istream& file, void* data, std::size_t size) {
  file.read(static_cast<char*>(data), static_cast<std::streamsize>(size));
  require(!file.fail(), "it cannot be read completely");
}

std::uint64_t sizeOf(std::istream& file) {
  file.seekg(0, std::ios::end);
  const std::streamoff size = file.tellg();
  file.seekg(0);
  return size < 0 ? 0 : static_cast<std::uint64_t>(size);
}

}  // namespace

bool startsAsContainer(std::istream& file) {
  char start[sizeof(Header::magic)] = {};
  return file.read(start, sizeof(start)) && std::memcmp(start, kMagic, sizeof(start)) == 0;
}

std::string packContainer(std::string_view message, std::string_view numbers) {
  if (sizeof(Header) + message.size() + numbers.size() > kMaxModelBytes) {
    throw Error("The model would be larger than 2 GB; train on fewer images or reduce it.");
  }
  Header header = {};
  std::memcpy(header.magic, kMagic, sizeof(header.magic));
  header.format = kFormat;
  header.message_bytes = static_cast<std::uint32_t>(message.size());
  header.numbers_bytes = numbers.size();
  header.numbers_checksum = checksum(0, numbers.data(), numbers.size());
  header.checksum = checksumOf(header, message);

  std::string bytes;
  bytes.reserve(sizeof(header) + message.size() + numbers.size());
  bytes.append(reinterpret_cast<const char*>(&header), sizeof(header));
  bytes += message;
  return bytes += numbers;
}

ContainerReader::ContainerReader(std::istream& file) : file_(file) {
  const std::uint64_t size = sizeOf(file);
  Header header = {};
  readBytes(file, &header, std::min<std::size_t>(size, sizeof(header)));
  require(std::memcmp(header.magic, kMagic, sizeof(header.magic)) == 0,
          "it is not a place_recognition model");
  require(size >= sizeof(header), "it is truncated after " + std::to_string(size) + " bytes");
  require(header.format == kFormat, "its format version is " + std::to_string(header.format) +
                                        ", but this program reads " + std::to_string(kFormat));
  bytes_left_ = size - sizeof(header);
  require(size <= kMaxModelBytes && header.message_bytes <= bytes_left_ &&
              header.numbers_bytes == bytes_left_ - header.message_bytes,
          "its length does not match its header");
  message_.resize(header.message_bytes);
  readBytes(file, message_.data(), message_.size());
  require(header.checksum == checksumOf(header, message_), "its checksum does not match");
  version_ = header.checksum;
  numbers_checksum_ = header.numbers_checksum;
  bytes_left_ = header.numbers_bytes;
}

std::string ContainerReader::version() const {
  char text[9];
  std::snprintf(text, sizeof(text), "%08x", version_);
  return text;
}

std::size_t ContainerReader::nextCount(std::size_t element_bytes) {
  std::uint64_t count = 0;
  read(&count, sizeof(count));
  require(count <= bytes_left_ / element_bytes, "its numbers are truncated");
  return count;
}

void ContainerReader::read(void* data, std::size_t size) {
  require(size <= bytes_left_, "its numbers are truncated");
  // In pieces, so that the checksum finds the bytes in the cache.
  constexpr std::size_t kPiece = std::size_t{1} << 18;
  for (auto* bytes = static_cast<char*>(data); size > 0;) {
    const std::size_t piece = std::min(size, kPiece);
    readBytes(file_, bytes, piece);
    checksum_ = checksum(checksum_, bytes, piece);
    bytes += piece;
    size -= piece;
    bytes_left_ -= piece;
  }
}

void ContainerReader::finish() const {
  require(bytes_left_ == 0, "it contains more numbers than it should");
  require(checksum_ == numbers_checksum_, "its checksum does not match");
}

}  // namespace place_recognition
