#include <nodelet/nodelet.h>

#include <memory>
#include <pluginlib/class_list_macros.hpp>

#include "ros/place_recognizer.h"

namespace place_recognition {

/// place_recognizer in the process of a nodelet manager, where images are not copied.
class PlaceRecognizerNodelet : public nodelet::Nodelet {
 private:
  void onInit() override {
    recognizer_ =
        std::make_unique<PlaceRecognizer>(getMTNodeHandle(), getMTPrivateNodeHandle(), getName());
  }

  std::unique_ptr<PlaceRecognizer> recognizer_;
};

}  // namespace place_recognition

PLUGINLIB_EXPORT_CLASS(place_recognition::PlaceRecognizerNodelet, nodelet::Nodelet)
