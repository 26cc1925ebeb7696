#include "labels/labels.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>

#include "base/options.h"
#include "base/place_name.h"
#include "base/text.h"
#include "labels/label_lines.h"
#include "place_recognition/error.h"

namespace place_recognition {
namespace {

struct Interval {
  double from = std::numeric_limits<double>::quiet_NaN();
  double to = std::numeric_limits<double>::infinity();
  std::string place;

  template <typename Self, typename Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor("from", self.from, "s; required");
    visitor("to", self.to, "s; if omitted: until the next interval");
    visitor("place", self.place, "label");
  }
};

struct LabelsFile {
  std::string times = "relative";
  std::vector<Interval> labels;

  template <typename Self, typename Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor("times", self.times, "relative to the bag's start, or absolute");
    visitor("labels", self.labels, "intervals");
  }
};

/// In order of time. Nothing if the file says `labels: []`, which means that there deliberately are
/// none.
std::optional<std::vector<Interval>> readIntervals(const std::string& path, double start) {
  LabelsFile file;
  const YAML::Node tree = readYamlFile(path);
  const YAML::Node list = tree.IsMap() ? tree["labels"] : YAML::Node(YAML::NodeType::Undefined);
  if (list.IsDefined() && !list.IsSequence() && list.size() == 0) {
    throw Error(path + ": labels is not a list; write 'labels: []' if there are none.");
  }
  readOptions(tree, path, file);
  if (file.times != "relative" && file.times != "absolute") {
    throw Error(path + ": times is '" + file.times + "'; it must be relative or absolute.");
  }
  if (file.labels.empty() && list.IsDefined()) return std::nullopt;
  const double origin = file.times == "relative" ? start : 0;
  for (std::size_t i = 0; i < file.labels.size(); ++i) {
    Interval& interval = file.labels[i];
    const std::string where = path + ", labels[" + std::to_string(i) + "]";
    checkLabel(interval.place, where);
    if (std::isnan(interval.from)) {
      throw Error(where + ": 'from' is missing or no number; give the time at which " +
                  inQuotes(interval.place) + " begins.");
    }
    if (!std::isfinite(interval.from) || !(interval.from < interval.to)) {
      throw Error(where + ": 'from' must be less than 'to'.");
    }
    interval.from += origin;
    interval.to += origin;
  }
  std::stable_sort(file.labels.begin(), file.labels.end(),
                   [](const Interval& a, const Interval& b) { return a.from < b.from; });
  return std::move(file.labels);
}

void addIntervals(const std::vector<Interval>& intervals, const std::string& path, Labels& labels) {
  for (std::size_t i = 0; i < intervals.size(); ++i) {
    const Interval& interval = intervals[i];
    labels.add(interval.from, interval.place);
    const bool last = i + 1 == intervals.size();
    const double next = last ? std::numeric_limits<double>::infinity() : intervals[i + 1].from;
    if (!std::isfinite(interval.to) && interval.from < next) continue;
    if (interval.to > next) {
      throw Error(path + ": the intervals of " + inQuotes(interval.place) + " and " +
                  inQuotes(intervals[i + 1].place) + " overlap; let the first end earlier.");
    }
    if (interval.to < next) labels.add(interval.to, "");
  }
}

/// Returns a sentence if a line has no effect, else nothing.
std::string addLines(const std::vector<LabelLine>& lines, const std::string& path, Labels& labels) {
  std::string note;
  const LabelLine* before = nullptr;
  for (const LabelLine& line : lines) {
    const std::string where = path + ", line " + std::to_string(line.number);
    if (!line.label.empty()) checkLabel(line.label, where);
    if (before && line.time < before->time) {
      throw Error(where + ": time runs backwards; sort the lines.");
    }
    if (note.empty() && before && line.time == before->time && line.label != before->label) {
      note = where + " has the same timestamp as the line before, whose label " +
             inQuotes(before->label) + " has no effect.";
    }
    labels.add(line.time, line.label);
    before = &line;
  }
  return note;
}

