#include "datasets/layouts.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <set>
#include <sstream>
#include <tuple>

#include "base/atomic_file.h"
#include "base/place_name.h"
#include "base/text.h"
#include "datasets/image_folder.h"
#include "labels/labels.h"
#include "place_recognition/error.h"

namespace place_recognition {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> split(const std::string& text, const char* separators) {
  std::vector<std::string> words;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find_first_of(separators, begin), text.size());
    if (end > begin) words.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return words;
}

bool isNumber(const std::string& word) {
  return word.find_first_not_of("0123456789") == std::string::npos;
}

/// cloudy, night or sunny if `word` is one of them in upper or lower case; else empty.
std::string asCondition(const std::string& word) {
  const std::string lower = lowerCase(word);
  return lower == "cloudy" || lower == "night" || lower == "sunny" ? lower : "";
}

/// The number after the first letter of `word`, such as t1125496218.37; NaN if there is none.
double numberBehindLetter(const std::string& word) {
  char* end = nullptr;
  const double value = word.size() > 1 ? std::strtod(word.c_str() + 1, &end) : NAN;
  return end && *end == '\0' && std::isfinite(value) ? value : NAN;
}

using Warnings = std::vector<std::string>;

void stampByRate(std::vector<LabelledImage>& images, double rate) {
  for (std::size_t i = 0; i < images.size(); ++i) {
    images[i].stamp = static_cast<double>(i) / rate;
  }
}

/// The images below a folder, for layouts whose paths contain more than the room.
std::vector<std::string> imagesBelow(const std::string& folder, Warnings& warnings) {
  FoundImages found = findImagesBelow(folder);
  warnings.insert(warnings.end(), found.warnings.begin(), found.warnings.end());
  std::vector<std::string> paths;
  for (PlacedImage& image : found.images) paths.push_back(std::move(image.path));
  return paths;
}

std::string allOf(const Warnings& warnings) {
  std::string text;
  for (const std::string& warning : warnings) text += " " + warning;
  return text;
}

std::vector<LabelledImage> listRooms(const fs::path& folder, Warnings& warnings) {
  FoundImages found = findRoomImages(folder.string());
  warnings.insert(warnings.end(), found.warnings.begin(), found.warnings.end());
  std::vector<LabelledImage> images;
  for (PlacedImage& image : found.images) {
    if (!image.place.empty()) images.push_back({image.path, image.place, 0});
  }
  return images;
}

/// The information in the path of a KTH-INDECS image, wherever in the path it is.
struct IndecsImage {
  std::string condition;
  std::string room;
  long marker = 0;
  long angle = 0;  // degrees
  std::string path;

  /// `path` is below `folder`. Throws Error if it does not name a room.
  IndecsImage(const fs::path& folder, const fs::path& path) : path(path.string()) {
    for (const fs::path& part : path.lexically_relative(folder).parent_path()) {
      if (const std::string found = asCondition(part.string()); !found.empty()) {
        condition = found;
      } else if (room.empty()) {
        room = part.string();
      }
    }
    const bool room_in_stem = room.empty();
    bool room_ended = false;
    for (const std::string& word : split(path.stem().string(), "_- ")) {
      if (const std::string found = asCondition(word); !found.empty()) {
        condition = found;
        room_ended = true;
      } else if (isNumber(word)) {
        marker = angle;
        angle = std::strtol(word.c_str(), nullptr, 10);
        room_ended = true;
      } else if (room_in_stem && !room_ended) {
        room += (room.empty() ? "" : "_") + word;
      }
    }
    if (room.empty()) {
      throw Error(path.string() +
                  " has no room in its folders or its name; see "
                  "doc/datasets.md for the layout.");
    }
  }

  bool operator<(const IndecsImage& other) const {
    return std::tie(room, marker, angle, path) <
           std::tie(other.room, other.marker, other.angle, other.path);
  }
};

std::vector<LabelledImage> listIndecs(const fs::path& folder, const std::string& wanted,
                                      Warnings& warnings) {
  std::vector<IndecsImage> found;
  std::set<std::string> conditions;
  for (const fs::path path : imagesBelow(folder.string(), warnings)) {
    IndecsImage image(folder, path);
    conditions.insert(image.condition);
    if (wanted.empty() || image.condition == wanted) found.push_back(std::move(image));
  }
  if (wanted.empty() && conditions.size() > 1) {
    throw Error(folder.string() +
                " contains several conditions, but a run has only one; "
                "add --condition cloudy, night or sunny.");
  }
  conditions.erase("");
  if (found.empty() && !conditions.empty()) {
    throw Error(folder.string() + " contains no images of the condition " + wanted + ", only of " +
                listed({conditions.begin(), conditions.end()}) + "; give another --condition.");
  }
  std::sort(found.begin(), found.end());
  std::vector<LabelledImage> images;
  for (const IndecsImage& image : found) images.push_back({image.path, image.room, 0});
  return images;
}

