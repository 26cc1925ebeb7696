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

/// The feature of all images of samples of materials.
struct MaterialFeatures {
  SetSamples samples;  ///< set: the sample of the material
  /// One list for each split, or a single one if the feature needs no training.
  std::vector<std::vector<Feature>> lists;

  const std::vector<Feature>& ofSplit(std::size_t split) const {
    return lists.size() == 1 ? lists.front() : lists.at(split);
  }
};

/// How `feature`, one of kMaterialFeatures, is found, for what identifies a result.
std::string describeFeature(const std::string& feature);

/// `feature` of all images of `sets`; textons are those of the training images of each of
/// `splits`. Throws Error if there is no image to be read, Cancelled.
MaterialFeatures extractMaterials(const std::string& feature, const std::vector<ImageSet>& sets,
                                  const std::vector<TrainingSamples>& splits, unsigned threads,
                                  const Progress& progress);

}  // namespace place_recognition
