#include "place_recognition/learning_options.h"

#include <gtest/gtest.h>

#include <limits>

#include "base/options.h"
#include "error_of.h"

namespace place_recognition {
namespace {

/// Returns the error of check() for options modified by `change`.
template <typename Options, typename Change>
std::string complaint(Change change) {
  Options options;
  change(options);
  return errorOf([&] { options.check(); });
}

TEST(LearningOptions, DefaultsAreGood) {
  KernelOptions().check();
  SvmOptions().check();
  ReductionOptions().check();
}

TEST(LearningOptions, NamesTheKeyTheValueAndTheRange) {
  EXPECT_EQ(complaint<SvmOptions>([](auto& o) { o.c = -1; }),
            "Option 'svm.c' is -1; give a number above 0.");
  EXPECT_EQ(complaint<KernelOptions>([](auto& o) { o.d = 11; }),
            "Option 'kernel.d' is 11; give 1 to 10.");
  EXPECT_EQ(
      complaint<ReductionOptions>([](auto& o) { o.method = "half"; }),
      "Option 'reduction.method' is 'half'; give none, qr, shared-qr, shared-greedy or auto.");
  EXPECT_EQ(complaint<ReductionOptions>([](auto& o) { o.tau = 1.5; }),
            "Option 'reduction.tau' is 1.5; give 0 to 1.");
}

TEST(LearningOptions, NamesOptionsThatExcludeEachOther) {
  EXPECT_EQ(
      complaint<ReductionOptions>(
          [](auto& o) { o.method = "qr", o.share = 0.5, o.support_vectors = 10; }),
      "Options 'reduction.share' and 'reduction.support_vectors' exclude each other; give one "
      "of them.");
  EXPECT_EQ(complaint<ReductionOptions>([](auto& o) { o.share = 0.5; }),
            "Options 'reduction.method=auto' and 'reduction.share' exclude each other; give one of "
            "them.");
}

TEST(LearningOptions, ReadConfigurationsFromBeforeNormaliseWasRenamed) {
  ReductionOptions options;
  readOptions(parseYaml("{method: qr, normalise: false}", "test"), "reduction", options);
  EXPECT_FALSE(options.normalize);
}

TEST(LearningOptions, NamesTheFieldOutOfRange) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto names = [](const std::string& text, const char* field) {
    return text.find(field) != std::string::npos;
  };
  EXPECT_TRUE(names(complaint<KernelOptions>([](auto& o) { o.type = "cubic"; }), "chi-squared"));
  EXPECT_TRUE(names(complaint<KernelOptions>([](auto& o) { o.gamma = -1; }), "gamma"));
  EXPECT_TRUE(names(complaint<KernelOptions>([=](auto& o) { o.p = nan; }), "kernel.p"));
  EXPECT_TRUE(names(complaint<KernelOptions>([](auto& o) { o.d = 0; }), "kernel.d"));
  EXPECT_TRUE(names(complaint<ReductionOptions>([](auto& o) { o.tau = 0.5; }), "reduction.tau"));
  EXPECT_TRUE(names(complaint<KernelOptions>([=](auto& o) { o.kappa = nan; }), "kappa"));
  EXPECT_TRUE(names(complaint<KernelOptions>([=](auto& o) { o.theta = nan; }), "theta"));
  EXPECT_TRUE(names(complaint<SvmOptions>([](auto& o) { o.c = 0; }), "svm.c"));
  EXPECT_TRUE(names(complaint<SvmOptions>([](auto& o) { o.multiclass = "x"; }), "multiclass"));
  EXPECT_TRUE(names(complaint<ReductionOptions>([](auto& o) { o.method = "x"; }), "method"));
  EXPECT_TRUE(names(complaint<ReductionOptions>([=](auto& o) { o.tau = nan; }), "tau"));
  EXPECT_TRUE(names(complaint<ReductionOptions>([](auto& o) { o.support_vectors = -1; }),
                    "support_vectors"));
}

}  // namespace
}  // namespace place_recognition
