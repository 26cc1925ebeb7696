// What place_recognizer uses in addition to frames: a map of adjoining rooms, and odometry.

#include <gtest/gtest.h>
#include <nav_msgs/Odometry.h>
#include <ros/ros.h>

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "ros/inbox.h"
#include "ros/recognizer/place_tracker.h"
#include "scratch_folder.h"

namespace place_recognition {
namespace {

std::shared_ptr<Model> threeRooms() {
  const auto model = std::make_shared<Model>();
  model->places = {"hall", "kitchen", "lab"};
  model->unknown_threshold = 0.5;
  model->adjacency = Adjacency(3);
  return model;
}

Recognition frameOf(double hall, double kitchen, double lab) {
  Recognition recognition;
  recognition.probabilities = Eigen::RowVector3d(hall, kitchen, lab);
  recognition.confidence = recognition.probabilities.maxCoeff(&recognition.place);
  recognition.evidence = 0.9;
  recognition.known = true;
  return recognition;
}

/// A node's parameters and topics, in a namespace that no other test uses.
class PlacesOverTime : public testing::Test {
 protected:
  PlacesOverTime() {
    static int count = 0;
    node_ = ros::NodeHandle("places_over_time_" + std::to_string(++count));
  }

  /// Returns the place after one second in the hall and two seconds of frames that look more like
  /// the lab than the kitchen; the lab can be reached only through the kitchen.
  std::string afterTheHall(std::shared_ptr<Model> model) {
    Parameters parameters(node_);
    PlaceTracker places(node_, parameters);
    places.setModels({std::move(model)}, 0.2);
    double stamp = 0;
    for (; stamp < 1; stamp += 0.1) places.update(stamp, frameOf(0.98, 0.01, 0.01));
    EXPECT_EQ(places.update(stamp, frameOf(0.98, 0.01, 0.01)), "hall");
    std::string place;
    for (int i = 0; i < 20; ++i) place = places.update(stamp += 0.1, frameOf(0.01, 0.44, 0.55));
    return place;
  }

