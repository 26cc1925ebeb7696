#include "tool/unusable_pictures.h"

#include <ostream>

#include "place_recognition/error.h"

namespace place_recognition::tool {

void UnusablePictures::add(const std::string& name, const std::string& problem) {
  if (count_++ == 0) first_ = name + ": " + problem;
}

void UnusablePictures::requireOthers(std::size_t pictures) const {
  if (count_ == 0 || count_ < pictures) return;
  if (count_ == 1) throw Error("The picture cannot be used (" + first_ + "); give a good one.");
  throw Error("None of the " + std::to_string(count_) + " pictures can be used (the first, " +
              first_ + "); give good ones.");
}

void UnusablePictures::warn(std::ostream& out) const {
  if (count_ == 0) return;
  out << "warning: " << count_ << (count_ == 1 ? " picture" : " pictures")
      << " cannot be used and were passed over (" << first_ << ").\n";
}

}  // namespace place_recognition::tool
