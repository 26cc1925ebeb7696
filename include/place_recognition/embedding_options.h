#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace place_recognition {

/// A neural network, ready to be stored in a model.
struct Network {
  std::string onnx;    ///< ONNX file with the layers up to the selected one
  std::string sha256;  ///< of the original file, 64 hexadecimal digits
};

/// The output of a neural network, or of one of its layers, as a descriptor of the whole image.
/// Typically the network was trained to classify objects (Sharif Razavian et al., "CNN features
/// off-the-shelf", 2014). For visit() and check(), see feature_options.h.
struct EmbeddingOptions {
  static constexpr const char* kType = "embedding";

  std::string network;
  std::string layer;
  int stride = 0;
  int width = 0;
  int height = 0;
  int columns = 1;
  int power = 1;
  std::string fit = "stretch";
  std::string channels = "rgb";
  std::vector<double> mean = {127.5};
  std::vector<double> scale = {1 / 127.5};

  /// Number of averages that follow one another in the feature: of the whole and of each column.
  int parts() const { return columns > 1 ? 1 + columns : 1; }

  // These are not options, see loadNetwork(); a model stores them beside the options.
  std::shared_ptr<const Network> loaded;  ///< null: not loaded yet
  std::size_t dimension = 0;              ///< of the values used, without height and width

  template <typename Self, typename Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor("network", self.network,
            "ONNX network: the name of one in $ROS_HOME/place_recognition/networks, or a file if "
            "it has a slash or ends in .onnx; a model contains a copy");
    visitor("layer", self.layer,
            "name of the layer to use, or of its output; empty: the output of the network");
    visitor(
        "stride", self.stride,
        "2, 4, 8, 16, 32 or 64: use the last layer up to `layer` whose output has one place for "
        "about this many pixels of the input's width and height; 0: use `layer`");
    visitor("width", self.width,
            "width of the network's input, pixels, 16..1024; 0: as the network declares");
    visitor("height", self.height,
            "height of the network's input, pixels, 16..1024; 0: as the network declares");
    visitor(
        "columns", self.columns,
        "1..16; above 1: the output is averaged over the whole image and over each of this many "
        "columns of it, before any pooling within the network");
    visitor("power", self.power,
            "1..8, the exponent p of the averages, (mean of x^p)^(1/p); above 1, large values "
            "count more and negative ones as 0");
    visitor("fit", self.fit,
            "stretch: the whole image is scaled to width x height; crop: its largest central part "
            "of that shape is scaled");
    visitor("channels", self.channels, "order of the network's input channels: rgb, bgr or grey");
    visitor("mean", self.mean,
            "the network's input is (pixel - mean) * scale, for pixels 0..255; one number, or one "
            "per channel, in their order");
    visitor("scale", self.scale, "see mean; not 0");
  }
  void check(const std::string& key = "feature") const;
};

}  // namespace place_recognition
