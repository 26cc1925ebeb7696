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
#include <vector>

#include "ros/nodes/image_input.h"

namespace place_recognition {

/// An image and its time of arrival.
struct ArrivedImage {
  ImageMessage message;
  std::chrono::steady_clock::time_point arrival;
  std::size_t camera;  ///< of the image
};

/// A request for the answer to a given image.
struct Question {
  ImageMessage message;
  std::promise<PlaceRecognition> answer;
};

using Work = std::variant<ArrivedImage, Question>;

/// Passes work from the threads that receive it to the thread that does it. Holds at most one image
/// per camera: while the worker is busy, the newest replaces the previous one, and the cameras take
/// turns. Questions, for which somebody waits, go first, and none is lost. Thread-safe.
class WorkQueue {
 public:
  explicit WorkQueue(std::size_t cameras = 1) : images_(cameras) {}

  /// False if an image that was not taken yet is replaced.
  bool put(const ImageMessage& message, std::size_t camera = 0) {
    const std::lock_guard<std::mutex> lock(mutex_);
    std::optional<ArrivedImage>& image = images_[camera];
    const bool free = !image;
    image = ArrivedImage{message, std::chrono::steady_clock::now(), camera};
    changed_.notify_one();
    return free;
  }

  /// The answer arrives when the worker reaches the question; std::future_error after close().
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
    std::optional<ArrivedImage>* image = nullptr;
    changed_.wait(lock, [&] {
      image = nextImage();
      return image != nullptr || !questions_.empty() || closed_;
    });
    if (closed_) return std::nullopt;
    std::optional<Work> taken;
    if (questions_.empty()) {
      last_ = (*image)->camera;
      taken = std::move(**image);
      image->reset();
    } else {
      taken = std::move(questions_.front());
      questions_.pop_front();
    }
    return taken;
  }

  /// Discards the waiting images.
  void clear() {
    const std::lock_guard<std::mutex> lock(mutex_);
    for (std::optional<ArrivedImage>& image : images_) image.reset();
  }

  void close() {
    const std::lock_guard<std::mutex> lock(mutex_);
    closed_ = true;
    questions_.clear();
    changed_.notify_all();
  }

 private:
  /// The image of the next camera in turn that has one; null if none has.
  std::optional<ArrivedImage>* nextImage() {
    for (std::size_t i = 1; i <= images_.size(); ++i) {
      std::optional<ArrivedImage>& image = images_[(last_ + i) % images_.size()];
      if (image) return &image;
    }
    return nullptr;
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<std::optional<ArrivedImage>> images_;
  std::size_t last_ = 0;  // camera of the last image taken
  std::deque<Question> questions_;
  bool closed_ = false;
};

}  // namespace place_recognition
