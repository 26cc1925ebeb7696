// bag_reader info|images BAG LABEL_TOPIC [IMAGE_TOPIC...]
//
// Reads a bag for openBagRecording() and bagInfo() and writes what it finds to standard output
// (bag_records.h). A program of its own, because rosbag_storage can crash on a damaged bag.

#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <sensor_msgs/CompressedImage.h>
#include <sensor_msgs/Image.h>
#include <std_msgs/String.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <map>
#include <new>
#include <string>
#include <utility>
#include <vector>

#include "base/process_limits.h"
#include "datasets/depth_scale.h"
#include "place_recognition/camera_correlation.h"
#include "place_recognition/depth_extent.h"
#include "place_recognition/error.h"
#include "ros/bags/bag_file.h"
#include "ros/bags/bag_guard.h"
#include "ros/bags/bag_recording.h"
#include "ros/messages/bag_records.h"
#include "ros/messages/conversions.h"

namespace place_recognition {
namespace {

const std::string kImageType = "sensor_msgs/Image";
const std::string kCompressedType = "sensor_msgs/CompressedImage";
const std::string kLabelType = "std_msgs/String";

struct Topic {
  std::string type;
  std::uint32_t messages = 0;

  bool hasImages() const { return type == kImageType || type == kCompressedType; }
};

/// A name without the slashes at its start, which old recorders leave out, and at its end.
std::string bareName(const std::string& topic) {
  const std::size_t start = topic.find_first_not_of('/');
  return start == std::string::npos ? ""
                                    : topic.substr(start, topic.find_last_not_of('/') + 1 - start);
}

/// Whether the images are distances, which no camera's image can be taken for.
bool isCompressedDepth(const std::string& topic) {
  const std::string ending = "compressedDepth";
  return topic.size() >= ending.size() &&
         topic.compare(topic.size() - ending.size(), ending.size(), ending) == 0;
}

/// By name.
using Topics = std::map<std::string, Topic>;

void send(const BagRecord& record) {
  restartWorkLimit();
  // The reader of the pipe has gone, so nobody is left to tell.
  if (!writeRecord(STDOUT_FILENO, record)) std::exit(1);
}

Topics listTopics(const rosbag::Bag& bag) {
  Topics topics;
  for (const rosbag::ConnectionInfo* connection : rosbag::View(bag).getConnections()) {
    topics[connection->topic].type = connection->datatype;
  }
  for (auto& [name, topic] : topics) {
    topic.messages = rosbag::View(bag, rosbag::TopicQuery(name)).size();
  }
  return topics;
}

template <typename Message>
void decode(const rosbag::MessageInstance& instance, cv::Mat& image, BagRecord& record,
            boost::shared_ptr<void>& owner) {
  const boost::shared_ptr<Message> message = instance.instantiate<Message>();
  if (!message) throw Error("The message is not a " + instance.getDataType() + " as known today.");
  if (!message->header.stamp.isZero()) record.stamp = message->header.stamp.toSec();
  image = toImage(*message);
  owner = message;
}

/// The image of a message; `record` tells of it, or of the problem with it. `owner` keeps the
/// memory of the image.
cv::Mat readImage(const rosbag::MessageInstance& instance, BagRecord& record,
                  boost::shared_ptr<void>& owner) {
  record.time = instance.getTime().toSec();
  record.stamp = record.time;
  cv::Mat image;
  try {
    if (instance.getDataType() == kImageType) {
      decode<sensor_msgs::Image>(instance, image, record, owner);
    } else {
      decode<sensor_msgs::CompressedImage>(instance, image, record, owner);
    }
    record.kind = BagRecordKind::kImage;
    record.rows = static_cast<std::uint32_t>(image.rows);
    record.cols = static_cast<std::uint32_t>(image.cols);
  } catch (const Error& e) {
    record.kind = BagRecordKind::kProblem;
    record.detail = e.what();
  }
  return image;
}

/// The first and the last of most images: those that no gap of more than a day sets apart, as a
/// clock does that was not set.
std::pair<ros::Time, ros::Time> spanOfImages(rosbag::View& images) {
  constexpr double kGap = 24 * 60 * 60;  // s
  std::pair<ros::Time, ros::Time> span;
  std::uint32_t most = 0, count = 0;
  ros::Time first, last;
  for (const rosbag::MessageInstance& image : images) {
    const ros::Time time = image.getTime();
    if (count == 0 || time.toSec() - last.toSec() > kGap) {
      first = time;
      count = 0;
    }
    last = time;
    if (++count >= most) {
      most = count;
      span = {first, last};
    }
  }
  return span;
}

/// The time of the bag: of the images, and of all messages that no gap of more than ten minutes
/// sets apart from them.
std::pair<ros::Time, ros::Time> spanOf(const rosbag::Bag& bag) {
  constexpr double kGap = 10 * 60;  // s
  rosbag::View all(bag);
  if (all.size() == 0) return {};
  rosbag::View images(bag, rosbag::TypeQuery({kImageType, kCompressedType}));
  if (images.size() == 0) return {all.getBeginTime(), all.getEndTime()};
  const auto [first, last] = spanOfImages(images);
  ros::Time begin = all.getBeginTime(), before = begin, end = last;
  for (const rosbag::MessageInstance& message : rosbag::View(bag, ros::TIME_MIN, first)) {
    if (message.getTime().toSec() - before.toSec() > kGap) begin = message.getTime();
    before = message.getTime();
  }
  for (const rosbag::MessageInstance& message : rosbag::View(bag, last)) {
    if (message.getTime().toSec() - end.toSec() > kGap) break;
    end = message.getTime();
  }
  return {begin, end};
}

void sendSpan(const rosbag::Bag& bag) {
  const auto [begin, end] = spanOf(bag);
  BagRecord record;
  record.kind = BagRecordKind::kSpan;
  record.time = begin.toSec();
  record.stamp = end.toSec();
  send(record);
}

void sendTopics(const rosbag::Bag& bag, const Topics& topics, bool with_sizes) {
  for (const auto& [name, topic] : topics) {
    BagRecord record;
    if (with_sizes && topic.hasImages() && topic.messages > 0) {
      boost::shared_ptr<void> owner;
      readImage(*rosbag::View(bag, rosbag::TopicQuery(name)).begin(), record, owner);
    }
    record.kind = BagRecordKind::kTopic;
    record.text = name;
    record.detail = topic.type;
    record.number = topic.messages;
    send(record);
  }
}

std::string join(const Topics& topics, bool images_only) {
  std::string text;
  for (const auto& [name, topic] : topics) {
    if (images_only && (!topic.hasImages() || isCompressedDepth(name))) continue;
    text += (text.empty() ? "" : ", ") + name + " (" + topic.type + ")";
  }
  return text.empty() ? "none" : text;
}

void sendLabels(const rosbag::Bag& bag, const Topics& topics, const std::string& label_topic) {
  auto found = topics.find(label_topic);
  for (auto topic = topics.begin(); found == topics.end() && topic != topics.end(); ++topic) {
    if (bareName(topic->first) == bareName(label_topic)) found = topic;
  }
  if (found == topics.end()) {
    if (label_topic.empty() || label_topic == BagRecordingOptions().label_topic) return;
    throw Error("it has no topic " + label_topic + " for labels; its topics are " +
                join(topics, false));
  }
  if (found->second.type != kLabelType) {
    throw Error("the label topic " + label_topic + " is of " + found->second.type + ", not of " +
                kLabelType);
  }
  for (const rosbag::MessageInstance& instance :
       rosbag::View(bag, rosbag::TopicQuery(found->first))) {
    const auto message = instance.instantiate<std_msgs::String>();
    BagRecord record;
    record.kind = BagRecordKind::kLabel;
    record.time = instance.getTime().toSec();
    if (message) record.text = message->data;
    send(record);
  }
}

/// The topic of a camera by that of its images, which may end in "/compressed".
std::string cameraOf(const std::string& topic) {
  const std::string ending = "/compressed";
  const bool ends = topic.size() > ending.size() &&
                    topic.compare(topic.size() - ending.size(), ending.size(), ending) == 0;
  return "/" + bareName(topic.substr(0, topic.size() - (ends ? ending.size() : 0)));
}

/// The topic that is meant by `wanted`, also by its name without "/compressed" or slashes at its
/// start; the only camera's if it is empty.
std::string chooseImageTopic(const Topics& topics, const std::string& wanted) {
  std::vector<std::string> candidates;  // in order of name, so that compressed ones follow raw ones
  for (const auto& [name, topic] : topics) {
    if (!topic.hasImages() || isCompressedDepth(name)) continue;
    if (name == wanted) return name;
    candidates.push_back(name);
  }
  if (candidates.empty()) throw Error("it has no images; its topics are " + join(topics, false));
  if (!wanted.empty()) {
    for (const char* suffix : {"", "/compressed"}) {
      const auto meant = [&](const std::string& name) {
        return bareName(name) == bareName(wanted) + suffix;
      };
      const auto found = std::find_if(candidates.begin(), candidates.end(), meant);
      if (found != candidates.end()) return *found;
    }
    throw Error("it has no images on " + wanted + "; topics of images are " + join(topics, true));
  }
  const std::string& first = candidates.front();
  const bool one_camera = std::all_of(
      candidates.begin(), candidates.end(),
      [&first](const std::string& name) { return name == first || name == first + "/compressed"; });
  if (!one_camera) {
    throw Error(
        "it has several topics of images; name one with --image-topic, or those of several cameras "
        "of one robot with commas between them: " +
        join(topics, true));
  }
  return first;
}

/// The topics that are meant by `wanted`, one per camera; the only camera's if there are none.
std::vector<std::string> chooseImageTopics(const Topics& topics,
                                           const std::vector<std::string>& wanted) {
  std::vector<std::string> chosen;
  if (wanted.size() > kMaxCameras) {
    throw Error("a robot has at most " + std::to_string(kMaxCameras) +
                " cameras here; name fewer topics of images");
  }
  if (wanted.empty()) chosen.push_back(chooseImageTopic(topics, ""));
  for (const std::string& one : wanted) {
    const std::string topic = chooseImageTopic(topics, one);
    const bool again = std::any_of(chosen.begin(), chosen.end(), [&](const std::string& other) {
      return cameraOf(other) == cameraOf(topic);
    });
    if (again) throw Error("its camera " + cameraOf(topic) + " is named twice; name each once");
    chosen.push_back(topic);
  }
  return chosen;
}

/// Tells the extent of images of 16 bits, by some from all of the topics.
void sendDepth(const rosbag::Bag& bag, const std::vector<std::string>& topics) {
  DepthExtent extent;
  constexpr std::uint32_t kSamples = 16;
  rosbag::View view(bag, rosbag::TopicQuery(topics));
  const std::uint32_t step = std::max(view.size() / kSamples, std::uint32_t{1});
  std::uint32_t number = 0;
  for (const rosbag::MessageInstance& instance : view) {
    if (number++ % step != 0) continue;
    boost::shared_ptr<void> owner;
    BagRecord ignored;
    const cv::Mat image = readImage(instance, ignored, owner);
    if (!image.empty() && image.depth() != CV_16U) return;
    if (!image.empty()) extent = united(extent, depthExtentOf(image));
  }
  if (!extent.known()) return;
  BagRecord depth;
  depth.kind = BagRecordKind::kDepth;
  depth.rows = extent.low;
  depth.cols = extent.high;
  send(depth);
}

void sendCameras(const std::vector<std::string>& topics) {
  for (const std::string& topic : topics) {
    BagRecord record;
    record.kind = BagRecordKind::kCamera;
    record.text = cameraOf(topic);
    send(record);
  }
}

void sendImages(const rosbag::Bag& bag, const std::vector<std::string>& topics) {
  sendDepth(bag, topics);
  sendCameras(topics);
  std::vector<int> numbers(topics.size());
  for (const rosbag::MessageInstance& instance : rosbag::View(bag, rosbag::TopicQuery(topics))) {
    const auto camera = static_cast<std::size_t>(
        std::find(topics.begin(), topics.end(), instance.getTopic()) - topics.begin());
    boost::shared_ptr<void> owner;
    BagRecord record;
    const cv::Mat image = readImage(instance, record, owner);
    record.type = image.type();
    record.number = camera;
    record.text = topics[camera] + " #" + std::to_string(++numbers[camera]);
    send(record);
    if (record.kind != BagRecordKind::kImage) continue;
    for (int row = 0; row < image.rows; ++row) {
      const std::size_t row_bytes = static_cast<std::size_t>(image.cols) * image.elemSize();
      if (!writeBytes(STDOUT_FILENO, image.ptr(row), row_bytes)) std::exit(1);
    }
  }
}

void sendAll(const rosbag::Bag& bag, bool images, const std::string& label_topic,
             const std::vector<std::string>& image_topics) {
  const Topics topics = listTopics(bag);
  sendSpan(bag);
  sendTopics(bag, topics, !images);
  std::vector<std::string> chosen;
  if (images) chosen = chooseImageTopics(topics, image_topics);
  sendLabels(bag, topics, label_topic);
  if (images) sendImages(bag, chosen);
  send(BagRecord());
}

/// Sends all of a bag; `failed_at` tells how far that came, for once the bag is closed its
/// position is gone.
void readBag(bool images, const std::string& path, const std::string& label_topic,
             const std::vector<std::string>& image_topics, std::uint64_t& failed_at) {
  rosbag::Bag bag(path, rosbag::bagmode::Read);
  try {
    sendAll(bag, images, label_topic, image_topics);
  } catch (const Error&) {
    throw;  // of what was asked for, not of a place in the bag
  } catch (...) {
    failed_at = bagOffset();
    throw;
  }
}

std::string whyUnindexed(const std::string& path) {
  if (isActiveBag(path)) return whyActive(path);
  return "it has no index, as when recording was cut short; run: rosbag reindex " + path;
}

/// readBag() with every error told to the other end of the pipe.
int run(bool images, const std::string& path, const std::string& label_topic,
        const std::vector<std::string>& image_topics) {
  BagRecord record;
  record.kind = BagRecordKind::kError;
  try {
    guardBag(path);
    readBag(images, path, label_topic, image_topics, record.number);
    return 0;
  } catch (const rosbag::BagUnindexedException&) {
    record.detail = whyUnindexed(path);
  } catch (const std::bad_alloc&) {
    record.detail = "it asks for more than " + std::to_string(kMaxMemory >> 30) +
                    " GB of memory; it is probably damaged";
  } catch (const Error& e) {
    record.detail = e.what();
  } catch (const std::exception& e) {
    record.detail = std::string("it is damaged or cut short (") + e.what() + ")";
    record.text = "copy or record it again, or try: rosbag reindex " + path;
  }
  send(record);
  return 1;
}

}  // namespace
}  // namespace place_recognition

int main(int argc, char** argv) {
  if (argc < 4) return 2;
  return place_recognition::run(std::string(argv[1]) == "images", argv[2], argv[3],
                                {argv + 4, argv + argc});
}
