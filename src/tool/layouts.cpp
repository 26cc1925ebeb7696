#include "tool/layouts.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <set>
#include <sstream>
#include <tuple>

#include "place_recognition/error.h"
#include "ros/labels.h"
#include "tool/inputs.h"

namespace place_recognition::tool {
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

/// cloudy, night or sunny, if `word` says so in any case; else nothing.
std::string asCondition(std::string word) {
  std::transform(word.begin(), word.end(), word.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return word == "cloudy" || word == "night" || word == "sunny" ? word : "";
}

/// A double behind the first letter of `word`, as in t1125496218.37; NaN if there is none.
double numberBehindLetter(const std::string& word) {
  char* end = nullptr;
  const double value = word.size() > 1 ? std::strtod(word.c_str() + 1, &end) : NAN;
  return end && *end == '\0' ? value : NAN;
}

void stampByRate(std::vector<LabelledPicture>& pictures, double rate) {
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    pictures[i].stamp = static_cast<double>(i) / rate;
  }
}

std::vector<LabelledPicture> listRooms(const fs::path& folder) {
  std::vector<LabelledPicture> pictures;
  for (const fs::path path : picturesBelow(folder.string())) {
    const fs::path relative = path.lexically_relative(folder);
    if (std::distance(relative.begin(), relative.end()) == 2) {
      pictures.push_back({path.string(), relative.begin()->string(), 0});
    }
  }
  return pictures;
}

/// What the path of a KTH-INDECS picture tells, wherever in it that stands.
struct IndecsPicture {
  std::string condition;
  std::string room;
  long marker = 0;
  long angle = 0;  // degrees
  std::string path;

  /// `path` lies below `folder`. Throws Error if it names no room.
  IndecsPicture(const fs::path& folder, const fs::path& path) : path(path.string()) {
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
                  " tells no room, neither by a folder nor by its name; see "
                  "doc/datasets.md for the layout.");
    }
  }

  bool operator<(const IndecsPicture& other) const {
    return std::tie(room, marker, angle, path) <
           std::tie(other.room, other.marker, other.angle, other.path);
  }
};

std::vector<LabelledPicture> listIndecs(const fs::path& folder, const std::string& wanted) {
  std::vector<IndecsPicture> found;
  std::set<std::string> conditions;
  for (const fs::path path : picturesBelow(folder.string())) {
    IndecsPicture picture(folder, path);
    conditions.insert(picture.condition);
    if (wanted.empty() || picture.condition == wanted) found.push_back(std::move(picture));
  }
  if (wanted.empty() && conditions.size() > 1) {
    throw Error(folder.string() +
                " holds several conditions of light, and a run is one of them; "
                "add --condition cloudy, night or sunny.");
  }
  std::sort(found.begin(), found.end());
  std::vector<LabelledPicture> pictures;
  for (const IndecsPicture& picture : found) pictures.push_back({picture.path, picture.room, 0});
  return pictures;
}

std::vector<LabelledPicture> listIdol(const fs::path& folder) {
  std::vector<LabelledPicture> pictures;
  for (const fs::path path : picturesBelow(folder.string())) {
    LabelledPicture picture{path.string(), "", NAN};
    for (const std::string& word : split(path.stem().string(), "_")) {
      if (word.front() == 't') picture.stamp = numberBehindLetter(word);
      if (word.front() == 'r') picture.place = word.substr(1);
    }
    if (picture.place.empty() || std::isnan(picture.stamp)) {
      throw Error(picture.path +
                  " is not named as KTH-IDOL does (tTIME_rROOM_xX_yY_aANGLE); give "
                  "the folder of one sequence, or another --layout.");
    }
    pictures.push_back(std::move(picture));
  }
  return pictures;
}

/// The stamp in the name of a picture of COLD; NaN if it has none.
double coldStamp(const std::string& file) {
  return numberBehindLetter(file.substr(0, file.find('_')));
}

