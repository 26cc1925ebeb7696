#pragma once

#include <cstddef>
#include <memory>
#include <string>

namespace place_recognition {

namespace onnx {
class Model;
}

/// The shape of one image that a network takes; 0: it is left open.
struct NetworkInput {
  int channels = 0;
  int height = 0;
  int width = 0;
};

/// The graph of an ONNX file: layers in the order in which they are computed. Read and cut here,
/// not by OpenCV, because the names that OpenCV gives to layers differ from version to version,
/// and because its reader trusts sizes and shapes. Errors are phrases without a source.
class OnnxGraph {
 public:
  /// Throws Error unless `bytes` are an ONNX file in which every tensor has the length that its
  /// shape says, every layer takes what is there before it, and no layer holds a graph of its own
  /// or refers to another file.
  explicit OnnxGraph(const std::string& bytes);
  ~OnnxGraph();

  /// Makes `layer` (the name of a layer or of its output; empty: the output of the network) the
  /// only output, and removes what it does not need. Throws Error if there is no such layer, or if
  /// it does not depend on exactly one image.
  void cutBehind(const std::string& layer);

  /// Shape of the input image; call after cutBehind(). Throws Error unless it is
  /// channels x height x width.
  NetworkInput input() const;
  /// Declares the shape of the image. Nothing may be open.
  void setInput(const NetworkInput& input);

  std::size_t layers() const;
  /// For a person, as in 'conv1' (Conv).
  std::string describeLayer(std::size_t i) const;

  /// An ONNX file of the first `count` layers, or of all, with the output of the last one.
  std::string firstLayers(std::size_t count) const;
  std::string bytes() const;

 private:
  std::unique_ptr<onnx::Model> model_;
};

}  // namespace place_recognition
