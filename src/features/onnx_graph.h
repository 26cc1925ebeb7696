#pragma once

#include <cstddef>
#include <memory>
#include <string>

namespace place_recognition {

namespace onnx {
class Model;
}

/// The shape of one input image of a network; 0: not fixed.
struct NetworkInput {
  int channels = 0;
  int height = 0;
  int width = 0;
};

/// The graph of an ONNX file: layers in the order of computation. It is read and cut here, not by
/// OpenCV, because OpenCV's names of layers differ from version to version, and because OpenCV's
/// reader trusts sizes and shapes. Error messages are phrases that do not name a source.
class OnnxGraph {
 public:
  /// Throws Error unless `bytes` are an ONNX file in which the length of every tensor matches its
  /// shape, every layer uses only what precedes it, and no layer contains a graph of its own or
  /// refers to another file.
  explicit OnnxGraph(const std::string& bytes);
  ~OnnxGraph();

  /// Makes `layer` (the name of a layer or of its output; empty: the output of the network) the
  /// only output, and removes what it does not need. Throws Error if there is no such layer, or if
  /// it does not depend on exactly one image.
  void cutBehind(const std::string& layer);

  /// If the last layer averages over height and width, or only reshapes the output of a layer that
  /// does, removes all from that layer on. Call it after cutBehind().
  void cutBeforePooling();

  /// Shape of the input image; call it after cutBehind(). Throws Error unless the shape is channels
  /// x height x width.
  NetworkInput input() const;
  /// Declares the shape of the image. No size may remain open.
  void setInput(const NetworkInput& input);

  std::size_t layers() const;
  /// Describes a layer for a person, such as "'conv1' (Conv)".
  std::string describeLayer(std::size_t i) const;

  /// An ONNX file of the first `count` layers; its output is that of the last of them.
  std::string firstLayers(std::size_t count) const;
  std::string bytes() const;

 private:
  std::unique_ptr<onnx::Model> model_;
};

}  // namespace place_recognition
