#pragma once

#include <string>
#include <vector>

#include "datasets/image_set.h"

namespace place_recognition {

/// The images of a data set by condition of light (cloudy, night, sunny), in order of their
/// names.
///
/// indecs     `folder` as import takes it, with several conditions
/// idol, cold  a folder of sequences whose names tell the condition, as in dum_cloudy1, seq2_night1
///
/// Throws Error if there are fewer than two conditions, or for what does not fit the layout.
std::vector<ImageSet> conditionSets(const std::string& folder, const std::string& layout);

/// Buildings: each folder in `folder`, read as above, the images of all its conditions, of which
/// one is enough. Its places are to be named by their kind; in the names of cold (2PO1-A), what
/// follows the kind is left out (2PO). Throws Error for what does not fit the layout.
std::vector<ImageSet> buildingSets(const std::string& folder, const std::string& layout);

/// The n-th sample of each material in the n-th set: MATERIAL/SAMPLE/IMAGE, samples in order of
/// their names. Where images lie directly in the materials' folders, four blocks of each in order
/// of their names take the place of samples. Throws Error if materials differ in their number of
/// samples.
std::vector<ImageSet> sampleSets(const std::string& folder);

}  // namespace place_recognition
