#pragma once

#include <place_recognition/PlaceRecognition.h>
#include <ros/time.h>

#include <optional>
#include <string>

namespace place_recognition {

/// Whether the answers over time (`~belief`) speak for one room, and have done so for long enough.
/// `now` is when an answer comes, or is asked for; it never falls but for forget(). Not
/// thread-safe.
class HeldRoom {
 public:
  struct Options {
    double min_probability = 0;  ///< of a room, against the other rooms and 'unknown', 0..1
    double hold = 0;             ///< s that it must have had it
    double timeout = 0;          ///< s after which the next answer counts as missing
  };

  explicit HeldRoom(const Options& options) : options_(options) {}

  /// Forgets all answers.
  void forget();
  void add(const PlaceRecognition& belief, const ros::Time& now);

  /// The room that is sure. Empty: none is, for the reason that whyNot() tells.
  std::string sureRoom(const ros::Time& now) const;
  /// As in "the answer is 'unknown'"; empty: a room is sure.
  std::string whyNot(const ros::Time& now) const;

  /// The probability of a room now; 0 if no answer has come in time, or if the model does not know
  /// the room.
  double probabilityOf(const std::string& room, const ros::Time& now) const;

 private:
  bool isMissing(const ros::Time& now) const;

  Options options_;
  std::optional<PlaceRecognition> belief_;  // the last one
  ros::Time arrival_;                       // of it
  ros::Time since_;                         // its room is likely enough; zero: it is not
};

}  // namespace place_recognition
