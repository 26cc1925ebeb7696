#include "recognition/model/classifier_numbers.h"

#include <algorithm>
#include <cmath>
#include <variant>

#include "base/place_name.h"
#include "base/require.h"
#include "learning/classifier_parts.h"
#include "place_recognition/error.h"

namespace place_recognition {
namespace {

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

bool allFinite(const std::vector<double>& numbers) {
  return std::all_of(numbers.begin(), numbers.end(), [](double x) { return std::isfinite(x); });
}

/// The dimension of an extractor's dense vectors; 0 if they are sparse.
std::size_t dimensionOf(const FeatureOptions& options) {
  if (const auto* embedding = std::get_if<EmbeddingOptions>(&options)) {
    return embedding->dimension * static_cast<std::size_t>(embedding->parts());
  }
  if (const auto* hog = std::get_if<HogOptions>(&options)) return hog->dimension();
  const auto* lbp = std::get_if<LbpOptions>(&options);
  std::size_t dimension = 0;
  if (!lbp) return dimension;
  for (const LbpCircle& circle : lbp->circles) {
    dimension += static_cast<std::size_t>(circle.points) + 2;
  }
  return dimension;
}

// One overload per alternative of SupportSet::Index.
void write(const InvertedIndex& index, ClassifierNumbers& numbers) {
  numbers.lists = index.lists();
}
void write(const LocalMatchIndex& index, ClassifierNumbers& numbers) {
  for (const Feature& feature : index.vectors()) {
    const auto& set = std::get<DescriptorSet>(feature);
    numbers.set_sizes.push_back(static_cast<std::uint32_t>(set.size()));
    numbers.descriptors.insert(numbers.descriptors.end(), set.descriptors.begin(),
                               set.descriptors.end());
  }
}

BinarySvms machinesOf(const ClassifierNumbers& numbers, const Model& model) {
  BinarySvms machines;
  machines.places = model.places.size();
  machines.one_against_one = model.options.svm.multiclass == "one-against-one";
  const std::size_t vectors = numbers.vector_origins.size();
  const std::size_t count = machineCount(machines.places, machines.one_against_one);
  require(numbers.biases.size() == count, "the number of machines does not match the places");
  require(numbers.weights.size() == vectors * count,
          "the number of weights does not match the support vectors and machines");
  require(allFinite(numbers.weights), "a weight is not finite");
  require(allFinite(numbers.biases), "a bias is not finite");
  machines.weights = Eigen::Map<const RowMajor>(
      numbers.weights.data(), static_cast<Eigen::Index>(vectors), static_cast<Eigen::Index>(count));
  machines.biases =
      Eigen::Map<const Eigen::RowVectorXd>(numbers.biases.data(), static_cast<Eigen::Index>(count));
  require(supportVectors(machines).size() == vectors, "a support vector has no weight");
  return machines;
}

constexpr int kAgeBits = 16;
constexpr std::uint32_t kLargest = (1u << kAgeBits) - 1;  // place, or age
static_assert(kMaxPlaces <= kLargest);

std::vector<std::uint32_t> packed(const std::vector<VectorOrigin>& origins) {
  std::vector<std::uint32_t> numbers;
  for (const VectorOrigin& origin : origins) {
    const std::uint32_t age = std::min(kLargest, static_cast<std::uint32_t>(origin.age));
    numbers.push_back(static_cast<std::uint32_t>(origin.place) | age << kAgeBits);
  }
  return numbers;
}

std::vector<VectorOrigin> originsOf(const ClassifierNumbers& numbers, const Model& model) {
  std::vector<VectorOrigin> origins;
  for (const std::uint32_t number : numbers.vector_origins) {
    const std::uint32_t place = number & kLargest;
    require(place < model.places.size(), "a support vector belongs to a place that does not exist");
    origins.push_back({static_cast<int>(place), static_cast<int>(number >> kAgeBits)});
  }
  return origins;
}

/// The sizes must be consistent before anything is allocated for the sets.
std::vector<Feature> descriptorSets(const ClassifierNumbers& numbers) {
  std::uint64_t total = 0;
  for (const std::uint32_t size : numbers.set_sizes) {
    require(size > 0, "a support vector is empty");
    total += size;
  }
  require(numbers.set_sizes.size() == numbers.vector_origins.size() &&
              numbers.descriptors.size() == total * DescriptorSet::kDimension,
          "the sizes of the support vectors do not add up");
  std::vector<Feature> sets;
  const std::uint8_t* begin = numbers.descriptors.data();
  for (const std::uint32_t size : numbers.set_sizes) {
    const std::uint8_t* end = begin + std::size_t{size} * DescriptorSet::kDimension;
    sets.emplace_back(DescriptorSet{{begin, end}});
    begin = end;
  }
  return sets;
}

SupportSet supportSetOf(ClassifierNumbers& numbers, const CueOptions& cue) {
  const bool local = std::holds_alternative<LocalFeatureOptions>(cue.feature);
  const PostingLists& lists = numbers.lists;
  const bool no_lists = lists.totals.empty() && lists.bins.empty() && lists.counts.empty() &&
                        lists.rows.empty() && lists.values.empty() && lists.numbers.empty();
  require(local ? no_lists : numbers.set_sizes.empty() && numbers.descriptors.empty(),
          "the support vectors are not of the extractor's kind");
  const Kernel kernel(cue.kernel);
  if (local) return SupportSet(kernel, descriptorSets(numbers));
  require(lists.vectors() == numbers.vector_origins.size(),
          "the number of totals does not match the support vectors");
  numbers.lists.dimension = dimensionOf(cue.feature);
  return SupportSet(kernel, std::move(numbers.lists));
}

}  // namespace

ClassifierNumbers numbersOf(const Classifier& classifier) {
  ClassifierNumbers numbers;
  const ClassifierParts& parts = ClassifierParts::of(classifier);
  numbers.vector_origins = packed(parts.origins);
  const RowMajor weights = parts.machines.weights;
  const Eigen::RowVectorXd& biases = parts.machines.biases;
  numbers.weights.assign(weights.data(), weights.data() + weights.size());
  numbers.biases.assign(biases.data(), biases.data() + biases.size());
  std::visit([&numbers](const auto& index) { write(index, numbers); }, parts.support_set.index());
  return numbers;
}

Classifier classifierOf(ClassifierNumbers numbers, const Model& model, std::size_t cue) {
  BinarySvms machines = machinesOf(numbers, model);
  std::vector<VectorOrigin> origins = originsOf(numbers, model);
  return ClassifierParts::assemble(
      {std::move(machines), supportSetOf(numbers, model.options.cues[cue]), std::move(origins)});
}

}  // namespace place_recognition
