#include "recognition/frames/left_out_frames.h"

#include "base/text.h"
#include "recognition/frames/image_profile.h"

namespace place_recognition {

bool LeftOutFrames::leavesOut(const Frame& frame) {
  if (frame.place.empty()) {
    ++unlabelled_;
  } else if (frame.image.empty()) {
    add(frame.place, frame.name, frame.problem);
  } else if (isUniform(statisticsOf(frame.image))) {
    if (uniform_++ == 0) first_uniform_ = frame.name;
    note(frame.place, frame.name + ": it " + kUniformProblem);
  } else {
    return false;
  }
  return true;
}

void LeftOutFrames::add(const std::string& place, const std::string& name,
                        const std::string& problem) {
  if (unusable_++ == 0) first_unusable_ = name + ": " + problem;
  note(place, name + ": " + problem);
}

void LeftOutFrames::note(const std::string& place, const std::string& problem) {
  if (first_problem_.empty()) first_problem_ = problem;
  first_problems_.emplace(place, problem);
}

std::vector<std::string> LeftOutFrames::sentences(const std::string& recording) const {
  std::vector<std::string> sentences;
  const auto say = [&](std::uint64_t count, const std::string& why) {
    if (count == 0) return;
    sentences.push_back(recording + ": " + counted(count, "image") + " " + why +
                        (count == 1 ? " is" : " are") + " left out.");
  };
  say(unlabelled_, "without a label");
  say(uniform_, "of a single colour, as from a covered lens (the first: " + first_uniform_ + ")");
  say(unusable_, "that cannot be used (" + first_unusable_ + ")");
  return sentences;
}

}  // namespace place_recognition
