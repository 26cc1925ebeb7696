#pragma once

#include <Eigen/Core>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <mutex>
#include <opencv2/core/mat.hpp>
#include <string>
#include <thread>
#include <vector>

#include "place_recognition/feature.h"
#include "place_recognition/model.h"
#include "place_recognition/training_options.h"
#include "recognition/frames/bounded_queue.h"
#include "recognition/frames/light.h"

namespace place_recognition {

/// The features of one image.
struct ExtractedFeatures {
  std::vector<Feature> features;  ///< one per cue
  Eigen::RowVector3d colour;      ///< logColour() in the light of the training
  std::string problem;            ///< why no cue could be extracted; empty if one could
};

/// Threads that extract features from the images submitted to them.
class ExtractionPool {
 public:
  ExtractionPool(const TrainingOptions& options, const ImageProfile& images, unsigned threads);
  ~ExtractionPool();

  /// Queues an image; cues that follow the light of the run multiply it by `light`. Waits while the
  /// queue is full. `result` must stay in memory and must not be touched before finish(). Throws
  /// what an extractor threw.
  void submit(const cv::Mat& image, ExtractedFeatures& result, const Light& light = {});

  /// Waits until every result is complete; more images may follow. Throws what an extractor threw.
  void finish();

 private:
  struct Job {
    cv::Mat image;
    ExtractedFeatures* result = nullptr;
    Light light;
  };

  void work(const TrainingOptions& options, const ImageProfile& images);
  void stop();
  void rethrowFailure();

  BoundedQueue<Job> queue_;
  std::vector<std::thread> threads_;
  std::mutex mutex_;  // of the following
  std::condition_variable changed_;
  std::size_t unfinished_ = 0;  // submitted images without a result
  std::exception_ptr failure_;
};

}  // namespace place_recognition
