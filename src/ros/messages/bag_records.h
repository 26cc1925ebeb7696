#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace place_recognition {

// Records that bag_reader sends to openBagRecording() and bagInfo() through a pipe. Their order:
// one kSpan, one kTopic per topic, the kLabel records in order of time, possibly a kDepth, one
// kCamera per topic to read, the kImage or kProblem records in order of time, and kEnd. A kError or
// kCrash may come at any point and is the last record.

enum class BagRecordKind : std::uint32_t {
  kSpan,    ///< time and stamp: first and last bag time; number: of images outside, a day away
  kTopic,   ///< text: name; detail: type; number: messages; rows and cols of the first image
  kLabel,   ///< text: label; time
  kDepth,   ///< rows and cols: the lowest and highest value of images with 16 bits, see DepthExtent
  kCamera,  ///< text: the topic without /compressed
  kImage,   ///< text: name; time; stamp; number: of its camera; rows, cols, type; pixels follow
  kProblem,  ///< an image that cannot be decoded: like kImage, with the reason in detail, and no
             ///< pixels
  kError,    ///< detail: why the bag cannot be read, for a person; text: what to do, if detail does
             ///< not say it; number: byte offset
  kCrash,    ///< number: byte offset reached
  kEnd,
};

struct BagRecordNumbers {
  BagRecordKind kind = BagRecordKind::kEnd;
  std::int32_t type = 0;  ///< of cv::Mat: one or three channels of CV_8U or CV_16U
  double time = 0;        ///< bag time, s
  double stamp = 0;       ///< of the image's header, s
  std::uint64_t number = 0;
  std::uint32_t rows = 0;
  std::uint32_t cols = 0;
};

struct BagRecord : BagRecordNumbers {
  std::string text;    ///< truncated to kMaxText
  std::string detail;  ///< likewise

  static constexpr std::size_t kMaxText = 4096;
};

/// Writes a record without its pixels; false if nobody reads the pipe any more.
bool writeRecord(int fd, const BagRecord& record);
bool writeBytes(int fd, const void* bytes, std::size_t count);

/// Reads a record without its pixels; nothing at the end of the pipe or if the record is malformed.
std::optional<BagRecord> readRecord(int fd);
bool readBytes(int fd, void* bytes, std::size_t count);

/// Writes a kCrash record; for use in a signal handler.
void writeCrash(int fd, std::uint64_t offset);

}  // namespace place_recognition
