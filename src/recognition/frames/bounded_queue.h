#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <mutex>
#include <utility>

namespace place_recognition {

/// A queue between threads with limited capacity, so that a fast producer waits for slow consumers
/// instead of filling the memory.
template <typename T>
class BoundedQueue {
 public:
  explicit BoundedQueue(std::size_t capacity) : capacity_(capacity) {}

  /// Waits for room; false, dropping the element, if the queue is closed.
  bool push(T element) {
    std::unique_lock<std::mutex> lock(mutex_);
    changed_.wait(lock, [this] { return closed_ || elements_.size() < capacity_; });
    if (closed_) return false;
    elements_.push_back(std::move(element));
    changed_.notify_all();
    return true;
  }

  /// Waits for an element; false if the queue is closed and empty.
  bool pop(T& element) {
    std::unique_lock<std::mutex> lock(mutex_);
    changed_.wait(lock, [this] { return closed_ || !elements_.empty(); });
    if (elements_.empty()) return false;
    element = std::move(elements_.front());
    elements_.pop_front();
    changed_.notify_all();
    return true;
  }

  /// Rejects further elements; those inside can still be taken.
  void close() {
    const std::lock_guard<std::mutex> lock(mutex_);
    closed_ = true;
    changed_.notify_all();
  }

 private:
  const std::size_t capacity_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<T> elements_;
  bool closed_ = false;
};

}  // namespace place_recognition
