#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "place_recognition/recording.h"

namespace place_recognition {

/// Counts the frames of a recording that cannot be used for training or evaluation.
class LeftOutFrames {
 public:
  /// Counts `frame` and returns true if it has no label, no image, or a uniform image.
  bool leavesOut(const Frame& frame);

  /// Counts a frame of `place` that cannot be used for another reason.
  void add(const std::string& place, const std::string& name, const std::string& problem);

  std::uint64_t count() const { return unlabelled_ + uniform_ + unusable_; }

  /// "NAME: problem" of the first frame of each place.
  const std::map<std::string, std::string>& firstProblems() const { return first_problems_; }

  /// The same for the first frame of all; empty if there is none.
  const std::string& firstProblem() const { return first_problem_; }

  /// What was left out of the recording with this name, one sentence per reason.
  std::vector<std::string> sentences(const std::string& recording) const;

 private:
  void note(const std::string& place, const std::string& problem);

  std::uint64_t unlabelled_ = 0;
  std::uint64_t uniform_ = 0;
  std::uint64_t unusable_ = 0;
  std::string first_uniform_;   // its name
  std::string first_unusable_;  // with its problem
  std::string first_problem_;
  std::map<std::string, std::string> first_problems_;
};

}  // namespace place_recognition
