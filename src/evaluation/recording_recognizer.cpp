#include "evaluation/recording_recognizer.h"

namespace place_recognition {

RecordingRecognizer::RecordingRecognizer(std::shared_ptr<const Model> model)
    : model_(std::move(model)),
      guards_(1, ImageGuard(*model_)),
      filter_(*model_, model_->adjacency, {}),
      smoother_(model_->adjacency, {}, kSmoothingLag) {
  recognizers_.emplace_back(model_);
}

void RecordingRecognizer::begin(Recording& recording) {
  recording.setLevelRange(model_->images.levels);
  cameras_ = recording.cameras();
  continuity_.begin(cameras_);
}

void RecordingRecognizer::take(const Frame& frame) {
  if (!continuity_.beginsStream(frame)) return;
  while (recognizers_.size() < cameras_.size()) recognizers_.emplace_back(model_);
  for (Recognizer& recognizer : recognizers_) recognizer.forgetStream();
  guards_.assign(cameras_.size(), ImageGuard(*model_));
  filter_ = TemporalFilter(std::vector<const Model*>(cameras_.size(), model_.get()),
                           coefficientsFor(cameras_, model_->cameras), model_->adjacency, {});
}

std::vector<std::string> RecordingRecognizer::judge(const Frame& frame) {
  std::vector<std::string> sentences =
      guards_[static_cast<std::size_t>(frame.camera)].judge(frame.image, frame.stamp);
  if (cameras_.size() > 1) {
    const std::string& camera = cameras_[static_cast<std::size_t>(frame.camera)];
    for (std::string& sentence : sentences) sentence.insert(0, camera + ": ");
  }
  return sentences;
}

const Recognition& RecordingRecognizer::recognize(const Frame& frame) {
  return recognizers_[static_cast<std::size_t>(frame.camera)].recognize(frame.image, frame.stamp);
}

const FilteredAnswer& RecordingRecognizer::follow(const Frame& frame,
                                                  const Recognition& recognition) {
  const FilteredAnswer& answer = filter_.update(frame.stamp, recognition, std::nullopt,
                                                static_cast<std::size_t>(frame.camera));
  smoother_.add(filter_);
  return answer;
}

}  // namespace place_recognition
