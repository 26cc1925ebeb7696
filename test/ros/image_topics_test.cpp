// The messages when no images arrive.

#include "ros/nodes/image_topics.h"

#include <gtest/gtest.h>

#include <string>

namespace place_recognition {
namespace {

const char* const kImage = "sensor_msgs/Image";
const char* const kCompressed = "sensor_msgs/CompressedImage";

std::string explain(const std::string& topic, const std::string& transport,
                    const ros::master::V_TopicInfo& published) {
  return explainSilence(topic, transport, published, "/place_recognizer");
}

void expectSays(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << part << " in: " << text;
}

TEST(ExplainSilence, NamesTheTopicsOfImagesThatThereAre) {
  const std::string text = explain("/camera/image", "raw",
                                   {{"/front/image_raw", kImage},
                                    {"/rear/image_raw/compressed", kCompressed},
                                    {"/depth/image/compressedDepth", kCompressed},
                                    {"/place_recognizer/debug_image", kImage},
                                    {"/other/recognition", "place_recognition/PlaceRecognition"},
                                    {"/other/front/debug_image", kImage},
                                    {"/scan", "sensor_msgs/LaserScan"}});
  EXPECT_EQ(text,
            "Nobody publishes /camera/image. Images are published on: /front/image_raw, "
            "/rear/image_raw/compressed.");
  expectSays(explain("/camera/image", "compressed", {{"/scan", "sensor_msgs/LaserScan"}}),
             "Nobody publishes /camera/image/compressed. Nobody publishes images.");
}

TEST(ExplainSilence, NamesTheOtherFormOfTheTopic) {
  const std::string only_compressed =
      explain("/camera/image", "raw", {{"/camera/image/compressed", kCompressed}});
  expectSays(only_compressed, "/camera/image/compressed is published");
  expectSays(only_compressed,
             "set ~image_transport to compressed and remap image to /camera/image.");
  expectSays(explain("/camera/image", "compressed", {{"/camera/image", kImage}}),
             "set ~image_transport to raw and remap image to /camera/image.");
  for (const char* transport : {"raw", "compressed"}) {  // `image` given with its suffix
    expectSays(explain("/camera/image/compressed", transport,
                       {{"/camera/image", kImage}, {"/camera/image/compressed", kCompressed}}),
               "set ~image_transport to compressed and remap image to /camera/image.");
  }
  expectSays(explain("/photos", "raw", {{"/photos", kCompressed}}),
             "relay it to /photos/compressed");
  expectSays(explain("/photos", "compressed", {{"/photos", kCompressed}}),
             "relay it to /photos/compressed");
}

TEST(ExplainSilence, OfATopicThatIsPublishedPointsAtTheCamera) {
  expectSays(explain("/camera/image", "raw", {{"/camera/image", kImage}}),
             "/camera/image is published, but no image arrives");
  expectSays(explain("/camera/image", "theora",
                     {{"/camera/image/theora", "theora_image_transport/Packet"}}),
             "/camera/image/theora is published, but no image arrives");
  expectSays(explain("/scan", "raw", {{"/scan", "sensor_msgs/LaserScan"}}),
             "published as sensor_msgs/LaserScan, which is not an image");
  expectSays(explain("/depth/compressedDepth", "raw", {{"/depth/compressedDepth", kCompressed}}),
             "contains distances");
}

}  // namespace
}  // namespace place_recognition
