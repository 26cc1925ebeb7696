#pragma once

#include <string>
#include <vector>

#include "datasets/image_set.h"
#include "experiments/material_grid.h"
#include "experiments/test_sets.h"
#include "place_recognition/feature.h"
#include "place_recognition/progress.h"
#include "place_recognition/training_options.h"

namespace place_recognition {

/// One feature of all images of the materials' samples.
struct MaterialFeatures {
  SetSamples samples;  ///< its `sets` are the samples of the materials
  /// One list per split, or a single one if the feature needs no training.
  std::vector<std::vector<Feature>> lists;

  const std::vector<Feature>& ofSplit(std::size_t split) const {
    return lists.size() == 1 ? lists.front() : lists.at(split);
  }
};

/// The definition of `feature`, one of kMaterialFeatures, for the identity of a result.
std::string describeFeature(const std::string& feature);

/// Extracts `feature` from all images of `sets`; textons come from the training images of each of
/// `splits`. Throws Error if there is no image to read; Cancelled.
MaterialFeatures extractMaterials(const std::string& feature, const std::vector<ImageSet>& sets,
                                  const std::vector<TrainingSamples>& splits, unsigned threads,
                                  const Progress& progress);

}  // namespace place_recognition
