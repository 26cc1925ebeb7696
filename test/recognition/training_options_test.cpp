#include "place_recognition/training_options.h"

#include <gtest/gtest.h>

#include "base/options.h"
#include "error_of.h"
#include "features/small_network.h"

namespace place_recognition {
namespace {

TEST(TrainingOptions, ReadBackAsWritten) {
  const std::string text = writeOptions(TrainingOptions());
  TrainingOptions options;
  readOptions(parseYaml(text, "defaults"), "", options);
  EXPECT_EQ(writeOptions(options), text);
}

TEST(TrainingOptions, NamesTheKeyTheValueAndTheRange) {
  const auto complaint = [](void (*change)(TrainingOptions&)) {
    TrainingOptions options;
    change(options);
    return errorOf([&] { options.check(); });
  };
  EXPECT_EQ(complaint([](TrainingOptions& o) { o.cues[1].kernel.gamma = -0.5; }),
            "Option 'cues.tints.kernel.gamma' is -0.5; give a number from 0.");
  EXPECT_EQ(complaint([](TrainingOptions& o) { o.cues[0].weight = 0; }),
            "Option 'cues.colours.weight' is 0; give 0.01 to 100.");
  EXPECT_EQ(complaint([](TrainingOptions& o) { o.cues[0].normalize = "grey"; }),
            "Option 'cues.colours.normalize' is 'grey'; give none, brightness, grey-world or run.");
  EXPECT_EQ(complaint([](TrainingOptions& o) {
              o.cues[0].name = "a b";
            }).find("Option 'cues.name' is 'a b'; give "),
            0u);
  EXPECT_EQ(
      complaint([](TrainingOptions& o) { std::get<CrfhOptions>(o.cues[2].feature).bins = {0}; }),
      "Option 'cues.edges.feature.bins' is 0; give 1 to 65536.");
  EXPECT_EQ(
      complaint([](TrainingOptions& o) { std::get<HogOptions>(o.cues[4].feature).rows = 17; }),
      "Option 'cues.directions.feature.rows' is 17; give 1 to 16.");
  EXPECT_EQ(complaint([](TrainingOptions& o) {
              LbpOptions lbp;
              lbp.circles = {{}, {3, 1}};
              o.cues[0].feature = lbp;
            }),
            "Option 'cues.colours.feature.circles.1.points' is 3; give 4 to 32.");
  EXPECT_EQ(complaint([](TrainingOptions& o) { o.image.panorama.inner = 0.5; }),
            "Option 'image.panorama.inner' is 0.5; give 0 to less than 0.47 "
            "(image.panorama.outer).");
  EXPECT_EQ(complaint([](TrainingOptions& o) { o.cues.clear(); }),
            "Option 'cues' is empty; give at least one cue.");
}

TEST(TrainingOptions, NamesTheFieldOutOfRange) {
  const auto complaint = [](const TrainingOptions& options) {
    return errorOf([&] { options.check(); });
  };
  TrainingOptions options;
  EXPECT_EQ(complaint(options), "");
  options.validation.folds = 1;
  EXPECT_NE(complaint(options).find("validation.folds"), std::string::npos);
  options = TrainingOptions();
  options.image.max_width = -1;
  EXPECT_NE(complaint(options).find("image.max_width"), std::string::npos);
  options = TrainingOptions();
  options.unknown.false_alarm_rate = 1.5;
  EXPECT_NE(complaint(options).find("unknown.false_alarm_rate"), std::string::npos);
  options = TrainingOptions();
  options.cues[0].kernel.type = "cubic";
  EXPECT_EQ(complaint(options),
            "Option 'cues.colours.kernel.type' is 'cubic'; give one of: linear, polynomial, "
            "gaussian, sigmoid, chi-squared, intersection, local-match.");
  for (const char* kernel : {"chi-squared", "intersection", "local-match"}) {
    options.cues[0].feature = SmallNetwork::options();
    options.cues[0].kernel.type = kernel;
    EXPECT_NE(complaint(options).find("use one of: linear, polynomial, gaussian, sigmoid"),
              std::string::npos);
  }
  options = TrainingOptions();
  options.cues.push_back(options.cues[0]);
  EXPECT_NE(complaint(options).find("'colours'"), std::string::npos);
  options.cues.clear();
  EXPECT_NE(complaint(options).find("'cues'"), std::string::npos);
}

}  // namespace
}  // namespace place_recognition
