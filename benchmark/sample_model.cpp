#include "sample_model.h"

#include "views.h"

namespace place_recognition {
namespace {

class ViewRun : public Recording {
 public:
  explicit ViewRun(std::size_t count) : Recording("views"), count_(count) {}

  bool next(Frame& frame) override {
    if (position_ == count_) return false;
    const View view = views_[position_];
    frame.image = view.image;
    frame.place = "room " + std::to_string(view.place);
    frame.stamp = static_cast<double>(position_);
    frame.name = "view " + std::to_string(position_++);
    return true;
  }

  double fraction() const override {
    return static_cast<double>(position_) / static_cast<double>(count_);
  }

 private:
  Views views_;
  std::size_t count_;
  std::size_t position_ = 0;
};

}  // namespace

RecordingOpener viewRun(std::size_t count) {
  return [count] { return std::make_unique<ViewRun>(count); };
}

Model sampleModel(TrainingOptions options, std::size_t count) {
  for (CueOptions& cue : options.cues) {
    if (cue.kernel.gamma == 0) cue.kernel.gamma = 1;  // instead of a search
  }
  options.svm.c = 0.01;
  options.reduction.method = "none";
  return train({viewRun(count)}, options, 1).model;
}

Model sampleModel(std::size_t count) {
  TrainingOptions options;
  options.cues = {CueOptions()};
  options.cues.front().kernel.gamma = 1;
  return sampleModel(options, count);
}

}  // namespace place_recognition
