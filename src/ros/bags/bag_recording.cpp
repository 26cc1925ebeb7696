#include "ros/bags/bag_recording.h"

#include <algorithm>
#include <limits>
#include <map>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <set>

#include "base/bag_name.h"
#include "base/child_process.h"
#include "base/descriptor_io.h"
#include "base/place_name.h"
#include "base/standing_stamp.h"
#include "base/text.h"
#include "datasets/level_scale.h"
#include "datasets/size_count.h"
#include "labels/labels.h"
#include "place_recognition/error.h"
#include "ros/bags/bag_file.h"
#include "ros/bags/bag_records.h"
#include "ros/bags/bag_topics.h"
#include "ros/messages/conversions.h"

namespace place_recognition {
namespace {

/// The file of labels for the bag at `path`; empty if there is none, or if it has no effect.
std::string findLabelsFile(const std::string& path, const BagRecordingOptions& options) {
  if (!options.label.empty()) return "";
  return options.labels_file.empty() ? labelsFileBeside(path) : options.labels_file;
}

/// The records that bag_reader writes about one bag, each of them checked.
class BagRecords {
 public:
  BagRecords(const std::string& path, const std::string& mode, const std::string& label_topic,
             const std::vector<std::string>& image_topics)
      : path_(path),
        reader_(command(mode, path, label_topic, image_topics), ChildProcess::Stderr::kDiscard) {}

  /// The next record. Throws Error if the bag turns out to be damaged or the reader has died.
  BagRecord next() {
    std::optional<BagRecord> record = readRecord(reader_.output());
    if (!record || record->kind == BagRecordKind::kCrash) throwCrash(record);
    if (record->kind == BagRecordKind::kError) {
      const std::string remedy = record->text.empty() ? "" : "; " + record->text;
      throw Error("Cannot read " + path_ + ": " + record->detail +
                  position(record->failure.offset) + remedy + ".");
    }
    if (record->kind == BagRecordKind::kCamera) ++cameras_;
    if (record->kind == BagRecordKind::kImage || record->kind == BagRecordKind::kProblem) {
      if (record->image.camera >= cameras_) throwCrash(std::nullopt);
      ++images_;
    }
    return *std::move(record);
  }

  /// The pixels that follow the record of an image.
  cv::Mat pixels(const BagRecord::Image& of) {
    const bool sound =
        of.rows > 0 && of.rows <= kMaxImageSide && of.cols > 0 && of.cols <= kMaxImageSide &&
        (of.type == CV_8UC1 || of.type == CV_8UC3 || of.type == CV_16UC1 || of.type == CV_16UC3);
    if (!sound) throwCrash(std::nullopt);
    cv::Mat image(static_cast<int>(of.rows), static_cast<int>(of.cols), of.type);
    const std::size_t bytes = image.total() * image.elemSize();
    if (readAll(reader_.output(), image.data, bytes) != bytes) throwCrash(std::nullopt);
    return image;
  }

  const std::string& path() const { return path_; }

 private:
  static std::vector<std::string> command(const std::string& mode, const std::string& path,
                                          const std::string& label_topic,
                                          const std::vector<std::string>& image_topics) {
    std::vector<std::string> words{findExecutable("bag_reader"), mode, path, label_topic};
    words.insert(words.end(), image_topics.begin(), image_topics.end());
    return words;
  }

  /// The position that the reader reached; empty if it has not read any image yet.
  std::string position(std::uint64_t offset) const {
    if (images_ == 0 && offset == 0) return "";
    return " (after " + counted(images_, "image") + ", near byte " + std::to_string(offset) + ")";
  }

  [[noreturn]] void throwCrash(const std::optional<BagRecord>& crash) {
    if (!crash) reader_.kill();  // it may still run; else it ends by its own signal
    const int status = reader_.wait();
    requireStarted("bag_reader", status);
    throw Error("Cannot read " + path_ +
                ": it is damaged (the library that reads bags ended with " + describeExit(status) +
                position(crash ? crash->failure.offset : 0) + "); try: rosbag reindex " + path_ +
                ", or record it again.");
  }

