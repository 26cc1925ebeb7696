#include "recognition/training/labelled_light.h"

#include "recognition/frames/colour_normalization.h"
#include "recognition/model/place_index.h"

namespace place_recognition {

LabelledLight::LabelledLight(const Model* model)
    : model_(model), estimate_(model ? model->colours : ColourStatistics{}) {}

Light LabelledLight::next(const Frame& frame) {
  if (!model_ || !model_->colours.known()) return {};
  estimate_.beginFrame(frame.stamp);
  const Light light = estimate_.correction();
  const auto& places = model_->places;
  const int place = placeIndex(frame.place, places);
  if (place >= 0) {
    certain_.setZero(static_cast<Eigen::Index>(places.size()));
    certain_[place] = 1;
    estimate_.add(logColour(frame.image), certain_);
  }
  return light;
}

}  // namespace place_recognition
