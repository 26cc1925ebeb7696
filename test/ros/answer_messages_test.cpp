// The messages that the node publishes: images, answers and information on the model.

#include <gtest/gtest.h>

#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "ros/gradient.h"
#include "ros/messages/conversions.h"
#include "ros/recognizer/place_marker.h"

namespace place_recognition {
namespace {

TEST(ImageMessages, RoundTrip) {
  std_msgs::Header header;
  header.frame_id = "camera";
  header.stamp = ros::Time(12, 34);
  for (const int type : {CV_8UC3, CV_8UC1}) {
    const cv::Mat image = gradient(type);
    const sensor_msgs::Image message = toImageMessage(image(cv::Rect(2, 3, 20, 10)), header);
    EXPECT_EQ(message.header.stamp, header.stamp);
    EXPECT_EQ(message.header.frame_id, "camera");
    EXPECT_EQ(cv::norm(toImage(message), image(cv::Rect(2, 3, 20, 10)), cv::NORM_INF), 0);
  }
}

Model namedPlaces() {
  Model model;
  model.name = "home";
  model.version = "0123abcd";
  model.places = {"corridor", "kitchen"};
  return model;
}

TEST(RecognitionMessages, CarryHeaderModelAndScores) {
  Recognition recognition;
  recognition.place = 1;
  recognition.known = true;
  recognition.confidence = 0.75;
  recognition.evidence = 0.625;
  recognition.probabilities = Eigen::RowVector2d(0.25, 0.75);
  recognition.decision_values = Eigen::RowVector2d(-1.5, 0.5);
  std_msgs::Header header;
  header.seq = 9;
  header.stamp = ros::Time(5, 6);
  header.frame_id = "camera";
  const PlaceRecognition message = toPlaceRecognition(recognition, namedPlaces(), header, 0.02);
  EXPECT_EQ(message.header.stamp, header.stamp);
  EXPECT_EQ(message.header.frame_id, "camera");
  EXPECT_EQ(message.model_name, "home");
  EXPECT_EQ(message.model_version, "0123abcd");
  EXPECT_EQ(message.place, "kitchen");
  EXPECT_TRUE(message.known);
  EXPECT_EQ(message.confidence, 0.75);
  EXPECT_EQ(message.evidence, 0.625);
  ASSERT_EQ(message.places.size(), 2u);
  EXPECT_EQ(message.places[0].name, "corridor");
  EXPECT_EQ(message.places[0].probability, 0.25);
  EXPECT_EQ(message.places[0].margin, -1.5);
  EXPECT_EQ(message.places[1].margin, 0.5);
  EXPECT_EQ(message.seconds, 0.02);
}

TEST(RecognitionMessages, NoPlaceIsAnEmptyNameAndAReason) {
  Recognition recognition;
  recognition.probabilities = Eigen::RowVector2d(0.5, 0.5);
  recognition.decision_values = Eigen::RowVector2d(0, 0);
  recognition.reason = "too few interest points";
  const PlaceRecognition message =
      toPlaceRecognition(recognition, namedPlaces(), std_msgs::Header(), 0);
  EXPECT_EQ(message.place, "");
  EXPECT_FALSE(message.known);
  EXPECT_EQ(message.reason, "too few interest points");
}

TEST(RecognitionMessages, AreRevisedEvenWithoutAnyEvidence) {
  Recognition recognition;
  recognition.probabilities = Eigen::RowVector2d(0.25, 0.75);
  recognition.decision_values = Eigen::RowVector2d(-1.5, 0.5);
  PlaceRecognition message = toPlaceRecognition(recognition, namedPlaces(), std_msgs::Header(), 0);
  FilteredAnswer answer;
  answer.probabilities = Eigen::RowVector3d(0, 0, 1);
  revise(answer, message);
  EXPECT_FALSE(message.known);
  EXPECT_EQ(message.evidence, 0);
  EXPECT_EQ(message.confidence, 0.5);
  EXPECT_EQ(message.places[0].probability, 0.5);
  EXPECT_EQ(message.places[1].probability, 0.5);
}

TEST(RecognitionMessages, ModelInfoListsPlacesAndFeatures) {
  const ModelInfo message = toModelInfo(namedPlaces());
  EXPECT_EQ(message.name, "home");
  EXPECT_EQ(message.places, (std::vector<std::string>{"corridor", "kitchen"}));
  EXPECT_EQ(message.features,
            (std::vector<std::string>{
                "colours: crfh, chi-squared kernel", "tints: crfh, chi-squared kernel",
                "edges: crfh, chi-squared kernel", "shapes: crfh, chi-squared kernel",
                "directions: hog, chi-squared kernel"}));
}

TEST(PlaceMarkers, AreTextWhereTheCameraIs) {
  std_msgs::Header header;
  header.frame_id = "camera";
  header.stamp = ros::Time(5, 6);
  const visualization_msgs::Marker marker = placeMarker("kitchen", header);
  EXPECT_EQ(marker.header.frame_id, "camera");
  EXPECT_EQ(marker.header.stamp, header.stamp);
  EXPECT_EQ(marker.type, visualization_msgs::Marker::TEXT_VIEW_FACING);
  EXPECT_EQ(marker.text, "kitchen");
  EXPECT_GT(marker.scale.z, 0);
  EXPECT_EQ(marker.color.a, 1);
  EXPECT_EQ(marker.pose.orientation.w, 1);
  EXPECT_GT(marker.lifetime.toSec(), 0);
}

}  // namespace
}  // namespace place_recognition
