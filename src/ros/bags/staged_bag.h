#pragma once

#include <rosbag/bag.h>

#include <memory>
#include <mutex>
#include <string>

namespace place_recognition {

/// A bag that has its name only once it is complete; until then it is a file beside it. A disk that
/// is full is an Error. Thread-safe.
class StagedBag {
 public:
  /// The suffix of what is being recorded, as rosbag record has it.
  static constexpr const char* kActive = ".active";

  /// Opens `path` + `suffix` for writing. Throws Error if the folder cannot be written to.
  StagedBag(const std::string& path, const std::string& suffix);

  /// What has not been completed or discarded stays behind under the name with the suffix.
  ~StagedBag();

  void setCompression(rosbag::CompressionType type) { bag_->setCompression(type); }

  /// Throws Error if the disk refuses.
  template <typename Message>
  void write(const std::string& topic, const ros::Time& time, const Message& message) {
    const std::lock_guard<std::mutex> lock(mutex_);
    try {
      bag_->write(topic, time, message);
    } catch (const rosbag::BagException& e) {
      throwCannotWrite(e.what());
    }
  }

  /// Closes the bag and gives it its name. Throws Error if the disk refuses.
  void complete();

  /// Closes and removes it.
  void discard();

  const std::string& path() const { return path_; }

 private:
  void abandon();
  [[noreturn]] void throwCannotWrite(const std::string& reason) const;

  std::string path_;
  std::string staged_path_;
  std::mutex mutex_;  // of the bag
  std::unique_ptr<rosbag::Bag> bag_;
};

}  // namespace place_recognition
