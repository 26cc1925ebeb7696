#pragma once

#include <cstddef>
#include <iosfwd>
#include <string>

namespace place_recognition::tool {

/// Images that a verb skips, because one bad image is no reason to stop.
class UnusableImages {
 public:
  void add(const std::string& name, const std::string& problem);

  std::size_t count() const { return count_; }

  /// Throws Error if all `images` are unusable.
  void requireOthers(std::size_t images) const;

  /// Prints one line with their number and the first reason, if there are any.
  void warn(std::ostream& out) const;

 private:
  std::size_t count_ = 0;
  std::string first_;
};

}  // namespace place_recognition::tool
