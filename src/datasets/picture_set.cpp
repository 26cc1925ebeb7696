#include "datasets/picture_set.h"

#include <map>

#include "base/atomic_file.h"
#include "base/sha256.h"
#include "datasets/picture_sequence.h"
#include "report/text_table.h"

namespace place_recognition {
namespace {

constexpr std::size_t kMaxPictureBytes = 256 << 20;

class PictureSetRun : public Run {
 public:
  explicit PictureSetRun(const PictureSet& set) : Run(set.name), set_(set) {
    std::vector<std::string> paths;
    for (const LabelledPicture& picture : set.pictures) paths.push_back(picture.path);
    pictures_ = PictureSequence(std::move(paths));
  }

  bool next(Frame& frame) override {
    if (position_ == set_.pictures.size()) return false;
    DecodedImage decoded = pictures_.read(position_);
    const LabelledPicture& picture = set_.pictures[position_++];
    frame.image = std::move(decoded.image);
    frame.problem = std::move(decoded.problem);
    frame.place = picture.place;
    frame.stamp = picture.stamp;
    frame.name = picture.path;
    return true;
  }

  void setDepthExtent(const DepthExtent& extent) override { pictures_.setDepthExtent(extent); }
  DepthExtent depthExtent() const override { return pictures_.depthExtent(); }

  double fraction() const override {
    return static_cast<double>(position_) / static_cast<double>(set_.pictures.size());
  }

 private:
  const PictureSet& set_;
  PictureSequence pictures_;
  std::size_t position_ = 0;
};

}  // namespace

PictureSet thinnedOut(const PictureSet& set, int step) {
  PictureSet thinned{set.name, {}};
  std::map<std::string, int> seen;
  for (const LabelledPicture& picture : set.pictures) {
    if (seen[picture.place]++ % step == 0) thinned.pictures.push_back(picture);
  }
  return thinned;
}

std::string digestOf(const std::vector<PictureSet>& sets) {
  std::string lines;
  for (const PictureSet& set : sets) {
    lines += set.name + "\n";
    for (const LabelledPicture& picture : set.pictures) {
      lines += sha256(readFile(picture.path, kMaxPictureBytes)) + " " + picture.place + "/" +
               baseName(picture.path) + "\n";
    }
  }
  return sha256(lines);
}

std::unique_ptr<Run> openPictureSet(const PictureSet& set) {
  return std::make_unique<PictureSetRun>(set);
}

}  // namespace place_recognition
