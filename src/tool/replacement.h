#pragma once

#include <string>
#include <utility>
#include <vector>

#include "place_recognition/model.h"
#include "place_recognition/progress.h"
#include "place_recognition/training.h"

namespace place_recognition::tool {

/// Judges whether a new model may replace an old one: by the mean rate of the rooms of labelled
/// runs that neither was trained on. It may be lower by one standard error, as if frames were
/// independent: so many images do not tell that from equal. A room that one of the two has not
/// learned counts as 0 for it.
class Replacement {
 public:
  /// Answers `recordings` with the model at `path`; the path may be empty or of no file: then every
  /// model is good enough. Throws Error, Cancelled.
  Replacement(std::vector<RecordingOpener> recordings, const std::string& path,
              const Progress& progress);

  /// The rate of `model` on the runs, 0..1. Throws Error if that of the old one is better.
  double judge(const Model& model, const Progress& progress) const;

 private:
  struct Room {
    std::string place;
    double rate;
    double variance;  // of the rate
  };
  static std::vector<Room> roomsOf(const Model& model,
                                   const std::vector<RecordingOpener>& recordings,
                                   const Progress& progress);
  /// Mean and standard error over the rooms of both.
  static std::pair<double, double> meanRate(const std::vector<Room>& rooms,
                                            const std::vector<Room>& others);

  std::vector<RecordingOpener> recordings_;
  std::string path_;
  std::vector<Room> old_rooms_;
};

}  // namespace place_recognition::tool
