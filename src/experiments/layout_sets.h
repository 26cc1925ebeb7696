#pragma once

#include <string>
#include <vector>

#include "datasets/image_set.h"

namespace place_recognition {

/// The images of a data set by illumination condition (cloudy, night, sunny), in order of the
/// conditions' names.
///
/// indecs      `folder` as `import` takes it, with several conditions
/// idol, cold  a folder of sequences whose names contain the condition: dum_cloudy1, seq2_night1
///
/// `warnings`: gets a sentence for the user for each folder without images. Throws Error if there
/// are fewer than two conditions, or if the folder does not fit the layout.
std::vector<ImageSet> conditionSets(const std::string& folder, const std::string& layout,
                                    std::vector<std::string>& warnings);

/// The buildings in `folder`: each subfolder is read as above, with the images of all its
/// conditions, of which one is enough. Its places must be named by their kind; for cold, the rest
/// of the name is dropped (2PO1-A becomes 2PO). Throws Error if a folder does not fit the layout.
std::vector<ImageSet> buildingSets(const std::string& folder, const std::string& layout,
                                   std::vector<std::string>& warnings);

/// The n-th set contains the n-th sample of each material: MATERIAL/SAMPLE/IMAGE, samples in order
/// of their names. If images lie directly in the materials' folders, the samples are four blocks of
/// each, in order of their names. Throws Error if materials differ in their number of samples.
std::vector<ImageSet> sampleSets(const std::string& folder);

}  // namespace place_recognition
