// Images as they arrive at the node, damaged or made to harm: each is refused, or a picture.

#include <gtest/gtest.h>

#include "place_recognition/error.h"
#include "reliability/allocation_meter.h"
#include "reliability/image_messages.h"
#include "ros/messages/conversions.h"
#include "rounds.h"

namespace place_recognition {
namespace {

/// A decoder's own tables.
constexpr std::size_t kConstant = 4 << 20;
/// Memory of a picture that announces 64 million pixels, the most that a decoder may be given.
constexpr std::size_t kLargestPicture = 64'000'000 * std::size_t{8};

/// Whether `message` gives a picture, which must be one that extractors take, or one of 16 bits
/// for DepthScale.
template <typename Message>
bool givesPicture(const Message& message) {
  try {
    const cv::Mat image = toImage(message);
    EXPECT_TRUE(image.depth() == CV_8U || image.depth() == CV_16U);
    EXPECT_TRUE(image.channels() == 1 || image.channels() == 3);
    EXPECT_GT(image.total(), 0u);
    EXPECT_LE(image.cols, static_cast<int>(kMaxImageSide));
    EXPECT_LE(image.rows, static_cast<int>(kMaxImageSide));
    return true;
  } catch (const Error&) {
    return false;
  }
}

TEST(ImageDamage, RawImagesAreRefusedOrPictures) {
  ImageMessages messages(1);
  int pictures = 0;
  const int count = rounds(20000, 1000000);
  for (int i = 0; i < count; ++i) {
    const sensor_msgs::Image message = messages.raw();
    const AllocationMeter meter;
    pictures += givesPicture(message);
    EXPECT_LE(meter.peak(), 4 * message.data.size() + kConstant);
  }
  EXPECT_GT(pictures, count / 10);
  EXPECT_LT(pictures, count * 9 / 10);
}

TEST(ImageDamage, CompressedImagesAreRefusedOrPictures) {
  ImageMessages messages(2);
  int pictures = 0;
  const int count = rounds(2000, 100000);
  for (int i = 0; i < count; ++i) {
    const sensor_msgs::CompressedImage message = messages.compressed();
    const AllocationMeter meter;
    pictures += givesPicture(message);
    EXPECT_LE(meter.peak(), kLargestPicture);
  }
  EXPECT_GT(pictures, count / 100);
  EXPECT_LT(pictures, count * 9 / 10);
}

}  // namespace
}  // namespace place_recognition
