#pragma once

#include <rosbag/bag.h>

#include <memory>
#include <mutex>
#include <string>

namespace place_recognition {

/// A bag that gets its name only once it is complete; until then it is a file beside it. A full
/// disk is reported as an Error. Thread-safe.
class StagedBag {
 public:
  /// Suffix of a bag during recording, as used by rosbag record.
  static constexpr const char* kActive = ".active";

  /// Opens `path` + `suffix` for writing. Throws Error if the folder cannot be written to.
  StagedBag(const std::string& path, const std::string& suffix);

  /// Leaves a bag that was neither completed nor discarded behind, under the name with the suffix.
  ~StagedBag();

  void setCompression(rosbag::CompressionType type) { bag_->setCompression(type); }

  /// Throws Error if writing fails.
  template <typename Message>
  void write(const std::string& topic, const ros::Time& time, const Message& message) {
    const std::lock_guard<std::mutex> lock(mutex_);
    try {
      bag_->write(topic, time, message);
    } catch (const rosbag::BagException& e) {
      throwCannotWrite(e.what());
    }
  }

  /// Closes the bag and gives it its name. Throws Error if writing fails.
  void complete();

  /// Closes and removes the bag.
  void discard();

  const std::string& path() const { return path_; }

 private:
  void abandon();
  [[noreturn]] void throwCannotWrite(const std::string& reason) const;

  std::string path_;
  std::string staged_path_;
  std::mutex mutex_;  // guards the bag
  std::unique_ptr<rosbag::Bag> bag_;
};

}  // namespace place_recognition
