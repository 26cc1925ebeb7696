#pragma once

#include <vector>

#include "datasets/image_set.h"
#include "experiments/experiment.h"
#include "experiments/table_8_4.h"
#include "experiments/test_sets.h"
#include "place_recognition/feature.h"
#include "place_recognition/feature_options.h"

namespace place_recognition {

/// Which histograms are compared, and beside which table of the thesis.
enum class HistogramSweep {
  kDescriptors,  ///< Table 8.4: descriptors x combinations of one to four of the scales 1..5
  kBins,         ///< Table 8.5: 5 to 40 bins for seven combinations at the thesis' scales
};

/// Sections 8.3.1: one cell a histogram, which holds its rate for every training set and gamma of
/// 10^-3, 10^-2.5 ... 10^3, with C = 100. As in the thesis, the tables show the best of these in
/// hindsight.
class HistogramExperiment : public Experiment {
 public:
  /// Each of `sets` is trained on in turn. Descriptors: histograms of more than `max_dimensions`
  /// are left out, as are those whose bins 64 bits cannot number. `threads`: 0: one per core.
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
  /// What a batch of histograms of all images takes up is bounded by how many there are.
  using Batch = std::vector<const Candidate*>;

  const Candidate& candidateOf(const Json& cell) const;
  Json cellOf(const Candidate& candidate) const;
  std::vector<std::vector<Feature>> extract(const Batch& batch, const Progress& progress) const;
  Json rates(const std::vector<Feature>& features, const Progress& progress) const;

  HistogramSweep sweep_;
  std::vector<ImageSet> sets_;
  std::vector<const LabelledImage*> images_;  // of all sets, one after the other
  SetSamples samples_;
  unsigned threads_;
  std::vector<Candidate> candidates_;
};

}  // namespace place_recognition