std::vector<LabelledImage> listIdol(const fs::path& folder, Warnings& warnings) {
  std::vector<LabelledImage> images;
  for (const fs::path path : imagesBelow(folder.string(), warnings)) {
    LabelledImage image{path.string(), "", NAN};
    for (const std::string& word : split(path.stem().string(), "_")) {
      // Only the first of these words: more may follow, as in _retouched.
      if (word.front() == 't' && std::isnan(image.stamp)) image.stamp = numberBehindLetter(word);
      if (word.front() == 'r' && image.place.empty()) image.place = word.substr(1);
    }
    if (image.place.empty() || std::isnan(image.stamp)) {
      throw Error(image.path +
                  " is not named like an image of KTH-IDOL (tTIME_rROOM_xX_yY_aANGLE); give "
                  "the folder of one sequence, or another --layout.");
    }
    images.push_back(std::move(image));
  }
  return images;
}

/// The stamp in the name of a COLD image; NaN if there is none.
double coldStamp(const std::string& file) {
  return numberBehindLetter(file.substr(0, file.find('_')));
}

/// One line per image, `tTIME_xX_yY_aANGLE.jpeg LABEL`.
std::vector<LabelledImage> listByImages(const fs::path& cameras, const fs::path& list) {
  constexpr std::size_t kMaxFileBytes = 64 << 20;
  std::vector<LabelledImage> images;
  int number = 0;
  for (const std::string& line : linesOf(toUtf8(readFile(list.string(), kMaxFileBytes)))) {
    ++number;
    std::istringstream words(line);
    std::string file, place;
    if (!(words >> file)) continue;
    const double stamp = coldStamp(file);
    if (!(words >> place) || std::isnan(stamp)) {
      throw Error(list.string() + " line " + std::to_string(number) +
                  " is not of the form 'tTIME_xX_yY_aANGLE.jpeg LABEL'; correct it.");
    }
    images.push_back({(cameras / file).string(), place, stamp});
  }
  return images;
}

/// Lines `timestamp label` (COLD-Meta), each valid until the next one. Images before the first line
/// are left out.
std::vector<LabelledImage> listByTimes(const fs::path& cameras, const fs::path& labels_file,
                                       Warnings& warnings) {
  std::vector<LabelledImage> images;
  double start = std::numeric_limits<double>::infinity(), end = -start;
  for (const std::string& path : imagesBelow(cameras.string(), warnings)) {
    const double stamp = coldStamp(fs::path(path).filename().string());
    if (std::isnan(stamp)) {
      throw Error(path + " is not named like an image of COLD (tTIME_xX_yY_aANGLE); remove it.");
    }
    images.push_back({path, "", stamp});
    start = std::min(start, stamp);
    end = std::max(end, stamp);
  }
  const Labels labels = Labels::fromFile(labels_file.string(), start, end);
  for (LabelledImage& image : images) image.place = labels.at(image.stamp);
  images.erase(std::remove_if(images.begin(), images.end(),
                              [](const auto& image) { return image.place.empty(); }),
               images.end());
  return images;
}

std::vector<LabelledImage> listCold(const fs::path& folder, const std::string& camera,
                                    Warnings& warnings) {
  const fs::path cameras = folder / (camera.empty() ? "std_cam" : camera),
                 list = folder / "localization" / "places.lst";
  if (fs::exists(list)) return listByImages(cameras, list);
  for (const fs::path& labels : {folder / "labels.dat", folder / "localization" / "labels.dat"}) {
    if (fs::exists(labels) && fs::is_directory(cameras)) {
      return listByTimes(cameras, labels, warnings);
    }
  }
  throw Error("There is neither " + list.string() + " nor " + (folder / "labels.dat").string() +
              "; give the folder of one COLD sequence, which contains " +
              cameras.filename().string() + " and one of these.");
}

}  // namespace

std::vector<std::string> indecsConditions(const std::string& folder) {
  std::set<std::string> conditions;
  Warnings told_later;
  for (const std::string& path : imagesBelow(folder, told_later)) {
    conditions.insert(IndecsImage(folder, path).condition);
  }
  conditions.erase("");
  return {conditions.begin(), conditions.end()};
}

std::vector<LabelledImage> listImages(const std::string& folder, const Layout& layout,
                                      std::vector<std::string>& warnings) {
  if (!fs::is_directory(folder)) throw Error(folder + " is not a folder; check the path.");
  const bool by_rate = layout.name == "rooms" || layout.name == "indecs";
  std::vector<LabelledImage> images =
      layout.name == "rooms"    ? listRooms(folder, warnings)
      : layout.name == "indecs" ? listIndecs(folder, layout.condition, warnings)
      : layout.name == "idol"   ? listIdol(folder, warnings)
                                : listCold(folder, layout.camera, warnings);
  for (LabelledImage& image : images) image.place = placeName(image.place);
  if (images.empty()) {
    throw Error("The folder " + folder +
                " contains no images (png, jpg, webp, bmp or tiff) in the layout '" + layout.name +
                "'; check the path, or give another --layout." + allOf(warnings));
  }
  if (by_rate) {
    stampByRate(images, layout.rate);
  } else {
    std::stable_sort(images.begin(), images.end(),
                     [](const auto& a, const auto& b) { return a.stamp < b.stamp; });
  }
  return images;
}

}  // namespace place_recognition
