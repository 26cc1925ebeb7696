#include "tuning/thinned_recording.h"

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "recognition/training/sampling.h"

namespace place_recognition {
namespace {

class ThinnedRecording : public Recording {
 public:
  ThinnedRecording(std::unique_ptr<Recording> recording, std::size_t step, std::uint64_t seed)
      : Recording(recording->name()), recording_(std::move(recording)), step_(step), seed_(seed) {
    warnings_ = recording_->warnings();
  }

  bool next(Frame& frame) override {
    while (recording_->next(frame)) {
      if (!frame.place.empty() && streamOf(frame.place).keepsNext()) return true;
    }
    warnings_ = recording_->warnings();
    return false;
  }

  std::vector<std::string> cameras() const override { return recording_->cameras(); }

  cv::Size usualSize() override { return recording_->usualSize(); }
  std::string howToLabel() const override { return recording_->howToLabel(); }

  void setLevelRange(const LevelRange& range) override { recording_->setLevelRange(range); }
  LevelRange levelRange() const override { return recording_->levelRange(); }
  double fraction() const override { return recording_->fraction(); }

 private:
  StratifiedStream& streamOf(const std::string& place) {
    return streams_.try_emplace(place, step_, seed_ + streams_.size()).first->second;
  }

  std::unique_ptr<Recording> recording_;
  std::size_t step_;
  std::uint64_t seed_;
  std::map<std::string, StratifiedStream> streams_;  // by place
};

}  // namespace

std::unique_ptr<Recording> thinOut(std::unique_ptr<Recording> recording, std::size_t step,
                                   std::uint64_t seed) {
  return std::make_unique<ThinnedRecording>(std::move(recording), step, seed);
}

}  // namespace place_recognition
