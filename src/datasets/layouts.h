#pragma once

#include <string>
#include <vector>

#include "datasets/image_set.h"

namespace place_recognition {

/// How to read a folder of images as one run.
struct Layout {
  std::string name = "rooms";  ///< rooms, indecs, idol or cold; see doc/datasets.md
  std::string condition;       ///< indecs: cloudy, night or sunny; empty: the only one there is
  double rate = 5;             ///< rooms, indecs: images a second
  std::string camera;          ///< cold: std_cam or omni_cam; empty: std_cam
};

/// The images of `folder` in the order of their stamps, which start at 0 for rooms and indecs and
/// are those of the recording for idol and cold. Throws Error, naming the file, for what does not
/// fit the layout, and if there is no image at all. Adds to `warnings` a sentence for each folder
/// that gives nothing.
std::vector<LabelledImage> listImages(const std::string& folder, const Layout& layout,
                                      std::vector<std::string>& warnings);

/// cloudy, night, sunny: those of which a folder of layout indecs has images, in this order.
std::vector<std::string> indecsConditions(const std::string& folder);

}  // namespace place_recognition
