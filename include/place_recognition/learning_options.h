#pragma once

#include <string>

namespace place_recognition {

// For visit() and check(), see feature_options.h.

/// A kernel function, thesis section 5.2.2.
struct KernelOptions {
  std::string type = "chi-squared";
  double gamma = 0;
  double p = 1;
  int d = 3;
  double kappa = 1;
  double theta = 0;

  template <typename Self, typename Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor("type", self.type,
            "linear, polynomial, gaussian, sigmoid, chi-squared, intersection or local-match");
    visitor("gamma", self.gamma,
            "exponent of gaussian, chi-squared and local-match; 0: found by cross-validation");
    visitor("p", self.p, "offset of the polynomial kernel (x'y + p)^d");
    visitor("d", self.d, "degree of the polynomial kernel, 1..10");
    visitor("kappa", self.kappa, "slope of the sigmoid kernel tanh(kappa x'y + theta)");
    visitor("theta", self.theta, "offset of the sigmoid kernel");
  }
  void check(const std::string& key = "kernel") const;

  /// Whether the type has a gamma, to be found by cross-validation if it is 0. Throws Error for an
  /// unknown type.
  bool hasGamma() const;
};

/// Support vector classification, thesis chapter 5.
struct SvmOptions {
  double c = 100;
  std::string multiclass = "one-against-all";

  template <typename Self, typename Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor("c", self.c, "SVM penalty parameter C, > 0 (eq. 5.26)");
    visitor("multiclass", self.multiclass, "one-against-all or one-against-one (section 5.3)");
  }
  void check() const;
};

/// Support vector reduction, thesis chapter 6.
struct ReductionOptions {
  std::string method = "auto";
  double tau = 0.01;
  bool normalize = true;
  double share = 0;
  int support_vectors = 0;

  template <typename Self, typename Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor("method", self.method,
            "none; qr: each machine separately (section 6.3); shared-qr: one basis for all "
            "machines; shared-greedy: the basis that reproduces all decision values best; auto: "
            "the method and the fraction (of 15, 25, 35, 50, 70 or all 100 %) with the fewest "
            "vectors that lose neither log loss nor rate on held-out blocks of the training runs; "
            "all vectors if more than 4000 images are learned");
    visitor("tau", self.tau, "rank threshold, relative to the largest pivot, 0..1");
    visitor("normalize", self.normalize, "scale the columns of the matrix to norm one first",
            "normalise");
    visitor("share", self.share,
            "fraction of each cue's support vectors to keep, 0..1, instead of tau; 0: use tau");
    visitor("support_vectors", self.support_vectors,
            "number of vectors of each cue to keep, instead of tau; 0: use tau");
  }
  void check() const;
};

}  // namespace place_recognition
