#pragma once

#include <memory>
#include <vector>

#include "datasets/image_set.h"
#include "experiments/experiment.h"
#include "experiments/place_training.h"

namespace place_recognition {

// The experiments. Unless stated otherwise, each of `sets` is trained on in turn and tested on the
// others. `threads`: 0 means one per core.

/// Tables 8.2 and 8.6, and the splits of Table 8.1. One cell per training set.
std::unique_ptr<Experiment> finalExperiment(PlaceFeatures features, std::vector<ImageSet> sets,
                                            unsigned threads);

/// Tables 8.3 and 8.7: support vector reduction of the classifiers of Tables 8.2 and 8.6 by the
/// thesis' method, with and without normalization, and by the two methods with one basis for all
/// machines. One cell per kind of features, training set, method and normalization.
std::unique_ptr<Experiment> reductionExperiment(std::vector<ImageSet> sets, unsigned threads);

/// Table 8.4 (section 8.3.1): descriptors x combinations of one to four of the scales 1..5, without
/// histograms of more than `max_dimensions` dimensions and those whose bins cannot be numbered with
/// 64 bits. One cell per histogram: its rate for every training set and every gamma of 10^-3,
/// 10^-2.5 ... 10^3, with C = 100. As in the thesis, the table shows the best of these in
/// hindsight.
std::unique_ptr<Experiment> descriptorsExperiment(std::vector<ImageSet> sets, int max_dimensions,
                                                  unsigned threads);

/// The same for Table 8.5: 5 to 40 bins for seven combinations at the thesis' scales.
std::unique_ptr<Experiment> binsExperiment(std::vector<ImageSet> sets, unsigned threads);

/// Chapter 7: support vector reduction on materials. Some samples of each material are trained on,
/// and the others are tested on. One cell per feature, split and kernel, for all machines with that
/// kernel; see material_grid.h. `samples`: at least three, each with images of every material;
/// throws Error if there are fewer.
std::unique_ptr<Experiment> materialsExperiment(std::vector<ImageSet> samples, unsigned threads);

/// Figures 5.5, 6.1 and 6.2, and one of kernels: machines on artificial points of the plane. One
/// cell per panel.
std::unique_ptr<Experiment> figuresExperiment();

/// Measures how much training data is needed and which viewpoints matter (section 9.1): the rate on
/// the other sets, with global features, for 1, 2, 4 ... images per room, either spread over its
/// viewpoints or from neighbouring ones, and without each viewpoint in turn. A viewpoint is twelve
/// successive images of a room, one marker of KTH-INDECS. One cell per training set; gamma is found
/// on the whole training set.
std::unique_ptr<Experiment> learningCurveExperiment(std::vector<ImageSet> sets, unsigned threads);

/// Tests whether a classifier generalizes to new places of the same kind (section 9.1): it is
/// trained on all buildings but one and tested on that one. One cell per kind of features and
/// tested building. `buildings`: at least three, whose places of one kind share one name; throws
/// Error if there are fewer.
std::unique_ptr<Experiment> categoriesExperiment(std::vector<ImageSet> buildings, unsigned threads);

/// Compares two ways of combining cues (section 9.1): the weighted mean of their decision values,
/// which models use, and an SVM over the decision values of all cues (Pronobis, Martinez Mozos and
/// Caputo 2008). Both are fitted on the same held-out frames of the training set and tested on
/// single images of the other sets. One cell per set of cues and training set.
std::unique_ptr<Experiment> cuesExperiment(std::vector<ImageSet> sets, unsigned threads);

}  // namespace place_recognition
