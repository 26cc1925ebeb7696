#pragma once

#include <image_transport/image_transport.h>
#include <ros/ros.h>
#include <sensor_msgs/CompressedImage.h>
#include <sensor_msgs/Image.h>

#include <functional>
#include <opencv2/core/mat.hpp>
#include <string>
#include <variant>

#include "ros/nodes/node_names.h"
#include "ros/nodes/parameters.h"

namespace place_recognition {

/// An image message as received.
class ImageMessage {
 public:
  ImageMessage() = default;
  explicit ImageMessage(sensor_msgs::ImageConstPtr message) : message_(std::move(message)) {}
  explicit ImageMessage(sensor_msgs::CompressedImageConstPtr message)
      : message_(std::move(message)) {}

  const std_msgs::Header& header() const;
  /// The image, which may share the message's memory. Throws Error if it is unusable.
  cv::Mat image() const;

  /// What its topic appends to the name without a transport.
  std::string topicSuffix() const;

  /// Calls `use` with the message itself, a sensor_msgs::Image or CompressedImage.
  template <typename Use>
  void visit(const Use& use) const {
    std::visit([&use](const auto& message) { use(*message); }, message_);
  }

 private:
  std::variant<sensor_msgs::ImageConstPtr, sensor_msgs::CompressedImageConstPtr> message_;
};

/// The subscription to a topic of images, with the transport that the parameter `~image_transport`
/// names. `compressed` is decoded here, because not every installation has image_transport's plugin
/// for it.
class ImageInput {
 public:
  using Callback = std::function<void(const ImageMessage&)>;

  /// While the callback is busy, the newest `queue` images wait. `topic`: without the suffix of the
  /// transport. Throws Error if the transport is not installed.
  ImageInput(const ros::NodeHandle& node, const ros::NodeHandle& private_node,
             Parameters& parameters, Callback callback, std::uint32_t queue,
             std::string topic = names::kImage);

  /// May be called at any time, from one thread at a time.
  void subscribe();
  void unsubscribe();

  /// The topic without the suffix of the transport.
  std::string topic() const { return node_.resolveName(topic_); }
  const std::string& transport() const { return transport_name_; }

 private:
  void onImage(const sensor_msgs::ImageConstPtr& message) { callback_(ImageMessage(message)); }
  void onCompressed(const sensor_msgs::CompressedImageConstPtr& message) {
    callback_(ImageMessage(message));
  }
  void requireTransport(const Parameters& parameters) const;

  ros::NodeHandle node_;
  ros::NodeHandle private_node_;
  const std::string topic_;
  const std::string transport_name_;
  Callback callback_;
  const std::uint32_t queue_;
  image_transport::ImageTransport transport_;
  image_transport::Subscriber plugin_subscriber_;
  ros::Subscriber compressed_subscriber_;
};

}  // namespace place_recognition
