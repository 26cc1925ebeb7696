#include <gtest/gtest.h>

#include <opencv2/core/version.hpp>

#include "error_of.h"
#include "features/onnx_graph.h"
#include "features/small_network.h"
#include "place_recognition/error.h"
#include "place_recognition/network.h"
#include "scratch_folder.h"

namespace place_recognition {
namespace {

/// Returns the message of the Error that loading `onnx` from a file throws; empty if none.
std::string errorIn(const std::string& onnx, EmbeddingOptions options = {}) {
  const ScratchFolder folder;
  options.network = folder.write("tried.onnx", onnx);
  const std::string error = errorOf([&] { loadNetwork(options); });
  if (error.empty()) return error;
  EXPECT_NE(error.find(options.network), std::string::npos) << error;
  EXPECT_NE(error.find(CV_VERSION), std::string::npos) << error;
  EXPECT_EQ(error.find('\n'), std::string::npos) << error;
  return error;
}

void expectRefused(const std::string& onnx, const std::string& words,
                   const EmbeddingOptions& options = {}) {
  const std::string error = errorIn(onnx, options);
  EXPECT_NE(error.find(words), std::string::npos) << error;
}

/// Returns a network with 16 x 16 input pixels and these fields in its graph.
std::string networkOf(const std::string& fields) {
  return SmallNetwork::number(1, 6) +
         SmallNetwork::bytes(
             7, fields + SmallNetwork::bytes(11, SmallNetwork::value("image", {1, 3, 16, 16})) +
                    SmallNetwork::bytes(12, SmallNetwork::value("out", {1, 6, 7, 7}))) +
         SmallNetwork::bytes(8, SmallNetwork::number(2, 9));
}

TEST(LoadNetwork, NamesWhatIsMissing) {
  EmbeddingOptions options;
  options.network = "absent";
  const std::string error = errorOf([&] { loadNetwork(options); });
  EXPECT_NE(error.find("--name absent"), std::string::npos) << error;
  EXPECT_NE(error.find("'absent'"), std::string::npos) << error;
  options.network = "/nowhere/a.onnx";
  EXPECT_THROW(loadNetwork(options), Error);
}

TEST(LoadNetwork, RefusesFilesThatAreNotNetworks) {
  const std::string sound = SmallNetwork::onnx();
  EXPECT_EQ(errorIn(sound), "");
  expectRefused("", "not an ONNX file");
  expectRefused("\x89PNG\r\n", "not an ONNX file");
  expectRefused(sound.substr(0, sound.size() / 2), "not an ONNX file");
  expectRefused(networkOf(""), "no layers");
}

TEST(LoadNetwork, NamesTheLayerThatOpenCvDoesNotRun) {
  const std::string pool = SmallNetwork::node("pooled", "GlobalAveragePool", {"image"}, "mean", "");
  expectRefused(
      networkOf(pool + SmallNetwork::node("strange", "NoSuchOperator", {"mean"}, "odd", "") +
                SmallNetwork::node("after", "Relu", {"odd"}, "out", "")),
      "layer 'strange' (NoSuchOperator)");
  // Three channels, but weights for four.
  expectRefused(networkOf(SmallNetwork::node("mixing", "Conv", {"image", "w"}, "out",
                                             SmallNetwork::ints("kernel_shape", {1, 1})) +
                          SmallNetwork::tensor("w", {6, 4, 1, 1})),
                "layer 'mixing' (Conv)");
}

TEST(LoadNetwork, RefusesWhatWouldHarmOpenCv) {
  const auto conv = [](const std::string& attributes, const std::string& tensor) {
    return networkOf(SmallNetwork::node("c", "Conv", {"image", "w"}, "out", attributes) + tensor);
  };
  const std::string kernel = SmallNetwork::ints("kernel_shape", {3, 3});
  const std::string weights = SmallNetwork::tensor("w", {6, 3, 3, 3});
  EXPECT_EQ(errorIn(conv(kernel, weights)), "");
  expectRefused(conv(SmallNetwork::ints("kernel_shape", {0, 3}), weights), "out of range");
  expectRefused(conv(kernel + SmallNetwork::ints("strides", {0, 0}), weights), "out of range");
  expectRefused(conv(kernel + SmallNetwork::ints("pads", {1 << 30, 0, 0, 0}), weights),
                "out of range");
  expectRefused(conv(kernel, ""), "uses 'w', which nothing before it provides");
  // A shape that is larger than the data.
  std::string longer = weights;
  const std::string six = SmallNetwork::number(1, 6);
  longer.replace(longer.find(six), six.size(), SmallNetwork::number(1, 7));
  expectRefused(conv(kernel, longer), "has a length that does not match its shape");
  expectRefused(conv(kernel, SmallNetwork::tensor("w", {6, 0, 3, 3})), "an impossible shape");
  // 8192 x 8192 pixels between layers.
  expectRefused(conv(kernel + SmallNetwork::ints("pads", {8192, 8192, 8192, 8192}), weights),
                "more than 1 GiB");
}

TEST(LoadNetwork, RefusesToJoinConstantsAlongAnAxisThatTheyLack) {
  const auto joined = [](int axis) {
    return networkOf(SmallNetwork::node("join", "Concat", {"w", "w"}, "both",
                                        SmallNetwork::integer("axis", axis)) +
                     SmallNetwork::node("add", "Add", {"image", "both"}, "out", "") +
                     SmallNetwork::tensor("w", {1, 3, 8, 16}));
  };
  EXPECT_EQ(errorIn(joined(2)).find("'axis'"), std::string::npos);
  expectRefused(joined(9), "layer 'join' (Concat): 'axis' is out of range");
  expectRefused(joined(-2), "layer 'join' (Concat): 'axis' is out of range");
}

TEST(LoadNetwork, NamesTheLayerThatOpenCvDoesNotReadBehindOneThatCostsTooMuch) {
  // Running the first layer to find the second would take more than 1 GiB.
  const std::string wide = SmallNetwork::ints("kernel_shape", {3, 3}) +
                           SmallNetwork::ints("pads", {8192, 8192, 8192, 8192});
  expectRefused(networkOf(SmallNetwork::node("wide", "Conv", {"image", "w"}, "huge", wide) +
                          SmallNetwork::node("strange", "NoSuchOperator", {"huge"}, "out", "") +
                          SmallNetwork::tensor("w", {6, 3, 3, 3})),
                "layer 'strange' (NoSuchOperator)");
}

TEST(LoadNetwork, FollowsReshapingLayersToTheirEnd) {
  const auto node = SmallNetwork::node;
  for (const std::string& graph : {node("image", "Identity", {"image"}, "out", ""),
                                   node("", "Reshape", {"", "image"}, "out", ""),
                                   node("none", "Identity", {}, "nothing", "") +
                                       node("last", "Flatten", {"nothing", "image"}, "out", ""),
                                   node("mean", "GlobalAveragePool", {"image"}, "out", "")}) {
    OnnxGraph onnx(networkOf(graph));
    onnx.cutBehind("out");
    const std::size_t layers = onnx.layers();
    onnx.cutBeforePooling();
    EXPECT_EQ(onnx.layers(), layers);  // there is nothing before a pooling to keep
  }
}

TEST(LoadNetwork, RemovesAFinalMeanOverHeightAndWidthHoweverItsAxesAreWritten) {
  const auto layersLeft = [](const std::vector<int>& axes) {
    OnnxGraph onnx(networkOf(SmallNetwork::node("rectified", "Relu", {"image"}, "map", "") +
                             SmallNetwork::node("mean", "ReduceMean", {"map"}, "out",
                                                SmallNetwork::ints("axes", axes))));
    onnx.cutBehind("");
    onnx.cutBeforePooling();
    return onnx.layers();
  };
  for (const std::vector<int>& axes : {std::vector<int>{2, 3}, {-2, -1}, {3, 2}, {2, -1}}) {
    EXPECT_EQ(layersLeft(axes), 1u);
  }
  for (const std::vector<int>& axes : {std::vector<int>{1, 2}, {-1}, {1, 2, 3}}) {
    EXPECT_EQ(layersLeft(axes), 2u);
  }
}

TEST(LoadNetwork, RefusesWhatTakesNoSuchImages) {
  const std::string sound = SmallNetwork::onnx();
  EmbeddingOptions grey;
  grey.channels = "grey";
  expectRefused(sound, "3 channels", grey);
  EmbeddingOptions absent;
  absent.layer = "absent";
  expectRefused(sound, "its last layers are 'first' (Conv), 'rectified' (Relu), 'second' (Conv)",
                absent);
}

TEST(LoadNetwork, NamesTheStridesAndTheWidthThatItsLayersHave) {
  EmbeddingOptions options;
  options.stride = 8;
  expectRefused(SmallNetwork::onnx(), "it has no layer with 'stride: 8'; it has strides of 2, 4",
                options);
  options.stride = 0;
  options.columns = 5;
  expectRefused(SmallNetwork::onnx(), "its output is 4 wide, too narrow for 'columns: 5'", options);
}

}  // namespace
}  // namespace place_recognition
