#include "ros/bags/bag_time_span.h"

#include <rosbag/view.h>

#include "ros/messages/image_types.h"

namespace place_recognition {
namespace {

/// The span of the largest group of images alone. A gap of more than a day, caused by a clock that
/// was not set, separates groups.
BagTimeSpan spanOfImages(rosbag::View& images) {
  constexpr double kGap = 24 * 60 * 60;  // s
  BagTimeSpan span;
  std::uint32_t most = 0, count = 0;
  ros::Time first, last;
  for (const rosbag::MessageInstance& image : images) {
    const ros::Time time = image.getTime();
    if (count == 0 || time.toSec() - last.toSec() > kGap) {
      first = time;
      count = 0;
    }
    last = time;
    if (++count >= most) {
      most = count;
      span = {first, last, images.size() - most};
    }
  }
  return span;
}

}  // namespace

BagTimeSpan timeSpan(const rosbag::Bag& bag) {
  constexpr double kGap = 10 * 60;  // s
  rosbag::View all(bag);
  if (all.size() == 0) return {};
  rosbag::View images(bag, rosbag::TypeQuery({kImageType, kCompressedImageType}));
  if (images.size() == 0) return {all.getBeginTime(), all.getEndTime(), 0};
  const auto [first, last, others] = spanOfImages(images);
  ros::Time begin = all.getBeginTime(), before = begin, end = last;
  for (const rosbag::MessageInstance& message : rosbag::View(bag, ros::TIME_MIN, first)) {
    if (message.getTime().toSec() - before.toSec() > kGap) begin = message.getTime();
    before = message.getTime();
  }
  for (const rosbag::MessageInstance& message : rosbag::View(bag, last)) {
    if (message.getTime().toSec() - end.toSec() > kGap) break;
    end = message.getTime();
  }
  return {begin, end, others};
}

}  // namespace place_recognition
