#include "datasets/image_recording.h"

#include <filesystem>
#include <utility>

#include "datasets/image_sequence.h"
#include "datasets/size_count.h"

namespace place_recognition {
namespace {

namespace fs = std::filesystem;

class ImageRecording : public Recording {
 public:
  ImageRecording(std::string name, std::vector<LabelledImage> images,
                 std::vector<std::string> warnings)
      : Recording(std::move(name)), images_(std::move(images)) {
    warnings_ = std::move(warnings);
    std::vector<std::string> paths;
    for (const LabelledImage& image : images_) paths.push_back(image.path);
    sequence_ = ImageSequence(std::move(paths));
  }

  bool next(Frame& frame) override {
    if (position_ == images_.size()) {
      if (!sizes_.note().empty()) warnings_.push_back(name() + ": " + sizes_.note());
      if (!sequence_.note().empty()) warnings_.push_back(name() + ": " + sequence_.note());
      return false;
    }
    DecodedImage decoded = sequence_.read(position_);
    const LabelledImage& image = images_[position_++];
    frame = Frame{};
    frame.image = std::move(decoded.image);
    sizes_.add(frame.image.size(), image.path);
    frame.place = image.place;
    frame.stamp = image.stamp;
    frame.name = image.path;
    frame.problem = std::move(decoded.problem);
    return true;
  }

  void setLevelRange(const LevelRange& range) override { sequence_.setLevelRange(range); }
  LevelRange levelRange() const override { return sequence_.levelRange(); }

  cv::Size usualSize() override { return sequence_.usualSize(); }

  std::string howToLabel() const override {
    fs::path room = fs::path(name()).lexically_normal();
    if (!room.has_filename()) room = room.parent_path();
    const fs::path above = (room.has_parent_path() ? room : fs::absolute(room)).parent_path();
    return "if " + name() + " is a room, give the folder above it, " + above.string() +
           ", in which the folders are the rooms";
  }

  double fraction() const override {
    return static_cast<double>(position_) / static_cast<double>(images_.size());
  }

 private:
  std::vector<LabelledImage> images_;
  ImageSequence sequence_;
  std::size_t position_ = 0;
  SizeCount sizes_;
};

}  // namespace

std::unique_ptr<Recording> recordingOf(std::string name, std::vector<LabelledImage> images,
                                       std::vector<std::string> warnings) {
  return std::make_unique<ImageRecording>(std::move(name), std::move(images), std::move(warnings));
}

}  // namespace place_recognition
