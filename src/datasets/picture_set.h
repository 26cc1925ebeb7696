#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "place_recognition/run.h"

namespace place_recognition {

/// A picture of a data set on disk.
struct LabelledPicture {
  std::string path;
  std::string place;
  double stamp = 0;  ///< s
};

/// Pictures that are trained or tested on together: one condition of light (chapter 8), or one
/// sample of every material (chapter 7). Neighbours in time are neighbours in the list.
struct PictureSet {
  std::string name;
  std::vector<LabelledPicture> pictures;
};

/// Every `step`-th picture of each place, from the first.
PictureSet thinnedOut(const PictureSet& set, int step);

/// A SHA-256 that depends on names, places and contents, not on where the files lie. Throws Error
/// if a file cannot be read.
std::string digestOf(const std::vector<PictureSet>& sets);

/// The set as a recording; `set` must outlive it.
std::unique_ptr<Run> openPictureSet(const PictureSet& set);

}  // namespace place_recognition
