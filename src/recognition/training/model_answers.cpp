#include "recognition/training/model_answers.h"

namespace place_recognition {
namespace {

HeldOutValues cueAnswers(const Classifier& classifier, const std::vector<Feature>& features) {
  const auto count = static_cast<Eigen::Index>(features.size());
  HeldOutValues answers{
      Eigen::MatrixXd::Zero(count, static_cast<Eigen::Index>(classifier.places())),
      std::vector<bool>(features.size(), false), Eigen::VectorXd::Zero(count)};
  Eigen::VectorXd kernel_values;
  Eigen::RowVectorXd decision_values;
  for (Eigen::Index i = 0; i < count; ++i) {
    const Feature& feature = features[static_cast<std::size_t>(i)];
    if (isMissing(feature)) continue;
    classifier.decisionValues(feature, kernel_values, decision_values);
    answers.decision_values.row(i) = decision_values;
    if (kernel_values.size() > 0) answers.familiarity[i] = kernel_values.maxCoeff();
    answers.valid[static_cast<std::size_t>(i)] = true;
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
