#include "tool/inputs.h"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <map>
#include <set>
#include <system_error>

#include "base/bag_name.h"
#include "base/text.h"
#include "datasets/image_folder.h"
#include "datasets/image_sequence.h"
#include "place_recognition/error.h"
#include "ros/bags/bag_file.h"
#include "tool/output.h"
#include "tool/recording_parts.h"

namespace place_recognition::tool {
namespace {

namespace fs = std::filesystem;

/// The first bag directly in a folder; empty if there is none.
std::string firstBagIn(const std::string& folder) {
  for (const std::string& name : entriesOf(folder).others) {
    const std::string path = (fs::path(folder) / name).string();
    if (isBag(path)) return path;
  }
  return "";
}

constexpr const char* kBagGroup = "Options for bags";

/// Whether `path` is one run. A folder with bags is a folder of runs, whatever else it contains.
bool isRecording(const std::string& path) {
  return isBag(path) ||
         (fs::is_directory(path) && holdsRoomImages(path) && firstBagIn(path).empty());
}

/// Why a folder without runs yields nothing.
std::string whyNoRoomFolders(const std::string& folder) {
  const FolderEntries entries = entriesOf(folder);
  if (!entries.problem.empty()) return "it cannot be opened (" + entries.problem + ")";
  const std::string bag = firstBagIn(folder);
  if (!bag.empty()) return "it contains bags, such as " + bag + "; give this folder itself";
  const FoundImages found = findRoomImages(folder);
  if (!found.images.empty()) {
    return "its images are nested too deeply, such as " + found.images.front().path +
           "; arrange them as room/image";
  }
  std::vector<std::string> reasons{"it contains no room/image files"};
  reasons.insert(reasons.end(), found.warnings.begin(), found.warnings.end());
  return listed(reasons, "; ");
}

/// Why no image can be read from a bag. Problems with its labels are reported elsewhere, because
/// they can be corrected.
std::string whyUnreadable(const std::string& bag) {
  BagRecordingOptions without_labels;
  without_labels.label = "any";
  try {
    const BagInfo info = bagInfo(bag, without_labels);
    std::vector<std::string> topics;
    for (const BagTopic& topic : info.topics) {
      if (hasImages(topic) && topic.messages > 0) return "";
      topics.push_back(topic.name);
    }
    return whyNoImages(topics);
  } catch (const Error& e) {
    const std::string message = e.what(), start = "Cannot read " + bag + ": ";
    return message.substr(startsWith(message, start) ? start.size() : 0);
  }
}

/// Why `path`, in a folder of runs, is not a run; empty if nobody would expect it to be one.
std::string whyPassedOver(const std::string& path) {
  std::error_code ignored;
  const std::string what = whyNoRecording(path);
  const bool is_folder = fs::is_directory(path, ignored);
  if (!what.empty()) return is_folder || isBag(path) ? "it is " + what : "";
  if (isBag(path)) return whyUnreadable(path);
  return is_folder && !isRecording(path) ? whyNoRoomFolders(path) : "";
}

/// Finds the runs directly in a folder, and reports entries that look like runs but yield nothing.
void findRecordingsIn(const std::string& folder, std::vector<std::string>& recordings) {
  const FolderEntries entries = entriesOf(folder);
  if (!entries.problem.empty()) {
    throw Error("Cannot read the folder " + folder + ": " + entries.problem +
                "; check its permissions.");
  }
  std::vector<std::string> names = entries.folders;
  names.insert(names.end(), entries.others.begin(), entries.others.end());
  std::sort(names.begin(), names.end(), naturalLess);
  const std::string bag = firstBagIn(folder);
  const std::size_t before = recordings.size();
  std::vector<std::string> passed_over;  // sentences
  const auto pass_over = [&](const std::string& path, const std::string& why) {
    const std::string end = why.back() == '.' ? "" : ".";
    passed_over.push_back("Nothing was read from " + path + ": " + why + end);
  };
  for (const std::string& name : names) {
    const std::string path = (fs::path(folder) / name).string();
    const std::string why = whyPassedOver(path);
    if (!why.empty()) {
      pass_over(path, why);
    } else if (!bag.empty() && fs::is_directory(path) && !entriesOf(path).images.empty()) {
      pass_over(path, "its images lie beside bags, such as " + bag +
                          "; put its room folder into a folder without bags");
    } else if (isRecording(path)) {
      recordings.push_back(path);
    }
  }
  for (const std::string& name : entries.dead) {
    pass_over((fs::path(folder) / name).string(), "it is a broken link");
  }
  if (recordings.size() == before) {
    passed_over.insert(
        passed_over.begin(),
        "The folder " + folder +
            " contains neither bags nor room/image files (png, jpg, webp, bmp or tiff); put the "
            "images of each room into a folder with the room's name.");
    throw Error(listed(passed_over, " "));
  }
  printWarnings(passed_over);
}

void findRecordingsOf(const std::string& input, std::vector<std::string>& recordings) {
  std::error_code failure;
  if (!fs::exists(input, failure)) {
    const bool is_link = fs::is_symlink(input, failure);
    const std::string meant = bagBeside(input);
    throw Error(input + (is_link ? " is a broken link" : " does not exist") + "; " +
                (meant.empty() ? "check the path" : meant) + ".");
  }
  const std::string what = whyNoRecording(input);
  if (!what.empty()) throw Error(input + " is " + what + ".");
  if (isRecording(input)) {
    recordings.push_back(input);
  } else if (fs::is_directory(input)) {
    findRecordingsIn(input, recordings);
  } else {
    throw Error(input +
                " is neither a bag nor a folder; give a file that ends in .bag or a "
                "folder of room/image files.");
  }
}

/// A run that is given twice would be held out and learned at once.
std::vector<std::string> withoutRepetitions(const std::vector<std::string>& recordings) {
  std::vector<std::string> distinct;
  std::set<fs::path> seen;
  for (const std::string& recording : recordings) {
    if (seen.insert(fs::canonical(recording)).second) {
      distinct.push_back(recording);
    } else {
      std::cerr << "warning: " << recording << " is given twice and read once.\n";
    }
  }
  return distinct;
}

/// Warns of bags with one file of labels, such as run.1 and run.2 with run.labels.yaml.
void warnOfSharedLabels(const std::vector<std::string>& recordings) {
  std::map<std::string, std::string> bags;  // by file of labels
  for (const std::string& recording : recordings) {
    const std::string labels =
        isBag(recording) ? ownLabelsFile(fs::absolute(recording).lexically_normal()) : "";
    if (labels.empty()) continue;
    const auto [bag, is_new] = bags.emplace(labels, recording);
    if (is_new) continue;
    std::cerr << "warning: " << labels << " labels both " << bag->second << " and " << recording
              << "; if it describes only one of them, rename the other.\n";
  }
}

}  // namespace

const char* const kInputHelp =
    "Labelled runs: bags, folders of room/image files (png, jpg, webp, bmp, tiff), or folders of "
    "these";

void InputOptions::addImageTopicTo(Verb& verb) {
  verb.option("--image-topic", "TOPIC", bag.image_topics,
              "Topic of the images, required if there are several; for the cameras of one robot, "
              "several topics separated by commas")
      .commaSeparated()
      .group(kBagGroup);
}

void InputOptions::addTo(Verb& verb) {
  addImageTopicTo(verb);
  verb.option("--label-topic", "TOPIC", bag.label_topic,
              "Topic of the labels, std_msgs/String (default " + bag.label_topic + ")")
      .group(kBagGroup);
  verb.option("--labels", "FILE", bag.labels_file,
              "File of labels; RUN.labels.yaml or labels.dat beside RUN.bag is found automatically")
      .excludes("--label-topic")
      .group(kBagGroup);
  verb.option("--label", "PLACE", bag.label, "Every bag shows only this place")
      .excludes("--labels")
      .excludes("--label-topic")
      .group(kBagGroup);
}

std::vector<RecordingOpener> InputOptions::openers(const std::vector<std::string>& inputs,
                                                   bool are_all) const {
  const std::vector<std::string> recordings = findRecordings(inputs);
  if (are_all && !recordings.empty()) requireBag(recordings);
  if (!bag.labels_file.empty() && std::count_if(recordings.begin(), recordings.end(), isBag) > 1) {
    throw Error(
        "--labels " + bag.labels_file +
        " applies to a single bag; for several bags, put a file RUN.labels.yaml beside each.");
  }
  if (bag.labels_file.empty() && bag.label.empty()) warnOfSharedLabels(recordings);
  std::vector<RecordingOpener> openers;
  for (const RecordingPart& part : partsInOrder(recordings, bag)) {
    InputOptions options = *this;
    options.bag.initial_label = part.initial_label;
    openers.push_back([options, path = part.path] { return options.open(path); });
  }
  return openers;
}

InputOptions InputOptions::withoutLabels() const {
  InputOptions others = *this;
  others.bag.label.clear();
  others.bag.labels_file.clear();
  return others;
}

std::unique_ptr<Recording> InputOptions::open(const std::string& recording) const {
  return isBag(recording) ? openBagRecording(recording, bag) : openFolderRecording(recording);
}

void InputOptions::requireBag(const std::vector<std::string>& paths) const {
  if (std::any_of(paths.begin(), paths.end(), isBag)) return;
  const BagRecordingOptions defaults;
  const std::pair<const char*, bool> options[] = {
      {"--image-topic", !bag.image_topics.empty()},
      {"--label-topic", bag.label_topic != defaults.label_topic},
      {"--initial-label", !bag.initial_label.empty()},
      {"--labels", !bag.labels_file.empty()},
      {"--label", !bag.label.empty()}};
  for (const auto& [option, is_given] : options) {
    if (!is_given) continue;
    throw UsageError(std::string(option) +
                     " applies to bags, and there is none; the folder of an image names its room");
  }
}

void addThreads(Verb& verb, unsigned& threads) {
  verb.option("--threads", "N", threads, "Threads, 0..1024; 0: one per core. Changes no result")
      .range(0, 1024);
}

std::vector<std::string> findRecordings(const std::vector<std::string>& inputs) {
  std::vector<std::string> recordings;
  for (const std::string& input : inputs) findRecordingsOf(input, recordings);
  return withoutRepetitions(recordings);
}

Frame imageFrame(const std::string& path, const LevelRange& levels) {
  std::error_code ignored;
  if (!fs::exists(path, ignored)) {
    const std::string meant = bagBeside(path);
    throw Error("There is no image " + path + "; " + (meant.empty() ? "check the path" : meant) +
                ".");
  }
  ImageSequence sequence({path});
  sequence.setLevelRange(levels);
  DecodedImage decoded = sequence.read(0);
  Frame frame;
  frame.name = path;
  frame.image = std::move(decoded.image);
  frame.problem = std::move(decoded.problem);
  return frame;
}

cv::Mat readImage(const std::string& path) {
  const Frame frame = imageFrame(path, {});
  if (!frame.image.empty()) return frame.image;
  throw Error("The image " + path + " cannot be used: " + frame.problem +
              "; remove or replace it.");
}

}  // namespace place_recognition::tool
