#include "evaluation/over_time.h"

#include <algorithm>
#include <iterator>

namespace place_recognition {
namespace {

void count(int answer, int truth, AnswerCounts& counts) {
  counts.unknown += answer < 0 ? 1 : 0;
  counts.wrong += answer >= 0 && answer != truth ? 1 : 0;
}

void count(const FrameResult& frame, AnswersOverTime& answers) {
  ++answers.frames;
  count(frame.known ? frame.place : -1, frame.truth, answers.single);
  count(frame.place_over_time, frame.truth, answers.filtered);
  count(frame.place_smoothed, frame.truth, answers.smoothed);
}

/// Stamps of the first frames after each change of room, in ascending order.
std::vector<double> changesIn(const std::vector<const FrameResult*>& recording) {
  std::vector<double> stamps;
  for (std::size_t i = 1; i < recording.size(); ++i) {
    if (recording[i]->truth != recording[i - 1]->truth) stamps.push_back(recording[i]->stamp);
  }
  return stamps;
}

bool inDoorway(double stamp, const std::vector<double>& changes) {
  const auto next = std::upper_bound(changes.begin(), changes.end(), stamp);
  const bool before = next != changes.end() && *next - stamp <= OverTime::kBefore;
  return before || (next != changes.begin() && stamp - *std::prev(next) < OverTime::kAfter);
}

/// Tracks how the changes from one learned room to another in a recording are followed.
class Followed {
 public:
  explicit Followed(OverTime& result) : result_(result) {}

  void add(const FrameResult& frame, bool learned) {
    if (frame.truth != room_) {
      if (waiting_) ++result_.missed;
      waiting_ = was_learned_ && learned;
      room_ = frame.truth;
      was_learned_ = learned;
      since_ = frame.stamp;
    }
    if (!waiting_ || frame.place_over_time != frame.truth) return;
    result_.delays.push_back(frame.stamp - since_);
    waiting_ = false;
  }

  void finish() {
    if (waiting_) ++result_.missed;
  }

 private:
  OverTime& result_;
  int room_ = -1;
  bool was_learned_ = false;  // room_
  double since_ = 0;
  bool waiting_ = false;
};

void addDrive(const std::vector<const FrameResult*>& recording, const Evaluation& evaluation,
              OverTime& result) {
  const std::vector<double> changes = changesIn(recording);
  Followed followed(result);
  for (const FrameResult* frame : recording) {
    const bool learned = evaluation.learned(*frame);
    followed.add(*frame, learned);
    if (!learned) continue;
    count(*frame, result.all);
    if (!inDoorway(frame->stamp, changes)) count(*frame, result.settled);
  }
  followed.finish();
}

}  // namespace

bool isDrive(const std::vector<const FrameResult*>& recording, std::size_t places) {
  std::vector<PlaceAt> way;
  for (const FrameResult* frame : recording) way.push_back({frame->stamp, frame->truth});
  Adjacency adjacency(places);
  return learnAdjacency(way, adjacency);
}

double OverTime::followedWithin(double seconds) const {
  const auto all = delays.size() + missed;
  const auto in_time = std::upper_bound(delays.begin(), delays.end(), seconds) - delays.begin();
  return all > 0 ? static_cast<double>(in_time) / static_cast<double>(all) : 1;
}

std::optional<OverTime> overTime(const Evaluation& evaluation) {
  OverTime result;
  for (std::size_t r = 0; r < evaluation.recordings.size(); ++r) {
    const std::vector<const FrameResult*> recording = evaluation.framesOf(static_cast<int>(r));
    if (isDrive(recording, evaluation.places.size())) addDrive(recording, evaluation, result);
  }
  if (result.all.frames == 0) return std::nullopt;
  std::sort(result.delays.begin(), result.delays.end());
  return result;
}

}  // namespace place_recognition
