#include "ros/bags/bag_records.h"

#include <algorithm>

#include "base/descriptor_io.h"

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

bool readExactly(int fd, void* bytes, std::size_t count) {
  return readAll(fd, bytes, count) == count;
}

}  // namespace

bool writeRecord(int fd, const BagRecord& record) {
  RecordHeader header;
  header.text_size = static_cast<std::uint16_t>(std::min(record.text.size(), BagRecord::kMaxText));
  header.detail_size =
      static_cast<std::uint16_t>(std::min(record.detail.size(), BagRecord::kMaxText));
  header.numbers = record;
  return writeAll(fd, &header, sizeof header) &&
         writeAll(fd, record.text.data(), header.text_size) &&
         writeAll(fd, record.detail.data(), header.detail_size);
}

std::optional<BagRecord> readRecord(int fd) {
  RecordHeader header;
  if (!readExactly(fd, &header, sizeof header) || header.magic != RecordHeader::kMagic ||
      header.text_size > BagRecord::kMaxText || header.detail_size > BagRecord::kMaxText) {
    return std::nullopt;
  }
  BagRecord record;
  static_cast<BagRecordNumbers&>(record) = header.numbers;
  record.text.resize(header.text_size);
  record.detail.resize(header.detail_size);
  if (!readExactly(fd, record.text.data(), record.text.size()) ||
      !readExactly(fd, record.detail.data(), record.detail.size())) {
    return std::nullopt;
  }
  return record;
}

void writeCrash(int fd, std::uint64_t offset) {
  RecordHeader header;
  header.numbers.kind = BagRecordKind::kCrash;
  header.numbers.failure = {offset};
  writeAll(fd, &header, sizeof header);
}

}  // namespace place_recognition
