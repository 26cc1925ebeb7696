#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "place_recognition/embedding_options.h"

namespace place_recognition {

/// Reads the network that `options` name, cuts off what its layer does not need, and runs it once.
/// An ONNX file is taken for hostile: sizes, shapes and references are checked before OpenCV sees
/// them, as are memory and work before it runs. Throws Error, one line that names the file, the
/// layer and OpenCV's version, if it is missing, damaged, or of a kind that OpenCV does not run.
std::shared_ptr<const Network> loadNetwork(const EmbeddingOptions& options);

/// What a network file holds.
struct NetworkFacts {
  std::size_t bytes = 0;
  std::string sha256;  ///< 64 hexadecimal digits
  int channels = 0;    ///< of its input; 0: it is left open, as the two below
  int width = 0;
  int height = 0;
  std::size_t layers = 0;     ///< that lead to the layer taken
  std::size_t dimension = 0;  ///< of the vectors that it gives
};

/// Reads the network `name` (see networkPath()), cuts it behind `layer` and runs it once, on an
/// image of 224 x 224 pixels in three channels unless it declares another one. Throws like
/// loadNetwork().
NetworkFacts networkFacts(const std::string& name, const std::string& layer);

/// Names of the networks in networkFolder(), ascending.
std::vector<std::string> networkNames();

/// The path of a network by name: NAME itself if it has a slash or ends in `.onnx`, else
/// networkFolder()/NAME.onnx. Throws Error for a name that is not [A-Za-z0-9_-]{1,64}.
std::string networkPath(const std::string& name);

/// $ROS_HOME/place_recognition/networks, or ~/.ros/place_recognition/networks.
std::string networkFolder();

/// Largest network file that is read, bytes.
constexpr std::size_t kMaxNetworkBytes = std::size_t{128} << 20;

}  // namespace place_recognition