  ros::NodeHandle node_;
  const ScratchFolder scratch_;
};

const char* const kRow = "rooms: {hall: [kitchen], kitchen: [lab]}";

TEST_F(PlacesOverTime, TakeAnyRoomForANeighbourWithoutAMap) {
  EXPECT_EQ(afterTheHall(threeRooms()), "lab");
}

TEST_F(PlacesOverTime, FollowTheMapOfTheParameter) {
  node_.setParam("adjacency", scratch_.write("map.yaml", kRow));
  EXPECT_EQ(afterTheHall(threeRooms()), "kitchen");
}

TEST_F(PlacesOverTime, FollowTheMapOfTheModelUnlessThereIsAParameter) {
  const auto model = threeRooms();
  model->adjacency = readAdjacency(scratch_.write("row.yaml", kRow), model->places);
  EXPECT_EQ(afterTheHall(model), "kitchen");
  node_.setParam("adjacency",
                 scratch_.write("map.yaml", "rooms: {hall: [kitchen, lab], kitchen: [lab]}"));
  EXPECT_EQ(afterTheHall(model), "lab");
}

TEST_F(PlacesOverTime, DoWithoutAMapThatCannotBeUsed) {
  for (const std::string text : {"rooms: {cellar: [hall]}", "[", "rooms: 3"}) {
    node_.setParam("adjacency", scratch_.write("map.yaml", text));
    EXPECT_EQ(afterTheHall(threeRooms()), "lab");
  }
  node_.setParam("adjacency", "/no/such/map.yaml");
  EXPECT_EQ(afterTheHall(threeRooms()), "lab");
}

/// Returns the message on a frame at `stamp` that a model of that name has answered.
PlaceRecognition messageOf(double stamp, const std::string& model = "rooms") {
  PlaceRecognition message;
  message.header.stamp = ros::Time(stamp);
  message.model_name = model;
  message.places.resize(3);
  message.places[0].name = "hall";
  message.places[1].name = "kitchen";
  message.places[2].name = "lab";
  return message;
}

TEST_F(PlacesOverTime, TheBeliefIsThatOfTheFilter) {
  Parameters parameters(node_);
  PlaceTracker places(node_, parameters);
  const auto model = threeRooms();
  places.setModels({model}, 0.2);
  TemporalFilterOptions options;
  options.decorrelation_time = 0.2;
  TemporalFilter filter(*model, model->adjacency, options);
  for (int i = 0; i < 20; ++i) {
    const double stamp = 0.1 * i;
    const Recognition frame = i < 10 ? frameOf(0.8, 0.1, 0.1) : frameOf(0.1, 0.2, 0.7);
    const std::string place = places.update(stamp, frame);
    const Eigen::RowVectorXd& expected = filter.update(stamp, frame).probabilities;
    const PlaceRecognition belief = places.belief(messageOf(stamp));
    EXPECT_NEAR(belief.header.stamp.toSec(), stamp, 1e-6);
    EXPECT_NEAR(belief.evidence, 1 - expected[3], 1e-12);
    double largest = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double probability = belief.places[k].probability;
      EXPECT_NEAR(probability * belief.evidence, expected[static_cast<Eigen::Index>(k)], 1e-12);
      largest = std::max(largest, probability);
    }
    EXPECT_EQ(belief.confidence, largest);
    if (i % 10 == 9) {
      EXPECT_EQ(belief.place, place);
      EXPECT_TRUE(belief.known);
    }
  }
}

TEST_F(PlacesOverTime, WithoutSmoothingTheBeliefIsTheFrame) {
  Parameters parameters(node_);
  PlaceTracker places(node_, parameters);
  places.setModels({threeRooms()}, 0);
  places.update(1, frameOf(0.8, 0.1, 0.1));
  PlaceRecognition message = messageOf(1);
  message.place = "lab";
  message.confidence = 0.625;
  EXPECT_EQ(places.belief(message).place, "lab");
  EXPECT_EQ(places.belief(message).confidence, 0.625);
}

TEST_F(PlacesOverTime, SmoothedComeALagLaterEachFrameOnce) {
  node_.setParam("smoothing_lag", 0.5);
  Parameters parameters(node_);
  PlaceTracker places(node_, parameters);
  places.setModels({threeRooms()}, 0.2);
  std::vector<PlaceRecognition> all;
  for (int i = 0; i < 40; ++i) {
    const double stamp = 0.1 * i;
    // Two frames in the hall show the lab; from the 20th frame on, all show the kitchen.
    places.update(stamp, i == 8 || i == 9 ? frameOf(0.2, 0.1, 0.7)
                         : i < 20         ? frameOf(0.9, 0.05, 0.05)
                                          : frameOf(0.05, 0.9, 0.05));
    for (const PlaceRecognition& message : places.smooth(messageOf(stamp))) {
      EXPECT_GT(stamp - message.header.stamp.toSec(), 0.5);
      EXPECT_LT(stamp - message.header.stamp.toSec(), 0.7);
      all.push_back(message);
    }
  }
  ASSERT_GT(all.size(), 32u);
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_NEAR(all[i].header.stamp.toSec(), 0.1 * static_cast<double>(i), 1e-6);
    EXPECT_EQ(all[i].place, i < 20 ? "hall" : "kitchen") << i;
    EXPECT_TRUE(all[i].known);
    double sum = 0;
    for (const PlaceScore& score : all[i].places) sum += score.probability;
    EXPECT_NEAR(sum, 1, 1e-9);
    EXPECT_EQ(all[i].confidence, all[i].places[i < 20 ? 0 : 1].probability);
    EXPECT_GT(all[i].evidence, 0.5);
  }
}

