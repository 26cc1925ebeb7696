#include "ros/messages/bag_records.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>

namespace place_recognition {
namespace {

/// The data sent before the texts.
struct RecordHeader {
  std::uint32_t magic = kMagic;
  std::uint16_t text_size = 0;
  std::uint16_t detail_size = 0;
  BagRecordNumbers numbers;

  static constexpr std::uint32_t kMagic = 0x67616270;
};

}  // namespace

bool writeBytes(int fd, const void* bytes, std::size_t count) {
  const char* position = static_cast<const char*>(bytes);
  while (count > 0) {
    const ssize_t written = write(fd, position, count);
    if (written < 0 && errno != EINTR) return false;
    if (written > 0) {
      position += written;
      count -= static_cast<std::size_t>(written);
    }
  }
  return true;
}

bool readBytes(int fd, void* bytes, std::size_t count) {
  char* position = static_cast<char*>(bytes);
  while (count > 0) {
    const ssize_t got = read(fd, position, count);
    if (got == 0 || (got < 0 && errno != EINTR)) return false;
    if (got > 0) {
      position += got;
      count -= static_cast<std::size_t>(got);
    }
  }
  return true;
}

bool writeRecord(int fd, const BagRecord& record) {
  RecordHeader header;
  header.text_size = static_cast<std::uint16_t>(std::min(record.text.size(), BagRecord::kMaxText));
  header.detail_size =
      static_cast<std::uint16_t>(std::min(record.detail.size(), BagRecord::kMaxText));
  header.numbers = record;
  return writeBytes(fd, &header, sizeof header) &&
         writeBytes(fd, record.text.data(), header.text_size) &&
         writeBytes(fd, record.detail.data(), header.detail_size);
}

std::optional<BagRecord> readRecord(int fd) {
  RecordHeader header;
  if (!readBytes(fd, &header, sizeof header) || header.magic != RecordHeader::kMagic ||
      header.text_size > BagRecord::kMaxText || header.detail_size > BagRecord::kMaxText) {
    return std::nullopt;
  }
  BagRecord record;
  static_cast<BagRecordNumbers&>(record) = header.numbers;
  record.text.resize(header.text_size);
  record.detail.resize(header.detail_size);
  if (!readBytes(fd, record.text.data(), record.text.size()) ||
      !readBytes(fd, record.detail.data(), record.detail.size())) {
    return std::nullopt;
  }
  return record;
}

void writeCrash(int fd, std::uint64_t offset) {
  RecordHeader header;
  header.numbers.kind = BagRecordKind::kCrash;
  header.numbers.number = offset;
  writeBytes(fd, &header, sizeof header);
}

}  // namespace place_recognition
