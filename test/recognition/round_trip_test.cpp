// Every kind of model gives bit-identical answers after it was saved and loaded.
#include <gtest/gtest.h>

#include "features/small_network.h"
#include "place_recognition/model_file.h"
#include "place_recognition/recognizer.h"
#include "recognition/drawn_recording.h"

namespace place_recognition {
namespace {

struct Kind {
  std::string name;
  TrainingOptions options;
};

FeatureOptions localFeature() {
  LocalFeatureOptions local;
  local.cornerness_threshold = 1;
  local.laplacian_threshold = 0;
  local.min_points = 1;
  return local;
}

TrainingOptions withKernel(const std::string& type, const FeatureOptions& feature) {
  TrainingOptions options = quickOptions();
  options.cues[0].feature = feature;
  options.cues[0].kernel.type = type;
  options.cues[0].kernel.gamma = 1;
  options.validation.folds = 2;
  return options;
}

/// Each kernel with each form of feature that it accepts, several cues, and each reduction.
std::vector<Kind> kindsOfEitherMulticlass() {
  const FeatureOptions sparse = quickOptions().cues[0].feature;
  std::vector<Kind> kinds;
  for (const char* kernel :
       {"linear", "polynomial", "gaussian", "sigmoid", "chi-squared", "intersection"}) {
    kinds.push_back({std::string("sparse ") + kernel, withKernel(kernel, sparse)});
    kinds.push_back({std::string("dense ") + kernel, withKernel(kernel, LbpOptions())});
  }
  kinds.push_back({"local-match", withKernel("local-match", localFeature())});
  kinds.push_back({"hog", withKernel("chi-squared", HogOptions())});
  kinds.push_back({"mr8", withKernel("intersection", Mr8Options())});
  for (const char* kernel : {"linear", "gaussian"}) {
    kinds.push_back(
        {std::string("embedding ") + kernel, withKernel(kernel, SmallNetwork::options())});
  }
  kinds.push_back({"several cues", twoCueOptions()});
  kinds.back().options.cues.push_back(withKernel("local-match", localFeature()).cues[0]);
  kinds.back().options.cues.back().name = "local";
  kinds.back().options.cues.push_back(withKernel("gaussian", SmallNetwork::options()).cues[0]);
  kinds.back().options.cues.back().name = "embedding";
  kinds.back().options.cues.push_back(kinds.back().options.cues.back());
  kinds.back().options.cues.back().name = "layout";
  std::get<EmbeddingOptions>(kinds.back().options.cues.back().feature).columns = 3;
  kinds.back().options.cues.push_back(withKernel("gaussian", SmallNetwork::earlyOptions()).cues[0]);
  kinds.back().options.cues.back().name = "early";
  for (const char* method : {"none", "qr", "shared-qr", "shared-greedy", "auto"}) {
    kinds.push_back({method, twoCueOptions()});
    kinds.back().options.reduction.method = method;
    if (std::string(method) != "auto") kinds.back().options.reduction.tau = 0.1;
  }
  return kinds;
}

std::vector<Kind> kinds() {
  std::vector<Kind> kinds;
  for (const char* multiclass : {"one-against-all", "one-against-one"}) {
    for (Kind& kind : kindsOfEitherMulticlass()) {
      kind.name += std::string(" ") + multiclass;
      kind.options.svm.multiclass = multiclass;
      kinds.push_back(std::move(kind));
    }
  }
  return kinds;
}

class RoundTrip : public testing::TestWithParam<Kind> {};

TEST_P(RoundTrip, GivesBitIdenticalDecisionValues) {
  Training training = train({opener(drawFrames(3, 6))}, GetParam().options);
  const std::string bytes = serializeModel(training.model);
  const auto trained = std::make_shared<const Model>(std::move(training.model));
  const auto loaded = std::make_shared<const Model>(parseModel(bytes, "test"));
  EXPECT_EQ(serializeModel(*loaded), bytes);
  EXPECT_GT(loaded->supportVectorCount(), 0u);

  Recognizer before(trained), after(loaded);
  for (const Frame& frame : drawFrames(3, 2, 500)) {
    const Recognition& wanted = before.recognize(frame.image);
    const Recognition& answer = after.recognize(frame.image);
    ASSERT_NE(wanted.place, -1) << wanted.reason;
    EXPECT_TRUE(answer.decision_values == wanted.decision_values) << answer.decision_values << "\n"
                                                                  << wanted.decision_values;
    EXPECT_TRUE(answer.probabilities == wanted.probabilities);
    EXPECT_EQ(answer.known, wanted.known);
  }
}

TEST(Networks, AreStoredOnceForAllTheirCues) {
  TrainingOptions options = withKernel("gaussian", SmallNetwork::options());
  options.cues.push_back(options.cues[0]);
  options.cues[1].name = "layout";
  std::get<EmbeddingOptions>(options.cues[1].feature).columns = 3;
  std::get<EmbeddingOptions>(options.cues[1].feature).loaded = SmallNetwork::network();
  options.cues.push_back(options.cues[0]);
  options.cues[2].name = "early";
  options.cues[2].feature = SmallNetwork::earlyOptions();
  const Model model = train({opener(drawFrames(3, 6))}, options).model;
  const std::string bytes = serializeModel(model);
  const std::string& onnx = std::get<EmbeddingOptions>(model.options.cues[0].feature).loaded->onnx;
  const std::size_t at = bytes.find(onnx);
  ASSERT_NE(at, std::string::npos);
  EXPECT_EQ(bytes.find(onnx, at + 1), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(Every, RoundTrip, testing::ValuesIn(kinds()),
                         [](const testing::TestParamInfo<Kind>& info) {
                           std::string name = info.param.name;
                           for (char& c : name) c = c == '-' || c == ' ' ? '_' : c;
                           return name;
                         });

}  // namespace
}  // namespace place_recognition
