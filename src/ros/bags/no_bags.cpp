// Replaces bag_recording.cpp and labelled_bag_writer.cpp in a build without ROS.
#include "place_recognition/error.h"
#include "ros/bags/bag_recording.h"
#include "ros/bags/labelled_bag_writer.h"

namespace place_recognition {
namespace {

[[noreturn]] void refuse(const std::string& path) {
  throw Error(path +
              " is a bag, but this program was built without ROS; build it with "
              "-DPLACE_RECOGNITION_ROS=ON, or use folders of room/image files.");
}

}  // namespace

std::unique_ptr<Recording> openBagRecording(const std::string& path, const BagRecordingOptions&) {
  refuse(path);
}

BagInfo bagInfo(const std::string& path, const BagRecordingOptions&) { refuse(path); }

bool hasImages(const BagTopic&) { return false; }

struct LabelledBagWriter::Bag {};

LabelledBagWriter::LabelledBagWriter(const std::string& path, const LabelledBagOptions&) {
  refuse(path);
}
LabelledBagWriter::~LabelledBagWriter() = default;
void LabelledBagWriter::write(const cv::Mat&, const std::string&, double, const std::string&) {}
void LabelledBagWriter::close() {}

}  // namespace place_recognition
