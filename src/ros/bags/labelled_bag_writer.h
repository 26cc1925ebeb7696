#pragma once

#include <cstdint>
#include <memory>
#include <opencv2/core/mat.hpp>
#include <string>

namespace place_recognition {

/// Options for writing a labelled bag.
struct LabelledBagOptions {
  enum class Compression { kNone, kLz4, kBz2 };

  std::string image_topic = "/camera/image_raw";  ///< "/compressed" is appended for JPEG
  std::string label_topic = "/place_label";
  std::string frame_id = "camera";
  bool jpeg = true;       ///< sensor_msgs/CompressedImage; false: sensor_msgs/Image
  int jpeg_quality = 90;  ///< 1..100
  Compression compression = Compression::kNone;  ///< of the bag's chunks
  double base_time = 1'000'000'000;              ///< s since 1970, added to every stamp
};

/// Writes a bag of images and of labels, one whenever the label changes, in the format of
/// openBagRecording(). The bag gets its name only once it is complete: close() renames a temporary
/// file beside it, and the destructor removes one that was not renamed.
class LabelledBagWriter {
 public:
  /// Throws Error if the folder cannot be written to.
  explicit LabelledBagWriter(const std::string& path, const LabelledBagOptions& options = {});
  ~LabelledBagWriter();

  /// `image`: CV_8UC3 BGR or CV_8UC1, not empty. `place`: empty means unlabelled. `stamp`: s, not
  /// before the previous one. `camera`, if not empty, is the tf frame of the image and the first
  /// part of its topic, /CAMERA/image_raw. Throws Error if writing fails.
  void write(const cv::Mat& image, const std::string& place, double stamp,
             const std::string& camera = "");

  /// Completes the bag. Throws Error if writing fails.
  void close();

 private:
  struct Bag;
  std::unique_ptr<Bag> bag_;
};

}  // namespace place_recognition
