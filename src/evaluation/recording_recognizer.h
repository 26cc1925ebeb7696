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

/// Largest gap between two parts of a split recording, s: a message or two.
constexpr double kMaxGapOfParts = 2;

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

  /// Whether the recording, of which a frame was judged or recognized, has the cameras of the
  /// previous one and starts less than kMaxGapOfParts after its end.
  bool continues() const { return continues_; }

  /// New remarks about the image of `frame`, see ImageGuard.
  std::vector<std::string> judge(const Frame& frame);

  /// The answer to the image of `frame`; valid until the next call.
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
  void beginAt(double stamp);

  std::shared_ptr<const Model> model_;
  std::vector<std::string> cameras_{""};  // of the recording
  std::vector<Recognizer>
      recognizers_;                 // one per camera at least; they serve one run after another
  std::vector<ImageGuard> guards_;  // one per camera
  TemporalFilter filter_;           // of the recording
  FixedLagSmoother smoother_;
  bool starts_ = false;  // no frame of the recording has come
  bool may_continue_ = false;
  bool continues_ = false;
  double last_stamp_ = 0;
};

}  // namespace place_recognition
