#pragma once

#include <cmath>
#include <memory>
#include <opencv2/imgproc.hpp>
#include <random>
#include <string>
#include <vector>

#include "place_recognition/recording.h"
#include "place_recognition/training.h"

namespace place_recognition {

/// Returns an image of an artificial room, 96 x 72: the size and spacing of its blobs depend on the
/// room, their positions on the frame.
inline cv::Mat drawRoom(int room, unsigned frame) {
  std::mt19937 generator(1000u * static_cast<unsigned>(room) + frame);
  cv::Mat image(72, 96, CV_8UC3, cv::Scalar(90 + 20 * room, 120, 140 - 15 * room));
  for (int i = 0; i < 40 + 30 * room; ++i) {
    const cv::Point centre(static_cast<int>(generator() % 96), static_cast<int>(generator() % 72));
    const double grey = static_cast<double>(generator() % 200);
    cv::circle(image, centre, 2 + 2 * room, cv::Scalar(grey, grey / 2, 255 - grey), -1);
  }
  return image;
}

/// A recording of given frames.
class FrameList : public Recording {
 public:
  FrameList(const std::string& name, std::vector<Frame> frames,
            std::vector<std::string> cameras = {""})
      : Recording(name), frames_(std::move(frames)), cameras_(std::move(cameras)) {}

  std::vector<std::string> cameras() const override { return cameras_; }

  bool next(Frame& frame) override {
    if (position_ == frames_.size()) return false;
    frame = frames_[position_++];
    return true;
  }
  double fraction() const override {
    return static_cast<double>(position_) / static_cast<double>(frames_.size());
  }

 private:
  std::vector<Frame> frames_;
  std::vector<std::string> cameras_;
  std::size_t position_ = 0;
};

/// Returns `count` frames of each of `rooms` drawn rooms, named room0, room1, ...
inline std::vector<Frame> drawFrames(int rooms, int count, unsigned first_frame = 0) {
  std::vector<Frame> frames;
  for (int room = 0; room < rooms; ++room) {
    for (int i = 0; i < count; ++i) {
      Frame frame;
      frame.image = drawRoom(room, first_frame + static_cast<unsigned>(i));
      frame.place = "room" + std::to_string(room);
      frame.stamp = static_cast<double>(frames.size());
      frame.name = "frame" + std::to_string(frames.size());
      frames.push_back(frame);
    }
  }
  return frames;
}

/// Returns `count` frames of one of four drawn rooms.
inline std::vector<Frame> framesOf(const std::string& room, unsigned first_frame, int count = 15) {
  std::vector<Frame> frames;
  for (const Frame& frame : drawFrames(4, count, first_frame)) {
    if (frame.place == room) frames.push_back(frame);
  }
  return frames;
}

inline RecordingOpener opener(const std::vector<Frame>& frames, const std::string& name = "drawn",
                              const std::vector<std::string>& cameras = {""}) {
  return [frames, name, cameras] { return std::make_unique<FrameList>(name, frames, cameras); };
}

/// Returns the parts of a recording that was split in front of the frames `borders`.
inline std::vector<RecordingOpener> openersOfParts(const std::vector<Frame>& frames,
                                                   std::vector<std::ptrdiff_t> borders) {
  borders.push_back(static_cast<std::ptrdiff_t>(frames.size()));
  std::vector<RecordingOpener> openers;
  std::ptrdiff_t begin = 0;
  for (const std::ptrdiff_t end : borders) {
    openers.push_back(opener({frames.begin() + begin, frames.begin() + end},
                             "part" + std::to_string(openers.size())));
    begin = end;
  }
  return openers;
}

/// Returns options that train on drawn rooms quickly.
inline TrainingOptions quickOptions() {
  TrainingOptions options;
  CrfhOptions crfh;
  crfh.descriptors = {"L", "Lxx"};
  crfh.scales = {1};
  crfh.bins = {8};
  options.cues = {CueOptions()};
  options.cues[0].feature = crfh;
  return options;
}

/// Returns the same options with a second cue, which uses colour.
inline TrainingOptions twoCueOptions() {
  TrainingOptions options = quickOptions();
  CueOptions colour;
  colour.name = "colour";
  CrfhOptions crfh;
  crfh.descriptors = {"R", "G", "B"};
  crfh.scales = {1};
  crfh.bins = {6};
  colour.feature = crfh;
  options.cues.push_back(colour);
  return options;
}

}  // namespace place_recognition
