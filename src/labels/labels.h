#pragma once

#include <algorithm>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace place_recognition {

/// Throws Error unless `label` can name a place to learn (see whyNoPlaceName()); `where` states its
/// position.
void checkLabel(const std::string& label, const std::string& where);

/// The places that a recording shows over time. Times are bag times in s, at which messages were
/// recorded (as rosbag play and rqt_bag show them).
class Labels {
 public:
  /// One place for the whole bag. Throws Error like checkLabel().
  static Labels wholeBag(const std::string& place);

  /// Reads a file beside a bag that starts at `start` and ends at `end`. A YAML file contains
  /// intervals:
  ///
  ///     times: relative          # seconds since the bag's start; or absolute, as stamps
  ///     labels:
  ///       - {from: 0, to: 12.5, place: kitchen}
  ///       - {from: 15, place: corridor}   # no `to`: until the next interval
  ///
  /// The intervals must not overlap; `labels: []` means that there are none. Any other file
  /// contains lines `timestamp label` in order of time; each label is valid until the next one, see
  /// readLabelLines(). Throws Error naming the faulty line, or if no label falls into the bag.
  static Labels fromFile(const std::string& path, double start, double end);

  /// Sets the label from `time` on, which must not precede the last one, to `label`, normalized by
  /// placeName(); empty means none. Of two labels at the same time the later one is valid.
  void add(double time, const std::string& label);

  /// The place at `time`, empty before the first label.
  const std::string& at(double time) const;

  /// For a person: how a file was read if it deviates from the format, and which of its
  /// intervals lie outside the bag; else empty.
  const std::string& note() const { return note_; }

  /// Whether note() names the intervals outside the bag, if there are any.
  bool notesOutside() const { return notes_outside_; }

  /// Calls visit(from, to, place) for each labelled interval between `start` and `end`.
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
  bool notes_outside_ = false;
};

}  // namespace place_recognition
