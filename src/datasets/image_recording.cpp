#include "datasets/image_recording.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <map>
#include <utility>

#include "base/text.h"
#include "datasets/image_sequence.h"

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
      warnOfSizes();
      if (!sequence_.note().empty()) warnings_.push_back(name() + ": " + sequence_.note());
      return false;
    }
    DecodedImage decoded = sequence_.read(position_);
    const LabelledImage& image = images_[position_++];
    frame = Frame{};
    frame.image = std::move(decoded.image);
    if (!frame.image.empty()) {
      ++sizes_.try_emplace({frame.image.cols, frame.image.rows}, SameSize{image.path, 0})
            .first->second.count;
    }
    frame.place = image.place;
    frame.stamp = image.stamp;
    frame.name = image.path;
    frame.problem = std::move(decoded.problem);
    return true;
  }

  void setDepthExtent(const DepthExtent& extent) override { sequence_.setDepthExtent(extent); }
  DepthExtent depthExtent() const override { return sequence_.depthExtent(); }

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
  /// The images of one size that were read.
  struct SameSize {
    std::string first;  // its path
    std::size_t count;
  };
  using Sizes = std::map<std::pair<int, int>, SameSize>;  // by width and height

  void warnOfSizes() {
    if (sizes_.size() < 2) return;
    const auto usual = std::max_element(sizes_.begin(), sizes_.end(),
                                        [](const Sizes::value_type& a, const Sizes::value_type& b) {
                                          return a.second.count < b.second.count;
                                        });
    std::size_t count = 0;
    for (const auto& [size, same] : sizes_) count += same.count;
    const std::size_t others = count - usual->second.count;
    const auto text = [](const std::pair<int, int>& size) {
      return std::to_string(size.first) + " x " + std::to_string(size.second);
    };
    const auto other = usual == sizes_.begin() ? std::next(usual) : sizes_.begin();
    const std::string example = other->second.first + ", " + text(other->first);
    warnings_.push_back(name() + ": " + std::to_string(others) + " of " + counted(count, "image") +
                        (others == 1 ? " has" : " have") + " another size than the usual " +
                        text(usual->first) +
                        (others == 1 ? ": " + example : " (such as " + example + ")") + ".");
  }

  std::vector<LabelledImage> images_;
  ImageSequence sequence_;
  std::size_t position_ = 0;
  Sizes sizes_;
};

}  // namespace

std::unique_ptr<Recording> recordingOf(std::string name, std::vector<LabelledImage> images,
                                       std::vector<std::string> warnings) {
  return std::make_unique<ImageRecording>(std::move(name), std::move(images), std::move(warnings));
}

}  // namespace place_recognition
