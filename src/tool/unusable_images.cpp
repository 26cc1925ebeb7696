#include "tool/unusable_images.h"

#include <ostream>

#include "place_recognition/error.h"

namespace place_recognition::tool {

void UnusableImages::add(const std::string& name, const std::string& problem) {
  if (count_++ == 0) first_ = name + ": " + problem;
}

void UnusableImages::requireOthers(std::size_t images) const {
  if (count_ == 0 || count_ < images) return;
  if (count_ == 1) throw Error("The image cannot be used (" + first_ + "); give another one.");
  throw Error("None of the " + std::to_string(count_) +
              " images can be used (the first: " + first_ + "); give other ones.");
}

void UnusableImages::warn(std::ostream& out) const {
  if (count_ == 0) return;
  out << "warning: " << count_
      << (count_ == 1 ? " image cannot be used and was" : " images cannot be used and were")
      << " skipped (" << first_ << ").\n";
}

}  // namespace place_recognition::tool
