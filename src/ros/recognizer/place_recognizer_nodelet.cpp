#include <nodelet/nodelet.h>

#include <memory>
#include <pluginlib/class_list_macros.hpp>

#include "place_recognition/error.h"
#include "ros/recognizer/place_recognizer.h"

namespace place_recognition {

/// place_recognizer in the process of a nodelet manager, to which images are passed without copies.
class PlaceRecognizerNodelet : public nodelet::Nodelet {
 private:
  void onInit() override {
    try {
      recognizer_ =
          std::make_unique<PlaceRecognizer>(getMTNodeHandle(), getMTPrivateNodeHandle(), getName());
    } catch (const Error& e) {
      NODELET_FATAL("%s", e.what());
      throw;  // the manager, which does not report the reason, does not load the nodelet
    }
  }

  std::unique_ptr<PlaceRecognizer> recognizer_;
};

}  // namespace place_recognition

PLUGINLIB_EXPORT_CLASS(place_recognition::PlaceRecognizerNodelet, nodelet::Nodelet)
