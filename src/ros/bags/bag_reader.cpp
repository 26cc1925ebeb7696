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
#include <new>
#include <string>
#include <utility>
#include <vector>

#include "base/bag_name.h"
#include "base/descriptor_io.h"
#include "base/process_limits.h"
#include "datasets/level_scale.h"
#include "place_recognition/error.h"
#include "place_recognition/level_range.h"
#include "ros/bags/bag_guard.h"
#include "ros/bags/bag_records.h"
#include "ros/bags/bag_time_span.h"
#include "ros/bags/bag_topics.h"
#include "ros/messages/conversions.h"

namespace place_recognition {
namespace {

void send(const BagRecord& record) {
  restartWorkLimit();
  // The reader of the pipe has gone, so there is nobody to report to.
  if (!writeRecord(STDOUT_FILENO, record)) std::exit(1);
}

template <typename Message>
void decode(const rosbag::MessageInstance& instance, cv::Mat& image, BagRecord& record,
            boost::shared_ptr<void>& owner) {
  const boost::shared_ptr<Message> message = instance.instantiate<Message>();
  if (!message) throw Error("The message is not a " + instance.getDataType() + " as known today.");
  if (!message->header.stamp.isZero()) record.image.stamp = message->header.stamp.toSec();
  image = toImage(*message);
  owner = message;
}

/// The image of a message; `record` describes it, or the problem with it. `owner` keeps the memory
/// of the image alive.
cv::Mat readImage(const rosbag::MessageInstance& instance, BagRecord& record,
                  boost::shared_ptr<void>& owner) {
  record.image.time = instance.getTime().toSec();
  record.image.stamp = record.image.time;
  cv::Mat image;
  try {
    if (instance.getDataType() == kImageType) {
      decode<sensor_msgs::Image>(instance, image, record, owner);
    } else {
      decode<sensor_msgs::CompressedImage>(instance, image, record, owner);
    }
    record.kind = BagRecordKind::kImage;
    record.image.rows = static_cast<std::uint32_t>(image.rows);
    record.image.cols = static_cast<std::uint32_t>(image.cols);
    record.image.type = image.type();
  } catch (const Error& e) {
    record.kind = BagRecordKind::kProblem;
    record.detail = e.what();
  }
  return image;
}

void sendSpan(const rosbag::Bag& bag) {
  const BagTimeSpan span = timeSpan(bag);
  BagRecord record(BagRecordKind::kSpan);
  record.span = {span.begin.toSec(), span.end.toSec(), span.other_images};
  send(record);
}

void sendTopics(const rosbag::Bag& bag, const RecordedTopics& topics, bool with_sizes) {
  for (const auto& [name, topic] : topics) {
    BagRecord image;
    if (with_sizes && areImages(name, topic.type) && topic.messages > 0) {
      boost::shared_ptr<void> owner;
      readImage(*rosbag::View(bag, rosbag::TopicQuery(name)).begin(), image, owner);
    }
    BagRecord record(BagRecordKind::kTopic);
    record.topic = {topic.messages, image.image.cols, image.image.rows};
    record.text = name;
    record.detail = topic.type;
    send(record);
  }
}

void sendLabels(const rosbag::Bag& bag, const RecordedTopics& topics,
                const std::string& label_topic) {
  const std::string topic = chooseLabelTopic(topics, label_topic);
  if (topic.empty()) return;
  for (const rosbag::MessageInstance& instance : rosbag::View(bag, rosbag::TopicQuery(topic))) {
    const auto message = instance.instantiate<std_msgs::String>();
    BagRecord record(BagRecordKind::kLabel);
    record.label = {instance.getTime().toSec()};
    if (message) record.text = message->data;
    send(record);
  }
}

/// Sends the range of levels of images with 16 bits, determined from some images of all the topics.
void sendLevels(const rosbag::Bag& bag, const std::vector<std::string>& topics) {
  LevelRange range;
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
    if (!image.empty()) range = united(range, levelRangeOf(image));
  }
  if (!range.known()) return;
  BagRecord record(BagRecordKind::kLevels);
  record.levels = {range.low, range.high};
  send(record);
}

void sendCameras(const std::vector<std::string>& topics) {
  for (const std::string& topic : topics) {
    BagRecord record(BagRecordKind::kCamera);
    record.text = cameraOf(topic);
    send(record);
  }
}

void sendImages(const rosbag::Bag& bag, const std::vector<std::string>& topics) {
  sendLevels(bag, topics);
  sendCameras(topics);
  std::vector<int> numbers(topics.size());
  for (const rosbag::MessageInstance& instance : rosbag::View(bag, rosbag::TopicQuery(topics))) {
    const auto camera = static_cast<std::size_t>(
        std::find(topics.begin(), topics.end(), instance.getTopic()) - topics.begin());
    boost::shared_ptr<void> owner;
    BagRecord record;
    const cv::Mat image = readImage(instance, record, owner);
    record.image.camera = camera;
    record.text = topics[camera] + " #" + std::to_string(++numbers[camera]);
    send(record);
    if (record.kind != BagRecordKind::kImage) continue;
    for (int row = 0; row < image.rows; ++row) {
      const std::size_t row_bytes = static_cast<std::size_t>(image.cols) * image.elemSize();
      if (!writeAll(STDOUT_FILENO, image.ptr(row), row_bytes)) std::exit(1);
    }
  }
}

void sendAll(const rosbag::Bag& bag, bool images, const std::string& label_topic,
             const std::vector<std::string>& image_topics) {
  const RecordedTopics topics = listTopics(bag);
  sendSpan(bag);
  sendTopics(bag, topics, !images);
  std::vector<std::string> chosen;
  if (images) chosen = chooseImageTopics(topics, image_topics);
  sendLabels(bag, topics, label_topic);
  if (images) sendImages(bag, chosen);
  send(BagRecord());
}

/// Sends everything in a bag. `failed_at` is set to the position of a failure, because that is lost
/// when the bag is closed.
void readBag(bool images, const std::string& path, const std::string& label_topic,
             const std::vector<std::string>& image_topics, std::uint64_t& failed_at) {
  rosbag::Bag bag(path, rosbag::bagmode::Read);
  try {
    sendAll(bag, images, label_topic, image_topics);
  } catch (const Error&) {
    throw;  // the error concerns the request, not a position in the bag
  } catch (...) {
    failed_at = bagOffset();
    throw;
  }
}

std::string whyUnindexed(const std::string& path) {
  if (isActiveBag(path)) return whyActive(path);
  return "it has no index because its recording was interrupted; run: rosbag reindex " + path;
}

/// readBag() with every error reported to the other end of the pipe.
int run(bool images, const std::string& path, const std::string& label_topic,
        const std::vector<std::string>& image_topics) {
  BagRecord record(BagRecordKind::kError);
  record.failure = {};
  try {
    guardBag(path);
    readBag(images, path, label_topic, image_topics, record.failure.offset);
    return 0;
  } catch (const rosbag::BagUnindexedException&) {
    record.detail = whyUnindexed(path);
  } catch (const std::bad_alloc&) {
    record.detail = "it asks for more than " + std::to_string(kMaxMemory >> 30) +
                    " GB of memory; it is probably damaged";
  } catch (const Error& e) {
    record.detail = e.what();
  } catch (const std::exception& e) {
    record.detail = std::string("it is damaged or truncated (") + e.what() + ")";
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
