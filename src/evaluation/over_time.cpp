#include "evaluation/over_time.h"

#include <algorithm>

namespace place_recognition {
namespace {

void count(int answer, int truth, AnswerCounts& counts) {
  counts.unknown += answer < 0 ? 1 : 0;
  counts.wrong += answer >= 0 && answer != truth ? 1 : 0;
}

void count(const FrameResult& frame, BothAnswers& answers) {
  ++answers.frames;
  count(frame.known ? frame.place : -1, frame.truth, answers.single);
  count(frame.place_over_time, frame.truth, answers.filtered);
}

bool isDrive(const std::vector<const FrameResult*>& run, std::size_t places) {
  std::vector<PlaceAt> way;
  for (const FrameResult* frame : run) way.push_back({frame->stamp, frame->truth});
  Adjacency adjacency(places);
  return learnAdjacency(way, adjacency);
}

/// Follows the changes from one learned room to another in a run.
class Changes {
 public:
  explicit Changes(OverTime& result) : result_(result) {}

  void add(const FrameResult& frame, bool learned) {
    if (frame.truth != room_) {
      if (waiting_) ++result_.missed;
      changed_ = room_ >= 0;
      waiting_ = changed_ && learned;
      room_ = frame.truth;
      since_ = frame.stamp;
    }
    if (!waiting_ || frame.place_over_time != frame.truth) return;
    result_.delays.push_back(frame.stamp - since_);
    waiting_ = false;
  }

  void finish() {
    if (waiting_) ++result_.missed;
  }

  bool settled(const FrameResult& frame) const {
    return !changed_ || frame.stamp - since_ >= OverTime::kSettling;
  }

 private:
  OverTime& result_;
  int room_ = -1;
  double since_ = 0;
  bool changed_ = false;  ///< false in the first room of the run
  bool waiting_ = false;
};

void addDrive(const std::vector<const FrameResult*>& run, const Evaluation& evaluation,
              OverTime& result) {
  Changes changes(result);
  for (const FrameResult* frame : run) {
    const bool learned = evaluation.learned(*frame);
    changes.add(*frame, learned);
    if (!learned) continue;
    count(*frame, result.all);
    if (changes.settled(*frame)) count(*frame, result.settled);
  }
  changes.finish();
}

}  // namespace

double OverTime::followedWithin(double seconds) const {
  const auto all = delays.size() + missed;
  const auto in_time = std::upper_bound(delays.begin(), delays.end(), seconds) - delays.begin();
  return all > 0 ? static_cast<double>(in_time) / static_cast<double>(all) : 1;
}

std::optional<OverTime> overTime(const Evaluation& evaluation) {
  OverTime result;
  for (std::size_t r = 0; r < evaluation.runs.size(); ++r) {
    std::vector<const FrameResult*> run;
    for (const FrameResult& frame : evaluation.frames) {
      if (frame.run == static_cast<int>(r)) run.push_back(&frame);
    }
    if (isDrive(run, evaluation.places.size())) addDrive(run, evaluation, result);
  }
  if (result.all.frames == 0) return std::nullopt;
  std::sort(result.delays.begin(), result.delays.end());
  return result;
}

}  // namespace place_recognition
