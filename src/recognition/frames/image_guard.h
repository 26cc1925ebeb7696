#pragma once

#include <array>
#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "place_recognition/model.h"
#include "recognition/frames/image_scaling.h"

namespace place_recognition {

/// Watches the images of one camera or run for problems that make answers unreliable without
/// showing in them: images unlike the training images, and a camera that shows nothing. Cheap: it
/// reads a few rows of each image. Not thread-safe.
class ImageGuard {
 public:
  /// What the images are for, on which the advice depends.
  enum class Use { kRecognition, kTraining };

  explicit ImageGuard(const Model& model) : ImageGuard(model.images, model.options.image) {}
  ImageGuard(const ImageProfile& trained, const ImageOptions& options, Use use = Use::kRecognition);

  /// Judges the next image (CV_8UC3 or CV_8UC1, not empty), with its `stamp`, s. Returns new
  /// remarks, not made about an earlier image: sentences for a person.
  std::vector<std::string> judge(const cv::Mat& image, double stamp);

  /// The problem of the last image, without a full stop; empty if none.
  const std::string& problem() const { return problem_; }

  /// Whether the camera shows nothing: the last image was uniform, or repeated too often.
  bool blind() const { return blind_; }

 private:
  enum Kind { kSize, kAspectRatio, kGrey, kColour, kBlack, kWhite, kOneColour, kFrozen, kKinds };

  void judgeSize(cv::Size size);
  void judgeUniform(double brightness);
  bool isFrozen(const cv::Mat& image, double stamp);
  /// Reports the problem `what`, and once, with `advice`, as a remark.
  void fault(Kind kind, const std::string& what, const std::string& advice);
  void say(Kind kind, const std::string& sentence);

  Use use_;
  ImageProfile trained_;
  ImageScaler scaler_;
  std::array<bool, kKinds> said_{};
  std::string problem_;
  bool blind_ = false;
  std::vector<std::string> news_;
  cv::Mat last_rows_;      // sampledRows() of the last image
  int repeats_ = 0;        // number of images before it with the same rows
  double same_since_ = 0;  // s
};

}  // namespace place_recognition
