#include "tool/replacement.h"

#include <cmath>
#include <filesystem>
#include <memory>
#include <set>

#include "base/text.h"
#include "evaluation/evaluation.h"
#include "evaluation/summary.h"
#include "place_recognition/error.h"
#include "place_recognition/model_file.h"

namespace place_recognition::tool {

Replacement::Replacement(ValidationRuns& runs, const std::string& path, const Progress& progress)
    : recordings_(runs.openers()), path_(path) {
  if (!std::filesystem::exists(path_)) return;
  const Model old = loadModel(path_);
  runs.requireNotLearnedBy(old, path_);
  std::vector<std::string> of_old_model;
  old_rooms_ = roomsOf(old, progress, of_old_model);
}

std::vector<Replacement::Room> Replacement::roomsOf(const Model& model, const Progress& progress,
                                                    std::vector<std::string>& warnings) const {
  const Evaluation evaluation =
      evaluate(std::make_shared<const Model>(model), recordings_, 0, progress);
  warnings = evaluation.warnings;
  const Summary summary = summarize(evaluation);
  std::vector<Room> rooms;
  for (const RoomSummary& room : summary.rooms) {
    const double rate = room.rate();
    rooms.push_back({summary.places[static_cast<std::size_t>(room.place)], rate,
                     rate * (1 - rate) / static_cast<double>(room.count)});
  }
  return rooms;
}

std::pair<double, double> Replacement::meanRate(const std::vector<Room>& rooms,
                                                const std::vector<Room>& others) {
  std::set<std::string> names;
  double sum = 0, variance = 0;
  for (const Room& room : rooms) {
    names.insert(room.place);
    sum += room.rate;
    variance += room.variance;
  }
  for (const Room& room : others) names.insert(room.place);
  const auto count = static_cast<double>(names.size());
  return {sum / count, std::sqrt(variance) / count};
}

Replacement::Verdict Replacement::judge(const Model& model, const Progress& progress) const {
  Verdict verdict;
  const std::vector<Room> rooms = roomsOf(model, progress, verdict.warnings);
  verdict.rate = meanRate(rooms, old_rooms_).first;
  const auto [old_rate, error] = meanRate(old_rooms_, rooms);
  if (!old_rooms_.empty() && verdict.rate < old_rate - error) {
    verdict.objection = "The old model is kept: on the runs of --validate, " + path_ +
                        " is right for " + percent(old_rate) +
                        " (mean of the rooms), the new one for " + percent(verdict.rate) + ".";
  }
  return verdict;
}

}  // namespace place_recognition::tool
