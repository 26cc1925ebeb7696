#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>

#include "ros/image_input.h"

namespace place_recognition {

/// An image and when it came.
struct ArrivedImage {
  ImageMessage message;
  std::chrono::steady_clock::time_point arrival;
};

/// Hands images from the thread that receives them to the one that works on them. Holds one at
/// most: while the worker is busy, the newest takes the place of the one before. Thread-safe.
class NewestImage {
 public:
  /// False: an image that nobody has taken was replaced.
  bool put(const ImageMessage& message) {
    const std::lock_guard<std::mutex> lock(mutex_);
    const bool free = !image_;
    image_ = ArrivedImage{message, std::chrono::steady_clock::now()};
    changed_.notify_one();
    return free;
  }

  /// Waits for an image; nothing after close().
  std::optional<ArrivedImage> take() {
    std::unique_lock<std::mutex> lock(mutex_);
    changed_.wait(lock, [this] { return image_ || closed_; });
    if (closed_) return std::nullopt;
    std::optional<ArrivedImage> taken;
    taken.swap(image_);
    return taken;
  }

  /// Forgets the image that waits.
  void clear() {
    const std::lock_guard<std::mutex> lock(mutex_);
    image_.reset();
  }

  void close() {
    const std::lock_guard<std::mutex> lock(mutex_);
    closed_ = true;
    changed_.notify_all();
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  std::optional<ArrivedImage> image_;
  bool closed_ = false;
};

}  // namespace place_recognition
