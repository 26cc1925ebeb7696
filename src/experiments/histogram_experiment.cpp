#include "experiments/experiments.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "base/parallel.h"
#include "datasets/image_file.h"
#include "experiments/crfh_bank.h"
#include "experiments/histogram_tables.h"
#include "experiments/test_sets.h"
#include "experiments/thesis_histograms.h"
#include "learning/gram.h"
#include "learning/selection.h"
#include "place_recognition/error.h"
#include "recognition/frames/cue_extraction.h"

namespace place_recognition {
namespace {

constexpr int kWidth = 512;  // pixels, section 8.1
constexpr double kC = 100;
/// Parameters that the thesis does not state for Table 8.4. Its rows have at most 8 dimensions, as
/// if bins were numbered with 32 bits, and one row equals the row of Table 8.5 with 15 bins.
constexpr int kBinsOfTable84 = 15;
constexpr double kBatchBytes = 1.5e9;

std::vector<double> gammas() {
  std::vector<double> values;
  for (int i = -6; i <= 6; ++i) values.push_back(std::pow(10, 0.5 * i));
  return values;
}

/// All combinations of one to four of the scales 1..5, ordered by their number.
std::vector<std::vector<double>> scaleCombinations() {
  std::vector<std::vector<double>> combinations;
  for (int count = 1; count <= 4; ++count) {
    for (int chosen = 1; chosen < 32; ++chosen) {
      std::vector<double> scales;
      for (int scale = 1; scale <= 5; ++scale) {
        if (chosen & (1 << (scale - 1))) scales.push_back(scale);
      }
      if (static_cast<int>(scales.size()) == count) combinations.push_back(scales);
    }
  }
  return combinations;
}

/// Whether the bins can be numbered with 64 bits.
bool isPossible(const CrfhOptions& options) {
  try {
    options.check();
    return true;
  } catch (const Error&) {
    return false;
  }
}

CrfhOptions histogram(const ThesisRow& row, const std::vector<double>& scales, int bins) {
  CrfhOptions options;
  options.descriptors = row.descriptors;
  options.scales = scales;
  options.bins = {bins};
  return options;
}

cv::Mat readImage(const LabelledImage& image) {
  const DecodedImage decoded = readImageFile(image.path);
  if (decoded.image.empty()) {
    throw Error("The image " + image.path + " cannot be used: " + decoded.problem +
                "; remove it or put a good one in its place.");
  }
  cv::Mat buffer;
  return scaledDown(decoded.image, kWidth, buffer);
}

double bytesOf(const Feature& feature) {
  constexpr double kBytesOfBin = sizeof(std::uint64_t) + sizeof(float);
  const auto* histogram = std::get_if<SparseVector>(&feature);
  return histogram ? kBytesOfBin * static_cast<double>(histogram->size()) : 0;
}

/// A histogram to compare.
struct Candidate {
  std::size_t row;  ///< of the thesis' table
  CrfhOptions options;
};

std::vector<Candidate> candidatesOfTable84(int max_dimensions) {
  std::vector<Candidate> candidates;
  for (std::size_t row = 0; row < table84().size(); ++row) {
    for (const std::vector<double>& scales : scaleCombinations()) {
      const auto dimensions = table84()[row].descriptors.size() * scales.size();
      if (static_cast<int>(dimensions) > max_dimensions) continue;
      candidates.push_back({row, histogram(table84()[row], scales, kBinsOfTable84)});
    }
  }
  return candidates;
}

std::vector<Candidate> candidatesOfTable85() {
  std::vector<Candidate> candidates;
  for (std::size_t row = 0; row < table85().size(); ++row) {
    for (int bins = 5; bins <= 40; ++bins) {
      candidates.push_back({row, histogram(table85()[row], table85()[row].scales, bins)});
    }
  }
  return candidates;
}

class HistogramExperiment : public Experiment {
 public:
  /// Compares those of `candidates` that are possible.
  HistogramExperiment(HistogramSweep sweep, std::vector<Candidate> candidates,
                      std::vector<ImageSet> sets, unsigned threads)
      : sweep_(sweep),
        sets_(std::move(sets)),
        samples_(samplesOf(sets_)),
        threads_(threads),
        candidates_(std::move(candidates)) {
    for (const ImageSet& set : sets_) {
      for (const LabelledImage& image : set.images) images_.push_back(&image);
    }
    candidates_.erase(std::remove_if(candidates_.begin(), candidates_.end(),
                                     [](const Candidate& c) { return !isPossible(c.options); }),
                      candidates_.end());
  }

  std::vector<Json> cells() const override {
    std::vector<Json> cells;
    for (const Candidate& candidate : candidates_) cells.push_back(cellOf(candidate));
    return cells;
  }

  void compute(const std::vector<Json>& cells, const CellSink& finished,
               const Progress& progress) override {
    std::size_t done = 0;
    // Progress of a part of the work that reports from 0 to 1.
    const auto fraction = [&](double parts) -> Progress {
      return [&, parts](const std::string& stage, double fraction) {
        const double all = (static_cast<double>(done) + parts * fraction) / cells.size();
        return !progress || progress("Histograms, " + stage, all);
      };
    };
    while (done < cells.size()) {
      // Histograms of the same descriptors have the same responses.
      const Candidate& first = candidateOf(cells[done]);
      Batch batch;
      double bytes = 0;
      for (std::size_t i = done; i < cells.size(); ++i) {
        const Candidate& candidate = candidateOf(cells[i]);
        if (candidate.row != first.row) break;
        CrfhBank bank({candidate.options});
        const auto sample = bank.extract(readImage(*images_[images_.size() / 2]));
        bytes += bytesOf(sample[0]) * static_cast<double>(images_.size());
        if (!batch.empty() && bytes > kBatchBytes) break;
        batch.push_back(&candidate);
      }
      std::vector<std::vector<Feature>> features = extract(batch, fraction(0));
      for (std::vector<Feature>& histograms : features) {
        finished(cells[done], rates(histograms, fraction(1)));
        ++done;
        std::vector<Feature>().swap(histograms);
      }
    }
  }

