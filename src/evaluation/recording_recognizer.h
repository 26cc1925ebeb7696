#pragma once

#include <memory>
#include <string>
#include <vector>

#include "place_recognition/fixed_lag_smoother.h"
#include "place_recognition/recognizer.h"
#include "place_recognition/recording.h"
#include "place_recognition/temporal_filter.h"
#include "recognition/frames/continuity.h"
#include "recognition/frames/image_guard.h"

namespace place_recognition {

/// Delay of the smoothed answer, s.
constexpr double kSmoothingLag = 1;

/// Recognizes the frames of recordings as the node place_recognizer does, one at a time. Each
/// camera has its own light and guard; their answers are combined over time. Not thread-safe.
class RecordingRecognizer {
 public:
  explicit RecordingRecognizer(std::shared_ptr<const Model> model);

  /// Begins `recording`, which has not been read from. Its first frame discards everything about
  /// the previous recording, unless it continues that one.
  void begin(Recording& recording);

  /// Takes the next frame of the recording, whether it is then judged and recognized or not.
  void take(const Frame& frame);

  /// See Continuity.
  bool continues() const { return continuity_.continues(); }

  /// New remarks about the image of the frame taken last, see ImageGuard.
  std::vector<std::string> judge(const Frame& frame);

  /// The answer to the image of the frame taken last; valid until the next call.
  const Recognition& recognize(const Frame& frame);

  /// The same for a single image outside of any recording.
  const Recognition& recognizeImage(const cv::Mat& image) {
    return recognizers_.front().recognize(image);
  }

  /// The answer over time after that frame, given its `recognition`; also adds the frame to
  /// smoother().
  const FilteredAnswer& follow(const Frame& frame, const Recognition& recognition);

  FixedLagSmoother& smoother() { return smoother_; }
  const Model& model() const { return *model_; }

 private:
  std::shared_ptr<const Model> model_;
  std::vector<std::string> cameras_{""};  // of the recording
  Continuity continuity_;
  std::vector<Recognizer>
      recognizers_;                 // one per camera at least; they serve one run after another
  std::vector<ImageGuard> guards_;  // one per camera
  TemporalFilter filter_;           // of the recording
  FixedLagSmoother smoother_;
};

}  // namespace place_recognition
