#include "recognition/frames/image_guard.h"

#include <cmath>
#include <opencv2/core.hpp>
#include <utility>

#include "base/text.h"
#include "recognition/frames/image_profile.h"

namespace place_recognition {
namespace {

/// The same pixels in this many images and for this time, s, cannot come from a static camera,
/// whose noise would change them.
constexpr int kFrozenRepeats = 9;
constexpr double kFrozenTime = 3;
/// Limits of brightness for uniform images to be called black or white.
constexpr double kBlackest = 10;
constexpr double kWhitest = 245;
/// Relative differences between aspect ratios below this are due to rounding.
constexpr double kSameRatio = 0.02;
/// Images enlarged by more than this lack detail that the model uses.
constexpr double kHarmlessEnlargement = 1.1;

std::string text(cv::Size size) { return sizeText(size.width, size.height); }

double ratio(cv::Size size) { return static_cast<double>(size.width) / size.height; }

}  // namespace

ImageGuard::ImageGuard(const ImageProfile& trained, const ImageOptions& options, Use use)
    : use_(use), trained_(trained), scaler_(trained, options.max_width) {}

std::vector<std::string> ImageGuard::judge(const cv::Mat& image, double stamp) {
  problem_.clear();
  blind_ = false;
  news_.clear();
  const ImageStatistics statistics = statisticsOf(image);
  if (trained_.known()) {
    judgeSize(image.size());
    if (trained_.colour && !statistics.colour && !isUniform(statistics)) {
      fault(kGrey, "Images are grey, but the model was trained on colour images",
            "check the camera's encoding");
    } else if (trained_.includesImages() && !trained_.colour && statistics.colour) {
      fault(kColour, "Images are in colour, but the model was trained on grey images",
            "set the camera to grey, or train with its present images");
    }
  }
  if (isUniform(statistics)) judgeUniform(statistics.brightness);
  if (isFrozen(image, stamp)) {
    fault(kFrozen, "The camera sends the same image again and again", "check its driver");
  }
  return std::move(news_);
}

void ImageGuard::judgeSize(cv::Size size) {
  const cv::Size trained{trained_.width, trained_.height};
  const cv::Size used = scaler_.sizeFor(size);
  const bool learns = use_ == Use::kTraining;
  const std::string whose =
      learns ? ", the size that is learned" : ", the working size of the model";
  if (std::abs(ratio(size) / ratio(trained) - 1) > kSameRatio) {
    fault(kAspectRatio,
          "Images of " + text(size) + " have another aspect ratio than the " + text(trained) +
              (learns ? " that are learned" : " of the model"),
          learns ? "crop them to that ratio, or leave them out"
                 : "set the camera to that ratio, or train with its present one");
  } else if (used.width > kHarmlessEnlargement * size.width) {
    fault(kSize,
          "Images of " + text(size) + " are enlarged to " + text(used) + whose +
              ", and lack its finest detail",
          std::string(learns ? "leave them out" : "set the camera to that size") +
              ", or train with image.max_width=" + std::to_string(size.width));
  } else if (size != trained && size != used) {
    say(kSize, "Images of " + text(size) + " are scaled to " + text(used) + whose +
                   (learns ? " (that of the smallest run)." : "."));
  }
}

void ImageGuard::judgeUniform(double brightness) {
  if (brightness <= kBlackest) {
    fault(kBlack, "Images are black", "check the lens, the exposure and the light");
  } else if (brightness >= kWhitest) {
    fault(kWhite, "Images are white", "check the exposure");
  } else {
    fault(kOneColour, "Images show nothing but one colour", "check the lens and the cable");
  }
}

/// Two images count as equal if their sampledRows() are.
bool ImageGuard::isFrozen(const cv::Mat& image, double stamp) {
  const cv::Mat rows = sampledRows(image);
  const bool same = rows.size() == last_rows_.size() && rows.type() == last_rows_.type() &&
                    cv::norm(rows, last_rows_, cv::NORM_INF) == 0;
  if (same) {
    ++repeats_;
  } else {
    rows.copyTo(last_rows_);
    repeats_ = 0;
    same_since_ = stamp;
  }
  return repeats_ >= kFrozenRepeats && stamp - same_since_ >= kFrozenTime;
}

void ImageGuard::fault(Kind kind, const std::string& what, const std::string& advice) {
  problem_ += (problem_.empty() ? "" : "; ") + what;
  blind_ |= kind >= kBlack;
  say(kind, what + "; " + advice + ".");
}

void ImageGuard::say(Kind kind, const std::string& sentence) {
  if (said_[kind]) return;
  said_[kind] = true;
  news_.push_back(sentence);
}

}  // namespace place_recognition
