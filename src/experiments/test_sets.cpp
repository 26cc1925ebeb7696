#include "experiments/test_sets.h"

#include <map>
#include <utility>

#include "learning/selection.h"
#include "recognition/model/scores.h"

namespace place_recognition {

Fold SetSamples::split(int set) const {
  Fold fold;
  for (std::size_t i = 0; i < sets.size(); ++i) {
    (sets[i] == set ? fold.train : fold.test).push_back(static_cast<int>(i));
  }
  return fold;
}

SetSamples samplesOf(const std::vector<ImageSet>& sets) {
  std::map<std::string, int> places;
  for (const ImageSet& set : sets) {
    for (const LabelledImage& image : set.images) places[image.place] = 0;
  }
  SetSamples samples;
  samples.set_count = static_cast<int>(sets.size());
  for (auto& [name, place] : places) place = samples.place_count++;
  for (std::size_t set = 0; set < sets.size(); ++set) {
    for (const LabelledImage& image : sets[set].images) {
      samples.places.push_back(places[image.place]);
      samples.sets.push_back(static_cast<int>(set));
    }
  }
  return samples;
}

std::vector<TestCount> testCounts(const SetSamples& samples, const std::vector<int>& test,
                                  const std::vector<int>& answers) {
  std::map<std::pair<int, int>, TestCount> found;
  for (std::size_t i = 0; i < test.size(); ++i) {
    const auto sample = static_cast<std::size_t>(test[i]);
    TestCount& count = found[{samples.places[sample], samples.sets[sample]}];
    count.place = samples.places[sample];
    count.set = samples.sets[sample];
    count.right += answers[i] == count.place ? 1 : 0;
    ++count.total;
  }
  std::vector<TestCount> counts;
  for (const auto& [key, count] : found) counts.push_back(count);
  return counts;
}

double meanRate(const std::vector<TestCount>& counts) {
  double sum = 0;
  for (const TestCount& count : counts) sum += static_cast<double>(count.right) / count.total;
  return counts.empty() ? 0 : sum / static_cast<double>(counts.size());
}

std::vector<int> answersOf(const BinarySvms& machines, const Eigen::MatrixXd& kernel_values) {
  const Eigen::MatrixXd decision_values =
      placeValues(machines, machines.decisionValues(kernel_values));
  std::vector<int> answers;
  for (Eigen::Index i = 0; i < decision_values.rows(); ++i)
    answers.push_back(largest(decision_values.row(i)));
  return answers;
}

double rateOf(const Eigen::MatrixXd& gram, const SetSamples& samples, const Fold& fold,
              const SvmOptions& svm) {
  const BinarySvms machines =
      trainMachines(submatrix(gram, fold.train, fold.train), pick(samples.places, fold.train),
                    static_cast<std::size_t>(samples.place_count), svm);
  const auto answers = answersOf(machines, submatrix(gram, fold.test, fold.train));
  return meanRate(testCounts(samples, fold.test, answers));
}

}  // namespace place_recognition
