#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "place_recognition/recording.h"

namespace place_recognition {

/// Which images of a bag to read, and the source of their labels. Labels are searched for in this
/// order: `label`, `labels_file`, a file beside the bag, `label_topic`.
struct BagRecordingOptions {
  std::vector<std::string> image_topics;  ///< one per camera; empty: the only topic of images
  std::string label_topic =
      "/place_label";         ///< std_msgs/String: holds until the next; see labels.h
  std::string label;          ///< one place for the whole bag
  std::string initial_label;  ///< what was said before the bag starts, for labels of its topic
  std::string labels_file;    ///< empty: labelsFileBeside()
};

/// Reads the images of a bag (sensor_msgs/Image or CompressedImage; uncompressed, bz2 or lz4) with
/// their labels, one at a time. A child process opens the bag, because rosbag_storage can crash on
/// a damaged one; such a crash is reported as an Error, too. Slashes at the start and end of topics
/// are ignored. Throws Error if the file is not a bag, is not indexed, has no images, or has
/// several image topics of which none is named.
std::unique_ptr<Recording> openBagRecording(const std::string& path,
                                            const BagRecordingOptions& options = {});

/// A topic of a bag.
struct BagTopic {
  std::string name;
  std::string type;  ///< such as std_msgs/String
  std::uint64_t messages = 0;
  int width = 0;  ///< pixels of its first image; 0: not images, or none that can be decoded
  int height = 0;
};

/// Whether the messages of the topic are images that can be used, by its name and type.
bool hasImages(const BagTopic& topic);

/// An interval of a bag with one label.
struct BagLabel {
  double from = 0;  ///< s since the bag's start
  double to = 0;
  std::string place;
};

/// The contents of a bag.
struct BagInfo {
  double start = 0;                ///< s since 1970, or of simulated time; see timeSpan()
  double duration = 0;             ///< s
  std::uint64_t other_images = 0;  ///< number of images more than a day before or after
  std::vector<BagTopic> topics;    ///< images first, then in order of name
  std::vector<BagLabel> labels;    ///< in order of time; empty: the bag is not labelled
  std::string last_label;          ///< at its end; empty: none
  std::string labels_file;         ///< file with the labels; empty: the bag or an option
  std::string labels_note;         ///< what is odd about that file, for a person; else empty
};

/// Reads the contents of a bag. Throws Error like openBagRecording(), but not if there are no
/// images.
BagInfo bagInfo(const std::string& path, const BagRecordingOptions& options = {});

}  // namespace place_recognition
