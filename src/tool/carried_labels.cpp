#include "tool/carried_labels.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <numeric>
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
  const auto gapBehind = [&](int j) {
    const BagInfo& bag = bags[static_cast<std::size_t>(j)];
    return std::abs(bags[static_cast<std::size_t>(i)].start - bag.start - bag.duration);
  };
  int nearest = -1;
  for (int j = 0; j < static_cast<int>(bags.size()); ++j) {
    const bool may_be = j != i && !bags[static_cast<std::size_t>(j)].topics.empty();
    if (!may_be || gapBehind(j) > kMaxGapOfParts) continue;
    if (j == i - 1) return j;
    if (nearest < 0 || gapBehind(j) < gapBehind(nearest)) nearest = j;
  }
  return nearest;
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

std::vector<std::string> carriedLabels(const std::vector<std::string>& recordings,
                                       const BagRecordingOptions& options) {
  std::vector<std::string> carried(recordings.size());
  const bool may_lack =
      recordings.size() > 1 || (!recordings.empty() && isLaterPart(recordings.front()));
  if (!may_lack || !options.label.empty()) return carried;
  std::vector<BagInfo> bags;
  for (const std::string& recording : recordings) bags.push_back(infoOf(recording, options));
  // In order of time, so that a label is carried through parts without labels.
  std::vector<int> order(recordings.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&bags](int a, int b) {
    return bags[static_cast<std::size_t>(a)].start < bags[static_cast<std::size_t>(b)].start;
  });
  for (const int number : order) {
    const auto i = static_cast<std::size_t>(number);
    if (bags[i].topics.empty() || !bags[i].labels_file.empty()) continue;
    const int before = partBefore(bags, number);
    if (before < 0 || bags[static_cast<std::size_t>(before)].last_label.empty()) {
      warnOfStart(recordings[i], bags[i], recordings.size() > 1);
      continue;
    }
    BagRecordingOptions own = options;
    own.initial_label = carried[i] = bags[static_cast<std::size_t>(before)].last_label;
    bags[i] = infoOf(recordings[i], own);
    std::cerr << "note: " << recordings[i] << " continues where "
              << recordings[static_cast<std::size_t>(before)] << " ends, and starts in '"
              << carried[i] << "'.\n";
  }
  return carried;
}

}  // namespace place_recognition::tool
