#include "recognition/training/repeated_images.h"

#include "base/text.h"

namespace place_recognition {

void RepeatedImages::begin(const std::string& input, bool continues) {
  inputs_.push_back(input);
  recording_ = continues ? last_recording_ : ++recordings_;
  images_ = 0;
  repeated_ = 0;
  sources_.assign(inputs_.size(), false);
}

bool RepeatedImages::isRepeated(const std::optional<std::uint64_t>& hash, bool labelled) {
  ++images_;
  if (hash) {
    const std::size_t input = inputs_.size() - 1;
    const auto [entry, is_new] = shown_.insert({*hash, {input, recording_, labelled}});
    Shown& shown = entry->second;
    const bool elsewhere = shown.input != input && shown.recording != recording_;
    if (!is_new && elsewhere && (shown.labelled || !labelled)) {
      ++repeated_;
      sources_[shown.input] = true;
      return true;
    }
    if (labelled && !shown.labelled) shown = {input, recording_, true};
  }
  last_recording_ = recording_;
  return false;
}

std::string RepeatedImages::sentence() const {
  if (repeated_ == 0) return "";
  std::vector<std::string> sources;
  for (std::size_t i = 0; i < sources_.size(); ++i) {
    if (sources_[i]) sources.push_back(inputs_[i]);
  }
  return inputs_.back() + ": " + std::to_string(repeated_) + " of " + counted(images_, "image") +
         (repeated_ == 1 ? " is that of " : " are those of ") + listed(sources) +
         "; they count once.";
}

}  // namespace place_recognition
