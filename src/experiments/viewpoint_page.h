#pragma once

#include <string>
#include <vector>

#include "datasets/image_set.h"

namespace place_recognition {

/// A viewpoint of a training set, and its effect on the rate.
struct ShownViewpoint {
  std::string training_set;
  std::string place;
  int number = 0;                   ///< within the place, from 1
  double rate = 0;                  ///< on the other sets, 0..1, with the whole training set
  double rate_without = 0;          ///< with all of it except this viewpoint
  std::vector<std::string> images;  ///< paths
};

/// The images of the viewpoint `number` of a place, see Viewpoint.
std::vector<std::string> imagesOf(const ImageSet& set, const std::string& place, int number);

/// A page that shows all images of each viewpoint side by side; images that cannot be read are
/// omitted.
std::string viewpointPage(const std::vector<ShownViewpoint>& viewpoints);

}  // namespace place_recognition
