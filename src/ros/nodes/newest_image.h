#pragma once

#include <place_recognition/PlaceRecognition.h>

#include <chrono>
#include <condition_variable>
#include <deque>
#include <future>
#include <mutex>
#include <optional>
#include <utility>
#include <variant>

#include "ros/nodes/image_input.h"

namespace place_recognition {

/// An image and when it came.
struct ArrivedImage {
  ImageMessage message;
  std::chrono::steady_clock::time_point arrival;
};

/// A picture that somebody asks about, and where the answer goes.
struct Question {
  ImageMessage message;
  std::promise<PlaceRecognition> answer;
};

using Work = std::variant<ArrivedImage, Question>;

/// Hands images from the thread that receives them to the one that works on them. Holds one at
/// most: while the worker is busy, the newest takes the place of the one before. Questions, for
/// which somebody waits, go first and none is lost. Thread-safe.
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

  /// The answer comes in the worker's turn; std::future_error after close().
  std::future<PlaceRecognition> ask(const ImageMessage& message) {
    const std::lock_guard<std::mutex> lock(mutex_);
    Question question{message, {}};
    std::future<PlaceRecognition> answer = question.answer.get_future();
    if (!closed_) questions_.push_back(std::move(question));
    changed_.notify_one();
    return answer;
  }

  /// Waits for work; nothing after close().
  std::optional<Work> take() {
    std::unique_lock<std::mutex> lock(mutex_);
    changed_.wait(lock, [this] { return image_ || !questions_.empty() || closed_; });
    if (closed_) return std::nullopt;
    std::optional<Work> taken;
    if (questions_.empty()) {
      taken = std::move(*image_);
      image_.reset();
    } else {
      taken = std::move(questions_.front());
      questions_.pop_front();
    }
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
    questions_.clear();
    changed_.notify_all();
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  std::optional<ArrivedImage> image_;
  std::deque<Question> questions_;
  bool closed_ = false;
};

}  // namespace place_recognition
