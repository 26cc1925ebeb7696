#include "evaluation/evaluation.h"

#include <algorithm>
#include <chrono>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "base/place_name.h"
#include "base/text.h"
#include "place_recognition/error.h"
#include "recognition/frames/image_hash.h"
#include "recognition/frames/left_out_frames.h"
#include "recognition/training/training_warnings.h"

namespace place_recognition {
namespace {

/// The index of `name` in `names`, to which it is added if it is new.
int indexIn(std::vector<std::string>& names, const std::string& name) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found != names.end()) return static_cast<int>(found - names.begin());
  names.push_back(name);
  return static_cast<int>(names.size()) - 1;
}

std::string joined(const std::vector<std::string>& words, std::size_t first, std::size_t last) {
  const auto begin = words.begin();
  return listed(
      {begin + static_cast<std::ptrdiff_t>(first), begin + static_cast<std::ptrdiff_t>(last)});
}

std::string thumbnail(const cv::Mat& image) {
  constexpr int kWidth = 320;
  cv::Mat small = image;
  if (image.cols > kWidth) {
    const int height = std::max(1, image.rows * kWidth / image.cols);
    cv::resize(image, small, cv::Size(kWidth, height), 0, 0, cv::INTER_AREA);
  }
  std::vector<unsigned char> bytes;
  cv::imencode(".jpg", small, bytes, {cv::IMWRITE_JPEG_QUALITY, 80});
  return {bytes.begin(), bytes.end()};
}

class Evaluator {
 public:
  Evaluator(const std::shared_ptr<const Model>& model, std::size_t wrong_images)
      : recognizer_(model), wrong_images_(wrong_images) {
    evaluation_.model = model->name;
    evaluation_.places = model->places;
    evaluation_.model_places = model->places.size();
    evaluation_.support_vectors = model->supportVectorCount();
  }

  void read(Recording& recording, const Progress& progress) {
    evaluation_.recordings.push_back(recording.name());
    if (how_to_label_.empty()) how_to_label_ = recording.howToLabel();
    recognizer_.begin(recording);
    camera_of_.clear();
    for (const std::string& camera : recording.cameras()) {
      camera_of_.push_back(indexIn(evaluation_.cameras, camera));
    }
    const std::string stage = "Recognizing " + recording.name();
    report(progress, stage, 0);
    LeftOutFrames left_out;
    RunSketch sketch;
    bool is_first = true;
    for (Frame frame; recording.next(frame);) {
      ++images_;
      recognizer_.take(frame);
      addLabelled(frame, sketch);
      if (is_first && recognizer_.continues()) evaluation_.recordings.pop_back();
      is_first = false;
      if (!left_out.leavesOut(frame)) {
        for (const std::string& warning : recognizer_.judge(frame)) {
          evaluation_.warnings.push_back(recording.name() + ": " + warning);
        }
        add(frame);
      }
      report(progress, stage, recording.fraction());
    }
    warnOfLearnedTest(recognizer_.model(), recording.name(), sketch, evaluation_.warnings);
    evaluation_.warnings.insert(evaluation_.warnings.end(), recording.warnings().begin(),
                                recording.warnings().end());
    for (const std::string& sentence : left_out.sentences(recording.name())) {
      evaluation_.warnings.push_back(sentence);
    }
    if (first_problem_.empty()) first_problem_ = left_out.firstProblem();
  }

  Evaluation finish() {
    recognizer_.smoother().finish();
    takeSmoothed();
    requireLearnedPlaces();
    for (std::size_t k = evaluation_.model_places; k < evaluation_.places.size(); ++k) {
      evaluation_.warnings.push_back("The runs show '" + evaluation_.places[k] +
                                     "', which the model has not learned.");
    }
    for (const std::string& warning : warnOfLikeNames(evaluation_.places)) {
      evaluation_.warnings.push_back(warning);
    }
    return std::move(evaluation_);
  }

