#pragma once

#include <cstdint>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

#include "base/sha256.h"
#include "place_recognition/embedding_options.h"

namespace place_recognition {

/// An ONNX file, assembled field by field: a 3 x 3 convolution with stride 2, ReLU, and another
/// convolution with stride 2. The input is 16 x 16 pixels in three channels. The output has 6
/// channels of 4 x 4 values; after the first convolution there are 4 channels of 7 x 7.
class SmallNetwork {
 public:
  static constexpr std::size_t kDimension = 6;
  static constexpr std::size_t kEarlyDimension = 4;  ///< of the layer with stride 2

  static std::string onnx() {
    const std::string graph = node("first", "Conv", {"image", "w1", "b1"}, "c1",
                                   ints("strides", {2, 2}) + ints("kernel_shape", {3, 3})) +
                              node("rectified", "Relu", {"c1"}, "r1", "") +
                              node("second", "Conv", {"r1", "w2", "b2"}, "out",
                                   ints("strides", {2, 2}) + ints("kernel_shape", {1, 1})) +
                              bytes(2, "small") + tensor("w1", {4, 3, 3, 3}) + tensor("b1", {4}) +
                              tensor("w2", {6, 4, 1, 1}) + tensor("b2", {6}) +
                              bytes(11, value("image", {1, 3, 16, 16})) +
                              bytes(12, value("out", {1, 6, 4, 4}));
    return number(1, 6) + bytes(7, graph) + bytes(8, number(2, 9));
  }

  static std::shared_ptr<const Network> network() {
    return std::make_shared<const Network>(Network{onnx(), sha256(onnx())});
  }

  static EmbeddingOptions options() {
    EmbeddingOptions options;
    options.network = "small";
    options.loaded = network();
    options.dimension = kDimension;
    return options;
  }
  static EmbeddingOptions earlyOptions() {
    EmbeddingOptions options = SmallNetwork::options();
    options.stride = 2;
    options.power = 3;
    options.dimension = kEarlyDimension;
    return options;
  }

  // Protocol Buffers' encoding of a number, and of a length-delimited field.
  static std::string varint(std::uint64_t value) {
    std::string text;
    for (; value > 127; value >>= 7) text += static_cast<char>(value | 128);
    return text + static_cast<char>(value);
  }
  static std::string number(int field, std::uint64_t value) {
    return varint(static_cast<std::uint64_t>(field) << 3) + varint(value);
  }
  static std::string bytes(int field, const std::string& text) {
    return varint(static_cast<std::uint64_t>(field) << 3 | 2) + varint(text.size()) + text;
  }

  /// A field of a graph.
  static std::string node(const std::string& name, const std::string& type,
                          const std::vector<std::string>& inputs, const std::string& output,
                          const std::string& attributes) {
    std::string text;
    for (const std::string& input : inputs) text += bytes(1, input);
    return bytes(1, text + bytes(2, output) + bytes(3, name) + bytes(4, type) + attributes);
  }
  static std::string ints(const std::string& name, const std::vector<int>& values) {
    std::string text = bytes(1, name) + number(20, 7);
    for (const int value : values) text += number(8, static_cast<std::uint64_t>(value));
    return bytes(5, text);
  }
  static std::string integer(const std::string& name, int value) {
    return bytes(5, bytes(1, name) + number(20, 2) + number(3, static_cast<std::uint64_t>(value)));
  }
  static std::string tensor(const std::string& name, const std::vector<int>& dims) {
    std::string text;
    int count = 1;
    for (const int dim : dims) {
      text += number(1, static_cast<std::uint64_t>(dim));
      count *= dim;
    }
    std::string raw;
    for (int i = 0; i < count; ++i) {
      const float weight = static_cast<float>((i * 37 + count) % 19 - 9) / 16;
      raw.append(reinterpret_cast<const char*>(&weight), sizeof(weight));
    }
    return bytes(5, text + number(2, 1) + bytes(8, name) + bytes(9, raw));
  }
  static std::string value(const std::string& name, const std::vector<int>& dims) {
    std::string shape;
    for (const int dim : dims) shape += bytes(1, number(1, static_cast<std::uint64_t>(dim)));
    return bytes(1, name) + bytes(2, bytes(1, number(1, 1) + bytes(2, shape)));
  }
};

}  // namespace place_recognition
