#pragma once

#include <cstddef>
#include <map>
#include <opencv2/core/types.hpp>
#include <string>

namespace place_recognition {

/// How many images have which size.
class SizeCount {
 public:
  /// Images of 0 x 0 do not count.
  void add(const cv::Size& size, const std::string& name);

  /// The commonest size; 0 x 0 if there is none.
  cv::Size usual() const;

  /// How many images have another size, and an example, for a person; empty if all have the same.
  std::string note() const;

 private:
  struct Same {
    std::string first;  // the name of the first image of this size
    std::size_t count = 0;
  };
  struct Smaller {
    bool operator()(const cv::Size& a, const cv::Size& b) const {
      return a.width != b.width ? a.width < b.width : a.height < b.height;
    }
  };

  std::map<cv::Size, Same, Smaller> sizes_;
};

}  // namespace place_recognition
