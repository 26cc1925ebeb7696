#pragma once

#include <place_recognition/SayPlace.h>
#include <ros/ros.h>
#include <sensor_msgs/Joy.h>
#include <std_msgs/String.h>

#include <memory>

#include "base/keyboard.h"
#include "labels/label_keys.h"
#include "ros/labelers/labelled_recording.h"
#include "ros/nodes/image_input.h"
#include "ros/nodes/parameters.h"

namespace place_recognition {

/// Lets the person who drives the robot say where it is: with a key of the terminal, a button of
/// the joystick, the topic `~say` or the service `~say`. Callbacks come from one thread, besides
/// that of the keyboard.
class PlaceLabeler {
 public:
  /// Throws Error if a parameter is invalid or the bag cannot be written.
  PlaceLabeler(const ros::NodeHandle& node, const ros::NodeHandle& private_node);

  /// Ends the recording. Throws Error if there is no recording to keep.
  void finish() { recording_.finish(); }

 private:
  PlaceLabeler(const ros::NodeHandle& node, const ros::NodeHandle& private_node,
               Parameters parameters);
  void onKey(char key);
  void onSay(const std_msgs::StringConstPtr& message);
  void onJoy(const sensor_msgs::JoyConstPtr& message);
  bool onSayService(SayPlace::Request& request, SayPlace::Response& response);
  /// Returns the name as recorded.
  std::string say(const std::string& name);

  LabelKeys keys_;
  LabelledRecording recording_;
  ImageInput input_;
  ros::Subscriber say_subscriber_;
  ros::Subscriber joy_subscriber_;
  ros::ServiceServer say_server_;
  std::unique_ptr<Keyboard> keyboard_;  // null: there is no terminal
};

}  // namespace place_recognition
