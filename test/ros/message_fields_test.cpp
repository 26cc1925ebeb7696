// Generic access to the fields of messages: ~retrain has the fields of ~train.

#include "ros/nodes/message_fields.h"

#include <gtest/gtest.h>
#include <place_recognition/Retrain.h>
#include <place_recognition/TrainGoal.h>
#include <place_recognition/TrainResult.h>

#include <map>
#include <string>
#include <vector>

namespace place_recognition {
namespace {

using Texts = std::vector<std::string>;

Retrain::Request request() {
  Retrain::Request request;
  request.bags = {"a.bag", "b.bag"};
  request.image_topic = "/camera";
  request.label = "Küche # 1";
  request.model = "home";
  request.yaml = "seed: 2\nsvm: {c: 10}\n";
  request.vector_limit = 300;
  request.forgetting = 0.3;
  request.recognizers = {"/front"};
  return request;
}

TEST(SameFields, OfARequestAreThoseOfTheGoal) {
  const auto goal = sameFields<TrainGoal>(request());
  EXPECT_EQ(goal.bags, request().bags);
  EXPECT_EQ(goal.image_topic, "/camera");
  EXPECT_EQ(goal.label, "Küche # 1");
  EXPECT_EQ(goal.model, "home");
  EXPECT_EQ(goal.yaml, request().yaml);
  EXPECT_EQ(goal.vector_limit, 300u);
  EXPECT_EQ(goal.threads, 0u);
  EXPECT_EQ(goal.recognizers, request().recognizers);
  EXPECT_EQ(serialized(goal), serialized(request()));
}

TEST(SameFields, OfAResultAreThoseOfTheResponse) {
  TrainResult result;
  result.success = true;
  result.message = "Learned.";
  result.places = {"kitchen", "corridor"};
  result.images = 12345678901;
  result.validation_rate = 0.75;
  const auto response = sameFields<Retrain::Response>(result);
  EXPECT_TRUE(response.success);
  EXPECT_EQ(response.message, "Learned.");
  EXPECT_EQ(response.places, result.places);
  EXPECT_EQ(response.images, result.images);
  EXPECT_EQ(response.validation_rate, 0.75);
}

TEST(FieldsOf, AGoalAreItsFieldsInTheirOrder) {
  std::map<std::string, MessageField> fields;
  const std::vector<MessageField> all = fieldsOf(sameFields<TrainGoal>(request()));
  for (const MessageField& field : all) fields[field.name] = field;
  EXPECT_EQ(all.front().name, "bags");
  EXPECT_EQ(all.back().name, "recognizers");
  EXPECT_EQ(fields["bags"].values, (Texts{"a.bag", "b.bag"}));
  EXPECT_EQ(fields["label"].values, Texts{"Küche # 1"});
  EXPECT_EQ(fields["preset"].values, Texts{""});
  EXPECT_EQ(fields["yaml"].values, Texts{request().yaml});
  EXPECT_EQ(fields["vector_limit"].values, Texts{"300"});
  EXPECT_EQ(fields["vector_limit"].type, "uint32");
  EXPECT_EQ(fields["forgetting"].values, Texts{"0.3"});
  EXPECT_EQ(fields["recognizers"].values, Texts{"/front"});
}

}  // namespace
}  // namespace place_recognition
