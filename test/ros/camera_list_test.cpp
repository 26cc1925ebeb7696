// The cameras that place_recognizer's parameters name.

#include "ros/recognizer/camera_list.h"

#include <gtest/gtest.h>

#include "error_of.h"

namespace place_recognition {
namespace {

using XmlRpc::XmlRpcValue;

Parameters parametersOf(const std::vector<std::pair<std::string, std::string>>& texts) {
  XmlRpcValue values;
  for (const auto& [name, text] : texts) values[name] = text;
  return {"/node", values};
}

TEST(CameraList, IsOneOnImageUnlessSeveralAreNamed) {
  Parameters none = parametersOf({{"cameras", ""}, {"models", ""}, {"model", "rooms"}});
  ASSERT_EQ(readCameras(none).size(), 1u);
  EXPECT_EQ(readCameras(none)[0].name, "");
  EXPECT_EQ(readCameras(none)[0].topic, "image");
  Parameters one = parametersOf({{"cameras", "[front]"}});
  EXPECT_EQ(readCameras(one)[0].name, "");
  EXPECT_EQ(readCameras(one)[0].topic, "front/image_raw");
}

TEST(CameraList, TakesNamesAndTopicsWithAModelEach) {
  Parameters parameters =
      parametersOf({{"cameras", "[front, /rear/rgb, side/image]"}, {"models", "[a, b, a]"}});
  const std::vector<CameraName> cameras = readCameras(parameters);
  ASSERT_EQ(cameras.size(), 3u);
  EXPECT_EQ(cameras[0].name, "front");
  EXPECT_EQ(cameras[0].topic, "front/image_raw");
  EXPECT_EQ(cameras[1].name, "rear/rgb");
  EXPECT_EQ(cameras[1].topic, "/rear/rgb");
  EXPECT_EQ(cameras[2].topic, "side/image");
  EXPECT_EQ(cameras[1].model, "b");
}

TEST(CameraList, RefusesWhatCannotBeMeant) {
  const auto refuses = [](const std::string& cameras, const std::string& models,
                          const std::string& model) {
    Parameters parameters =
        parametersOf({{"cameras", cameras}, {"models", models}, {"model", model}});
    return errorOf([&] { readCameras(parameters); });
  };
  EXPECT_NE(refuses("[front, 'a b']", "", "m").find("'a b'"), std::string::npos);
  EXPECT_NE(refuses("front, rear", "", "m").find("; write [front, rear]."), std::string::npos);
  EXPECT_NE(refuses("[front, front]", "", "m").find("twice"), std::string::npos);
  EXPECT_NE(refuses("[front, /front]", "", "m").find("'/front' twice"), std::string::npos);
  EXPECT_NE(refuses("[a, b, c, d, e, f, g, h, i]", "", "m").find("at most 8"), std::string::npos);
  EXPECT_NE(refuses("[front, rear]", "[a]", "").find("1 name for 2 cameras"), std::string::npos);
  EXPECT_NE(refuses("", "[a, b]", "").find("2 names for 1 camera"), std::string::npos);
  EXPECT_NE(refuses("", "[a, b]", "").find("rosparam delete /node/models."), std::string::npos);
  EXPECT_NE(refuses("[front, rear]", "[a, b]", "m").find("Both ~model and ~models"),
            std::string::npos);
}

TEST(CameraList, HasEachTopicOnce) {
  Parameters parameters = parametersOf({{"cameras", "[front, /front/image_raw]"}});
  const std::vector<CameraName> cameras = readCameras(parameters);
  requireDifferentTopics(cameras, {"/robot/front/image_raw", "/front/image_raw"});
  EXPECT_EQ(errorOf([&] {
              requireDifferentTopics(cameras, {"/front/image_raw", "/front/image_raw"});
            }),
            "The cameras 'front' and 'front/image_raw' of ~cameras are the same topic, "
            "/front/image_raw; name each camera once.");
}

TEST(CameraCorrelationParameter, IsOneNumberOrOneForEachPair) {
  Parameters none = parametersOf({});
  EXPECT_EQ(readCameraCorrelation(none, 2).size(), 0);
  Parameters one = parametersOf({{"camera_correlation", "0.25"}});
  EXPECT_EQ(readCameraCorrelation(one, 2), (Eigen::Matrix2d() << 1, 0.25, 0.25, 1).finished());
  EXPECT_EQ(readCameraCorrelation(one, 3)(1, 2), 0.25);
  Parameters three = parametersOf({{"camera_correlation", "[0.1, 0.2, 0.3]"}});
  EXPECT_EQ(readCameraCorrelation(three, 3),
            (Eigen::Matrix3d() << 1, 0.1, 0.2, 0.1, 1, 0.3, 0.2, 0.3, 1).finished());
  EXPECT_NE(errorOf([&] { readCameraCorrelation(three, 4); }).find("give one for all, or 6"),
            std::string::npos);
  Parameters large = parametersOf({{"camera_correlation", "1.5"}});
  EXPECT_NE(errorOf([&] { readCameraCorrelation(large, 2); }).find("0 to 1"), std::string::npos);
}

}  // namespace
}  // namespace place_recognition
