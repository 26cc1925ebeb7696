#include "experiments/material_features.h"

#include <algorithm>
#include <functional>
#include <set>

#include "base/options.h"
#include "base/parallel.h"
#include "datasets/image_file.h"
#include "datasets/image_recording.h"
#include "experiments/textons.h"
#include "features/mr8_responses.h"
#include "place_recognition/error.h"
#include "recognition/frames/image_profile.h"
#include "recognition/frames/image_scaling.h"
#include "recognition/training/samples.h"

namespace place_recognition {
namespace {

constexpr int kPixelsPerImage = 500;  // for learning textons

TrainingOptions trainingOptions(const std::string& feature) {
  TrainingOptions options;
  CueOptions cue;
  cue.name = feature;
  if (feature == "lbp") cue.feature = LbpOptions();
  if (feature != "lbp") cue.feature = Mr8Options();
  options.cues = {cue};
  return options;
}

std::vector<RecordingOpener> runsOf(const std::vector<ImageSet>& sets) {
  std::vector<RecordingOpener> recordings;
  for (const ImageSet& set : sets)
    recordings.push_back([&set] { return recordingOf(set.name, set.images); });
  return recordings;
}

/// Extractors that need only one image at a time.
MaterialFeatures extractUntrained(const std::string& feature, const std::vector<ImageSet>& sets,
                                  unsigned threads, const Progress& progress) {
  Samples samples = collectSamples(runsOf(sets), trainingOptions(feature), threads, progress);
  MaterialFeatures result;
  result.samples.place_count = static_cast<int>(samples.places.size());
  result.samples.set_count = static_cast<int>(sets.size());
  for (const SampleOrigin& origin : samples.origins) {
    result.samples.places.push_back(origin.place);
    result.samples.sets.push_back(origin.recording);
  }
  result.lists.push_back(std::move(samples.features[0]));
  return result;
}

/// Histograms of textons. Images are read and filtered twice, once for the dictionaries and once
/// for the histograms, so that their responses need not be stored.
class TextonExtraction {
 public:
  TextonExtraction(const std::vector<ImageSet>& sets, unsigned threads, const Progress& progress)
      : size_(commonSize(runsOf(sets), progress)), threads_(threads), progress_(progress) {
    result_.samples = samplesOf(sets);
    for (const ImageSet& set : sets) {
      for (const LabelledImage& image : set.images) paths_.push_back(image.path);
    }
  }

  MaterialFeatures extract(const std::vector<TrainingSamples>& splits) {
    std::vector<cv::Mat1f> pixels(paths_.size());  // by image
    forEachImage("Filtering the images", [&](std::size_t i, const auto& responses) {
      pixels[i] = sampledPixels(responses, kPixelsPerImage);
    });
    std::vector<std::unique_ptr<TextonDictionary>> dictionaries(splits.size());
    report(progress_, "Learning textons", 0);
    parallelFor(splits.size(), threads_, [&](std::size_t split, unsigned) {
      dictionaries[split] = learn(pixels, splits[split]);
    });
    result_.lists.assign(splits.size(), std::vector<Feature>(paths_.size()));
    forEachImage("Counting textons", [&](std::size_t i, const auto& responses) {
      for (std::size_t split = 0; split < splits.size(); ++split) {
        result_.lists[split][i] = dictionaries[split]->histogram(responses);
      }
    });
    return std::move(result_);
  }

 private:
  std::unique_ptr<TextonDictionary> learn(const std::vector<cv::Mat1f>& pixels,
                                          const TrainingSamples& trained_on) const {
    const std::set<int> trained(trained_on.begin(), trained_on.end());
    std::vector<cv::Mat1f> materials(static_cast<std::size_t>(result_.samples.place_count));
    for (std::size_t i = 0; i < pixels.size(); ++i) {
      if (trained.count(result_.samples.sets[i]) == 0) continue;
      materials[static_cast<std::size_t>(result_.samples.places[i])].push_back(pixels[i]);
    }
    return std::make_unique<TextonDictionary>(materials);
  }

  using Work = std::function<void(std::size_t image, const Mr8FilterBank::Responses& responses)>;

  void forEachImage(const std::string& stage, const Work& work) const {
    std::vector<Mr8Responses> filters(threadCount(threads_), Mr8Responses(Mr8Options().weber));
    std::vector<ImageScaler> scalers(filters.size(), ImageScaler(size_, ImageOptions().max_width));
    constexpr std::size_t kAtOnce = 64;  // images between two checks for a stop
    for (std::size_t begin = 0; begin < paths_.size(); begin += kAtOnce) {
      report(progress_, stage, static_cast<double>(begin) / static_cast<double>(paths_.size()));
      const std::size_t count = std::min(kAtOnce, paths_.size() - begin);
      parallelFor(count, threads_, [&](std::size_t i, unsigned thread) {
        const DecodedImage image = readImageFile(paths_[begin + i]);
        if (image.image.empty()) {
          throw Error(paths_[begin + i] + " cannot be read: " + image.problem + ".");
        }
        work(begin + i, filters[thread].of(scalers[thread].scaled(image.image)));
      });
    }
  }

  const ImageProfile size_;
  const unsigned threads_;
  const Progress& progress_;
  std::vector<std::string> paths_;
  MaterialFeatures result_;
};

}  // namespace

std::string describeFeature(const std::string& feature) {
  if (feature != "mr8") return writeOptions(trainingOptions(feature).cues[0]);
  return std::to_string(TextonDictionary::kPerMaterial) + " textons per material, of " +
         std::to_string(kPixelsPerImage) + " pixels per image";
}

MaterialFeatures extractMaterials(const std::string& feature, const std::vector<ImageSet>& sets,
                                  const std::vector<TrainingSamples>& splits, unsigned threads,
                                  const Progress& progress) {
  if (feature != "mr8") return extractUntrained(feature, sets, threads, progress);
  return TextonExtraction(sets, threads, progress).extract(splits);
}

}  // namespace place_recognition