 private:
  void add(const Frame& frame) {
    using Clock = std::chrono::steady_clock;
    const Clock::time_point start = Clock::now();
    const Recognition& answer = recognizer_.recognize(frame);
    const std::chrono::duration<double> elapsed = Clock::now() - start;

    FrameResult result;
    result.name = frame.name;
    result.recording = static_cast<int>(evaluation_.recordings.size()) - 1;
    result.camera = camera_of_[static_cast<std::size_t>(frame.camera)];
    result.stamp = frame.stamp;
    result.truth = indexIn(evaluation_.places, frame.place);
    result.place = answer.place;
    result.known = answer.known;
    result.confidence = answer.confidence;
    result.evidence = answer.evidence;
    result.seconds = elapsed.count();
    result.place_over_time = recognizer_.follow(frame, answer).place;
    evaluation_.frames.push_back(result);
    takeSmoothed();
    if (!result.correct() && result.place >= 0) keepIfAmongTheWorst(result, frame.image);
  }

  void takeSmoothed() {
    FixedLagSmoother& smoother = recognizer_.smoother();
    for (; smoother.ready(); ++smoothed_) {
      evaluation_.frames[smoothed_].place_smoothed = smoother.next().place;
    }
  }

  /// Keeps evaluation_.wrong short and sorted by descending confidence.
  void keepIfAmongTheWorst(const FrameResult& result, const cv::Mat& image) {
    std::vector<WrongImage>& wrong = evaluation_.wrong;
    const auto place = std::find_if(wrong.begin(), wrong.end(), [&](const WrongImage& image) {
      return evaluation_.frames[image.frame].confidence < result.confidence;
    });
    if (static_cast<std::size_t>(place - wrong.begin()) >= wrong_images_) return;
    wrong.insert(place, {evaluation_.frames.size() - 1, thumbnail(image)});
    if (wrong.size() > wrong_images_) wrong.pop_back();
  }

  void requireLearnedPlaces() const {
    const std::string recordings = joined(evaluation_.recordings, 0, evaluation_.recordings.size());
    if (images_ == 0)
      throw Error("There are no images in " + recordings + "; give a run with images.");
    if (evaluation_.frames.empty() && !first_problem_.empty()) {
      throw Error("None of the labelled images in " + recordings + " can be used (" +
                  first_problem_ + "); give a run with usable ones.");
    }
    if (evaluation_.frames.empty()) {
      throw Error("None of " + counted(images_, "image") + " in " + recordings + " has a label; " +
                  how_to_label_ + ".");
    }
    const bool any = std::any_of(evaluation_.frames.begin(), evaluation_.frames.end(),
                                 [this](const FrameResult& f) { return evaluation_.learned(f); });
    if (any) return;
    throw Error("The model has learned none of the places in " + recordings + " (" +
                joined(evaluation_.places, evaluation_.model_places, evaluation_.places.size()) +
                ") but only " + joined(evaluation_.places, 0, evaluation_.model_places) +
                "; give a run of these.");
  }

  RecordingRecognizer recognizer_;
  std::vector<int> camera_of_;  // by camera of the current run: index into evaluation_.cameras
  std::size_t smoothed_ = 0;    // number of frames with a smoothed answer
  std::size_t wrong_images_;
  std::uint64_t images_ = 0;
  std::string how_to_label_;   // Recording::howToLabel() of the first one
  std::string first_problem_;  // of a labelled image that cannot be used
  Evaluation evaluation_;
};

}  // namespace

std::vector<const FrameResult*> Evaluation::framesOf(int recording) const {
  std::vector<const FrameResult*> of_recording;
  for (const FrameResult& frame : frames) {
    if (frame.recording == recording) of_recording.push_back(&frame);
  }
  return of_recording;
}

Evaluation evaluate(const std::shared_ptr<const Model>& model,
                    const std::vector<RecordingOpener>& recordings, std::size_t wrong_images,
                    const Progress& progress) {
  Evaluator evaluator(model, wrong_images);
  for (const RecordingOpener& open : recordings) evaluator.read(*open(), progress);
  return evaluator.finish();
}

}  // namespace place_recognition
