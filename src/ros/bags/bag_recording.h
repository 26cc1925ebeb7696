#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "place_recognition/recording.h"

namespace place_recognition {

/// Which images of a bag are read and where their labels come from. Labels are looked for in this
/// order: `label`, `labels_file`, a file beside the bag, `label_topic`.
struct BagRecordingOptions {
  std::vector<std::string> image_topics;  ///< one per camera; empty: the only topic of images
  std::string label_topic =
      "/place_label";         ///< std_msgs/String: holds until the next; see labels.h
  std::string label;          ///< one place for the whole bag
  std::string initial_label;  ///< what was said before the bag starts, for labels of its topic
  std::string
      labels_file;  ///< empty: RUN.labels.yaml or labels.dat beside RUN.bag, if there is one
};

/// Reads the images of a bag (sensor_msgs/Image or CompressedImage; not, bz2- or lz4-compressed)
/// with their labels, one at a time. The bag is opened by a child process, because rosbag_storage
/// can crash on a damaged one: that too is an Error. Slashes at the ends of topics do not matter.
/// Throws Error if the file is no bag, is not indexed, has no images, or more than one topic of
/// them and none is named.
std::unique_ptr<Recording> openBagRecording(const std::string& path,
                                            const BagRecordingOptions& options = {});

/// A topic of a bag.
struct BagTopic {
  std::string name;
  std::string type;  ///< as in std_msgs/String
  std::uint64_t messages = 0;
  int width = 0;  ///< pixels of its first image; 0: not images, or none that can be decoded
  int height = 0;
};

/// Whether the messages of the topic are images, by their type.
bool hasImages(const BagTopic& topic);

/// A stretch of a bag with one label.
struct BagLabel {
  double from = 0;  ///< s since the bag's start
  double to = 0;
  std::string place;
};

/// What is in a bag.
struct BagInfo {
  double start = 0;  ///< s since 1970, or of simulated time; of the first image or what precedes it
                     ///< without a gap of ten minutes, as a clock leaves that was not set
  double duration = 0;           ///< s
  std::vector<BagTopic> topics;  ///< of images first, then in order of name
  std::vector<BagLabel> labels;  ///< in order of time; empty: the bag is not labelled
  std::string last_label;        ///< at its end; empty: none
  std::string labels_file;       ///< where the labels are from; empty: from the bag
};

/// Looks into a bag. Throws Error like openBagRecording(), but not for want of images.
BagInfo bagInfo(const std::string& path, const BagRecordingOptions& options = {});

}  // namespace place_recognition
