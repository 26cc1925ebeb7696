#include "tool/carried_labels.h"

#include <cmath>
#include <iostream>

#include "place_recognition/error.h"
#include "ros/bag_file.h"

namespace place_recognition::tool {
namespace {

/// s; parts of a recording follow each other within a message or two.
constexpr double kMaxGap = 2;

/// What is in a bag whose labels are its own; nothing for what cannot be read, which its reader
/// will tell.
BagInfo infoOf(const std::string& run, const BagRunOptions& options) {
  try {
    return isBag(run) ? bagInfo(run, options) : BagInfo();
  } catch (const Error&) {
    return {};
  }
}

}  // namespace

std::vector<std::string> carriedLabels(const std::vector<std::string>& runs,
                                       const BagRunOptions& options) {
  std::vector<std::string> carried(runs.size());
  if (runs.size() < 2 || !options.label.empty()) return carried;
  BagInfo before;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    BagRunOptions own = options;
    BagInfo bag = infoOf(runs[i], own);
    const double gap = bag.start - before.start - before.duration;
    const bool has_topics = !bag.topics.empty() && bag.labels_file.empty();
    if (has_topics && !before.last_label.empty() && std::abs(gap) <= kMaxGap) {
      carried[i] = own.initial_label = before.last_label;
      bag = infoOf(runs[i], own);
      std::cerr << "note: " << runs[i] << " goes on where " << runs[i - 1]
                << " ends, and starts in '" << carried[i] << "'.\n";
    } else if (has_topics && bag.labels.empty()) {
      std::cerr
          << "warning: " << runs[i]
          << " has no labels. One that was said in another bag holds in the next only if that "
             "is given behind it and goes on where it ends; rosbag record --repeat-latched "
             "repeats it in every part.\n";
    }
    before = std::move(bag);
  }
  return carried;
}

}  // namespace place_recognition::tool
