#include "ros/recognizer/doubtful_frames.h"

#include <sys/resource.h>

#include <algorithm>
#include <boost/make_shared.hpp>
#include <csignal>
#include <filesystem>
#include <opencv2/imgproc.hpp>

#include "base/place_name.h"
#include "ros/messages/conversions.h"
#include "ros/written_bags.h"

namespace place_recognition {
namespace {

namespace fs = std::filesystem;

ImageMessage message(int number, int width = 16) {
  std_msgs::Header header;
  header.stamp = ros::Time::now();
  cv::Mat small;
  cv::resize(image(number), small, {width, 12});
  return ImageMessage(boost::make_shared<const sensor_msgs::Image>(toImageMessage(small, header)));
}

Recognition answer(int place, bool known) {
  Recognition recognition;
  recognition.place = place;
  recognition.known = known;
  return recognition;
}

class DoubtfulFramesTest : public testing::Test {
 protected:
  void SetUp() override {
    ros::Time::init();
    at(1000);
  }

  static void at(double seconds) { ros::Time::setNow(ros::Time(seconds)); }

  KeepOptions options() const {
    KeepOptions options;
    options.folder = scratch_ / "kept";
    options.per_hour = 3600;
    options.label_topic = "/place_label";
    return options;
  }

  std::vector<fs::path> kept(const std::string& ending) const {
    std::vector<fs::path> paths;
    for (const auto& entry : fs::directory_iterator(scratch_ / "kept")) {
      if (entry.path().extension() == ending && entry.file_size() != 2000000)
        paths.push_back(entry.path());
    }
    std::sort(paths.begin(), paths.end());
    return paths;
  }

  std::vector<Frame> keptFrames() const {
    std::vector<Frame> frames;
    for (const fs::path& bag : kept(".bag")) {
      for (const Frame& frame : readAll(bag)) frames.push_back(frame);
    }
    return frames;
  }

