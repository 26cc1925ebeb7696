#include "ros/labelled_bag_writer.h"

#include <rosbag/bag.h>
#include <sensor_msgs/CompressedImage.h>
#include <sensor_msgs/Image.h>
#include <std_msgs/String.h>
#include <unistd.h>

#include <cassert>
#include <cstdio>
#include <opencv2/imgcodecs.hpp>
#include <optional>

#include "place_recognition/error.h"
#include "ros/conversions.h"
#include "ros/labels.h"

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

}  // namespace

struct LabelledBagWriter::Bag {
  std::string path;
  std::string temporary;
  LabelledBagOptions options;
  rosbag::Bag file;
  std::optional<std::string> place;  // the label last written
  std::uint32_t images = 0;
  bool complete = false;

  [[noreturn]] void throwCannotWrite(const std::exception& e) const {
    throw Error("Cannot write " + path + ": " + e.what() +
                "; make room, or choose a folder that can be written.");
  }
};

LabelledBagWriter::LabelledBagWriter(const std::string& path, const LabelledBagOptions& options)
    : bag_(std::make_unique<Bag>()) {
  bag_->path = path;
  bag_->temporary = path + ".tmp-" + std::to_string(getpid());
  bag_->options = options;
  try {
    bag_->file.open(bag_->temporary, rosbag::bagmode::Write);
    bag_->file.setCompression(rosbagCompression(options.compression));
  } catch (const rosbag::BagException& e) {
    bag_->throwCannotWrite(e);
  }
}

LabelledBagWriter::~LabelledBagWriter() {
  if (bag_->complete) return;
  try {
    bag_->file.close();
  } catch (const rosbag::BagException&) {
    // What could not be written is removed anyway.
  }
  std::remove(bag_->temporary.c_str());
}

void LabelledBagWriter::write(const cv::Mat& image, const std::string& place, double stamp) {
  assert(!image.empty() && (image.type() == CV_8UC3 || image.type() == CV_8UC1));
  if (!place.empty()) checkLabel(place, bag_->path);
  std_msgs::Header header;
  header.seq = bag_->images++;
  header.stamp = ros::Time(bag_->options.base_time + stamp);
  header.frame_id = bag_->options.frame_id;
  try {
    if (bag_->place != place) {
      std_msgs::String label;
      label.data = place;
      bag_->file.write(bag_->options.label_topic, header.stamp, label);
      bag_->place = place;
    }
    if (bag_->options.jpeg) {
      bag_->file.write(bag_->options.image_topic + "/compressed", header.stamp,
                       toJpegMessage(image, header, bag_->options.jpeg_quality));
    } else {
      bag_->file.write(bag_->options.image_topic, header.stamp, toImageMessage(image, header));
    }
  } catch (const rosbag::BagException& e) {
    bag_->throwCannotWrite(e);
  }
}

void LabelledBagWriter::close() {
  try {
    bag_->file.close();
    // Closing does not tell whether the last bytes reached the disk; the index is among them.
    rosbag::Bag(bag_->temporary, rosbag::bagmode::Read);
  } catch (const rosbag::BagException& e) {
    bag_->throwCannotWrite(e);
  }
  if (std::rename(bag_->temporary.c_str(), bag_->path.c_str()) != 0) {
    bag_->throwCannotWrite(std::runtime_error("it cannot be renamed"));
  }
  bag_->complete = true;
}

}  // namespace place_recognition
