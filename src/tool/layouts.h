#pragma once

#include <string>
#include <vector>

namespace place_recognition::tool {

/// A picture of a data set on disk.
struct LabelledPicture {
  std::string path;
  std::string place;
  double stamp = 0;  ///< s
};

/// How to read a folder of pictures as one run.
struct Layout {
  std::string name = "rooms";  ///< rooms, indecs, idol or cold; see doc/datasets.md
  std::string condition;       ///< indecs: cloudy, night or sunny; empty: the only one there is
  double rate = 5;             ///< rooms, indecs: pictures a second
};

/// The pictures of `folder` in the order of their stamps, which start at 0 for rooms and indecs and
/// are those of the recording for idol and cold. Throws Error, naming the file, for what does not
/// fit the layout, and if there is no picture at all.
std::vector<LabelledPicture> listPictures(const std::string& folder, const Layout& layout);

}  // namespace place_recognition::tool
