#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "evaluation/recording_recognizer.h"
#include "place_recognition/model.h"
#include "place_recognition/progress.h"
#include "place_recognition/training.h"

namespace place_recognition {

/// The answer to one labelled image.
struct FrameResult {
  std::string name;          ///< of the image
  int recording = 0;         ///< index into Evaluation::recordings
  int camera = 0;            ///< index into Evaluation::cameras
  double stamp = 0;          ///< s
  int truth = 0;             ///< index into Evaluation::places
  int place = -1;            ///< the most probable place, even if the answer is 'unknown'; -1: none
  bool known = false;        ///< false: answered 'unknown'
  double confidence = 0;     ///< probability of `place`
  double evidence = 0;       ///< see Calibration::evidence()
  double seconds = 0;        ///< from the decoded image to the answer
  int place_over_time = -1;  ///< answer of a TemporalFilter given the run so far; -1: 'unknown'
  int place_smoothed = -1;   ///< answer of a FixedLagSmoother, kSmoothingLag later

  bool correct() const { return place == truth; }
};

/// An image whose answer is wrong.
struct WrongImage {
  std::size_t frame = 0;  ///< index into Evaluation::frames
  std::string jpeg;       ///< at most 320 pixels wide
};

/// The answers of a model to labelled recordings.
struct Evaluation {
  std::string model;                ///< its name
  std::vector<std::string> places;  ///< those of the model, in its order, then others that occur
  std::size_t model_places = 0;     ///< number of the model's places among them
  /// The names of the runs, each of one condition. The parts of a split recording are one run, with
  /// the name of the first.
  std::vector<std::string> recordings;
  std::vector<std::string> cameras;  ///< of all recordings, by the topics of their images
  std::vector<FrameResult> frames;
  std::vector<WrongImage> wrong;  ///< the most confidently wrong ones, worst first
  std::size_t support_vectors = 0;
  std::uint64_t model_bytes = 0;  ///< size of its file; 0 unless the caller of evaluate() sets it
  std::vector<std::string> warnings;  ///< for a person: skipped images, see also ImageGuard

  /// Whether the model has learned the true place of `frame`.
  bool learned(const FrameResult& frame) const {
    return static_cast<std::size_t>(frame.truth) < model_places;
  }

  /// The frames of one recording, in order.
  std::vector<const FrameResult*> framesOf(int recording) const;
};

/// Recognizes every labelled image of the recordings, one at a time in this thread, and keeps the
/// answers and the `wrong_images` most confident errors. Throws Error if there are no images, no
/// labels, or no images of a place that the model has learned; Cancelled.
Evaluation evaluate(const std::shared_ptr<const Model>& model,
                    const std::vector<RecordingOpener>& recordings, std::size_t wrong_images = 12,
                    const Progress& progress = {});

}  // namespace place_recognition
