// A disk that is full while a bag is written, simulated by a limit on the size of files.

#include <std_msgs/String.h>
#include <sys/resource.h>

#include <csignal>
#include <filesystem>

#include "error_of.h"
#include "ros/bags/staged_bag.h"
#include "ros/written_bags.h"

namespace place_recognition {
namespace {

/// Limits the size of files to `bytes` during its lifetime.
class SmallDisk {
 public:
  explicit SmallDisk(rlim_t bytes) : before_handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit small{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &small);
  }
  ~SmallDisk() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, before_handler_);
  }
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;

 private:
  rlimit before_;
  void (*before_handler_)(int);
};

/// Returns the error of writing a thousand messages of 2 KB.
std::string errorOfWriting(StagedBag& bag) {
  std_msgs::String message;
  message.data = std::string(2000, 'x');
  return errorOf([&] {
    for (int i = 0; i < 1000; ++i) bag.write("/text", ros::Time(1 + i), message);
    bag.complete();
  });
}

class FullDisk : public Bags, public testing::WithParamInterface<rlim_t> {};

TEST_P(FullDisk, IsAnErrorThatLeavesNothingUnderTheNameOfTheBag) {
  const SmallDisk disk(GetParam());
  try {
    StagedBag bag(path_, ".active");
    EXPECT_NE(errorOfWriting(bag).find("Cannot write " + path_), std::string::npos);
    EXPECT_NE(errorOfWriting(bag), "");  // the error persists
  } catch (const Error& e) {
    EXPECT_NE(std::string(e.what()).find("Cannot write " + path_), std::string::npos);
  }
  EXPECT_FALSE(std::filesystem::exists(path_));
}

TEST_P(FullDisk, IsGivenBack) {
  const SmallDisk disk(GetParam());
  try {
    StagedBag bag(path_, ".active");
    errorOfWriting(bag);
    bag.discard();
  } catch (const Error&) {
  }
  EXPECT_TRUE(std::filesystem::is_empty(scratch_ / "."));
}

TEST_P(FullDisk, LeavesNothingOfALabelledRun) {
  const SmallDisk disk(GetParam());
  LabelledBagOptions raw;
  raw.jpeg = false;
  EXPECT_THROW(
      {
        LabelledBagWriter writer(path_, raw);
        for (int i = 0; i < 2000; ++i) writer.write(image(0), "a", i);
        writer.close();
      },
      Error);
  EXPECT_TRUE(std::filesystem::is_empty(scratch_ / "."));
}

INSTANTIATE_TEST_SUITE_P(Sizes, FullDisk, testing::Values(0, 100, 4096, 5000, 70000, 800000));

}  // namespace
}  // namespace place_recognition
