#pragma once

#include <gtest/gtest.h>

#include <fstream>
#include <memory>
#include <opencv2/core.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "error_of.h"
#include "ros/bags/bag_recording.h"
#include "ros/bags/labelled_bag_writer.h"
#include "scratch_folder.h"

namespace place_recognition {

/// An image whose grey level encodes its number.
inline cv::Mat image(int number) {
  return cv::Mat(12, 16, CV_8UC3, cv::Scalar::all(10 + 10 * number));
}

/// The rooms of the images of writeRun(), one per second.
inline const std::vector<std::string> kRooms = {"kitchen", "kitchen", "", "corridor", "corridor"};

inline void writeRun(const std::string& path, const LabelledBagOptions& options = {}) {
  LabelledBagWriter writer(path, options);
  for (std::size_t i = 0; i < kRooms.size(); ++i) {
    writer.write(image(static_cast<int>(i)), kRooms[i], static_cast<double>(i));
  }
  writer.close();
}

inline std::vector<Frame> readAll(const std::string& path,
                                  const BagRecordingOptions& options = {}) {
  const std::unique_ptr<Recording> recording = openBagRecording(path, options);
  std::vector<Frame> frames;
  Frame frame;
  while (recording->next(frame)) frames.push_back(frame);
  EXPECT_EQ(recording->fraction(), 1);
  return frames;
}

inline std::vector<std::string> places(const std::vector<Frame>& frames) {
  std::vector<std::string> names;
  for (const Frame& frame : frames) names.push_back(frame.place);
  return names;
}

inline std::string errorOfReading(const std::string& path,
                                  const BagRecordingOptions& options = {}) {
  return errorOf([&] {
    const std::unique_ptr<Recording> recording = openBagRecording(path, options);
    Frame frame;
    while (recording->next(frame)) {
    }
  });
}

inline std::string readBytesOf(const std::string& path) {
  std::ostringstream bytes;
  bytes << std::ifstream(path, std::ios::binary).rdbuf();
  return bytes.str();
}

class Bags : public testing::Test {
 protected:
  ScratchFolder scratch_;
  const std::string path_ = scratch_ / "run.bag";
};

}  // namespace place_recognition
