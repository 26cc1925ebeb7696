#pragma once

#include <string>
#include <utility>
#include <vector>

#include "place_recognition/model.h"
#include "place_recognition/progress.h"
#include "place_recognition/training.h"
#include "tool/other_runs.h"

namespace place_recognition::tool {

/// Decides whether a new model may replace an old one, by the rooms' mean rate on labelled runs
/// that neither was trained on. The new rate may be lower by one standard error, as if frames were
/// independent, because so many images cannot distinguish it from equal. A room that one of the
/// models has not learned counts as 0 for it.
class Replacement {
 public:
  /// Recognizes `runs` with the model at `path`. If the path is empty or there is no file, every
  /// new model is accepted. Throws Error, also if the model was trained on one of the runs;
  /// Cancelled.
  Replacement(ValidationRuns& runs, const std::string& path, const Progress& progress);

  struct Verdict {
    double rate = 0;                    ///< of the new model on the runs, 0..1
    std::string objection;              ///< why the old model is better; empty: it is not
    std::vector<std::string> warnings;  ///< for a person, about the runs and their images
  };

  /// Recognizes the runs with the new model, which was not trained on them. Throws Error;
  /// Cancelled.
  Verdict judge(const Model& model, const Progress& progress) const;

 private:
  struct Room {
    std::string place;
    double rate;
    double variance;  // of the rate
  };
  std::vector<Room> roomsOf(const Model& model, const Progress& progress,
                            std::vector<std::string>& warnings) const;
  /// Mean and standard error over the rooms of both models.
  static std::pair<double, double> meanRate(const std::vector<Room>& rooms,
                                            const std::vector<Room>& others);

  std::vector<RecordingOpener> recordings_;
  std::string path_;
  std::vector<Room> old_rooms_;
};

}  // namespace place_recognition::tool
