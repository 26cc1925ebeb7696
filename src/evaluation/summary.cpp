#include "evaluation/summary.h"

#include <algorithm>
#include <functional>
#include <numeric>

#include "base/quantile.h"
#include "base/text.h"
#include "recognition/model/scores.h"
#include "report/text_table.h"

namespace place_recognition {
namespace {

/// The learned rooms among the frames that satisfy `chosen`.
std::vector<RoomSummary> summarizeRooms(const Evaluation& evaluation,
                                        const std::function<bool(const FrameResult&)>& chosen) {
  std::vector<RoomSummary> all(evaluation.model_places);
  for (const FrameResult& frame : evaluation.frames) {
    if (!evaluation.learned(frame) || !chosen(frame)) continue;
    RoomSummary& room = all[static_cast<std::size_t>(frame.truth)];
    ++room.count;
    room.correct += frame.correct() ? 1 : 0;
    room.unknown += frame.known ? 0 : 1;
  }
  std::vector<RoomSummary> rooms;
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (all[k].count == 0) continue;
    rooms.push_back(all[k]);
    rooms.back().place = static_cast<int>(k);
  }
  return rooms;
}

double sumOfRates(const std::vector<RoomSummary>& rooms) {
  return std::accumulate(rooms.begin(), rooms.end(), 0.0,
                         [](double sum, const RoomSummary& room) { return sum + room.rate(); });
}

std::optional<double> meanRate(const std::vector<RoomSummary>& rooms) {
  if (rooms.empty()) return std::nullopt;
  return sumOfRates(rooms) / static_cast<double>(rooms.size());
}

std::string conditionOf(const std::string& recording) {
  const std::string name = baseName(recording);
  const std::string ending = ".bag";
  const bool is_bag = name.size() > ending.size() && endsWith(name, ending);
  return is_bag ? name.substr(0, name.size() - ending.size()) : name;
}

void summarizeRecordings(const Evaluation& evaluation, Summary& summary) {
  double sum = 0;
  std::size_t sets = 0;
  for (std::size_t r = 0; r < evaluation.recordings.size(); ++r) {
    const auto inRecording = [r](const FrameResult& frame) {
      return frame.recording == static_cast<int>(r);
    };
    const std::string& name = evaluation.recordings[r];
    RecordingSummary recording{name, conditionOf(name), summarizeRooms(evaluation, inRecording), 0};
    recording.average_rate = meanRate(recording.rooms);
    sum += sumOfRates(recording.rooms);
    sets += recording.rooms.size();
    summary.recordings.push_back(std::move(recording));
  }
  summary.test_set_rate = sets == 0 ? 0 : sum / static_cast<double>(sets);
}

void summarizeCameras(const Evaluation& evaluation, Summary& summary) {
  if (evaluation.cameras.size() < 2) return;
  for (std::size_t c = 0; c < evaluation.cameras.size(); ++c) {
    const auto ofCamera = [c](const FrameResult& f) { return f.camera == static_cast<int>(c); };
    const std::vector<RoomSummary> rooms = summarizeRooms(evaluation, ofCamera);
    const std::string& topic = evaluation.cameras[c];
    CameraSummary camera{topic.empty() ? "images in folders" : topic, 0, meanRate(rooms)};
    for (const RoomSummary& room : rooms) camera.count += room.count;
    summary.cameras.push_back(std::move(camera));
  }
}

/// Pairs of learned places that the model confuses.
std::vector<ConfusedPair> confusedIn(const Evaluation& evaluation) {
  std::vector<int> truth, answers;
  for (const FrameResult& frame : evaluation.frames) {
    if (!evaluation.learned(frame)) continue;
    truth.push_back(frame.truth);
    answers.push_back(frame.place);
  }
  return confusedPairs(truth, answers, evaluation.places.size());
}

Confusion confusionOf(const Evaluation& evaluation) {
  const std::size_t places = evaluation.places.size();
  Confusion confusion{{places, std::vector<std::uint64_t>(places, 0)},
                      std::vector<std::uint64_t>(places, 0)};
  for (const FrameResult& frame : evaluation.frames) {
    const auto truth = static_cast<std::size_t>(frame.truth);
    ++(frame.place < 0 ? confusion.none[truth]
                       : confusion.counts[truth][static_cast<std::size_t>(frame.place)]);
  }
  return confusion;
}

void summarizeConfidence(const Evaluation& evaluation, Summary& summary) {
  std::vector<double> confidences;
  std::vector<bool> correct;
  for (const FrameResult& frame : evaluation.frames) {
    if (!evaluation.learned(frame)) continue;
    confidences.push_back(frame.confidence);
    correct.push_back(frame.correct());
  }
  summary.reliability = reliability(confidences, correct);
  summary.calibration_error = calibrationError(confidences, correct);
  summary.risk_coverage = riskCoverage(confidences, correct);
}

void summarizeUnknown(const Evaluation& evaluation, Summary& summary) {
  std::vector<double> learned, other;
  double false_alarms = 0, detections = 0;
  for (const FrameResult& frame : evaluation.frames) {
    const bool is_learned = evaluation.learned(frame);
    (is_learned ? learned : other).push_back(frame.evidence);
    (is_learned ? false_alarms : detections) += frame.known ? 0 : 1;
  }
  if (!learned.empty()) summary.unknown_share = false_alarms / static_cast<double>(learned.size());
  if (other.empty()) return;
  summary.unknown =
      UnknownSummary{rocArea(learned, other), summary.unknown_share,
                     detections / static_cast<double>(other.size()), rocCurve(learned, other)};
}

void summarizeLatency(const Evaluation& evaluation, Summary& summary) {
  std::vector<double> seconds;
  for (const FrameResult& frame : evaluation.frames) seconds.push_back(frame.seconds);
  summary.over_time = overTime(evaluation);
  summary.latency_p50 = quantile(seconds, 0.50);
  summary.latency_p95 = quantile(seconds, 0.95);
  summary.latency_p99 = quantile(seconds, 0.99);
}

}  // namespace

std::string rateText(const std::optional<double>& rate) { return rate ? percent(*rate) : ""; }

std::string RecordingSummary::rateText(int place) const {
  const auto room = std::find_if(rooms.begin(), rooms.end(), [place](const RoomSummary& candidate) {
    return candidate.place == place;
  });
  return room == rooms.end() ? "" : percent(room->rate());
}

Summary summarize(const Evaluation& evaluation) {
  Summary summary;
  summary.places = evaluation.places;
  summary.rooms = summarizeRooms(evaluation, [](const FrameResult&) { return true; });
  summary.average_rate = meanRate(summary.rooms).value_or(0);
  summarizeRecordings(evaluation, summary);
  summarizeCameras(evaluation, summary);
  summary.confusion = confusionOf(evaluation);
  summary.confused = confusedIn(evaluation);
  summarizeConfidence(evaluation, summary);
  summarizeUnknown(evaluation, summary);
  summarizeLatency(evaluation, summary);
  return summary;
}

}  // namespace place_recognition
