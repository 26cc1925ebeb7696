#include "experiments/experiments.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <set>

#include "base/options.h"
#include "base/parallel.h"
#include "base/text.h"
#include "datasets/image_file.h"
#include "datasets/image_recording.h"
#include "experiments/place_training.h"
#include "experiments/spread.h"
#include "experiments/test_sets.h"
#include "learning/gram.h"
#include "place_recognition/recognizer.h"
#include "place_recognition/training.h"
#include "recognition/frames/cue_extraction.h"
#include "recognition/model/place_index.h"
#include "recognition/model/scores.h"

namespace place_recognition {
namespace {

constexpr const char* kCueSets[] = {"thesis", "default"};
constexpr const char* kWays[] = {"best cue", "weighted mean", "linear SVM", "Gaussian SVM"};

/// The local and the global features of the thesis, or the default cues of `train`.
TrainingOptions optionsOf(const std::string& cue_set) {
  TrainingOptions options = trainingOptions(PlaceFeatures::kGlobal);
  if (cue_set == "default") {
    options.cues = defaultCues();
  } else {
    options.cues.push_back(trainingOptions(PlaceFeatures::kLocal).cues[0]);
  }
  return options;
}

/// A test image of a set.
struct Tested {
  int place = -1;                                   ///< its label in the model
  int answer = -1;                                  ///< of the weighted mean
  std::vector<Eigen::RowVectorXd> decision_values;  ///< of each cue; zero if it is missing
};

/// Answers of one model to single images.
class Tester {
 public:
  explicit Tester(const std::shared_ptr<const Model>& model)
      : recognizer_(model), extraction_(model->options, model->images) {}

  void test(const LabelledImage& image, Tested& tested) {
    const Model& model = recognizer_.model();
    const int place = placeIndex(image.place, model.places);
    const DecodedImage read = readImageFile(image.path);
    if (read.image.empty() || place < 0) return;
    tested.place = place;
    tested.answer = recognizer_.recognize(read.image).place;
    extraction_.extract(read.image, features_);
    for (std::size_t c = 0; c < features_.size(); ++c) {
      Eigen::RowVectorXd& decision_values = tested.decision_values.emplace_back();
      decision_values.setZero(static_cast<Eigen::Index>(model.places.size()));
      if (isMissing(features_[c])) continue;
      model.classifiers[c].decisionValues(features_[c], kernel_values_, decision_values);
    }
  }

 private:
  Recognizer recognizer_;
  CueExtraction extraction_;
  std::vector<Feature> features_;
  Eigen::VectorXd kernel_values_;
};

std::vector<Tested> testAll(const std::shared_ptr<const Model>& model, const ImageSet& set,
                            unsigned threads) {
  std::vector<std::unique_ptr<Tester>> testers(threadCount(threads));
  std::vector<Tested> tested(set.images.size());
  parallelFor(tested.size(), threads, [&](std::size_t i, unsigned thread) {
    if (!testers[thread]) testers[thread] = std::make_unique<Tester>(model);
    testers[thread]->test(set.images[i], tested[i]);
  });
  return tested;
}

/// The decision values of all cues as one vector, first for held-out frames, then for `tested`.
struct MarginVectors {
  std::vector<Feature> features;
  SetSamples samples;  ///< set 0: held out
  std::vector<int> folds;
};

MarginVectors marginVectors(const Model& model, const std::vector<std::vector<Tested>>& tested) {
  MarginVectors vectors;
  const HeldOutFrames& frames = model.held_out;
  vectors.samples.place_count = static_cast<int>(model.places.size());
  vectors.samples.set_count = static_cast<int>(tested.size()) + 1;
  for (std::size_t i = 0; i < frames.places.size(); ++i) {
    DenseVector vector;
    for (const Eigen::MatrixXf& cue : frames.decision_values) {
      const Eigen::RowVectorXf row = cue.row(static_cast<Eigen::Index>(i));
      vector.values.insert(vector.values.end(), row.data(), row.data() + row.size());
    }
    vectors.features.emplace_back(std::move(vector));
    vectors.samples.places.push_back(frames.places[i]);
    vectors.samples.sets.push_back(0);
  }
  vectors.folds = frames.folds;
  for (std::size_t set = 0; set < tested.size(); ++set) {
    for (const Tested& image : tested[set]) {
      DenseVector vector;
      for (const Eigen::RowVectorXd& cue : image.decision_values) {
        const Eigen::RowVectorXf row = cue.cast<float>();
        vector.values.insert(vector.values.end(), row.data(), row.data() + row.size());
      }
      vectors.features.emplace_back(std::move(vector));
      vectors.samples.places.push_back(image.place);
      vectors.samples.sets.push_back(static_cast<int>(set) + 1);
    }
  }
  return vectors;
}

/// Mean rate on each fold of the held-out frames after training on the others.
double validate(const Eigen::MatrixXd& gram, const MarginVectors& vectors, const SvmOptions& svm) {
  double sum = 0;
  const std::set<int> folds(vectors.folds.begin(), vectors.folds.end());
  for (const int fold : folds) {
    Fold split;
    for (std::size_t i = 0; i < vectors.folds.size(); ++i) {
      (vectors.folds[i] == fold ? split.test : split.train).push_back(static_cast<int>(i));
    }
    sum += rateOf(gram, vectors.samples, split, svm);
  }
  return sum / static_cast<double>(folds.size());
}

/// The rate, on the test sets, of an SVM over decision values whose parameters are the best on
/// held-out frames.
double svmRate(const std::string& kernel_type, const MarginVectors& vectors, unsigned threads) {
  KernelOptions kernel;
  kernel.type = kernel_type;
  const Eigen::MatrixXd measures = measureMatrix(Kernel(kernel), vectors.features, threads, {});
  const std::vector<double> gammas = kernel_type == "linear"
                                         ? std::vector<double>{1}
                                         : std::vector<double>{0.01, 0.03, 0.1, 0.3, 1};
  double best = -1, rate = 0;
  for (const double gamma : gammas) {
    kernel.gamma = gamma;
    const Eigen::MatrixXd gram = gramMatrix(Kernel(kernel), measures);
    for (const double c : {0.1, 1.0, 10.0, 100.0}) {
      const SvmOptions svm{c, "one-against-all"};
      const double validation = validate(gram, vectors, svm);
      if (validation <= best) continue;
      best = validation;
      rate = rateOf(gram, vectors.samples, vectors.samples.split(0), svm);
    }
  }
  return rate;
}

/// The rate of the given answers to all test images.
template <typename AnswerOf>
double rateOfAnswers(const MarginVectors& vectors, const std::vector<std::vector<Tested>>& tested,
                     const AnswerOf& answer_of) {
  std::vector<int> answers;
  for (const std::vector<Tested>& set : tested) {
    for (const Tested& image : set) answers.push_back(answer_of(image));
  }
  return meanRate(testCounts(vectors.samples, vectors.samples.split(0).test, answers));
}

/// Rates in the order of kWays.
std::vector<double> ratesOf(const Model& model, const std::vector<std::vector<Tested>>& tested,
                            unsigned threads) {
  const MarginVectors vectors = marginVectors(model, tested);
  double best_cue = 0;
  for (std::size_t c = 0; c < model.classifiers.size(); ++c) {
    best_cue = std::max(best_cue, rateOfAnswers(vectors, tested, [c](const Tested& image) {
                          return largest(image.decision_values[c]);
                        }));
  }
  const double mean =
      rateOfAnswers(vectors, tested, [](const Tested& image) { return image.answer; });
  return {best_cue, mean, svmRate("linear", vectors, threads),
          svmRate("gaussian", vectors, threads)};
}

class CuesExperiment : public Experiment {
 public:
  CuesExperiment(std::vector<ImageSet> sets, unsigned threads)
      : sets_(std::move(sets)), threads_(threads) {}

