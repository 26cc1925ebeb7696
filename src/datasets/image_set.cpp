#include "datasets/image_set.h"

#include <map>

#include "base/atomic_file.h"
#include "base/sha256.h"
#include "report/text_table.h"

namespace place_recognition {
namespace {

constexpr std::size_t kMaxImageBytes = 256 << 20;

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

}  // namespace place_recognition
