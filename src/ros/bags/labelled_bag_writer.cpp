#include "ros/bags/labelled_bag_writer.h"

#include <sensor_msgs/CompressedImage.h>
#include <sensor_msgs/Image.h>
#include <std_msgs/String.h>
#include <unistd.h>

#include <cassert>
#include <opencv2/imgcodecs.hpp>
#include <optional>

#include "base/text.h"
#include "labels/labels.h"
#include "place_recognition/error.h"
#include "ros/bags/staged_bag.h"
#include "ros/messages/conversions.h"
#include "ros/messages/image_types.h"

namespace place_recognition {
namespace {

rosbag::CompressionType rosbagCompression(LabelledBagOptions::Compression compression) {
  switch (compression) {
    case LabelledBagOptions::Compression::kLz4:
      return rosbag::compression::LZ4;
    case LabelledBagOptions::Compression::kBz2:
      return rosbag::compression::BZ2;
    default:
      return rosbag::compression::Uncompressed;
  }
}

sensor_msgs::CompressedImage toJpegMessage(const cv::Mat& image, const std_msgs::Header& header,
                                           int quality) {
  sensor_msgs::CompressedImage message;
  message.header = header;
  message.format =
      image.channels() == 3 ? "bgr8; jpeg compressed bgr8" : "mono8; jpeg compressed mono8";
  cv::imencode(".jpg", image, message.data, {cv::IMWRITE_JPEG_QUALITY, quality});
  return message;
}

/// Throws Error unless ROS can store the time.
ros::Time toTime(double seconds, std::uint32_t number, const std::string& path) {
  if (seconds >= ros::TIME_MIN.toSec() && seconds < ros::TIME_MAX.sec) return ros::Time(seconds);
  throw Error("Cannot write " + path + ": its image " + std::to_string(number) + " has the time " +
              significant(seconds, 13) +
              " s since 1970, which ROS cannot store; give a higher rate, or times in "
              "seconds.");
}

}  // namespace

struct LabelledBagWriter::Bag {
  Bag(const std::string& path, const LabelledBagOptions& bag_options)
      : file(path, ".tmp-" + std::to_string(getpid())), options(bag_options) {
    file.setCompression(rosbagCompression(options.compression));
  }

  StagedBag file;
  LabelledBagOptions options;
  std::optional<std::string> place;  // the last label written
  std::uint32_t images = 0;
  bool complete = false;
};

LabelledBagWriter::LabelledBagWriter(const std::string& path, const LabelledBagOptions& options)
    : bag_(std::make_unique<Bag>(path, options)) {}

LabelledBagWriter::~LabelledBagWriter() {
  if (!bag_->complete) bag_->file.discard();
}

void LabelledBagWriter::write(const cv::Mat& image, const std::string& place, double stamp,
                              const std::string& camera) {
  assert(!image.empty() && (image.type() == CV_8UC3 || image.type() == CV_8UC1));
  if (!place.empty()) checkLabel(place, bag_->file.path());
  std_msgs::Header header;
  header.seq = bag_->images++;
  header.stamp = toTime(bag_->options.base_time + stamp, bag_->images, bag_->file.path());
  header.frame_id = camera.empty() ? bag_->options.frame_id : camera;
  const std::string topic =
      camera.empty() ? bag_->options.image_topic : "/" + camera + "/image_raw";
  if (bag_->place != place) {
    std_msgs::String label;
    label.data = place;
    bag_->file.write(bag_->options.label_topic, header.stamp, label);
    bag_->place = place;
  }
  if (bag_->options.jpeg) {
    bag_->file.write(topic + kCompressedSuffix, header.stamp,
                     toJpegMessage(image, header, bag_->options.jpeg_quality));
  } else {
    bag_->file.write(topic, header.stamp, toImageMessage(image, header));
  }
}

void LabelledBagWriter::close() {
  bag_->file.complete();
  bag_->complete = true;
}

}  // namespace place_recognition