  std::string path_;
  ChildProcess reader_;
  std::uint64_t cameras_ = 0;
  std::uint64_t images_ = 0;
};

Labels readLabels(BagRecords& records, const BagInfo& info, const BagRecordingOptions& options,
                  const std::string& labels_file, BagRecord& record) {
  if (!options.label.empty()) return Labels::wholeBag(options.label);
  if (!labels_file.empty()) {
    return Labels::fromFile(labels_file, info.start, info.start + info.duration);
  }
  Labels labels;
  if (!options.initial_label.empty()) {
    labels.add(-std::numeric_limits<double>::infinity(), options.initial_label);
  }
  for (; record.kind == BagRecordKind::kLabel; record = records.next()) {
    if (!placeName(record.text).empty()) {
      checkLabel(record.text, records.path() + ", " + options.label_topic + " at " +
                                  significant(record.label.time - info.start) +
                                  " s (a file RUN.labels.yaml beside RUN.bag replaces the labels)");
    }
    labels.add(record.label.time, record.text);
  }
  return labels;
}

/// Starts a reader and reads everything before the images.
struct OpenBag {
  OpenBag(const std::string& path, const std::string& mode, const BagRecordingOptions& options)
      : labels_file(findLabelsFile(path, options)),
        records(path, mode, options.label.empty() && labels_file.empty() ? options.label_topic : "",
                options.image_topics) {
    BagRecord record = records.next();
    info.start = record.span.begin;
    info.duration = record.span.end - record.span.begin;
    info.other_images = record.span.other_images;
    for (record = records.next(); record.kind == BagRecordKind::kTopic; record = records.next()) {
      info.topics.push_back({record.text, record.detail, record.topic.messages,
                             static_cast<int>(record.topic.width),
                             static_cast<int>(record.topic.height)});
    }
    labels = readLabels(records, info, options, labels_file, record);
    for (; record.kind == BagRecordKind::kLevels; record = records.next()) {
      levels = {std::min(record.levels.low, record.levels.high), record.levels.high};
    }
    for (; record.kind == BagRecordKind::kCamera; record = records.next()) {
      cameras.push_back(record.text);
    }
    following = std::move(record);
  }

  std::string labels_file;
  BagRecords records;
  BagInfo info;
  Labels labels;
  LevelRange levels;  ///< of images with 16 bits
  std::vector<std::string> cameras;
  BagRecord following;  ///< the first record after these
};

class BagRecording : public Recording {
 public:
  BagRecording(const std::string& path, const BagRecordingOptions& options)
      : Recording(path), label_topic_(options.label_topic), bag_(path, "images", options) {
    if (isActiveBag(path)) warnings_.push_back(whyMisnamed(path) + ".");
    if (!bag_.labels.note().empty()) warnings_.push_back(bag_.labels.note());
    if (bag_.levels.known()) scale_.see(bag_.levels);
  }

  bool next(Frame& frame) override {
    const BagRecord record = std::move(bag_.following);
    if (record.kind == BagRecordKind::kEnd) {
      time_ = bag_.info.start + bag_.info.duration;
      warnOfUnseenPlaces();
      if (is_deep_) {
        warnings_.push_back(name() + ": images with 16 bits are converted to 8: " + scale_.text() +
                            ".");
      }
      return false;
    }
    time_ = record.image.time;
    frame.place = bag_.labels.at(time_);
    seen_.insert(frame.place);
    frame.camera = static_cast<int>(record.image.camera);
    frame.stamp = stampOf(record.image);
    frame.name = record.text;
    frame.problem = record.detail;
    frame.image =
        record.kind == BagRecordKind::kImage ? bag_.records.pixels(record.image) : cv::Mat();
    is_deep_ |= frame.image.depth() == CV_16U;
    frame.image = scale_.toEightBits(frame.image);
    bag_.following = bag_.records.next();
    return true;
  }

