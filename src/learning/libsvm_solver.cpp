#include "learning/libsvm_solver.h"

#include <svm.h>

#include <cassert>
#include <memory>
#include <mutex>

namespace place_recognition {
namespace {

/// Tolerance of the optimality conditions, which determines the accuracy of decision values.
constexpr double kTolerance = 1e-4;
/// Size of libsvm's own cache for rows of a machine's problem.
constexpr double kCacheMegabytes = 200;

void silenceLibsvm() {
  static std::once_flag once;
  std::call_once(once, [] { svm_set_print_string_function([](const char*) {}); });
}

svm_parameter parameters(double c) {
  svm_parameter parameter = {};
  parameter.svm_type = C_SVC;
  parameter.kernel_type = PRECOMPUTED;
  parameter.cache_size = kCacheMegabytes;
  parameter.eps = kTolerance;
  parameter.C = c;
  parameter.shrinking = 1;
  return parameter;
}

struct ModelDeleter {
  void operator()(svm_model* model) const { svm_free_and_destroy_model(&model); }
};

}  // namespace

LibsvmSolver::LibsvmSolver(const PackedGram& gram, const std::vector<int>& vectors) {
  silenceLibsvm();
  for (const int vector : vectors) rows_.push_back(gram.nodes(vector));
}

double LibsvmSolver::solve(const std::vector<int>& signs, double c,
                           Eigen::Ref<Eigen::VectorXd> weights) const {
  assert(signs.size() == rows_.size() && static_cast<std::size_t>(weights.size()) == rows_.size());
  std::vector<svm_node*> rows;
  std::vector<double> targets;
  std::vector<Eigen::Index> vectors;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    if (signs[i] == 0) continue;
    rows.push_back(rows_[i]);
    targets.push_back(signs[i]);
    vectors.push_back(static_cast<Eigen::Index>(i));
  }
  svm_problem problem = {static_cast<int>(rows.size()), targets.data(), rows.data()};
  const svm_parameter parameter = parameters(c);
  const std::unique_ptr<svm_model, ModelDeleter> model(svm_train(&problem, &parameter));
  assert(model->nr_class == 2);

  // libsvm's decision value is positive for the first label that it encounters.
  const double sign = model->label[0];
  weights.setZero();
  for (int k = 0; k < model->l; ++k) {
    weights[vectors[model->sv_indices[k] - 1]] = sign * model->sv_coef[0][k];
  }
  return -sign * model->rho[0];
}

}  // namespace place_recognition
