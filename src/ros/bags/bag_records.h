#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace place_recognition {

// Records that bag_reader sends to openBagRecording() and bagInfo() through a pipe. Their order:
// one kSpan, one kTopic per topic, the kLabel records in order of time, possibly a kLevels, one
// kCamera per topic to read, the kImage or kProblem records in order of time, and kEnd. A kError or
// kCrash may come at any point and is the last record.

enum class BagRecordKind : std::uint32_t {
  kSpan,     ///< span
  kTopic,    ///< topic; text: name; detail: type
  kLabel,    ///< label; text: the label
  kLevels,   ///< levels
  kCamera,   ///< text: the topic without /compressed
  kImage,    ///< image; text: name; the pixels follow
  kProblem,  ///< image, without size and pixels; text: name; detail: why it cannot be decoded
  kError,    ///< failure; detail: why the bag cannot be read, for a person; text: what to do, if
             ///< detail does not say it
  kCrash,    ///< failure
  kEnd,
};

/// The numbers of a record. Times are in seconds.
struct BagRecordNumbers {
  /// The first and the last bag time. Images a day or more outside are only counted.
  struct Span {
    double begin;
    double end;
    std::uint64_t other_images;
  };
  struct Topic {
    std::uint64_t messages;
    std::uint32_t width, height;  ///< of the first image; 0: not an image, or not read
  };
  struct Label {
    double time;
  };
  /// See LevelRange.
  struct Levels {
    std::uint32_t low, high;
  };
  struct Image {
    double time;           ///< bag time
    double stamp;          ///< of its header
    std::uint64_t camera;  ///< number of its kCamera record, from 0
    std::uint32_t rows, cols;
    std::int32_t type;  ///< of cv::Mat: one or three channels of CV_8U or CV_16U
  };
  struct Failure {
    std::uint64_t offset;  ///< byte of the bag that was reached
  };

  BagRecordKind kind = BagRecordKind::kEnd;
  union {
    Image image = {};  // the largest, so that all bytes are set
    Span span;
    Topic topic;
    Label label;
    Levels levels;
    Failure failure;
  };
};

struct BagRecord : BagRecordNumbers {
  explicit BagRecord(BagRecordKind of_kind = BagRecordKind::kEnd) { kind = of_kind; }

  std::string text;    ///< truncated to kMaxText
  std::string detail;  ///< likewise

  static constexpr std::size_t kMaxText = 4096;
};

/// Writes a record without its pixels; false if nobody reads the pipe any more.
bool writeRecord(int fd, const BagRecord& record);

/// Reads a record without its pixels; nothing at the end of the pipe or if the record is malformed.
std::optional<BagRecord> readRecord(int fd);

/// Writes a kCrash record; for use in a signal handler.
void writeCrash(int fd, std::uint64_t offset);

}  // namespace place_recognition
