#pragma once

#include <string>
#include <vector>

namespace place_recognition {

/// An image of a data set on disk.
struct LabelledImage {
  std::string path;
  std::string place;
  double stamp = 0;  ///< s
};

/// Images that are trained or tested on together: one illumination condition (chapter 8), or one
/// sample of every material (chapter 7). Neighbours in time are neighbours in the list.
struct ImageSet {
  std::string name;
  std::vector<LabelledImage> images;
};

/// Every `step`-th image of each place, from the first.
ImageSet thinnedOut(const ImageSet& set, int step);

/// A SHA-256 of names, places and contents, independent of where the files are. Throws Error if a
/// file cannot be read.
std::string digestOf(const std::vector<ImageSet>& sets);

}  // namespace place_recognition
