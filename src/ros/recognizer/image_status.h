#pragma once

#include <diagnostic_updater/DiagnosticStatusWrapper.h>
#include <ros/time.h>

#include <chrono>
#include <cstdint>
#include <mutex>
#include <string>

#include "place_recognition/light.h"
#include "ros/nodes/image_input.h"
#include "ros/nodes/parameters.h"

namespace place_recognition {

/// Tracks what happens to the images of one camera, for diagnostics. Once in each silence of the
/// camera it also logs the possible cause. Thread-safe.
class ImageStatus {
 public:
  using Clock = std::chrono::steady_clock;
  using Report = diagnostic_updater::DiagnosticStatusWrapper;

  /// `input` must outlive it.
  ImageStatus(Parameters& parameters, const ImageInput& input);

  void listening(bool subscribed);  ///< while false, the node does not expect images
  void arrived();
  void skipped();  ///< replaced by a newer image before its turn
  void leftOut();  ///< because of the rate limit
  void unusable(const std::string& problem);
  /// What is wrong with the last image, see ImageGuard; empty if nothing.
  void judged(const std::string& problem);
  /// An image was answered without a place, for this reason.
  void answeredNothing(const std::string& reason);
  /// This number of cues was not computed for an image.
  void held(std::size_t cues);
  /// The difference of the images from those of the training, estimated from the answers so far,
  /// see Recognizer.
  void followed(const Light& correction, double evidence_shift);
  /// Why answers are not used for ~place, as long as that is so; empty if they are.
  void notCounted(const std::string& why);
  /// An answer was published to the image with `stamp` that arrived at `arrival`.
  void answered(const ros::Time& stamp, Clock::time_point arrival);

  void report(Report& report);
  void warnOfSilence();

 private:
  /// Counts since the last report.
  struct Recent {
    int images = 0;
    int unusable = 0;
    int answers = 0;
    double latency_sum = 0;  ///< s
    double latency_max = 0;
  };

  void summarize(const Recent& recent, double silence, Report& report) const;
  /// Whether a silence has just become long enough for a warning.
  bool silenceBegins();

  const ImageInput& input_;
  const double timeout_;        // s without an image until a warning; 0: none
  const double max_image_age_;  // s between stamp and answer; 0: no limit, for a replay

  std::mutex mutex_;  // guards everything below
  Recent recent_;
  std::uint64_t skipped_ = 0;
  std::uint64_t left_out_ = 0;
  std::uint64_t unusable_ = 0;
  std::uint64_t answered_nothing_ = 0;
  std::uint64_t answers_ = 0;
  std::uint64_t with_held_cues_ = 0;
  bool last_unusable_ = false;  // whether the last image was unusable
  std::string last_problem_;
  std::string last_nothing_;   // why an image was answered without a place
  std::string image_problem_;  // current, likewise the next one
  std::string not_counted_;
  double last_age_ = 0;  // s, of the last image answered
  Light light_correction_;
  double evidence_shift_ = 0;
  bool listening_ = false;
  bool warned_of_silence_ = false;
  Clock::time_point last_arrival_ = Clock::now();
  Clock::time_point last_report_ = Clock::now();
};

}  // namespace place_recognition
