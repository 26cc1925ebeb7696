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
  EXPECT_NE(complaint(options).find("Cue 'colours'"), std::string::npos);
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
