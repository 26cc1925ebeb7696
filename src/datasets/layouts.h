#pragma once

#include <string>
#include <vector>

#include "datasets/image_set.h"

namespace place_recognition {

/// The interpretation of a folder of images as one run.
struct Layout {
  std::string name = "rooms";  ///< rooms, indecs, idol or cold; see doc/datasets.md
  std::string condition;       ///< indecs: cloudy, night or sunny; empty: the only one there is
  double rate = 5;             ///< rooms, indecs: images per second
  std::string camera;          ///< cold: std_cam or omni_cam; empty: std_cam
};

/// Lists the images of `folder` in the order of their stamps, which start at 0 for rooms and indecs
/// and are those of the recording for idol and cold. Throws Error, naming the file, if the folder
/// does not fit the layout or contains no image. Appends to `warnings` one sentence for each folder
/// without images.
std::vector<LabelledImage> listImages(const std::string& folder, const Layout& layout,
                                      std::vector<std::string>& warnings);

/// Those of cloudy, night, sunny, in this order, for which a folder of layout indecs has images.
std::vector<std::string> indecsConditions(const std::string& folder);

}  // namespace place_recognition
