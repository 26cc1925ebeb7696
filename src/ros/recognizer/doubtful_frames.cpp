#include "ros/recognizer/doubtful_frames.h"

#include <ros/console.h>
#include <std_msgs/String.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <vector>

#include "base/place_name.h"
#include "base/text.h"
#include "base/time_jump.h"
#include "base/user_path.h"
#include "place_recognition/error.h"
#include "ros/bags/bag_file.h"
#include "ros/nodes/node_names.h"

namespace place_recognition {
namespace {

namespace fs = std::filesystem;

constexpr const char* kStart = "doubtful_";
constexpr double kLongestBag = 3600;  // s
constexpr int kBagsOfLimit = 8;
constexpr double kTick = 1e-6;  // s, between frames if the clock stands still

std::uint64_t bytesOf(const KeepOptions& options) {
  constexpr std::uint64_t kMegabyte = 1000000;
  return static_cast<std::uint64_t>(options.megabytes) * kMegabyte;
}

std::string nameAt(std::time_t time) {
  char text[32];
  std::tm utc{};
  gmtime_r(&time, &utc);
  std::strftime(text, sizeof(text), "%Y-%m-%d_%H-%M-%S", &utc);
  return kStart + std::string(text) + ".bag";
}

struct KeptBag {
  fs::path path;
  std::uint64_t bytes;
};

/// The bags in the folder that no person has labelled, including those left by killed nodes, oldest
/// first.
std::vector<KeptBag> keptBags(const std::string& folder) {
  std::vector<KeptBag> bags;
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored)) {
    const std::string name = entry.path().filename();
    if (!startsWith(name, kStart) || name.find(".bag") == std::string::npos) continue;
    if (!ownLabelsFile(entry.path()).empty()) continue;
    bags.push_back({entry.path(), entry.file_size(ignored)});
  }
  std::sort(bags.begin(), bags.end(),
            [](const KeptBag& a, const KeptBag& b) { return a.path < b.path; });
  return bags;
}

}  // namespace

KeepOptions readKeepOptions(Parameters& parameters, const std::string& label_topic) {
  KeepOptions options;
  options.folder = userPath(parameters.text("keep_doubtful"));
  options.per_hour = parameters.integer("keep_per_hour", options.per_hour, 1, 1000000);
  options.megabytes = parameters.integer("keep_megabytes", options.megabytes, 1, 1000000);
  options.label_topic = label_topic;
  return options;
}

DoubtfulFrames::DoubtfulFrames(KeepOptions options) : options_(prepared(std::move(options))) {
  if (!isKeeping()) return;
  lock_ = std::make_unique<FolderLock>(options_.folder, FolderLock::IfTaken::kGiveUp);
  if (lock_->isTaken()) {
    throw Error("Another recognizer keeps its doubtful frames in " + options_.folder +
                "; set ~keep_doubtful to another folder.");
  }
}

/// Creates the folder and makes its path absolute.
KeepOptions DoubtfulFrames::prepared(KeepOptions options) {
  if (options.folder.empty()) return options;
  std::error_code failure;
  fs::create_directories(options.folder, failure);
  if (!failure) options.folder = fs::canonical(options.folder, failure);
  if (failure) {
    throw Error("Cannot keep doubtful frames in " + options.folder + ": " + failure.message() +
                "; set ~keep_doubtful to a writable folder.");
  }
  if (access(options.folder.c_str(), W_OK) != 0) {  // reported now, not at the first doubtful frame
    throw Error("The folder " + options.folder + " cannot be written to: " + std::strerror(errno) +
                "; set ~keep_doubtful to a writable one.");
  }
  return options;
}

DoubtfulFrames::~DoubtfulFrames() {
  try {
    finishBag();
  } catch (const Error& e) {
    ROS_ERROR("%s", e.what());
  }
}

void DoubtfulFrames::take(const std::string& topic, const ImageMessage& image,
                          const Recognition& recognition, const std::string& place) {
  if (!isKeeping() || failed_ || !isDoubtful(topic, recognition)) return;
  try {
    keep(topic, image, place);
  } catch (const Error& e) {
    ROS_ERROR("Doubtful frames are no longer kept: %s", e.what());
    failed_ = true;
    if (bag_) bag_->discard();
    bag_.reset();
  }
}

bool DoubtfulFrames::isDoubtful(const std::string& topic, const Recognition& recognition) {
  if (recognition.place < 0) return false;  // the image shows nothing
  const auto [last, is_first] = last_places_.emplace(topic, recognition.place);
  const bool flips = !is_first && last->second != recognition.place;
  last->second = recognition.place;
  return flips || !recognition.known;
}

void DoubtfulFrames::keep(const std::string& topic, const ImageMessage& image,
                          const std::string& place) {
  const ros::Time now = ros::Time::now();
  if (now < ros::TIME_MIN) return;  // a simulated clock that has not started
  if (now + ros::Duration(kTimeJump) < last_) {
    finishBag();
    due_ = {};
  }
  if (now < due_) return;
  due_ = now + ros::Duration(3600.0 / options_.per_hour);
  if (!bag_) begin(now);
  last_ = std::max(now, last_ + ros::Duration(kTick));
  const std::string label = place == kUnknownPlace ? "" : place;
  if (images_ == 0 || label != label_) {
    std_msgs::String message;
    message.data = label_ = label;
    bag_->write(options_.label_topic, last_, message);
  }
  image.visit([&](const auto& message) {
    bag_->write(topic + image.topicSuffix(), last_, message);
    bytes_ += ros::serialization::serializationLength(message);
  });
  ++images_;
  if (bytes_ > bytesOf(options_) / kBagsOfLimit || last_ > begin_ + ros::Duration(kLongestBag))
    finishBag();
}

void DoubtfulFrames::begin(const ros::Time& time) {
  named_ = std::max(named_ + 1, std::time(nullptr));  // later than all earlier ones
  while (fs::exists(options_.folder + "/" + nameAt(named_))) ++named_;
  bag_ = std::make_unique<StagedBag>(options_.folder + "/" + nameAt(named_), StagedBag::kActive);
  begin_ = last_ = time;
  bytes_ = images_ = 0;
}

void DoubtfulFrames::finishBag() {
  const std::unique_ptr<StagedBag> bag = std::move(bag_);
  if (!bag) return;
  try {
    bag->complete();
  } catch (const Error&) {
    bag->discard();
    throw;
  }
  ROS_INFO("Kept %s that the model doubts. Label them with: place_tool label %s",
           counted(images_, "image").c_str(), bag->path().c_str());
  removeOldest();
}

void DoubtfulFrames::removeOldest() const {
  const std::vector<KeptBag> bags = keptBags(options_.folder);
  std::uint64_t total = 0;
  for (const KeptBag& bag : bags) total += bag.bytes;
  for (const KeptBag& bag : bags) {
    if (total <= bytesOf(options_) / kBagsOfLimit * (kBagsOfLimit - 1)) return;
    std::error_code ignored;
    fs::remove(bag.path, ignored);
    total -= bag.bytes;
    ROS_INFO("Removing %s: more than ~keep_megabytes (%d) are kept.", bag.path.c_str(),
             options_.megabytes);
  }
}

}  // namespace place_recognition
