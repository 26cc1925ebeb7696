#pragma once

#include <place_recognition/PlaceRecognition.h>
#include <ros/time.h>

#include <optional>
#include <string>

namespace place_recognition {

/// Determines whether the answers over time (`~belief`) favour one room, and have done so for long
/// enough. `now` is the time at which an answer arrives or is requested; it never decreases, except
/// by forget(). Not thread-safe.
class HeldRoom {
 public:
  struct Options {
    double min_probability = 0;  ///< of a room, against the other rooms and 'unknown', 0..1
    double hold = 0;             ///< s for which it must have had it
    double timeout = 0;          ///< s after which the next answer counts as missing; 0: never
  };

  explicit HeldRoom(const Options& options) : options_(options) {}

  /// Forgets all answers.
  void forget();
  void add(const PlaceRecognition& belief, const ros::Time& now);

  /// The certain room. Empty if there is none, for the reason that whyNot() returns.
  std::string sureRoom(const ros::Time& now) const;
  /// The reason, such as "the answer is 'unknown'"; empty if a room is certain.
  std::string whyNot(const ros::Time& now) const;

  /// The current probability of a room; 0 if no answer has arrived in time, or if the model does
  /// not know the room.
  double probabilityOf(const std::string& room, const ros::Time& now) const;

 private:
  bool isMissing(const ros::Time& now) const;

  Options options_;
  std::optional<PlaceRecognition> belief_;  // the last one
  ros::Time arrival_;                       // of it
  ros::Time since_;  // since when its room is probable enough; zero: it is not
};

}  // namespace place_recognition
