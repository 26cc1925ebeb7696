#include "ros/localization/held_room.h"

#include "base/text.h"
#include "ros/nodes/seconds_between.h"

namespace place_recognition {
namespace {

/// The probability of the named room, against the other rooms and 'unknown'.
double probabilityOfPlace(const PlaceRecognition& belief) {
  return belief.confidence * belief.evidence;
}

}  // namespace

void HeldRoom::forget() {
  belief_.reset();
  since_ = ros::Time();
}

void HeldRoom::add(const PlaceRecognition& belief, const ros::Time& now) {
  const bool follows = !isMissing(now);
  const bool likely = belief.known && probabilityOfPlace(belief) >= options_.min_probability;
  const bool held = follows && likely && !since_.isZero() && belief_->place == belief.place;
  if (!held) since_ = likely ? now : ros::Time();
  belief_ = belief;
  arrival_ = now;
}

bool HeldRoom::isMissing(const ros::Time& now) const {
  if (!belief_) return true;
  return options_.timeout > 0 && secondsBetween(arrival_, now) > options_.timeout;
}

std::string HeldRoom::sureRoom(const ros::Time& now) const {
  return whyNot(now).empty() ? belief_->place : "";
}

std::string HeldRoom::whyNot(const ros::Time& now) const {
  if (!belief_) return "no answer of place_recognizer has arrived";
  if (isMissing(now)) {
    return "the last answer of place_recognizer arrived " +
           fixed(secondsBetween(arrival_, now), 2) + " s ago";
  }
  if (!belief_->known) return "the answer is 'unknown'";
  if (since_.isZero()) {
    return "'" + belief_->place + "' has a probability of " +
           fixed(probabilityOfPlace(*belief_), 2) + ", less than ~min_probability";
  }
  const double held = secondsBetween(since_, now);
  if (held < options_.hold) {
    return "'" + belief_->place + "' has been certain for " + fixed(held, 2) +
           " s, less than ~hold";
  }
  return "";
}

double HeldRoom::probabilityOf(const std::string& room, const ros::Time& now) const {
  if (isMissing(now)) return 0;
  for (const PlaceScore& place : belief_->places) {
    if (place.name == room) return place.probability * belief_->evidence;
  }
  return 0;
}

}  // namespace place_recognition
