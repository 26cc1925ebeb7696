#include "recognition/training/model_answers.h"

namespace place_recognition {
namespace {

HeldOutValues cueAnswers(const Classifier& classifier, const std::vector<Feature>& features) {
  HeldOutValues answers = HeldOutValues::none(features.size(), classifier.places());
  Eigen::VectorXd kernel_values;
  Eigen::RowVectorXd decision_values;
  for (std::size_t i = 0; i < features.size(); ++i) {
    if (isMissing(features[i])) continue;
    classifier.decisionValues(features[i], kernel_values, decision_values);
    answers.set(static_cast<int>(i), decision_values,
                kernel_values.size() > 0 ? kernel_values.maxCoeff() : 0);
  }
  return answers;
}

}  // namespace

std::vector<HeldOutValues> modelAnswers(const Model& model,
                                        const std::vector<std::vector<Feature>>& features) {
  std::vector<HeldOutValues> answers;
  for (std::size_t c = 0; c < model.classifiers.size(); ++c) {
    answers.push_back(cueAnswers(model.classifiers[c], features[c]));
  }
  return answers;
}

}  // namespace place_recognition
