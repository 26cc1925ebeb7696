#pragma once

#include <vector>

#include "datasets/image_set.h"
#include "experiments/experiment.h"
#include "experiments/table_8_4.h"
#include "experiments/test_sets.h"
#include "place_recognition/feature.h"
#include "place_recognition/feature_options.h"

namespace place_recognition {

/// The histograms to compare, and the corresponding table of the thesis.
enum class HistogramSweep {
  kDescriptors,  ///< Table 8.4: descriptors x combinations of one to four of the scales 1..5
  kBins,         ///< Table 8.5: 5 to 40 bins for seven combinations at the thesis' scales
};

/// Section 8.3.1. One cell per histogram: its rate for every training set and every gamma of 10^-3,
/// 10^-2.5 ... 10^3, with C = 100. As in the thesis, the tables show the best of these in
/// hindsight.
class HistogramExperiment : public Experiment {
 public:
  /// Trains on each of `sets` in turn. The sweep over descriptors omits histograms of more than
  /// `max_dimensions` dimensions and those whose bins cannot be numbered with 64 bits. `threads`: 0
  /// means one per core.
  HistogramExperiment(HistogramSweep sweep, std::vector<ImageSet> sets, int max_dimensions,
                      unsigned threads);

  std::vector<Json> cells() const override;
  void compute(const std::vector<Json>& cells, const CellSink& finished,
               const Progress& progress) override;
  Findings findings(const std::vector<Json>& results) const override;

 private:
  struct Candidate {
    std::size_t row;  ///< of the thesis' table
    CrfhOptions options;
  };
  /// Histograms extracted together; their number bounds the memory for the features of all images.
  using Batch = std::vector<const Candidate*>;

  const Candidate& candidateOf(const Json& cell) const;
  Json cellOf(const Candidate& candidate) const;
  std::vector<std::vector<Feature>> extract(const Batch& batch, const Progress& progress) const;
  Json rates(const std::vector<Feature>& features, const Progress& progress) const;

  HistogramSweep sweep_;
  std::vector<ImageSet> sets_;
  std::vector<const LabelledImage*> images_;  // of all sets, one after another
  SetSamples samples_;
  unsigned threads_;
  std::vector<Candidate> candidates_;
};

}  // namespace place_recognition
