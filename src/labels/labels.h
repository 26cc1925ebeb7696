#pragma once

#include <algorithm>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace place_recognition {

/// Throws Error unless `label` can name a place that is learned (see whyNoPlaceName()); `where`
/// tells where it stands.
void checkLabel(const std::string& label, const std::string& where);

/// Which place a recording shows at which time. Times are bag times, when messages were recorded
/// (as rosbag play and rqt_bag show them), s.
class Labels {
 public:
  /// One place throughout. Throws Error like checkLabel().
  static Labels wholeBag(const std::string& place);

  /// Reads a file beside a bag that starts at `start` and ends at `end`. A YAML file holds
  /// intervals:
  ///
  ///     times: relative          # seconds since the bag's start; or absolute, as stamps
  ///     labels:
  ///       - {from: 0, to: 12.5, place: kitchen}
  ///       - {from: 15, place: corridor}   # no `to`: until the next interval
  ///
  /// and its intervals do not overlap; `labels: []` says that there are none. Any other file has
  /// lines `timestamp label` in order of time, each of which holds until the next; see
  /// readLabelLines(). Throws Error naming the line at fault, or if no label falls into the bag.
  static Labels fromFile(const std::string& path, double start, double end);

  /// From `time`, not before the one before it, the label is `label`, as placeName() has it; empty:
  /// none. Of two labels at one time the later counts.
  void add(double time, const std::string& label);

  /// The place at `time`, empty before the first label.
  const std::string& at(double time) const;

  /// How a file was read, a sentence for a person, if not as it should be written; else empty.
  const std::string& note() const { return note_; }

  /// Calls visit(from, to, place) for each labelled stretch between `start` and `end`.
  template <typename Visit>
  void forEach(double start, double end, Visit visit) const {
    for (std::size_t i = 0; i < changes_.size(); ++i) {
      const auto& [from, place] = changes_[i];
      const double to =
          i + 1 < changes_.size() ? changes_[i + 1].first : std::numeric_limits<double>::infinity();
      if (place.empty() || to <= start || from > end) continue;
      visit(std::max(start, from), std::min(end, to), place);
    }
  }

 private:
  std::vector<std::pair<double, std::string>> changes_;  // in order of time
  std::string note_;
};

}  // namespace place_recognition
