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

/// What became of the images of one camera, for diagnostics. Once in each silence of the camera it
/// also logs what may be wrong. Thread-safe.
class ImageStatus {
 public:
  using Clock = std::chrono::steady_clock;
  using Report = diagnostic_updater::DiagnosticStatusWrapper;

  /// `input` must outlive it.
  ImageStatus(Parameters& parameters, const ImageInput& input);

  void listening(bool subscribed);  ///< no image is missed while the node does not listen
  void arrived();
  void skipped();  ///< a newer image came before its turn
  void leftOut();  ///< by the limit of the rate
  void unusable(const std::string& problem);
  /// What is wrong with the last image, see ImageGuard; empty: nothing.
  void judged(const std::string& problem);
  /// An image was answered without a place, for this reason.
  void saidNothing(const std::string& reason);
  /// So many cues were not computed for an image.
  void held(std::size_t cues);
  /// How the images differ from those of the training, as the answers so far tell, see Recognizer.
  void followed(const Light& correction, double evidence_shift);
  /// Why answers do not count for ~place, as long as it lasts; empty: they do.
  void notCounted(const std::string& why);
  /// An answer was published to the image of `stamp` that came at `arrival`.
  void answered(const ros::Time& stamp, Clock::time_point arrival);

  void report(Report& report);
  void warnOfSilence();

 private:
  /// What happened since the last report.
  struct Recent {
    int images = 0;
    int unusable = 0;
    int answers = 0;
    double latency_sum = 0;  ///< s
    double latency_max = 0;
  };

  void summarize(const Recent& recent, double silence, Report& report) const;
  /// Whether a silence has become worth a warning just now.
  bool silenceBegins();

  const ImageInput& input_;
  const double timeout_;        // s without an image that are worth a warning; 0: none
  const double max_image_age_;  // s between stamp and answer; 0: any, as in a replay

  std::mutex mutex_;  // of all below
  Recent recent_;
  std::uint64_t skipped_ = 0;
  std::uint64_t left_out_ = 0;
  std::uint64_t unusable_ = 0;
  std::uint64_t said_nothing_ = 0;
  std::uint64_t answers_ = 0;
  std::uint64_t with_held_cues_ = 0;
  std::string last_problem_;
  std::string last_silence_;   // why an image said nothing
  std::string image_problem_;  // as long as it lasts, as the next one
  std::string not_counted_;
  double last_age_ = 0;  // s, of the image last answered
  Light light_correction_;
  double evidence_shift_ = 0;
  bool listening_ = false;
  bool warned_of_silence_ = false;
  Clock::time_point last_arrival_ = Clock::now();
  Clock::time_point last_report_ = Clock::now();
};

}  // namespace place_recognition
