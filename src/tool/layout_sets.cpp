#include "tool/layout_sets.h"

#include <algorithm>
#include <filesystem>
#include <map>

#include "place_recognition/error.h"
#include "tool/inputs.h"
#include "tool/layouts.h"

namespace place_recognition::tool {
namespace {

namespace fs = std::filesystem;

constexpr int kBlocks = 4;  // KTH-TIPS2 has four samples a material

std::vector<fs::path> foldersIn(const fs::path& folder) {
  std::vector<fs::path> folders;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (entry.is_directory()) folders.push_back(entry.path());
  }
  std::sort(folders.begin(), folders.end());
  return folders;
}

/// The condition that the name of a sequence tells; empty if none.
std::string conditionOf(const fs::path& sequence) {
  const std::string name = sequence.filename().string();
  for (const char* condition : {"cloudy", "night", "sunny"}) {
    if (name.find(condition) != std::string::npos) return condition;
  }
  return "";
}

/// The pictures of all sequences below `folder`, by condition.
void addSequences(const fs::path& folder, const Layout& layout,
                  std::map<std::string, PictureSet>& sets) {
  for (const fs::path& child : foldersIn(folder)) {
    const std::string condition = conditionOf(child);
    if (condition.empty()) {
      addSequences(child, layout, sets);
      continue;
    }
    PictureSet& set = sets[condition];
    set.name = condition;
    const auto pictures = listPictures(child.string(), layout);
    set.pictures.insert(set.pictures.end(), pictures.begin(), pictures.end());
  }
}

/// Pictures directly in `folder`, 9.jpg before 10.jpg.
std::vector<std::string> picturesIn(const fs::path& folder) {
  std::vector<std::string> paths;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (isPicture(entry.path().string())) paths.push_back(entry.path().string());
  }
  std::sort(paths.begin(), paths.end(), [](const std::string& a, const std::string& b) {
    return a.size() != b.size() ? a.size() < b.size() : a < b;
  });
  return paths;
}

/// The samples of one material, each a list of pictures.
std::vector<std::vector<std::string>> samplesOf(const fs::path& material) {
  std::vector<std::vector<std::string>> samples;
  for (const fs::path& sample : foldersIn(material)) samples.push_back(picturesIn(sample));
  if (!samples.empty()) return samples;
  const std::vector<std::string> all = picturesIn(material);
  for (std::size_t block = 0; block < kBlocks; ++block) {
    const auto begin = all.begin() + static_cast<std::ptrdiff_t>(all.size() * block / kBlocks);
    const auto end = all.begin() + static_cast<std::ptrdiff_t>(all.size() * (block + 1) / kBlocks);
    samples.emplace_back(begin, end);
  }
  return samples;
}

void requireFolder(const std::string& folder) {
  if (!fs::is_directory(folder)) throw Error(folder + " is no folder; check the path.");
}

}  // namespace

std::vector<PictureSet> conditionSets(const std::string& folder, const std::string& layout) {
  requireFolder(folder);
  std::map<std::string, PictureSet> sets;
  Layout one;
  one.name = layout;
  if (layout == "indecs") {
    for (const std::string& condition : indecsConditions(folder)) {
      one.condition = condition;
      sets[condition] = {condition, listPictures(folder, one)};
    }
  } else {
    addSequences(folder, one, sets);
  }
  if (sets.size() < 2) {
    throw Error("The folder " + folder +
                " does not hold pictures of two conditions of light or more (cloudy, night, "
                "sunny); see doc/datasets.md for the layouts.");
  }
  std::vector<PictureSet> list;
  for (auto& [name, set] : sets) list.push_back(std::move(set));
  return list;
}

std::vector<PictureSet> sampleSets(const std::string& folder) {
  requireFolder(folder);
  std::vector<PictureSet> sets;
  for (const fs::path& material : foldersIn(folder)) {
    const auto samples = samplesOf(material);
    if (sets.empty()) sets.resize(samples.size());
    if (samples.size() != sets.size()) {
      throw Error(material.string() + " has " + std::to_string(samples.size()) +
                  " samples where others have " + std::to_string(sets.size()) +
                  "; give each material the same number.");
    }
    for (std::size_t i = 0; i < samples.size(); ++i) {
      sets[i].name = "sample " + std::to_string(i + 1);
      for (const std::string& path : samples[i]) {
        const auto stamp = static_cast<double>(sets[i].pictures.size());
        sets[i].pictures.push_back({path, material.filename().string(), stamp});
      }
    }
  }
  for (const PictureSet& set : sets) {
    if (set.pictures.empty()) throw Error("There are too few pictures in " + folder + ".");
  }
  if (sets.empty()) {
    throw Error("The folder " + folder + " holds no materials; give MATERIAL/SAMPLE/PICTURE.");
  }
  return sets;
}

}  // namespace place_recognition::tool
