#include <filesystem>
#include <vector>

#include "datasets/image_folder.h"
#include "datasets/image_sequence.h"
#include "place_recognition/error.h"
#include "place_recognition/recording.h"

namespace place_recognition {
namespace {

namespace fs = std::filesystem;

/// The error for a folder without images, which points out recordings one level below.
[[noreturn]] void throwNoImages(const std::string& folder,
                                const std::vector<std::string>& warnings) {
  for (const std::string& inner : entriesOf(folder).folders) {
    const std::string path = (fs::path(folder) / inner).string();
    if (!holdsRoomImages(path)) continue;
    throw Error("The folder " + folder +
                " contains recordings, not rooms; give one of them, such as " + path + ".");
  }
  std::string text = "The folder " + folder +
                     " contains no images; arrange them as room/image.jpg (png, jpg, webp, bmp or "
                     "tiff).";
  for (const std::string& warning : warnings) text += " " + warning;
  throw Error(text);
}

class FolderRecording : public Recording {
 public:
  explicit FolderRecording(const std::string& folder) : Recording(folder) {
    FoundImages found = findRoomImages(folder);
    if (found.images.empty()) throwNoImages(folder, found.warnings);
    warnings_ = std::move(found.warnings);
    std::vector<std::string> paths;
    for (PlacedImage& image : found.images) {
      paths.push_back(std::move(image.path));
      places_.push_back(std::move(image.place));
    }
    images_ = ImageSequence(std::move(paths));
  }

  bool next(Frame& frame) override {
    if (position_ == images_.size()) {
      if (!images_.note().empty()) warnings_.push_back(name() + ": " + images_.note());
      return false;
    }
    DecodedImage decoded = images_.read(position_);
    frame.image = std::move(decoded.image);
    frame.problem = std::move(decoded.problem);
    frame.place = places_[position_];
    frame.stamp = static_cast<double>(position_);
    frame.name = images_.path(position_);
    ++position_;
    return true;
  }

  void setDepthExtent(const DepthExtent& extent) override { images_.setDepthExtent(extent); }
  DepthExtent depthExtent() const override { return images_.depthExtent(); }

  double fraction() const override {
    return static_cast<double>(position_) / static_cast<double>(images_.size());
  }

 private:
  ImageSequence images_;
  std::vector<std::string> places_;  // by image
  std::size_t position_ = 0;
};

}  // namespace

std::unique_ptr<Recording> openFolderRecording(const std::string& folder) {
  return std::make_unique<FolderRecording>(folder);
}

}  // namespace place_recognition
