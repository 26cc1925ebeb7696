#pragma once

#include <memory>
#include <string>
#include <vector>

#include "place_recognition/fixed_lag_smoother.h"
#include "place_recognition/recognizer.h"
#include "place_recognition/recording.h"
#include "place_recognition/temporal_filter.h"
#include "recognition/frames/image_guard.h"

namespace place_recognition {

/// How long the smoothed answer waits, s.
constexpr double kSmoothingLag = 1;

/// Answers the frames of runs as the node place_recognizer does, one at a time: each camera has a
/// light and a guard of its own, and what they say joins in the answers over time. Not thread-safe.
class RecordingRecognizer {
 public:
  explicit RecordingRecognizer(std::shared_ptr<const Model> model);

  /// Frames of `recording` follow, which has not been read from; nothing of the recording before
  /// counts.
  void begin(Recording& recording);

  /// What is to be said about the image of `frame` and has not been said before: ImageGuard.
  std::vector<std::string> judge(const Frame& frame);

  /// The answer to the image of `frame` alone; valid until the next call.
  const Recognition& recognize(const Frame& frame);

  /// The same for an image by itself, which is of no run.
  const Recognition& recognizeImage(const cv::Mat& image) {
    return recognizers_.front().recognize(image);
  }

  /// The answer over time after that frame, `recognition`, which the smoother then waits for.
  const FilteredAnswer& follow(const Frame& frame, const Recognition& recognition);

  FixedLagSmoother& smoother() { return smoother_; }
  const Model& model() const { return *model_; }

 private:
  std::shared_ptr<const Model> model_;
  std::vector<std::string> cameras_{""};  // of the recording
  std::vector<Recognizer>
      recognizers_;                 // one per camera at least; they serve one run after another
  std::vector<ImageGuard> guards_;  // one per camera
  TemporalFilter filter_;           // of the recording
  FixedLagSmoother smoother_;
};

}  // namespace place_recognition