  ScratchFolder scratch_;
};

TEST_F(DoubtfulFramesTest, KeepsUnknownAndChangedAnswersWithThePlaceAsLabel) {
  {
    DoubtfulFrames frames(options());
    frames.take("/image", message(0), answer(0, true), "kitchen");
    at(1002);
    frames.take("/image", message(1), answer(0, true), "kitchen");
    at(1004);
    frames.take("/image", message(2), answer(1, true), "kitchen");  // another answer
    at(1006);
    frames.take("/image", message(3), answer(1, false), "corridor");  // unknown
    at(1008);
    frames.take("/other", message(4), answer(0, true), "corridor");  // first of its camera
    at(1010);
    frames.take("/image", message(5), answer(1, false), kUnknownPlace);
    at(1012);
    frames.take("/image", message(6), answer(-1, false), "corridor");  // no answer
    EXPECT_EQ(kept(".active").size(), 1u);
  }
  EXPECT_TRUE(kept(".active").empty());
  const std::vector<Frame> frames = keptFrames();
  EXPECT_EQ(places(frames), (std::vector<std::string>{"kitchen", "corridor", ""}));
  for (const int number : {2, 3, 5}) {
    const auto frame = frames[number == 2 ? 0 : number == 3 ? 1 : 2];
    EXPECT_EQ(frame.image.at<cv::Vec3b>(0, 0)[0], 10 + 10 * number);
  }
}

TEST_F(DoubtfulFramesTest, ThinsThemOut) {
  KeepOptions few = options();
  few.per_hour = 360;
  {
    DoubtfulFrames frames(few);
    for (int i = 0; i < 100; ++i) {
      at(1000 + i);
      frames.take("/image", message(1), answer(0, false), "kitchen");
    }
  }
  EXPECT_EQ(keptFrames().size(), 10u);
}

TEST_F(DoubtfulFramesTest, RemovesTheOldestButNotWhatAPersonHasLabelled) {
  KeepOptions little = options();
  little.megabytes = 1;
  fs::create_directories(little.folder);
  const std::string labelled = "kept/doubtful_2001-01-01_00-00-00";
  scratch_.write(labelled + ".bag", std::string(2000000, 'x'));
  scratch_.write(labelled + ".labels.yaml", "");
  const std::string labelled_too = "kept/doubtful_2001-01-01_00-00-01";
  scratch_.write(labelled_too + ".bag", std::string(2000000, 'x'));
  scratch_.write(labelled_too + ".labels.yml", "");
  scratch_.write("kept/doubtful_2001-01-02_00-00-00.bag.active", std::string(900000, 'x'));
  scratch_.write("kept/mine.bag", std::string(2000000, 'x'));
  {
    DoubtfulFrames frames(little);
    for (int i = 0; i < 40; ++i) {
      at(1000 + 2 * i);
      frames.take("/image", message(1, 1600), answer(0, false), "kitchen");  // 58 kB
    }
  }
  std::uintmax_t bytes = 0;
  const std::vector<fs::path> bags = kept(".bag");
  EXPECT_TRUE(fs::exists(scratch_ / (labelled + ".bag")));
  EXPECT_TRUE(fs::exists(scratch_ / (labelled_too + ".bag")));
  EXPECT_TRUE(fs::exists(scratch_ / "kept/mine.bag"));
  EXPECT_TRUE(kept(".active").empty());
  for (const fs::path& bag : bags) bytes += fs::file_size(bag);
  EXPECT_LE(bytes, 1000000u);
  EXPECT_GT(bytes, 600000u);
  const std::vector<Frame> frames = readAll(bags.back());
  EXPECT_EQ(frames.back().stamp, 1078) << "the newest are left";
}

TEST_F(DoubtfulFramesTest, GoesOnWhereTheClockJumpsBack) {
  {
    DoubtfulFrames frames(options());
    frames.take("/image", message(1), answer(0, false), "kitchen");
    at(10);
    frames.take("/image", message(2), answer(0, false), "corridor");
  }
  EXPECT_EQ(places(keptFrames()), (std::vector<std::string>{"kitchen", "corridor"}));
}

TEST_F(DoubtfulFramesTest, GoesOnWhereTheClockIsSet) {
  at(10);
  DoubtfulFrames frames(options());
  frames.take("/image", message(1), answer(0, false), "kitchen");
  at(3e9);  // more than a ros::Duration later
  EXPECT_NO_THROW(frames.take("/image", message(2), answer(0, false), "corridor"));
  EXPECT_EQ(kept(".bag").size(), 1u);
}

TEST_F(DoubtfulFramesTest, AFolderThatCannotBeMadeIsAnError) {
  KeepOptions wrong = options();
  wrong.folder = scratch_.write("file", "") + "/kept";
  EXPECT_THROW(DoubtfulFrames{wrong}, Error);
}

TEST_F(DoubtfulFramesTest, AFolderIsOfOneRecognizer) {
  {
    DoubtfulFrames first(options());
    EXPECT_THROW(DoubtfulFrames{options()}, Error);
  }
  EXPECT_NO_THROW(DoubtfulFrames{options()});
}

TEST_F(DoubtfulFramesTest, ADiskThatRefusesLeavesNothingHalfWritten) {
  DoubtfulFrames frames(options());
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const rlimit small{20000, before.rlim_max};
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  setrlimit(RLIMIT_FSIZE, &small);
  for (int i = 0; i < 100; ++i) {
    at(1000 + 2 * i);
    frames.take("/image", message(1, 1600), answer(0, false), "kitchen");
  }
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  EXPECT_TRUE(frames.isKeeping());
  EXPECT_TRUE(fs::is_empty(scratch_ / "kept"));
}

TEST_F(DoubtfulFramesTest, NothingIsKeptUnlessAskedFor) {
  DoubtfulFrames frames({});
  EXPECT_FALSE(frames.isKeeping());
  frames.take("/image", message(1), answer(0, false), "kitchen");
}

}  // namespace
}  // namespace place_recognition
