#include "recognition/frames/image_hash.h"

#include <string>

#include "base/sha256.h"
#include "recognition/frames/image_profile.h"

namespace place_recognition {

std::optional<std::uint64_t> imageHash(const cv::Mat& image) {
  if (image.empty() || isUniform(statisticsOf(image))) return std::nullopt;
  const cv::Mat rows = sampledRows(image).clone();
  std::string bytes = std::to_string(image.cols) + "x" + std::to_string(image.rows) + " " +
                      std::to_string(image.type()) + ":";
  bytes.append(reinterpret_cast<const char*>(rows.data), rows.total() * rows.elemSize());
  constexpr int kHexadecimal = 16, kDigits = 16;  // 64 bits
  return std::stoull(sha256(bytes).substr(0, kDigits), nullptr, kHexadecimal);
}

void addLabelled(const Frame& frame, RunSketch& sketch) {
  if (frame.place.empty()) return;
  if (const std::optional<std::uint64_t> hash = imageHash(frame.image)) sketch.add(*hash);
}

}  // namespace place_recognition
