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
  recording.setDepthExtent(model_->images.depth);
  may_continue_ = !starts_ && last_stamp_ > 0 && recording.cameras() == cameras_;
  cameras_ = recording.cameras();
  starts_ = true;
  continues_ = false;
}

void RecordingRecognizer::beginAt(double stamp) {
  if (!starts_) return;
  starts_ = false;
  continues_ = may_continue_ && stamp > last_stamp_ && stamp - last_stamp_ <= kMaxGapOfParts;
  if (continues_) return;
  while (recognizers_.size() < cameras_.size()) recognizers_.emplace_back(model_);
  for (Recognizer& recognizer : recognizers_) recognizer.forgetStream();
  guards_.assign(cameras_.size(), ImageGuard(*model_));
  filter_ = TemporalFilter(std::vector<const Model*>(cameras_.size(), model_.get()),
                           coefficientsFor(cameras_, model_->cameras), model_->adjacency, {});
}

std::vector<std::string> RecordingRecognizer::judge(const Frame& frame) {
  beginAt(frame.stamp);
  std::vector<std::string> sentences =
      guards_[static_cast<std::size_t>(frame.camera)].judge(frame.image, frame.stamp);
  if (cameras_.size() > 1) {
    const std::string& camera = cameras_[static_cast<std::size_t>(frame.camera)];
    for (std::string& sentence : sentences) sentence.insert(0, camera + ": ");
  }
  return sentences;
}

const Recognition& RecordingRecognizer::recognize(const Frame& frame) {
  beginAt(frame.stamp);
  last_stamp_ = frame.stamp;
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
