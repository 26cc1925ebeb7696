#include <filesystem>
#include <utility>
#include <vector>

#include "base/text.h"
#include "datasets/image_folder.h"
#include "datasets/image_recording.h"
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
  std::vector<std::string> sentences{
      "The folder " + folder +
      " contains no images; arrange them as room/image.jpg (png, jpg, webp, bmp or tiff)."};
  sentences.insert(sentences.end(), warnings.begin(), warnings.end());
  throw Error(listed(sentences, " "));
}

}  // namespace

std::unique_ptr<Recording> openFolderRecording(const std::string& folder) {
  FoundImages found = findRoomImages(folder);
  if (found.images.empty()) throwNoImages(folder, found.warnings);
  std::vector<LabelledImage> images;
  for (PlacedImage& image : found.images) {
    const auto stamp = static_cast<double>(images.size());
    images.push_back({std::move(image.path), std::move(image.place), stamp});
  }
  return recordingOf(folder, std::move(images), std::move(found.warnings));
}

}  // namespace place_recognition
