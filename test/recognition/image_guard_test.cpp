#include "recognition/frames/image_guard.h"

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "recognition/drawn_recording.h"

namespace place_recognition {
namespace {

using Sentences = std::vector<std::string>;

/// The profile of drawn rooms.
ImageProfile drawn() {
  ImageProfile profile;
  profile.width = 96;
  profile.height = 72;
  profile.colour = true;
  profile.darkest = 80;
  profile.brightest = 160;
  return profile;
}

cv::Mat grey(const cv::Mat& image) {
  cv::Mat grey;
  cv::cvtColor(image, grey, cv::COLOR_BGR2GRAY);
  return grey;
}

cv::Mat resized(const cv::Mat& image, cv::Size size) {
  cv::Mat changed;
  cv::resize(image, changed, size);
  return changed;
}

/// Returns a uniform image with sensor noise.
cv::Mat uniform(double brightness, unsigned frame) {
  cv::Mat image(72, 96, CV_8UC3);
  cv::RNG random(frame + 1);
  random.fill(image, cv::RNG::NORMAL, brightness, 2);
  return image;
}

TEST(ImageGuard, SaysNothingOfImagesLikeThoseTrainedOn) {
  ImageGuard guard(drawn(), {});
  for (unsigned i = 0; i < 50; ++i) {
    EXPECT_EQ(guard.judge(drawRoom(static_cast<int>(i % 3), i), i), Sentences());
    EXPECT_EQ(guard.problem(), "");
  }
}

/// Shows images for which `sentence` must be reported once, and then a good image.
void expectSaidOnce(const std::vector<cv::Mat>& images, const std::string& word) {
  ImageGuard guard(drawn(), {});
  EXPECT_EQ(guard.judge(drawRoom(0, 1000), 0), Sentences());
  const Sentences said = guard.judge(images[0], 1);
  ASSERT_EQ(said.size(), 1u) << word;
  EXPECT_NE(said[0].find(word), std::string::npos) << said[0];
  EXPECT_EQ(said[0].back(), '.');
  for (std::size_t i = 1; i < images.size(); ++i) {
    EXPECT_EQ(guard.judge(images[i], 1 + static_cast<double>(i)), Sentences());
    EXPECT_NE(guard.problem().find(word), std::string::npos) << guard.problem();
  }
  guard.judge(drawRoom(0, 1001), 100);
  EXPECT_EQ(guard.problem(), "");
}

TEST(ImageGuard, SaysOnceWhatIsWrong) {
  const cv::Mat one = drawRoom(1, 1), two = drawRoom(1, 2);
  expectSaidOnce({resized(one, {128, 72}), resized(two, {128, 72})}, "aspect ratio");
  expectSaidOnce({resized(one, {48, 36}), resized(two, {48, 36})},
                 "48 x 36 are enlarged to 96 x 72");
  expectSaidOnce({grey(one), grey(two)}, "grey");
  cv::Mat grey_in_colour;
  cv::cvtColor(grey(one), grey_in_colour, cv::COLOR_GRAY2BGR);
  expectSaidOnce({grey_in_colour, grey(two)}, "grey");
}

TEST(ImageGuard, WarnsOfColourWhereGreyWasLearned) {
  ImageProfile profile = drawn();
  profile.colour = false;
  ImageGuard guard(profile, {});
  EXPECT_EQ(guard.judge(grey(drawRoom(0, 1)), 0), Sentences());
  const Sentences news = guard.judge(drawRoom(0, 2), 1);
  ASSERT_EQ(news.size(), 1u);
  EXPECT_NE(news[0].find("in colour"), std::string::npos) << news[0];
  EXPECT_EQ(guard.judge(drawRoom(0, 3), 2), Sentences());
}

TEST(ImageGuard, KnowsACameraThatShowsOneColour) {
  ImageGuard guard(drawn(), {});
  ASSERT_EQ(guard.judge(uniform(0, 0), 0).size(), 1u);
  EXPECT_EQ(guard.problem(), "Images are black");
  ASSERT_EQ(guard.judge(uniform(254, 1), 1).size(), 1u);
  EXPECT_EQ(guard.problem(), "Images are white");
  ASSERT_EQ(guard.judge(uniform(100, 2), 2).size(), 1u);
  EXPECT_EQ(guard.problem(), "Images show nothing but one colour");
  EXPECT_TRUE(guard.blind());
  const cv::Mat green(72, 96, CV_8UC3, cv::Scalar(0, 135, 0));  // all zeros in YUV
  guard.judge(green, 3);
  EXPECT_EQ(guard.problem(), "Images show nothing but one colour");
  guard.judge(drawRoom(0, 1), 4);
  EXPECT_EQ(guard.problem(), "");
  EXPECT_FALSE(guard.blind());
}

TEST(ImageGuard, LargerImagesAreMentionedButNoProblem) {
  ImageGuard guard(drawn(), {});
  const Sentences said = guard.judge(resized(drawRoom(1, 1), {192, 144}), 0);
  ASSERT_EQ(said.size(), 1u);
  EXPECT_NE(said[0].find("192 x 144 are scaled to 96 x 72"), std::string::npos) << said[0];
  EXPECT_EQ(guard.problem(), "");
  EXPECT_EQ(guard.judge(resized(drawRoom(1, 2), {192, 144}), 1), Sentences());
}

TEST(ImageGuard, KnowsACameraThatIsFrozen) {
  const cv::Mat image = drawRoom(0, 1);
  ImageGuard guard(drawn(), {});
  const auto problemAfter = [&](int frames, double period) {
    guard = ImageGuard(drawn(), {});
    for (int i = 0; i < frames; ++i) guard.judge(image.clone(), i * period);
    return guard.problem();
  };
  EXPECT_NE(problemAfter(10, 0.5).find("same image"), std::string::npos);
  EXPECT_NE(problemAfter(100, 1 / 30.0).find("same image"), std::string::npos);
  EXPECT_EQ(problemAfter(9, 1), "");          // a slow camera
  EXPECT_EQ(problemAfter(60, 1 / 30.0), "");  // a short stop
  problemAfter(10, 0.5);
  guard.judge(drawRoom(0, 2), 6);
  EXPECT_EQ(guard.problem(), "");
}

TEST(ImageGuard, AcceptsAModelThatDoesNotKnowItsImages) {
  ImageGuard guard(ImageProfile(), {});
  EXPECT_EQ(guard.judge(grey(resized(drawRoom(0, 1), {300, 90})), 0), Sentences());
  EXPECT_EQ(guard.judge(uniform(3, 0), 1).size(), 1u);  // except for a camera that shows nothing
}

TEST(ImageProfile, TrainingKeepsSizeColourAndBrightness) {
  const std::vector<Frame> frames = drawFrames(3, 12);
  const ImageProfile profile = train({opener(frames)}, quickOptions()).model.images;
  EXPECT_EQ(cv::Size(profile.width, profile.height), cv::Size(96, 72));
  EXPECT_TRUE(profile.colour);
  double darkest = 255, brightest = 0;
  for (const Frame& frame : frames) {
    const cv::Scalar mean = cv::mean(frame.image);
    darkest = std::min(darkest, (mean[0] + mean[1] + mean[2]) / 3);
    brightest = std::max(brightest, (mean[0] + mean[1] + mean[2]) / 3);
  }
  EXPECT_NEAR(profile.darkest, darkest, 3);  // of all rows, not of some
  EXPECT_NEAR(profile.brightest, brightest, 3);
}

}  // namespace
}  // namespace place_recognition
