#include "ros/nodes/image_input.h"

#include "ros/messages/conversions.h"

namespace place_recognition {

const std_msgs::Header& ImageMessage::header() const {
  return std::visit([](const auto& message) -> const std_msgs::Header& { return message->header; },
                    message_);
}

cv::Mat ImageMessage::image() const {
  return std::visit([](const auto& message) { return toImage(*message); }, message_);
}

ImageInput::ImageInput(const ros::NodeHandle& node, const ros::NodeHandle& private_node,
                       Parameters& parameters, Callback callback, std::uint32_t queue)
    : node_(node),
      private_node_(private_node),
      transport_name_(parameters.text("image_transport", "raw")),
      callback_(std::move(callback)),
      queue_(queue),
      transport_(node) {}

void ImageInput::subscribe() {
  if (transport_name_ == "compressed") {
    // As image_transport does: a remapping of `image` holds for what is appended to it.
    compressed_subscriber_ = node_.subscribe(topic() + names::kCompressedSuffix, queue_,
                                             &ImageInput::onCompressed, this);
  } else {
    subscribeThroughPlugin();
  }
}

void ImageInput::subscribeThroughPlugin() {
  const image_transport::TransportHints hints("raw", ros::TransportHints(), private_node_);
  try {
    plugin_subscriber_ =
        transport_.subscribe(names::kImage, queue_, &ImageInput::onImage, this, hints);
  } catch (const std::exception& e) {
    ROS_ERROR("There is no image transport '%s' (%s); taking raw images. Correct ~image_transport.",
              hints.getTransport().c_str(), e.what());
    plugin_subscriber_ = transport_.subscribe(names::kImage, queue_, &ImageInput::onImage, this);
  }
}

void ImageInput::unsubscribe() {
  plugin_subscriber_.shutdown();
  compressed_subscriber_.shutdown();
}

}  // namespace place_recognition
