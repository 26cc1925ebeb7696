#pragma once

#include <ros/ros.h>
#include <sensor_msgs/CompressedImage.h>
#include <sensor_msgs/Image.h>

#include <opencv2/imgcodecs.hpp>
#include <string>

#include "ros/messages/conversions.h"

namespace place_recognition {

inline std_msgs::Header headerAt(double stamp) {
  std_msgs::Header header;
  header.stamp = ros::Time(stamp);
  header.frame_id = "camera_optical";
  return header;
}

/// A camera that publishes raw and compressed images.
class Camera {
 public:
  explicit Camera(ros::NodeHandle& node, const std::string& topic = "/camera/image")
      : raw_(node.advertise<sensor_msgs::Image>(topic, kQueue)),
        compressed_(node.advertise<sensor_msgs::CompressedImage>(topic + "/compressed", kQueue)) {}

  void send(const cv::Mat& image, double stamp) {
    raw_.publish(toImageMessage(image, headerAt(stamp)));
    sensor_msgs::CompressedImage message;
    message.header = headerAt(stamp);
    message.format = "png";
    cv::imencode(".png", image, message.data);
    compressed_.publish(message);
  }
  void send(const sensor_msgs::Image& message) { raw_.publish(message); }

  std::uint32_t rawListeners() const { return raw_.getNumSubscribers(); }
  std::uint32_t compressedListeners() const { return compressed_.getNumSubscribers(); }

 private:
  static constexpr std::uint32_t kQueue = 10;

  ros::Publisher raw_;
  ros::Publisher compressed_;
};

}  // namespace place_recognition
