#include "experiments/layout_sets.h"

#include <cctype>
#include <filesystem>
#include <map>

#include "datasets/image_folder.h"
#include "datasets/layouts.h"
#include "place_recognition/error.h"

namespace place_recognition {
namespace {

namespace fs = std::filesystem;

constexpr int kBlocks = 4;  // KTH-TIPS2 has four samples per material

/// The entries of a folder from which a data set is read.
FolderEntries openedEntries(const fs::path& folder) {
  FolderEntries entries = entriesOf(folder.string());
  if (entries.problem.empty()) return entries;
  throw Error("Cannot read the folder " + folder.string() + ": " + entries.problem +
              "; check its permissions.");
}

std::vector<fs::path> foldersIn(const fs::path& folder) {
  std::vector<fs::path> folders;
  for (const std::string& name : openedEntries(folder).folders) folders.push_back(folder / name);
  return folders;
}

/// The condition in the name of a sequence; empty if there is none.
std::string conditionOf(const fs::path& sequence) {
  const std::string name = sequence.filename().string();
  for (const char* condition : {"cloudy", "night", "sunny"}) {
    if (name.find(condition) != std::string::npos) return condition;
  }
  return "";
}

/// Images directly in `folder`, 9.jpg before 10.jpg.
std::vector<std::string> imagesIn(const fs::path& folder) {
  std::vector<std::string> paths;
  for (const std::string& name : openedEntries(folder).images) {
    paths.push_back((folder / name).string());
  }
  return paths;
}

/// The images of all sequences below `folder`, by condition.
void addSequences(const fs::path& folder, const Layout& layout,
                  std::map<std::string, ImageSet>& sets, std::vector<std::string>& warnings) {
  for (const fs::path& child : foldersIn(folder)) {
    const std::string condition = conditionOf(child);
    if (condition.empty()) {
      addSequences(child, layout, sets, warnings);
      continue;
    }
    ImageSet& set = sets[condition];
    set.name = condition;
    const auto images = listImages(child.string(), layout, warnings);
    set.images.insert(set.images.end(), images.begin(), images.end());
  }
}

/// The samples of one material, each a list of images.
std::vector<std::vector<std::string>> samplesOf(const fs::path& material) {
  std::vector<std::vector<std::string>> samples;
  for (const fs::path& sample : foldersIn(material)) samples.push_back(imagesIn(sample));
  if (!samples.empty()) return samples;
  const std::vector<std::string> all = imagesIn(material);
  for (std::size_t block = 0; block < kBlocks; ++block) {
    const auto begin = all.begin() + static_cast<std::ptrdiff_t>(all.size() * block / kBlocks);
    const auto end = all.begin() + static_cast<std::ptrdiff_t>(all.size() * (block + 1) / kBlocks);
    samples.emplace_back(begin, end);
  }
  return samples;
}

void requireFolder(const std::string& folder) {
  if (!fs::is_directory(folder)) throw Error(folder + " is not a folder; check the path.");
}

/// By name.
std::map<std::string, ImageSet> setsByCondition(const std::string& folder,
                                                const std::string& layout,
                                                std::vector<std::string>& warnings) {
  std::map<std::string, ImageSet> sets;
  Layout one;
  one.name = layout;
  if (layout == "indecs") {
    for (const std::string& condition : indecsConditions(folder)) {
      one.condition = condition;
      sets[condition] = {condition, listImages(folder, one, warnings)};
    }
  } else {
    addSequences(folder, one, sets, warnings);
  }
  return sets;
}

/// The kind of a place of COLD: 2PO for 2PO1-A.
std::string kindOf(const std::string& place) {
  std::string kind = place.substr(0, place.find('-'));
  while (kind.size() > 1 && std::isdigit(static_cast<unsigned char>(kind.back()))) kind.pop_back();
  return kind;
}

}  // namespace

std::vector<ImageSet> conditionSets(const std::string& folder, const std::string& layout,
                                    std::vector<std::string>& warnings) {
  requireFolder(folder);
  std::map<std::string, ImageSet> sets = setsByCondition(folder, layout, warnings);
  if (sets.size() < 2) {
    throw Error("The folder " + folder +
                " does not contain images of at least two conditions (cloudy, night, "
                "sunny); see doc/datasets.md for the layouts.");
  }
  std::vector<ImageSet> list;
  for (auto& [name, set] : sets) list.push_back(std::move(set));
  return list;
}

std::vector<ImageSet> buildingSets(const std::string& folder, const std::string& layout,
                                   std::vector<std::string>& warnings) {
  requireFolder(folder);
  std::vector<ImageSet> buildings;
  for (const fs::path& path : foldersIn(folder)) {
    ImageSet& building = buildings.emplace_back();
    building.name = path.filename().string();
    for (auto& [condition, set] : setsByCondition(path.string(), layout, warnings)) {
      for (LabelledImage& image : set.images) {
        if (layout == "cold") image.place = kindOf(image.place);
        building.images.push_back(std::move(image));
      }
    }
    if (building.images.empty()) {
      throw Error("The folder " + path.string() +
                  " contains no images of a condition (cloudy, night, sunny); see "
                  "doc/datasets.md for the layouts.");
    }
  }
  return buildings;
}

std::vector<ImageSet> sampleSets(const std::string& folder) {
  requireFolder(folder);
  std::vector<ImageSet> sets;
  for (const fs::path& material : foldersIn(folder)) {
    const auto samples = samplesOf(material);
    if (sets.empty()) sets.resize(samples.size());
    if (samples.size() != sets.size()) {
      throw Error(material.string() + " has " + std::to_string(samples.size()) +
                  " samples, but others have " + std::to_string(sets.size()) +
                  "; give each material the same number.");
    }
    for (std::size_t i = 0; i < samples.size(); ++i) {
      sets[i].name = "sample " + std::to_string(i + 1);
      for (const std::string& path : samples[i]) {
        const auto stamp = static_cast<double>(sets[i].images.size());
        sets[i].images.push_back({path, material.filename().string(), stamp});
      }
    }
  }
  for (const ImageSet& set : sets) {
    if (set.images.empty())
      throw Error("There are too few images in " + folder + "; give each material at least four.");
  }
  if (sets.empty()) {
    throw Error("The folder " + folder +
                " contains no materials; arrange it as MATERIAL/SAMPLE/IMAGE.");
  }
  return sets;
}

}  // namespace place_recognition
