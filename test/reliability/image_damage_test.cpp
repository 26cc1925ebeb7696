// Damaged and malicious image messages: each is refused or yields an image.

#include <gtest/gtest.h>

#include "place_recognition/error.h"
#include "reliability/allocation_meter.h"
#include "reliability/image_messages.h"
#include "ros/messages/conversions.h"
#include "rounds.h"

namespace place_recognition {
namespace {

/// Memory of a decoder's tables.
constexpr std::size_t kConstant = 4 << 20;
/// Memory of an image of 64 million pixels, the most that a decoder may be given.
constexpr std::size_t kLargestImage = 64'000'000 * std::size_t{8};

/// Whether `message` gives an image, which must be one that extractors take, or one of 16 bits
/// for LevelScale.
template <typename Message>
bool givesImage(const Message& message) {
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

TEST(ImageDamage, RawImagesAreRefusedOrImages) {
  ImageMessages messages(1);
  int images = 0;
  const int count = rounds(20000, 1000000);
  for (int i = 0; i < count; ++i) {
    const sensor_msgs::Image message = messages.raw();
    const AllocationMeter meter;
    images += givesImage(message);
    EXPECT_LE(meter.peak(), 4 * message.data.size() + kConstant);
  }
  EXPECT_GT(images, count / 10);
  EXPECT_LT(images, count * 9 / 10);
}

TEST(ImageDamage, CompressedImagesAreRefusedOrImages) {
  ImageMessages messages(2);
  int images = 0;
  const int count = rounds(2000, 100000);
  for (int i = 0; i < count; ++i) {
    const sensor_msgs::CompressedImage message = messages.compressed();
    const AllocationMeter meter;
    images += givesImage(message);
    EXPECT_LE(meter.peak(), kLargestImage);
  }
  EXPECT_GT(images, count / 100);
  EXPECT_LT(images, count * 9 / 10);
}

}  // namespace
}  // namespace place_recognition