  Findings findings(const std::vector<Json>& results) const override {
    std::vector<HistogramResult> histograms;
    for (std::size_t i = 0; i < candidates_.size(); ++i) {
      HistogramResult& histogram = histograms.emplace_back();
      histogram.row = candidates_[i].row;
      histogram.options = candidates_[i].options;
      for (const ImageSet& set : sets_) {
        histogram.rates.push_back(results[i].at("rates").at(set.name).get<std::vector<double>>());
      }
    }
    std::vector<std::string> names;
    for (const ImageSet& set : sets_) names.push_back(set.name);
    return {{histogramTable(sweep_, names, gammas(), histograms)}, {}};
  }

 private:
  /// Histograms extracted together; their number bounds the memory for the features of all images.
  using Batch = std::vector<const Candidate*>;

  Json cellOf(const Candidate& candidate) const {
    return {{"histogram",
             {{"descriptors", candidate.options.descriptors},
              {"scales", candidate.options.scales},
              {"bins", candidate.options.bins}}},
            {"width", kWidth},
            {"c", kC},
            {"gammas", gammas()}};
  }

  const Candidate& candidateOf(const Json& cell) const {
    return *std::find_if(candidates_.begin(), candidates_.end(),
                         [&](const Candidate& candidate) { return cellOf(candidate) == cell; });
  }

  std::vector<std::vector<Feature>> extract(const Batch& batch, const Progress& progress) const {
    std::vector<CrfhOptions> options;
    for (const Candidate* candidate : batch) options.push_back(candidate->options);
    std::vector<CrfhBank> banks(threadCount(threads_), CrfhBank(options));
    std::vector<std::vector<Feature>> features(batch.size(), std::vector<Feature>(images_.size()));
    std::atomic<std::size_t> done{0};
    parallelFor(images_.size(), threads_, [&](std::size_t i, unsigned thread) {
      std::vector<Feature> histograms = banks[thread].extract(readImage(*images_[i]));
      for (std::size_t h = 0; h < batch.size(); ++h) {
        if (isMissing(histograms[h])) {
          throw Error("The image " + images_[i]->path +
                      " is too small for these histograms; give larger ones.");
        }
        features[h][i] = std::move(histograms[h]);
      }
      ++done;
      if (thread == 0) {
        report(progress, "counting", static_cast<double>(done) / images_.size());
      }
    });
    return features;
  }

  Json rates(const std::vector<Feature>& features, const Progress& progress) const {
    const auto kernelOf = [](double gamma) {
      KernelOptions options;
      options.type = "chi-squared";
      options.gamma = gamma;
      return Kernel(options);
    };
    const Eigen::MatrixXd measures = measureMatrix(kernelOf(1), features, threads_, progress);
    SvmOptions svm;
    svm.c = kC;

    const std::vector<double> all_gammas = gammas();
    std::vector<std::vector<double>> rates(sets_.size(), std::vector<double>(all_gammas.size()));
    parallelFor(sets_.size() * all_gammas.size(), threads_, [&](std::size_t task, unsigned thread) {
      const std::size_t set = task / all_gammas.size(), g = task % all_gammas.size();
      if (thread == 0) report(progress, "comparing", 1);
      const Fold split = samples_.split(static_cast<int>(set));
      const Kernel kernel = kernelOf(all_gammas[g]);
      const Eigen::MatrixXd gram =
          gramMatrix(kernel, submatrix(measures, split.train, split.train));
      const BinarySvms machines =
          trainMachines(gram, pick(samples_.places, split.train),
                        static_cast<std::size_t>(samples_.place_count), svm);
      const Eigen::MatrixXd values =
          gramMatrix(kernel, submatrix(measures, split.test, split.train));
      rates[set][g] = meanRate(testCounts(samples_, split.test, answersOf(machines, values)));
    });

    double bins = 0;
    for (const Feature& feature : features) bins += std::get<SparseVector>(feature).size();
    Json by_set = Json::object();
    for (std::size_t set = 0; set < sets_.size(); ++set) by_set[sets_[set].name] = rates[set];
    return {{"rates", by_set}, {"bins_hit", bins / static_cast<double>(features.size())}};
  }

  HistogramSweep sweep_;
  std::vector<ImageSet> sets_;
  std::vector<const LabelledImage*> images_;  // of all sets, one after another
  SetSamples samples_;
  unsigned threads_;
  std::vector<Candidate> candidates_;
};

}  // namespace

std::unique_ptr<Experiment> descriptorsExperiment(std::vector<ImageSet> sets, int max_dimensions,
                                                  unsigned threads) {
  return std::make_unique<HistogramExperiment>(
      HistogramSweep::kDescriptors, candidatesOfTable84(max_dimensions), std::move(sets), threads);
}

std::unique_ptr<Experiment> binsExperiment(std::vector<ImageSet> sets, unsigned threads) {
  return std::make_unique<HistogramExperiment>(HistogramSweep::kBins, candidatesOfTable85(),
                                               std::move(sets), threads);
}

}  // namespace place_recognition
