#include "recognition/training/reduction_choice.h"

#include <gtest/gtest.h>

namespace place_recognition {
namespace {

/// Answers to 40 samples of two places; the first `wrong` of each place are wrong.
struct Answered {
  std::vector<SampleOrigin> samples;
  CombinedValues held_out{{Eigen::MatrixXd(40, 2), std::vector<bool>(40, true)}};

  explicit Answered(int wrong) {
    for (int i = 0; i < 40; ++i) {
      samples.push_back({i % 2, 0, static_cast<double>(i)});
      const double decision_value = i / 2 < wrong ? -1 : 1;
      held_out.decision_values.row(i) << (i % 2 == 0 ? decision_value : -decision_value),
          (i % 2 == 0 ? -decision_value : decision_value);
    }
  }
};

ReductionOptions reduction(const std::string& method, double fraction) {
  ReductionOptions options;
  options.method = method;
  options.share = fraction;
  return options;
}

/// Returns the choice among reductions with these numbers of wrong answers per place.
std::size_t choice(const std::vector<ReductionOptions>& reductions, const std::vector<int>& wrong) {
  std::vector<CombinedValues> held_out;
  for (const int count : wrong) held_out.push_back(Answered(count).held_out);
  return chooseReduction(reductions, held_out, Answered(0).samples, 2);
}

TEST(ReductionChoice, KeepsToWhatWasAskedFor) {
  const std::vector<ReductionOptions> one = reductionsInQuestion(reduction("qr", 0.5), 40);
  ASSERT_EQ(one.size(), 1u);
  EXPECT_EQ(one[0].method, "qr");
  EXPECT_EQ(one[0].share, 0.5);
}

TEST(ReductionChoice, AutoTriesEveryMethodFromManyVectorsToFew) {
  const std::vector<ReductionOptions> all = reductionsInQuestion(ReductionOptions(), 40);
  EXPECT_EQ(all[0].method, "none");
  for (std::size_t i = 1; i < all.size(); ++i) {
    all[i].check();
    EXPECT_TRUE(all[i].method != all[i - 1].method || all[i].share < all[i - 1].share) << i;
  }
}

TEST(ReductionChoice, AutoKeepsAllOfVeryManySamples) {
  const std::vector<ReductionOptions> all = reductionsInQuestion(ReductionOptions(), 20000);
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].method, "none");
}

TEST(ReductionChoice, TakesTheFewestVectorsAtNoLossThatCanBeTold) {
  const std::vector<ReductionOptions> reductions{reduction("none", 0), reduction("qr", 0.5),
                                                 reduction("qr", 0.3), reduction("qr", 0.1)};
  EXPECT_EQ(choice(reductions, {2, 2, 2, 2}), 3u);
  EXPECT_EQ(choice(reductions, {2, 1, 2, 8}), 2u);
  EXPECT_EQ(choice(reductions, {2, 9, 2, 2}), 0u);  // few vectors that are right by chance
  // One more of 20 wrong in each place: a loss of 0.05, with a standard error of 0.034.
  EXPECT_EQ(choice(reductions, {2, 2, 2, 3}), 2u);
}

TEST(ReductionChoice, KeepsAllVectorsIfAPlaceHasTooFewSamplesToJudge) {
  const std::vector<ReductionOptions> reductions{reduction("none", 0), reduction("qr", 0.5)};
  for (const int judged : {0, 4, 5}) {
    Answered answered(0);
    for (int i = 1; i < 40; i += 2) {
      answered.held_out.valid[static_cast<std::size_t>(i)] = i / 2 < judged;
    }
    EXPECT_EQ(
        chooseReduction(reductions, {answered.held_out, answered.held_out}, answered.samples, 2),
        judged < 5 ? 0u : 1u)
        << judged;
  }
}

TEST(ReductionChoice, OfEqualSharesTakesTheBetterRate) {
  const std::vector<ReductionOptions> reductions{reduction("none", 0), reduction("qr", 0.3),
                                                 reduction("shared-qr", 0.3)};
  EXPECT_EQ(choice(reductions, {4, 4, 3}), 2u);
  EXPECT_EQ(choice(reductions, {4, 3, 3}), 1u);
  EXPECT_EQ(choice(reductions, {4, 9, 9}), 0u);
}

TEST(ReductionChoice, LosesNoRateForProbabilitiesThatFitBetter) {
  // The reduced machines are wrong more often than the full ones, but with less confidence.
  Answered full(4);
  Answered reduced(5);
  for (int i = 0; i < 40; ++i) {
    const int more = i / 2 < 5 ? 1 : 8;
    reduced.held_out.decision_values.row(i) *= more;
    full.held_out.decision_values.row(i) *= i / 2 < 4 ? 8 : 1;
  }
  EXPECT_EQ(chooseReduction({reduction("none", 0), reduction("qr", 0.3)},
                            {full.held_out, reduced.held_out}, full.samples, 2),
            0u);
}

TEST(ReductionChoice, KeepsAllWhereNothingIsHeldOut) {
  const CombinedValues none{{Eigen::MatrixXd::Zero(2, 2), {false, false}}};
  const std::vector<SampleOrigin> samples{{0, 0, 0}, {1, 0, 1}};
  EXPECT_EQ(chooseReduction({reduction("none", 0), reduction("qr", 0.1)}, {none, none}, samples, 2),
            0u);
}

}  // namespace
}  // namespace place_recognition
