#include "tool/recording_parts.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <iostream>
#include <limits>
#include <regex>

#include "place_recognition/error.h"
#include "recognition/frames/continuity.h"
#include "ros/bags/bag_file.h"

namespace place_recognition::tool {
namespace {

/// The contents of a bag; empty if it cannot be read, which its reader will report.
BagInfo infoOf(const std::string& recording, const BagRecordingOptions& options) {
  try {
    return isBag(recording) ? bagInfo(recording, options) : BagInfo();
  } catch (const Error&) {
    return {};
  }
}

/// Whether `recording` has the name that rosbag gives to later parts of a recording.
bool isLaterPart(const std::string& recording) {
  static const std::regex part(R"(.*_0*[1-9]\d{0,3}\.bag)");
  const std::string name = std::filesystem::path(recording).filename().string();
  return name.size() < 256 && std::regex_match(name, part);
}

/// The bag that ends where bag `i` starts, preferably the one given before it; -1 if there is none.
int partBefore(const std::vector<BagInfo>& bags, int i) {
  const BagInfo& bag = bags[static_cast<std::size_t>(i)];
  int nearest = -1;
  double smallest_gap = std::numeric_limits<double>::infinity();
  for (int j = 0; j < static_cast<int>(bags.size()); ++j) {
    const BagInfo& other = bags[static_cast<std::size_t>(j)];
    const double gap = std::abs(bag.start - other.start - other.duration);
    if (other.topics.empty() || other.start >= bag.start || gap > kMaxGapOfParts) continue;
    if (j == i - 1) return j;
    if (gap >= smallest_gap) continue;
    nearest = j;
    smallest_gap = gap;
  }
  return nearest;
}

/// All numbers of `before`, each directly followed by those that it is before.
std::vector<int> inOrder(const std::vector<int>& before) {
  std::vector<int> order;
  const std::function<void(int)> add = [&](int previous) {
    for (int i = 0; i < static_cast<int>(before.size()); ++i) {
      if (before[static_cast<std::size_t>(i)] != previous) continue;
      order.push_back(i);
      add(i);
    }
  };
  add(-1);
  return order;
}

void warnOfStart(const std::string& recording, const BagInfo& bag, bool among_others) {
  constexpr double kAtOnce = 0.5;  // s
  const bool none = bag.labels.empty();
  if (!none && bag.labels.front().from <= kAtOnce) return;
  if (!isLaterPart(recording) && !(none && among_others)) return;
  std::cerr << "warning: " << recording << (none ? " has no labels." : " starts without a label.")
            << " A label from another part of its recording is carried over if that part is "
               "given, too; rosbag record --repeat-latched repeats labels in every part.\n";
}

}  // namespace

std::vector<RecordingPart> partsInOrder(const std::vector<std::string>& recordings,
                                        const BagRecordingOptions& options) {
  if (recordings.size() == 1 && !isLaterPart(recordings.front())) return {{recordings[0], ""}};
  std::vector<BagInfo> bags;
  std::vector<int> before;
  for (const std::string& recording : recordings) bags.push_back(infoOf(recording, options));
  for (int i = 0; i < static_cast<int>(bags.size()); ++i) before.push_back(partBefore(bags, i));
  std::vector<RecordingPart> parts;
  for (const int number : inOrder(before)) {
    const auto i = static_cast<std::size_t>(number);
    RecordingPart& part = parts.emplace_back(RecordingPart{recordings[i], ""});
    const bool has_labels = !options.label.empty() || !bags[i].labels_file.empty();
    if (has_labels || bags[i].topics.empty()) continue;
    const auto previous = static_cast<std::size_t>(before[i]);
    if (before[i] < 0 || bags[previous].last_label.empty()) {
      warnOfStart(part.path, bags[i], recordings.size() > 1);
      continue;
    }
    BagRecordingOptions own = options;
    own.initial_label = part.initial_label = bags[previous].last_label;
    bags[i] = infoOf(part.path, own);
    std::cerr << "note: " << part.path << " continues where " << recordings[previous]
              << " ends, and starts in '" << part.initial_label << "'.\n";
  }
  return parts;
}

}  // namespace place_recognition::tool
