#include <filesystem>
#include <vector>

#include "datasets/picture_folder.h"
#include "datasets/picture_sequence.h"
#include "place_recognition/error.h"
#include "place_recognition/run.h"

namespace place_recognition {
namespace {

namespace fs = std::filesystem;

/// What to say of a folder without pictures; points at recordings one level further down.
[[noreturn]] void throwNoPictures(const std::string& folder,
                                  const std::vector<std::string>& warnings) {
  for (const std::string& inner : entriesOf(folder).folders) {
    const std::string path = (fs::path(folder) / inner).string();
    if (!holdsRoomPictures(path)) continue;
    throw Error("The folder " + folder + " holds recordings, not rooms; give one of them, as in " +
                path + ".");
  }
  std::string text = "The folder " + folder +
                     " holds no pictures; arrange them as room/picture.jpg (png, jpg, webp, bmp or "
                     "tiff).";
  for (const std::string& warning : warnings) text += " " + warning;
  throw Error(text);
}

class FolderRun : public Run {
 public:
  explicit FolderRun(const std::string& folder) : Run(folder) {
    FoundPictures found = findRoomPictures(folder);
    if (found.pictures.empty()) throwNoPictures(folder, found.warnings);
    warnings_ = std::move(found.warnings);
    std::vector<std::string> paths;
    for (PlacedPicture& picture : found.pictures) {
      paths.push_back(std::move(picture.path));
      places_.push_back(std::move(picture.place));
    }
    pictures_ = PictureSequence(std::move(paths));
  }

  bool next(Frame& frame) override {
    if (position_ == pictures_.size()) {
      if (!pictures_.note().empty()) warnings_.push_back(name() + ": " + pictures_.note());
      return false;
    }
    DecodedImage decoded = pictures_.read(position_);
    frame.image = std::move(decoded.image);
    frame.problem = std::move(decoded.problem);
    frame.place = places_[position_];
    frame.stamp = static_cast<double>(position_);
    frame.name = pictures_.path(position_);
    ++position_;
    return true;
  }

  void setDepthExtent(const DepthExtent& extent) override { pictures_.setDepthExtent(extent); }
  DepthExtent depthExtent() const override { return pictures_.depthExtent(); }

  double fraction() const override {
    return static_cast<double>(position_) / static_cast<double>(pictures_.size());
  }

 private:
  PictureSequence pictures_;
  std::vector<std::string> places_;  // of each picture
  std::size_t position_ = 0;
};

}  // namespace

std::unique_ptr<Run> openFolderRun(const std::string& folder) {
  return std::make_unique<FolderRun>(folder);
}

}  // namespace place_recognition
