#include "ros/nodes/image_input.h"

#include <string>
#include <vector>

#include "base/contains.h"
#include "base/nearest_name.h"
#include "place_recognition/error.h"
#include "ros/messages/conversions.h"
#include "ros/messages/image_types.h"

namespace place_recognition {

const std_msgs::Header& ImageMessage::header() const {
  return std::visit([](const auto& message) -> const std_msgs::Header& { return message->header; },
                    message_);
}

std::string ImageMessage::topicSuffix() const {
  const bool compressed = std::holds_alternative<sensor_msgs::CompressedImageConstPtr>(message_);
  return compressed ? kCompressedSuffix : "";
}

cv::Mat ImageMessage::image() const {
  return std::visit([](const auto& message) { return toImage(*message); }, message_);
}

ImageInput::ImageInput(const ros::NodeHandle& node, const ros::NodeHandle& private_node,
                       Parameters& parameters, Callback callback, std::uint32_t queue,
                       std::string topic)
    : node_(node),
      private_node_(private_node),
      topic_(std::move(topic)),
      transport_name_(parameters.text("image_transport", "raw")),
      callback_(std::move(callback)),
      queue_(queue),
      transport_(node) {
  requireTransport(parameters);
}

void ImageInput::requireTransport(const Parameters& parameters) const {
  std::vector<std::string> known{"raw", "compressed"};
  if (contains(known, transport_name_)) return;
  std::string list = "raw, compressed";
  for (const std::string& plugin : transport_.getLoadableTransports()) {
    const std::string name = plugin.substr(plugin.find('/') + 1);  // after its package
    if (name == transport_name_) return;
    if (!contains(known, name)) list += ", " + name;
    known.push_back(name);
  }
  const std::string meant = nearestName(transport_name_, known);
  parameters.refuse("image_transport", "The parameter ~image_transport is '" + transport_name_ +
                                           "'; the installed transports are " + list + "." +
                                           (meant.empty() ? "" : " Did you mean " + meant + "?"));
}

void ImageInput::subscribe() {
  if (transport_name_ == "compressed") {
    // Like image_transport: a remapping of `image` also applies to its suffixes.
    compressed_subscriber_ =
        node_.subscribe(topic() + kCompressedSuffix, queue_, &ImageInput::onCompressed, this);
  } else {
    const image_transport::TransportHints hints("raw", ros::TransportHints(), private_node_);
    plugin_subscriber_ = transport_.subscribe(topic_, queue_, &ImageInput::onImage, this, hints);
  }
}

void ImageInput::unsubscribe() {
  plugin_subscriber_.shutdown();
  compressed_subscriber_.shutdown();
}

}  // namespace place_recognition
