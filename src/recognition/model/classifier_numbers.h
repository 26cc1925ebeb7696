#pragma once

#include <cstdint>
#include <vector>

#include "base/huge_pages.h"
#include "learning/posting_lists.h"
#include "place_recognition/model.h"

namespace place_recognition {

/// The numbers of one classifier as stored in a model file. Support vectors are stored by bin or,
/// if they are sets of local descriptors, one after another; the arrays of the other kind are
/// empty.
struct ClassifierNumbers {
  /// Origin of each vector: the index of its place; its age in the upper 16 bits.
  std::vector<std::uint32_t> vector_origins;
  std::vector<double> weights;           ///< vectors x machines, row-major
  std::vector<double> biases;            ///< one per machine
  PostingLists lists;                    ///< sparse and dense vectors
  std::vector<std::uint32_t> set_sizes;  ///< descriptors of each set
  HugeVector<std::uint8_t> descriptors;  ///< DescriptorSet::kDimension bytes each

  /// Calls visitor(array) for each array, in the order of the file.
  template <typename Visitor>
  void visit(Visitor& visitor) {
    visitor(vector_origins);
    visitor(weights);
    visitor(biases);
    visitor(lists.totals);
    visitor(lists.bins);
    visitor(lists.counts);
    visitor(lists.rows);
    visitor(lists.values);
    visitor(lists.numbers);
    visitor(set_sizes);
    visitor(descriptors);
  }
};

ClassifierNumbers numbersOf(const Classifier& classifier);

/// The classifier of cue number `cue` of a model whose options and places are set. Throws Error, a
/// phrase without a source, if any count, range or number is invalid for such a classifier.
Classifier classifierOf(ClassifierNumbers numbers, const Model& model, std::size_t cue);

}  // namespace place_recognition