/// "1000 to 1100 s", or "from 1000 s" if it has no end.
std::string spanText(double from, double to) {
  if (!std::isfinite(to)) return "from " + significant(from, 13) + " s";
  return significant(from, 13) + " to " + significant(to, 13) + " s";
}

/// Returns a sentence if intervals lie outside a bag, else nothing.
std::string noteOnOutside(const std::vector<Interval>& intervals, const std::string& path,
                          double start, double end) {
  std::uint64_t count = 0;
  std::string first;
  for (std::size_t i = 0; i < intervals.size(); ++i) {
    const auto& [from, to, place] = intervals[i];
    const double last = i + 1 < intervals.size() ? std::min(to, intervals[i + 1].from) : to;
    if (from <= end && last > start) continue;
    if (count++ == 0) first = inQuotes(place) + ", " + spanText(from, last);
  }
  if (count == 0) return "";
  return path + ": " + counted(count, "interval") + (count == 1 ? " lies" : " lie") +
         " outside the bag, which extends from " + spanText(start, end) + " (" +
         (count == 1 ? "" : "the first: ") + first + "); left out.";
}

[[noreturn]] void throwNoneFits(const std::string& path, double start, double end,
                                const std::string& hint) {
  throw Error(path + ": no label falls into the bag, which extends from " + spanText(start, end) +
              "; correct the times or remove the file. " + hint);
}

}  // namespace

void checkLabel(const std::string& label, const std::string& where) {
  const std::string why_not = whyNoPlaceName(label);
  if (!why_not.empty()) throw Error(where + ": the label " + inQuotes(label) + " " + why_not);
}

Labels Labels::wholeBag(const std::string& place) {
  checkLabel(place, "Label of the whole bag");
  Labels labels;
  labels.add(-std::numeric_limits<double>::infinity(), place);
  return labels;
}

Labels Labels::fromFile(const std::string& path, double start, double end) {
  const std::string extension = std::filesystem::path(path).extension().string();
  Labels labels;
  if (extension == ".yaml" || extension == ".yml") {
    const std::optional<std::vector<Interval>> intervals = readIntervals(path, start);
    if (!intervals) return labels;
    addIntervals(*intervals, path, labels);
    bool fits = false;
    labels.forEach(start, end, [&fits](double, double, const std::string&) { fits = true; });
    if (!fits) {
      throwNoneFits(path, start, end,
                    "Times relative to the bag's start need 'times: relative', and bag times "
                    "'times: absolute'.");
    }
    labels.note_ = noteOnOutside(*intervals, path, start, end);
    labels.notes_outside_ = true;
    return labels;
  }
  const LabelLines lines = readLabelLines(path);
  const std::string unused = addLines(lines.lines, path, labels);
  if (!lines.note.empty()) labels.note_ = path + " " + lines.note;
  if (!unused.empty()) labels.note_ += (labels.note_.empty() ? "" : " ") + unused;
  if (labels.changes_.empty() || labels.changes_.front().first > end ||
      labels.changes_.back().first < start) {
    throwNoneFits(path, start, end, "Put times relative to the bag's start into RUN.labels.yaml.");
  }
  return labels;
}

void Labels::add(double time, const std::string& label) {
  const std::string place = placeName(label);
  if (!changes_.empty() && changes_.back().first == time) changes_.pop_back();
  const bool changes = changes_.empty() ? !place.empty() : changes_.back().second != place;
  if (changes) changes_.emplace_back(time, place);
}

const std::string& Labels::at(double time) const {
  static const std::string kNone;
  const auto after = std::upper_bound(
      changes_.begin(), changes_.end(), time,
      [](double t, const std::pair<double, std::string>& change) { return t < change.first; });
  return after == changes_.begin() ? kNone : std::prev(after)->second;
}

}  // namespace place_recognition
