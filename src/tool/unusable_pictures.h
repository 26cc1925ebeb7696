#pragma once

#include <cstddef>
#include <iosfwd>
#include <string>

namespace place_recognition::tool {

/// Pictures that a verb passes over, because one bad picture is no reason to stop.
class UnusablePictures {
 public:
  void add(const std::string& name, const std::string& problem);

  std::size_t count() const { return count_; }

  /// Throws Error if all `pictures` were of no use.
  void requireOthers(std::size_t pictures) const;

  /// A line with their number and the reason for the first, if there are any.
  void warn(std::ostream& out) const;

 private:
  std::size_t count_ = 0;
  std::string first_;
};

}  // namespace place_recognition::tool