TEST_F(PlacesOverTime, SmoothedKeepTheModelThatAnsweredThemAndNoneIsLost) {
  Parameters parameters(node_);
  PlaceTracker places(node_, parameters);
  places.setModels({threeRooms()}, 0.2);
  std::vector<PlaceRecognition> all;
  for (int i = 0; i < 60; ++i) {
    if (i == 15) places.setModels({threeRooms()}, 0.2);
    if (i == 30) places.setSmoothing(0.3);
    const double stamp = 0.1 * i;
    places.update(stamp, frameOf(0.9, 0.05, 0.05));
    for (const auto& done : places.smooth(messageOf(stamp, i < 15 ? "old" : "new"))) {
      all.push_back(done);
    }
  }
  ASSERT_GT(all.size(), 45u);
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_NEAR(all[i].header.stamp.toSec(), 0.1 * static_cast<double>(i), 1e-6);
    EXPECT_EQ(all[i].model_name, i < 15 ? "old" : "new");
  }
}

TEST_F(PlacesOverTime, WhatWaitsComesWhenSmoothingEnds) {
  Parameters parameters(node_);
  PlaceTracker places(node_, parameters);
  places.setModels({threeRooms()}, 0.2);
  for (int i = 0; i < 5; ++i) {
    places.update(0.1 * i, frameOf(0.9, 0.05, 0.05));
    EXPECT_TRUE(places.smooth(messageOf(0.1 * i)).empty());
  }
  places.setSmoothing(0);
  places.update(0.5, frameOf(0.9, 0.05, 0.05));
  EXPECT_EQ(places.smooth(messageOf(0.5)).size(), 5u);
}

TEST_F(PlacesOverTime, NothingIsSmoothedWithoutSmoothing) {
  Parameters parameters(node_);
  PlaceTracker places(node_, parameters);
  places.setModels({threeRooms()}, 0);
  for (int i = 0; i < 30; ++i) {
    places.update(0.1 * i, frameOf(0.9, 0.05, 0.05));
    EXPECT_TRUE(places.smooth(messageOf(0.1 * i)).empty());
  }
}

class PlacesWithOdometry : public PlacesOverTime {
 protected:
  PlacesWithOdometry() {
    node_.setParam("use_odometry", true);
    Parameters parameters(node_);
    places_ = std::make_unique<PlaceTracker>(node_, parameters);
    places_->setModels({threeRooms()}, 0.2);
    publisher_ = node_.advertise<nav_msgs::Odometry>("odom", 10);
    EXPECT_TRUE(eventually([this] { return publisher_.getNumSubscribers() > 0; }));
  }

  /// Sends a pose, waits until it must have arrived, and adds a frame with the same stamp.
  std::string update(double stamp, double x, const Recognition& recognition) {
    nav_msgs::Odometry odometry;
    odometry.header.stamp = ros::Time(stamp);
    odometry.pose.pose.position.x = x;
    odometry.pose.pose.orientation.w = 1;
    publisher_.publish(odometry);
    ros::WallDuration(0.03).sleep();
    return places_->update(stamp, recognition);
  }

  std::unique_ptr<PlaceTracker> places_;
  ros::Publisher publisher_;
};

TEST_F(PlacesWithOdometry, StayWhereTheRobotStands) {
  double stamp = 100;
  for (int i = 0; i < 10; ++i) update(stamp += 0.1, 0.1 * i, frameOf(0.98, 0.01, 0.01));
  // Two seconds of frames that show another room, as if somebody stood in front of the camera.
  for (int i = 0; i < 20; ++i) {
    EXPECT_EQ(update(stamp += 0.1, 0.9, frameOf(0.01, 0.98, 0.01)), "hall");
  }
  std::string place;
  for (int i = 0; i < 20; ++i) {
    place = update(stamp += 0.1, 0.9 + 0.1 * i, frameOf(0.01, 0.98, 0.01));
  }
  EXPECT_EQ(place, "kitchen");
}

TEST_F(PlacesWithOdometry, SurviveOdometryThatIsNotANumber) {
  double stamp = 100;
  std::string place;
  for (const double x : {0.0, std::numeric_limits<double>::quiet_NaN(),
                         std::numeric_limits<double>::infinity(), -1e300, 1e300, 0.1}) {
    place = update(stamp += 0.1, x, frameOf(0.98, 0.01, 0.01));
  }
  EXPECT_EQ(place, "hall");
}

}  // namespace
}  // namespace place_recognition