/// A line a picture, `tTIME_xX_yY_aANGLE.jpeg LABEL`.
std::vector<LabelledPicture> listByPictures(const fs::path& cameras, const fs::path& list) {
  std::ifstream lines(list);
  std::vector<LabelledPicture> pictures;
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    std::istringstream words(line);
    std::string file, place;
    if (!(words >> file)) continue;
    const double stamp = coldStamp(file);
    if (!(words >> place) || std::isnan(stamp)) {
      throw Error(list.string() + " line " + std::to_string(number) +
                  " is not of the form 'tTIME_xX_yY_aANGLE.jpeg LABEL'; correct it.");
    }
    pictures.push_back({(cameras / file).string(), place, stamp});
  }
  return pictures;
}

/// Lines `timestamp label` (COLD-Meta), each of which holds until the next. Pictures before the
/// first are left out.
std::vector<LabelledPicture> listByTimes(const fs::path& cameras, const fs::path& labels_file) {
  std::vector<LabelledPicture> pictures;
  double start = std::numeric_limits<double>::infinity(), end = -start;
  for (const std::string& path : picturesBelow(cameras.string())) {
    const double stamp = coldStamp(fs::path(path).filename().string());
    if (std::isnan(stamp)) {
      throw Error(path + " is not named as COLD does (tTIME_xX_yY_aANGLE); remove it.");
    }
    pictures.push_back({path, "", stamp});
    start = std::min(start, stamp);
    end = std::max(end, stamp);
  }
  const Labels labels = Labels::fromFile(labels_file.string(), start, end);
  for (LabelledPicture& picture : pictures) picture.place = labels.at(picture.stamp);
  pictures.erase(std::remove_if(pictures.begin(), pictures.end(),
                                [](const auto& picture) { return picture.place.empty(); }),
                 pictures.end());
  return pictures;
}

std::vector<LabelledPicture> listCold(const fs::path& folder) {
  const fs::path cameras = folder / "std_cam", list = folder / "localization" / "places.lst";
  if (fs::exists(list)) return listByPictures(cameras, list);
  for (const fs::path& labels : {folder / "labels.dat", folder / "localization" / "labels.dat"}) {
    if (fs::exists(labels) && fs::is_directory(cameras)) return listByTimes(cameras, labels);
  }
  throw Error("There is neither " + list.string() + " nor " + (folder / "labels.dat").string() +
              "; give the folder of one COLD sequence, which holds std_cam and one of these.");
}

}  // namespace

std::vector<std::string> picturesBelow(const std::string& folder) {
  std::vector<std::string> paths;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file() && isPicture(entry.path().string())) {
      paths.push_back(entry.path().string());
    }
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

std::vector<std::string> indecsConditions(const std::string& folder) {
  std::set<std::string> conditions;
  for (const std::string& path : picturesBelow(folder)) {
    conditions.insert(IndecsPicture(folder, path).condition);
  }
  conditions.erase("");
  return {conditions.begin(), conditions.end()};
}

std::vector<LabelledPicture> listPictures(const std::string& folder, const Layout& layout) {
  if (!fs::is_directory(folder)) throw Error(folder + " is no folder; check the path.");
  const bool by_rate = layout.name == "rooms" || layout.name == "indecs";
  std::vector<LabelledPicture> pictures = layout.name == "rooms" ? listRooms(folder)
                                          : layout.name == "indecs"
                                              ? listIndecs(folder, layout.condition)
                                          : layout.name == "idol" ? listIdol(folder)
                                                                  : listCold(folder);
  if (pictures.empty()) {
    throw Error("The folder " + folder + " holds no pictures (png, jpg) in the layout '" +
                layout.name + "'; check the path, or give another --layout.");
  }
  if (by_rate) {
    stampByRate(pictures, layout.rate);
  } else {
    std::stable_sort(pictures.begin(), pictures.end(),
                     [](const auto& a, const auto& b) { return a.stamp < b.stamp; });
  }
  return pictures;
}

}  // namespace place_recognition::tool
