#include "ros/bags/staged_bag.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "base/atomic_file.h"
#include "place_recognition/error.h"

namespace place_recognition {

StagedBag::StagedBag(const std::string& path, const std::string& suffix)
    : path_(behindLinks(path)),
      staged_path_(path_ + suffix),
      bag_(std::make_unique<rosbag::Bag>()) {
  std::error_code ignored;
  const auto kind = std::filesystem::status(path, ignored);
  if (std::filesystem::exists(kind) && !std::filesystem::is_regular_file(kind)) {
    throw Error(path + " is a folder or a device; give the bag another name.");
  }
  const std::filesystem::path folder = std::filesystem::absolute(path_).parent_path();
  if (!std::filesystem::exists(folder, ignored)) {
    throw Error("Cannot write " + path_ + ": the folder " + folder.string() +
                " does not exist; create it, or choose another.");
  }
  try {
    bag_->open(staged_path_, rosbag::bagmode::Write);
  } catch (const rosbag::BagException& e) {
    abandon();
    std::remove(staged_path_.c_str());
    throwCannotWrite(e.what());
  }
}

StagedBag::~StagedBag() { abandon(); }

/// Closes the file as it is; its name shows that it is incomplete.
void StagedBag::abandon() {
  try {
    bag_->close();
  } catch (const rosbag::BagException&) {
    // A bag that cannot be closed tries again in its destructor, which then throws. It is therefore
    // left to the end of the process.
    static_cast<void>(bag_.release());
    bag_ = std::make_unique<rosbag::Bag>();
  }
}

void StagedBag::complete() {
  const std::lock_guard<std::mutex> lock(mutex_);
  try {
    bag_->close();
    // Closing does not show whether the last bytes, which include the index, reached the disk.
    rosbag::Bag(staged_path_, rosbag::bagmode::Read);
  } catch (const rosbag::BagException& e) {
    throwCannotWrite(e.what());
  }
  if (std::rename(staged_path_.c_str(), path_.c_str()) != 0) throwCannotWrite(std::strerror(errno));
}

void StagedBag::discard() {
  const std::lock_guard<std::mutex> lock(mutex_);
  abandon();
  std::remove(staged_path_.c_str());
}

void StagedBag::throwCannotWrite(const std::string& reason) const {
  throw Error("Cannot write " + path_ + ": " + reason +
              "; make room, or choose a writable folder.");
}

}  // namespace place_recognition
