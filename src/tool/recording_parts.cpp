#include "tool/recording_parts.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <iostream>
#include <limits>
#include <optional>
#include <regex>
#include <utility>

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

bool shareCamera(const BagInfo& a, const BagInfo& b) {
  return std::any_of(a.topics.begin(), a.topics.end(), [&b](const BagTopic& topic) {
    return hasImages(topic) && topic.messages > 0 &&
           std::any_of(b.topics.begin(), b.topics.end(), [&topic](const BagTopic& other) {
             return other.name == topic.name && other.messages > 0;
           });
  });
}

/// The mean time between two images of the quickest camera, s.
double intervalOf(const BagInfo& bag) {
  std::uint64_t most = 0;
  for (const BagTopic& topic : bag.topics) {
    if (hasImages(topic)) most = std::max(most, topic.messages);
  }
  return most > 1 ? bag.duration / static_cast<double>(most - 1) : 0;
}

/// Whether `bag` may be the part of a recording that follows `before`.
bool mayContinue(const BagInfo& before, const BagInfo& bag) {
  const double gap = std::abs(bag.start - before.start - before.duration);
  return before.start < bag.start && gap <= largestGapOfParts(intervalOf(before)) &&
         shareCamera(before, bag);
}

/// How many numbers differ between the names of two files of one folder that are otherwise the
/// same, as those of the parts of a recording; nothing if more differs.
std::optional<std::size_t> differingNumbers(const std::string& a, const std::string& b) {
  static const std::regex number(R"(\d+)");
  const std::filesystem::path one(a), two(b);
  const std::string first = one.filename().string(), second = two.filename().string();
  if (one.parent_path() != two.parent_path() ||
      std::regex_replace(first, number, "0") != std::regex_replace(second, number, "0")) {
    return std::nullopt;
  }
  std::sregex_iterator of_first(first.begin(), first.end(), number), none;
  std::sregex_iterator of_second(second.begin(), second.end(), number);
  std::size_t count = 0;
  for (; of_first != none; ++of_first, ++of_second) {
    if (of_first->str() != of_second->str()) ++count;
  }
  return count;
}

/// The bag that bag `i` continues; -1 if there is none. Of several, such as those of two robots, it
/// is the one whose name differs in the fewest numbers only; none if that does not decide.
int partBefore(const std::vector<std::string>& names, const std::vector<BagInfo>& bags, int i) {
  constexpr std::size_t kOtherName = std::numeric_limits<std::size_t>::max();
  const auto own = static_cast<std::size_t>(i);
  std::vector<std::pair<std::size_t, int>> candidates;  // by the likeness of their names
  for (std::size_t j = 0; j < bags.size(); ++j) {
    if (!mayContinue(bags[j], bags[own])) continue;
    candidates.emplace_back(differingNumbers(names[j], names[own]).value_or(kOtherName),
                            static_cast<int>(j));
  }
  std::sort(candidates.begin(), candidates.end());
  if (candidates.empty()) return -1;
  if (candidates.size() == 1 || candidates[0].first < candidates[1].first) {
    return candidates[0].second;
  }
  std::cerr << "warning: " << names[own] << " may continue "
            << names[static_cast<std::size_t>(candidates[0].second)] << " or "
            << names[static_cast<std::size_t>(candidates[1].second)]
            << ", so it is treated as a recording of its own.\n";
  return -1;
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

bool startsWithoutLabel(const BagInfo& bag) {
  constexpr double kAtOnce = 0.5;  // s
  return bag.labels.empty() || bag.labels.front().from > kAtOnce;
}

void warnOfStart(const std::string& recording, const BagInfo& bag) {
  std::cerr << "warning: " << recording
            << (bag.labels.empty() ? " has no labels." : " starts without a label.")
            << " If it is a part of a split recording, give the part before it, too, or label it: "
               "place_tool label "
            << recording << " (rosbag record --repeat-latched repeats labels in every part).\n";
}

}  // namespace

std::vector<RecordingPart> partsInOrder(const std::vector<std::string>& recordings,
                                        const BagRecordingOptions& options) {
  if (recordings.size() == 1 && !isLaterPart(recordings.front())) return {{recordings[0], ""}};
  std::vector<BagInfo> bags;
  std::vector<int> before;
  for (const std::string& recording : recordings) bags.push_back(infoOf(recording, options));
  for (int i = 0; i < static_cast<int>(bags.size()); ++i) {
    before.push_back(partBefore(recordings, bags, i));
  }
  std::vector<RecordingPart> parts;
  for (const int number : inOrder(before)) {
    const auto i = static_cast<std::size_t>(number);
    RecordingPart& part = parts.emplace_back(RecordingPart{recordings[i], ""});
    const bool has_labels = !options.label.empty() || !bags[i].labels_file.empty();
    if (has_labels || bags[i].topics.empty()) continue;
    if (before[i] < 0) {
      const bool expects_more = bags[i].labels.empty() && recordings.size() > 1;
      if (startsWithoutLabel(bags[i]) && (isLaterPart(part.path) || expects_more)) {
        warnOfStart(part.path, bags[i]);
      }
      continue;
    }
    const auto previous = static_cast<std::size_t>(before[i]);
    const std::string note =
        "note: " + part.path + " continues where " + recordings[previous] + " ends, ";
    if (bags[previous].last_label.empty()) {
      if (startsWithoutLabel(bags[i])) std::cerr << note << "in no place.\n";
      continue;
    }
    BagRecordingOptions own = options;
    own.initial_label = part.initial_label = bags[previous].last_label;
    bags[i] = infoOf(part.path, own);
    std::cerr << note << "and starts in '" << part.initial_label << "'.\n";
  }
  return parts;
}

}  // namespace place_recognition::tool
