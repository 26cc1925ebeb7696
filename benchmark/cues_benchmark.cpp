// Times one frame with all cues of a configuration: its features, compared with the least work for
// their distinct responses (crfh_limit.h), and its recognition by a model of 1000 support vectors
// in total. One core.

#include <benchmark/benchmark.h>

#include <map>
#include <memory>
#include <set>
#include <string>
#include <tuple>
#include <utility>

#include "base/options.h"
#include "crfh_limit.h"
#include "place_recognition/recognizer.h"
#include "recognition/frames/cue_extraction.h"
#include "sample_model.h"
#include "views.h"

namespace place_recognition {
namespace {

constexpr std::size_t kVectors = 1000;
constexpr std::size_t kFrames = 10;

TrainingOptions configuration(const std::string& name) {
  const std::string path = PLACE_RECOGNITION_CONFIG_FOLDER "/" + name + ".yaml";
  TrainingOptions options;
  readOptions(readYamlFile(path), path, options);
  return options;
}

/// Views that are not used for training.
const std::vector<cv::Mat>& frames() {
  static const std::vector<cv::Mat> frames = [] {
    std::vector<cv::Mat> frames;
    for (std::size_t i = 0; i < kFrames; ++i) frames.push_back(Views()[4 * kVectors + i].image);
    return frames;
  }();
  return frames;
}

/// The scales of the distinct responses. A response is a derivative of a channel at a scale, of the
/// image with the colour normalization and levels of the cue. Other features have none.
std::vector<double> distinctResponses(const TrainingOptions& options) {
  std::set<std::tuple<std::string, std::string, std::string, double>> responses;
  for (const CueOptions& cue : options.cues) {
    const auto* crfh = std::get_if<CrfhOptions>(&cue.feature);
    if (!crfh) continue;
    for (double t : crfh->variances()) {
      for (const std::string& descriptor : crfh->descriptors) {
        responses.emplace(cue.normalize, crfh->levels, descriptor, t);
      }
    }
  }
  std::vector<double> variances;
  for (const auto& response : responses) variances.push_back(std::get<double>(response));
  return variances;
}

void features(benchmark::State& state, const std::string& name) {
  CueExtraction extraction(configuration(name), ImageProfile());
  std::vector<Feature> features;
  extraction.extract(frames().back(), features);  // tables and buffers
  std::size_t frame = 0;
  for (auto _ : state) extraction.extract(frames()[frame++ % kFrames], features);
}

void limit(benchmark::State& state, const std::string& name) {
  const std::vector<double> responses = distinctResponses(configuration(name));
  CrfhLimit limit(responses);
  for (auto _ : state) limit.compute(frames().front().size());
  state.counters["responses"] = static_cast<double>(responses.size());
}

/// Recognizes the frames of a stream.
void answer(benchmark::State& state, const std::string& name) {
  TrainingOptions options = configuration(name);
  options.augmentation.other_light = false;
  const auto cues = options.cues.size();
  static std::map<std::string, std::shared_ptr<const Model>> models;
  std::shared_ptr<const Model>& model = models[name];
  if (!model) {
    model = std::make_shared<const Model>(sampleModel(options, (kVectors + cues - 1) / cues));
  }
  Recognizer recognizer(model);
  recognizer.recognize(frames().back());
  std::size_t frame = 0;
  for (auto _ : state) {
    const auto stamp = 0.1 * static_cast<double>(frame);
    benchmark::DoNotOptimize(&recognizer.recognize(frames()[frame++ % kFrames], stamp));
  }
  state.counters["vectors"] = static_cast<double>(model->supportVectorCount());
}

void add(const std::string& name, void (*function)(benchmark::State&, const std::string&),
         const std::string& configuration) {
  benchmark::RegisterBenchmark((configuration + "/" + name).c_str(), function, configuration)
      ->Unit(benchmark::kMillisecond);
}

const bool kAdded = [] {
  for (const char* const name : {"any_light", "colour_cues", "default"}) {
    add("features", features, name);
    add("limit", limit, name);
    add("answer", answer, name);
  }
  add("features", features, "mr8");
  return true;
}();

}  // namespace
}  // namespace place_recognition
