#pragma once

#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "place_recognition/feature.h"
#include "place_recognition/feature_options.h"

namespace place_recognition {

/// An image of a room.
struct View {
  cv::Mat image;  ///< 640 x 480, BGR
  int place;
};

/// Any number of views of the first five rooms that are found as room/image below the folder
/// $PLACE_RECOGNITION_PICTURES: first the images, then parts of them, every other one mirrored. The
/// rooms take turns. View i is always the same. Throws std::runtime_error if there are no images.
class Views {
 public:
  static constexpr std::size_t kPlaces = 5;

  Views();
  View operator[](std::size_t i) const;

 private:
  std::vector<std::vector<std::string>> files_;  ///< by room
};

/// The features and rooms of the first views.
struct ViewFeatures {
  std::vector<Feature> features;
  std::vector<int> labels;
};
ViewFeatures extractViews(const FeatureOptions& options, std::size_t count, std::size_t first = 0);

}  // namespace place_recognition
