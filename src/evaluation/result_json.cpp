#include "evaluation/result_json.h"

#include <nlohmann/json.hpp>

namespace place_recognition {
namespace {

using Json = nlohmann::json;

Json roomsJson(const std::vector<RoomSummary>& rooms, const std::vector<std::string>& places) {
  Json json = Json::object();
  for (const RoomSummary& room : rooms) {
    json[places[static_cast<std::size_t>(room.place)]] = {
        {"rate", room.rate()}, {"count", room.count}, {"unknown", room.unknownFraction()}};
  }
  return json;
}

Json jsonOf(const std::optional<double>& rate) { return rate ? Json(*rate) : Json(); }

Json runsJson(const Summary& summary) {
  Json json = Json::array();
  for (const RecordingSummary& recording : summary.recordings) {
    json.push_back({{"name", recording.name},
                    {"condition", recording.condition},
                    {"average_rate", jsonOf(recording.average_rate)},
                    {"rooms", roomsJson(recording.rooms, summary.places)}});
  }
  return json;
}

Json camerasJson(const Summary& summary) {
  Json json = Json::array();
  for (const CameraSummary& camera : summary.cameras) {
    json.push_back({{"name", camera.name},
                    {"count", camera.count},
                    {"average_rate", jsonOf(camera.average_rate)}});
  }
  return json;
}

Json reliabilityJson(const std::vector<ReliabilityBin>& bins) {
  Json json = Json::array();
  for (const ReliabilityBin& bin : bins) {
    json.push_back({{"count", bin.count}, {"confidence", bin.confidence}, {"rate", bin.rate}});
  }
  return json;
}

Json riskJson(const std::vector<RiskPoint>& points) {
  Json json = Json::array();
  for (int tenths = 1; tenths <= 10; ++tenths) {
    json.push_back({{"coverage", tenths / 10.0}, {"risk", riskAt(points, tenths / 10.0)}});
  }
  return json;
}

Json unknownJson(const Summary& summary) {
  if (!summary.unknown) return nullptr;
  return {{"roc_area", summary.unknown->roc_area},
          {"false_alarm_rate", summary.unknown->false_alarm_rate},
          {"detection_rate", summary.unknown->detection_rate}};
}

Json countsJson(const AnswerCounts& counts) {
  return {{"wrong", counts.wrong}, {"unknown", counts.unknown}};
}

Json answersJson(const AnswersOverTime& answers) {
  return {{"frames", answers.frames},
          {"single", countsJson(answers.single)},
          {"filtered", countsJson(answers.filtered)},
          {"smoothed", countsJson(answers.smoothed)}};
}

Json overTimeJson(const Summary& summary) {
  if (!summary.over_time) return nullptr;
  const OverTime& over_time = *summary.over_time;
  return {{"all", answersJson(over_time.all)},
          {"settled", answersJson(over_time.settled)},
          {"delays", over_time.delays},
          {"missed", over_time.missed},
          {"followed_within_2s", over_time.followedWithin(OverTime::kAfter)}};
}

nlohmann::json confusedJson(const Summary& summary) {
  nlohmann::json pairs = nlohmann::json::array();
  for (const ConfusedPair& pair : summary.confused) {
    pairs.push_back({{"places",
                      {summary.places[static_cast<std::size_t>(pair.a)],
                       summary.places[static_cast<std::size_t>(pair.b)]}},
                     {"rate", pair.rate}});
  }
  return pairs;
}

}  // namespace

nlohmann::json resultJson(const Evaluation& evaluation, const Summary& summary) {
  return {{"average_rate", summary.average_rate},
          {"test_set_rate", summary.test_set_rate},
          {"images", evaluation.frames.size()},
          {"rooms", roomsJson(summary.rooms, summary.places)},
          {"runs", runsJson(summary)},
          {"cameras", camerasJson(summary)},
          {"confusion",
           {{"labels", summary.places},
            {"counts", summary.confusion.counts},
            {"none", summary.confusion.none}}},
          {"confused", confusedJson(summary)},
          {"calibration_error", summary.calibration_error},
          {"reliability", reliabilityJson(summary.reliability)},
          {"risk_coverage", riskJson(summary.risk_coverage)},
          {"mean_risk", meanRisk(summary.risk_coverage)},
          {"unknown_share", summary.unknown_share},
          {"unknown", unknownJson(summary)},
          {"over_time", overTimeJson(summary)},
          {"model", evaluation.model},
          {"support_vectors", evaluation.support_vectors},
          {"model_bytes", evaluation.model_bytes},
          {"latency_ms",
           {{"p50", 1000 * summary.latency_p50},
            {"p95", 1000 * summary.latency_p95},
            {"p99", 1000 * summary.latency_p99}}},
          {"warnings", evaluation.warnings}};
}

}  // namespace place_recognition
