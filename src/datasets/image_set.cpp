#include "datasets/image_set.h"

#include <map>

#include "base/atomic_file.h"
#include "base/sha256.h"
#include "datasets/image_sequence.h"
#include "report/text_table.h"

namespace place_recognition {
namespace {

constexpr std::size_t kMaxImageBytes = 256 << 20;

class ImageSetRecording : public Recording {
 public:
  explicit ImageSetRecording(const ImageSet& set) : Recording(set.name), set_(set) {
    std::vector<std::string> paths;
    for (const LabelledImage& image : set.images) paths.push_back(image.path);
    images_ = ImageSequence(std::move(paths));
  }

  bool next(Frame& frame) override {
    if (position_ == set_.images.size()) return false;
    DecodedImage decoded = images_.read(position_);
    const LabelledImage& image = set_.images[position_++];
    frame.image = std::move(decoded.image);
    frame.problem = std::move(decoded.problem);
    frame.place = image.place;
    frame.stamp = image.stamp;
    frame.name = image.path;
    return true;
  }

  void setDepthExtent(const DepthExtent& extent) override { images_.setDepthExtent(extent); }
  DepthExtent depthExtent() const override { return images_.depthExtent(); }

  double fraction() const override {
    return static_cast<double>(position_) / static_cast<double>(set_.images.size());
  }

 private:
  const ImageSet& set_;
  ImageSequence images_;
  std::size_t position_ = 0;
};

}  // namespace

ImageSet thinnedOut(const ImageSet& set, int step) {
  ImageSet thinned{set.name, {}};
  std::map<std::string, int> seen;
  for (const LabelledImage& image : set.images) {
    if (seen[image.place]++ % step == 0) thinned.images.push_back(image);
  }
  return thinned;
}

std::string digestOf(const std::vector<ImageSet>& sets) {
  std::string lines;
  for (const ImageSet& set : sets) {
    lines += set.name + "\n";
    for (const LabelledImage& image : set.images) {
      lines += sha256(readFile(image.path, kMaxImageBytes)) + " " + image.place + "/" +
               baseName(image.path) + "\n";
    }
  }
  return sha256(lines);
}

std::unique_ptr<Recording> openImageSet(const ImageSet& set) {
  return std::make_unique<ImageSetRecording>(set);
}

}  // namespace place_recognition