  std::vector<Json> cells() const override {
    std::vector<Json> cells;
    for (const char* cue_set : kCueSets) {
      for (const ImageSet& set : sets_) {
        cells.push_back({{"cues", writeOptions(optionsOf(cue_set))},
                         {"cue_set", cue_set},
                         {"training_set", set.name}});
      }
    }
    return cells;
  }

  void compute(const std::vector<Json>& cells, const CellSink& finished,
               const Progress& progress) override {
    for (const Json& cell : cells) {
      const auto trained = std::find_if(sets_.begin(), sets_.end(), [&](const ImageSet& set) {
        return cell.at("training_set") == set.name;
      });
      Training training = train({[&] { return recordingOf(trained->name, trained->images); }},
                                optionsOf(cell.at("cue_set")), threads_, progress);
      warn(training.warnings);
      const auto model = std::make_shared<const Model>(std::move(training.model));
      std::vector<std::vector<Tested>> tested;
      for (const ImageSet& set : sets_) {
        report(progress, "Testing", 0);
        if (&set == &*trained) continue;
        std::vector<Tested>& images = tested.emplace_back(testAll(model, set, threads_));
        images.erase(std::remove_if(images.begin(), images.end(),
                                    [](const Tested& image) { return image.place < 0; }),
                     images.end());
      }
      finished(cell,
               {{"weights", model->cue_weights}, {"rates", ratesOf(*model, tested, threads_)}});
    }
  }

  Findings findings(const std::vector<Json>& results) const override {
    Table table{"cues",
                "Rate on the other sets, %, of the best cue by itself (in hindsight), the weighted "
                "mean of the cues' decision values, and SVMs over these decision values",
                {{"cues", "trained on"}}};
    table.rows[0].insert(table.rows[0].end(), std::begin(kWays), std::end(kWays));
    std::size_t next = 0;
    for (const char* cue_set : kCueSets) {
      std::vector<std::vector<double>> rates(std::size(kWays));
      for (const ImageSet& set : sets_) {
        std::vector<std::string>& row = table.rows.emplace_back();
        row = {cue_set, set.name};
        const Json& result = results[next++];
        for (std::size_t way = 0; way < rates.size(); ++way) {
          rates[way].push_back(100 * result.at("rates").at(way).get<double>());
          row.push_back(fixed(rates[way].back(), 1));
        }
      }
      std::vector<std::string>& mean = table.rows.emplace_back();
      mean = {cue_set, "mean"};
      for (const std::vector<double>& way : rates) mean.push_back(fixed(spreadOf(way).mean, 1));
    }
    return {{table}, {}};
  }

 private:
  std::vector<ImageSet> sets_;
  unsigned threads_;
};

}  // namespace

std::unique_ptr<Experiment> cuesExperiment(std::vector<ImageSet> sets, unsigned threads) {
  return std::make_unique<CuesExperiment>(std::move(sets), threads);
}

}  // namespace place_recognition
