#pragma once

#include <ros/ros.h>

#include <boost/function.hpp>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "eventually.h"

namespace place_recognition {

/// Collects the messages of a topic. Requires a spinner in another thread.
template <typename Message>
class Inbox {
 public:
  Inbox(ros::NodeHandle& node, const std::string& topic) {
    const boost::function<void(const boost::shared_ptr<const Message>&)> receive =
        [this](const boost::shared_ptr<const Message>& message) {
          const std::lock_guard<std::mutex> lock(mutex_);
          messages_.push_back(*message);
        };
    subscriber_ = node.subscribe<Message>(topic, 1000, receive);
  }

  std::vector<Message> messages() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return messages_;
  }

  /// Returns the first message, already received or still to come, that `matches`.
  template <typename Matches>
  std::optional<Message> find(Matches matches, double seconds = 15) const {
    std::optional<Message> found;
    eventually(
        [&] {
          for (const Message& message : messages()) {
            if (!found && matches(message)) found = message;
          }
          return found.has_value();
        },
        seconds);
    return found;
  }

  void clear() {
    const std::lock_guard<std::mutex> lock(mutex_);
    messages_.clear();
  }

  bool connected() const { return subscriber_.getNumPublishers() > 0; }

 private:
  mutable std::mutex mutex_;
  std::vector<Message> messages_;
  ros::Subscriber subscriber_;
};

}  // namespace place_recognition
