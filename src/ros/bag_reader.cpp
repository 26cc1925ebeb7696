// bag_reader info|images BAG IMAGE_TOPIC LABEL_TOPIC
//
// Reads a bag for openBagRun() and bagInfo() and writes what it finds to standard output
// (bag_records.h). A program of its own, because rosbag_storage can crash on a damaged bag.

#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <sensor_msgs/CompressedImage.h>
#include <sensor_msgs/Image.h>
#include <std_msgs/String.h>
#include <unistd.h>

#include <cstdlib>
#include <exception>
#include <map>
#include <new>
#include <string>

#include "place_recognition/error.h"
#include "ros/bag_guard.h"
#include "ros/bag_records.h"
#include "ros/bag_run.h"
#include "ros/conversions.h"

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

/// The picture of a message; `record` tells of it, or of the problem with it. `owner` keeps the
/// memory of the picture.
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
    record.type = image.type();
  } catch (const Error& e) {
    record.kind = BagRecordKind::kProblem;
    record.detail = e.what();
  }
  return image;
}

void sendSpan(const rosbag::Bag& bag) {
  rosbag::View all(bag);
  BagRecord record;
  record.kind = BagRecordKind::kSpan;
  if (all.size() > 0) {
    record.time = all.getBeginTime().toSec();
    record.stamp = all.getEndTime().toSec();
  }
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
    if (images_only && !topic.hasImages()) continue;
    text += (text.empty() ? "" : ", ") + name + " (" + topic.type + ")";
  }
  return text.empty() ? "none" : text;
}

void sendLabels(const rosbag::Bag& bag, const Topics& topics, const std::string& label_topic) {
  const auto found = topics.find(label_topic);
  if (found == topics.end()) {
    if (label_topic.empty() || label_topic == BagRunOptions().label_topic) return;
    throw Error("it has no topic " + label_topic + " for labels; its topics are " +
                join(topics, false));
  }
  if (found->second.type != kLabelType) {
    throw Error("the label topic " + label_topic + " is of " + found->second.type + ", not of " +
                kLabelType);
  }
  for (const rosbag::MessageInstance& instance :
       rosbag::View(bag, rosbag::TopicQuery(label_topic))) {
    const auto message = instance.instantiate<std_msgs::String>();
    BagRecord record;
    record.kind = BagRecordKind::kLabel;
    record.time = instance.getTime().toSec();
    if (message) record.text = message->data;
    send(record);
  }
}

/// The topic that is meant by `wanted`, also by its name without "/compressed"; the only one if it
/// is empty.
std::string chooseImageTopic(const Topics& topics, const std::string& wanted) {
  std::string only;
  int count = 0;
  for (const auto& [name, topic] : topics) {
    if (!topic.hasImages()) continue;
    if (name == wanted || name == wanted + "/compressed") return name;
    only = name;
    ++count;
  }
  if (count == 0) throw Error("it has no images; its topics are " + join(topics, false));
  if (!wanted.empty()) {
    throw Error("it has no images on " + wanted + "; topics of images are " + join(topics, true));
  }
  if (count > 1) throw Error("name one of its image topics: " + join(topics, true));
  return only;
}

void sendImages(const rosbag::Bag& bag, const std::string& topic) {
  int number = 0;
  for (const rosbag::MessageInstance& instance : rosbag::View(bag, rosbag::TopicQuery(topic))) {
    boost::shared_ptr<void> owner;
    BagRecord record;
    const cv::Mat image = readImage(instance, record, owner);
    record.text = topic + " #" + std::to_string(++number);
    send(record);
    if (record.kind != BagRecordKind::kImage) continue;
    for (int row = 0; row < image.rows; ++row) {
      const std::size_t row_bytes = static_cast<std::size_t>(image.cols) * image.elemSize();
      if (!writeBytes(STDOUT_FILENO, image.ptr(row), row_bytes)) std::exit(1);
    }
  }
}

void sendAll(const rosbag::Bag& bag, bool images, const std::string& image_topic,
             const std::string& label_topic) {
  const Topics topics = listTopics(bag);
  sendSpan(bag);
  sendTopics(bag, topics, !images);
  const std::string chosen = images ? chooseImageTopic(topics, image_topic) : "";
  sendLabels(bag, topics, label_topic);
  if (images) sendImages(bag, chosen);
  send(BagRecord());
}

/// Sends all of a bag; `failed_at` tells how far that came, for once the bag is closed its
/// position is gone.
void readBag(bool images, const std::string& path, const std::string& image_topic,
             const std::string& label_topic, std::uint64_t& failed_at) {
  rosbag::Bag bag(path, rosbag::bagmode::Read);
  try {
    sendAll(bag, images, image_topic, label_topic);
  } catch (...) {
    failed_at = bagOffset();
    throw;
  }
}

/// readBag() with every error told to the other end of the pipe.
int run(bool images, const std::string& path, const std::string& image_topic,
        const std::string& label_topic) {
  BagRecord record;
  record.kind = BagRecordKind::kError;
  try {
    guardBag(path);
    readBag(images, path, image_topic, label_topic, record.number);
    return 0;
  } catch (const rosbag::BagUnindexedException&) {
    record.detail = "it has no index, as when recording was cut short; run: rosbag reindex " + path;
  } catch (const std::bad_alloc&) {
    record.detail = "it asks for more than " + std::to_string(kMaxMemory >> 30) +
                    " GB of memory; it is probably damaged";
  } catch (const Error& e) {
    record.detail = e.what();
  } catch (const std::exception& e) {
    record.detail = std::string("it is damaged or no ROS 1 bag (") + e.what() + ")";
  }
  send(record);
  return 1;
}

}  // namespace
}  // namespace place_recognition

int main(int argc, char** argv) {
  if (argc != 5) return 2;
  return place_recognition::run(std::string(argv[1]) == "images", argv[2], argv[3], argv[4]);
}
