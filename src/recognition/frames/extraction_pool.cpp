#include "recognition/frames/extraction_pool.h"

#include <system_error>

#include "base/parallel.h"
#include "recognition/frames/cue_extraction.h"

namespace place_recognition {

ExtractionPool::ExtractionPool(const TrainingOptions& options, const ImageProfile& images,
                               unsigned threads)
    : queue_(2 * threadCount(threads)) {
  try {
    for (unsigned i = 0; i < threadCount(threads); ++i) {
      threads_.emplace_back([this, options, images] { work(options, images); });
    }
  } catch (const std::system_error&) {
    if (threads_.empty()) throw;  // else these do all the work
  }
}

ExtractionPool::~ExtractionPool() { stop(); }

void ExtractionPool::submit(const cv::Mat& image, ExtractedFeatures& result, const Light& light) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    ++unfinished_;
  }
  if (!queue_.push({image, &result, light})) rethrowFailure();
}

void ExtractionPool::finish() {
  {
    std::unique_lock<std::mutex> lock(mutex_);
    changed_.wait(lock, [this] { return unfinished_ == 0 || failure_; });
  }
  rethrowFailure();
}

void ExtractionPool::work(const TrainingOptions& options, const ImageProfile& images) {
  try {
    CueExtraction extraction(options, images);
    for (Job job; queue_.pop(job);) {
      if (!extraction.extract(job.image, job.result->features, job.light)) {
        job.result->problem = extraction.reason();
      }
      job.result->colour = extraction.colour() + logGains(job.light);
      const std::lock_guard<std::mutex> lock(mutex_);
      --unfinished_;
      changed_.notify_all();
    }
  } catch (...) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!failure_) failure_ = std::current_exception();
    changed_.notify_all();
    queue_.close();
  }
}

void ExtractionPool::stop() {
  queue_.close();
  for (std::thread& thread : threads_) {
    if (thread.joinable()) thread.join();
  }
}

void ExtractionPool::rethrowFailure() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (failure_) std::rethrow_exception(failure_);
}

}  // namespace place_recognition
