#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "place_recognition/embedding_options.h"

namespace place_recognition {

/// Reads the network that `options` name into them: removes what the selected layer does not need
/// and a final pooling over the whole area, and runs it once. An ONNX file is not trusted: sizes,
/// shapes and references are checked before OpenCV sees them, and memory and work are checked
/// before it runs. Throws Error, one line that names the file, the layer and OpenCV's version, if
/// the file is missing, damaged, or of a kind that OpenCV cannot run.
void loadNetwork(EmbeddingOptions& options);

/// Limits OpenCV to one thread in the whole program, for good. Running a network does the same:
/// sharing a layer between threads would change the last bits of its output, and images are
/// processed in parallel anyway. Changing the number ends threads of OpenCV that another caller may
/// be using, so call this before other threads use OpenCV. Thread-safe apart from that.
void limitOpenCvToOneThread();

/// Properties of a network file.
struct NetworkFacts {
  std::size_t bytes = 0;
  std::string sha256;  ///< 64 hexadecimal digits
  int channels = 0;    ///< of its input; 0: not fixed, likewise below
  int width = 0;
  int height = 0;
  std::size_t layers = 0;     ///< up to the selected one
  std::size_t dimension = 0;  ///< of its output vectors
};

/// Reads the network `name` (see networkPath()), cuts it after `layer` and runs it once. The input
/// is an image of 224 x 224 pixels with three channels unless the network declares another shape.
/// Throws like loadNetwork().
NetworkFacts networkFacts(const std::string& name, const std::string& layer);

/// Names of the networks in networkFolder(), in ascending order.
std::vector<std::string> networkNames();

/// The path of a network by name: NAME itself if it contains a slash or ends in `.onnx`, else
/// networkFolder()/NAME.onnx. Throws Error for a name that is not [A-Za-z0-9_-]{1,64}.
std::string networkPath(const std::string& name);

/// $ROS_HOME/place_recognition/networks, or ~/.ros/place_recognition/networks.
std::string networkFolder();

/// Maximum size of a network file, bytes.
constexpr std::size_t kMaxNetworkBytes = std::size_t{128} << 20;

}  // namespace place_recognition
