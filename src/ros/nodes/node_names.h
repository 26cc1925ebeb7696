#pragma once

#include <cstdint>

/// Names of the topics, services and actions of the nodes, their queue sizes and a default. Names
/// of a node's own interfaces are private: `~recognition` is /place_recognizer/recognition.
namespace place_recognition::names {

// place_recognizer
constexpr const char* kImage = "image";
constexpr const char* kImageRawSuffix = "/image_raw";
constexpr const char* kRecognition = "recognition";
constexpr const char* kPlace = "place";
constexpr const char* kBelief = "belief";
constexpr const char* kSmoothed = "smoothed";
constexpr const char* kModelInfo = "model_info";
constexpr const char* kDebugImage = "debug_image";
constexpr const char* kMarker = "marker";
constexpr const char* kOdometry = "odom";
constexpr const char* kLoadModel = "load_model";
constexpr const char* kReloadModel = "reload_model";
constexpr const char* kSetEnabled = "set_enabled";
constexpr const char* kReset = "reset";
constexpr const char* kRecognize = "recognize";

// trainer
constexpr const char* kTrain = "train";
constexpr const char* kRetrain = "retrain";

// place_labeler and auto_labeler
constexpr const char* kPlaceLabel = "place_label";
constexpr const char* kSay = "say";
constexpr const char* kJoy = "joy";
constexpr const char* kPose = "pose";

// place_to_pose
constexpr const char* kRecognizerBelief = "place_recognizer/belief";
constexpr const char* kAmclPose = "amcl_pose";
constexpr const char* kInitialPose = "initialpose";
constexpr const char* kRoomPose = "room_pose";
constexpr const char* kRoomMarkers = "room_markers";

/// Default of `~image_timeout`, s.
constexpr double kImageTimeout = 5;

/// Only the newest image matters.
constexpr std::uint32_t kImageQueue = 1;
/// Enough odometry for the moments in which a node is busy.
constexpr std::uint32_t kOdometryQueue = 100;
/// A recording must not lose images while the disk is briefly busy.
constexpr std::uint32_t kRecordingQueue = 100;
/// A subscriber that is briefly slow must not lose answers.
constexpr std::uint32_t kAnswerQueue = 10;

}  // namespace place_recognition::names