  std::vector<std::string> cameras() const override { return bag_.cameras; }

  cv::Size usualSize() override {
    constexpr int kFrames = 16;  // some drivers begin with images of another size
    SizeCount sizes;
    Frame frame;
    for (int count = 0; (count < kFrames || sizes.usual().empty()) && next(frame); ++count) {
      sizes.add(frame.image.size(), frame.name);
    }
    return sizes.usual();
  }

  void setLevelRange(const LevelRange& range) override {
    scale_ = LevelScale(range);
    if (bag_.levels.known()) scale_.see(bag_.levels);
  }

  LevelRange levelRange() const override { return bag_.levels; }

  std::string howToLabel() const override {
    std::vector<std::string> topics;
    for (const BagTopic& topic : bag_.info.topics) {
      const bool is_read = bareName(topic.name) == bareName(label_topic_);
      if (topic.type == kLabelType && topic.messages > 0 && !is_read) topics.push_back(topic.name);
    }
    if (topics.empty() || !bag_.labels_file.empty()) {
      return "label it with: place_tool label " + name();
    }
    return "if a topic of text has its labels, name it: --label-topic " +
           listed(topics, " or --label-topic ");
  }

  double fraction() const override {
    if (bag_.info.duration <= 0) return bag_.following.kind == BagRecordKind::kEnd ? 1 : 0;
    return std::clamp((time_ - bag_.info.start) / bag_.info.duration, 0.0, 1.0);
  }

 private:
  /// When the image was taken: its stamp, or the time of the bag if the stamps stand still.
  double stampOf(const BagRecord::Image& image) {
    if (!standing_stamps_[image.camera].standsStill(image.stamp, image.time)) return image.stamp;
    if (standing_.insert(image.camera).second) {
      warnings_.push_back(name() + ": the stamps of the images on " + bag_.cameras[image.camera] +
                          " stand still at " + fixed(image.stamp, 3) +
                          " s; images count at the times of their recording.");
    }
    return image.time;
  }

  void warnOfUnseenPlaces() {
    const double end = bag_.info.start + bag_.info.duration;
    bag_.labels.forEach(
        bag_.info.start, bag_.labels.notesOutside() ? end : std::numeric_limits<double>::infinity(),
        [this](double, double, const std::string& place) {
          if (!seen_.insert(place).second) return;
          warnings_.push_back(name() + ": the label '" + place +
                              "' is not used, because no image was recorded while it was valid.");
        });
  }

  std::string label_topic_;
  OpenBag bag_;
  LevelScale scale_;
  bool is_deep_ = false;                                    // an image with 16 bits was read
  double time_ = 0;                                         // bag time of the last frame, s
  std::set<std::string> seen_;                              // places of the frames
  std::map<std::uint64_t, StandingStamp> standing_stamps_;  // by camera
  std::set<std::uint64_t> standing_;                        // cameras that were reported
};

}  // namespace

bool hasImages(const BagTopic& topic) { return areImages(topic.name, topic.type); }

std::unique_ptr<Recording> openBagRecording(const std::string& path,
                                            const BagRecordingOptions& options) {
  requireBag(path);
  return std::make_unique<BagRecording>(path, options);
}

BagInfo bagInfo(const std::string& path, const BagRecordingOptions& options) {
  requireBag(path);
  OpenBag bag(path, "info", options);
  std::stable_partition(bag.info.topics.begin(), bag.info.topics.end(), hasImages);
  bag.labels.forEach(
      bag.info.start, bag.info.start + bag.info.duration,
      [&bag](double from, double to, const std::string& place) {
        bag.info.labels.push_back({from - bag.info.start, to - bag.info.start, place});
      });
  bag.info.last_label = bag.labels.at(bag.info.start + bag.info.duration);
  bag.info.labels_file = bag.labels_file;
  bag.info.labels_note = bag.labels.note();
  return bag.info;
}

}  // namespace place_recognition
