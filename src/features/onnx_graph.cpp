#include "features/onnx_graph.h"

#include <algorithm>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

#include "base/contains.h"
#include "base/data_folder.h"
#include "base/require.h"
#include "base/text.h"
#include "features/onnx_check.h"
#include "onnx.pb.h"

namespace place_recognition {
namespace {

using Names = std::set<std::string>;

constexpr int kMaxSide = 8192;  // of an image, pixels
constexpr int kFloat = 1;       // a type of elements, with the number of ONNX

/// The node with this name, or with an output of this name; -1 if there is none.
int findNode(const onnx::Graph& graph, const std::string& layer) {
  for (int i = graph.node_size() - 1; i >= 0; --i) {
    const onnx::Node& node = graph.node(i);
    if (node.name() == layer || contains(node.output(), layer)) {
      return i;
    }
  }
  return -1;
}

bool averagesArea(const onnx::Node& node) {
  if (node.op_type() == "GlobalAveragePool") return true;
  if (node.op_type() != "ReduceMean") return false;
  const auto& attributes = node.attribute();
  return std::any_of(attributes.begin(), attributes.end(), [](const onnx::Attribute& attribute) {
    std::set<std::int64_t> axes;  // negative ones count from the end of 1 x values x height x width
    for (const std::int64_t axis : attribute.ints()) axes.insert(axis < 0 ? axis + 4 : axis);
    return attribute.name() == "axes" && axes == std::set<std::int64_t>{2, 3};
  });
}

bool reshapes(const onnx::Node& node) {
  static const Names kTypes{"Flatten", "Reshape", "Squeeze", "Identity", "Dropout"};
  return kTypes.count(node.op_type()) > 0;
}

/// The node before `i` that provides the first input of `i`; -1 if there is none.
int findSource(const onnx::Graph& graph, int i) {
  if (graph.node(i).input_size() == 0) return -1;
  const std::string& input = graph.node(i).input(0);
  while (--i >= 0) {
    if (contains(graph.node(i).output(), input)) break;
  }
  return i;
}

std::string lastLayers(const onnx::Graph& graph) {
  std::string names;
  for (int i = std::max(0, graph.node_size() - 5); i < graph.node_size(); ++i) {
    names += (names.empty() ? "" : ", ") + describe(graph.node(i));
  }
  return names;
}

/// Keeps, in order, the elements that satisfy `keep`.
template <typename Repeated, typename Predicate>
void keepOnly(Repeated& elements, const Predicate& keep) {
  int kept = 0;
  for (int i = 0; i < elements.size(); ++i) {
    if (!keep(elements.Get(i))) continue;
    if (kept != i) elements.SwapElements(kept, i);
    ++kept;
  }
  elements.DeleteSubrange(kept, elements.size() - kept);
}

/// The names that the last node needs, directly or indirectly; removes all other nodes.
Names keepNeeded(onnx::Graph& graph) {
  Names needed;
  std::vector<bool> keep(static_cast<std::size_t>(graph.node_size()));
  for (int i = graph.node_size() - 1; i >= 0; --i) {
    const onnx::Node& node = graph.node(i);
    const bool used =
        i + 1 == graph.node_size() ||
        std::any_of(node.output().begin(), node.output().end(),
                    [&](const std::string& output) { return needed.count(output) > 0; });
    keep[static_cast<std::size_t>(i)] = used;
    if (used) needed.insert(node.input().begin(), node.input().end());
  }
  std::size_t next = 0;
  keepOnly(*graph.mutable_node(), [&](const onnx::Node&) { return keep[next++]; });
  return needed;
}

void setOnlyOutput(const std::string& name, onnx::Graph& graph) {
  graph.clear_output();
  onnx::ValueInfo& output = *graph.add_output();
  output.set_name(name);
  onnx::TensorType& type = *output.mutable_type()->mutable_tensor_type();
  type.set_elem_type(kFloat);
  type.mutable_shape();  // OpenCV requires one, and determines it by itself
}

void requireOneInput(const onnx::Graph& graph) {
  require(graph.input_size() == 1,
          "it takes " + std::to_string(graph.input_size()) + " inputs instead of one image");
}

/// Makes the first output of a node the only output, and removes what it does not need.
void cutBehindNode(int last, onnx::Graph& graph) {
  graph.mutable_node()->DeleteSubrange(last + 1, graph.node_size() - last - 1);
  setOnlyOutput(std::string(graph.node(last).output(0)), graph);

  const Names needed = keepNeeded(graph);
  const auto is_needed = [&](const auto& element) { return needed.count(element.name()) > 0; };
  keepOnly(*graph.mutable_initializer(), is_needed);
  Names constants;
  for (const onnx::Tensor& tensor : graph.initializer()) constants.insert(tensor.name());
  keepOnly(*graph.mutable_input(), [&](const onnx::ValueInfo& input) {
    return is_needed(input) && constants.count(input.name()) == 0;
  });
  graph.clear_value_info();
  requireOneInput(graph);
}

}  // namespace

OnnxGraph::OnnxGraph(const std::string& bytes) : model_(std::make_unique<onnx::Model>()) {
  require(model_->ParseFromString(bytes) && model_->has_graph(), "it is not an ONNX file");
  checkGraph(model_->graph());
}

OnnxGraph::~OnnxGraph() = default;

void OnnxGraph::cutBehind(const std::string& layer) {
  onnx::Graph& graph = *model_->mutable_graph();
  require(!layer.empty() || graph.output_size() == 1,
          "it has " + std::to_string(graph.output_size()) + " outputs; name one as 'layer'");
  const std::string wanted = layer.empty() ? graph.output(0).name() : layer;
  const int last = findNode(graph, wanted);
  require(last >= 0,
          "it has no layer " + inQuotes(wanted) + "; its last layers are " + lastLayers(graph));
  const std::string& output = graph.node(last).output(0);
  require(wanted == output || wanted == graph.node(last).name(),
          "only the first output of layer " + describe(graph.node(last)) + " can be used");
  cutBehindNode(last, graph);
}

void OnnxGraph::cutBeforePooling() {
  onnx::Graph& graph = *model_->mutable_graph();
  int i = graph.node_size() - 1;
  while (i >= 0 && reshapes(graph.node(i))) i = findSource(graph, i);
  if (i < 0 || !averagesArea(graph.node(i))) return;
  const int source = findSource(graph, i);
  if (source >= 0 && graph.node(source).output(0) == graph.node(i).input(0)) {
    cutBehindNode(source, graph);
  }
}

NetworkInput OnnxGraph::input() const {
  requireOneInput(model_->graph());
  const onnx::ValueInfo& input = model_->graph().input(0);
  const onnx::Shape& shape = input.type().tensor_type().shape();
  require(shape.dim_size() == 4,
          "its input " + inQuotes(input.name()) +
              " does not have the shape of an image, 1 x channels x height x "
              "width");
  std::vector<int> sides;
  for (const onnx::Dimension& dim : shape.dim()) {
    require(dim.dim_value() <= kMaxSide, "its input " + inQuotes(input.name()) + " is too large");
    sides.push_back(static_cast<int>(std::max<std::int64_t>(dim.dim_value(), 0)));
  }
  require(sides[0] <= 1, "it takes " + std::to_string(sides[0]) + " images at a time");
  return {sides[1], sides[2], sides[3]};
}

void OnnxGraph::setInput(const NetworkInput& input) {
  onnx::TensorType& type =
      *model_->mutable_graph()->mutable_input(0)->mutable_type()->mutable_tensor_type();
  type.clear_shape();
  for (const int side : {1, input.channels, input.height, input.width}) {
    type.mutable_shape()->add_dim()->set_dim_value(side);
  }
}

std::size_t OnnxGraph::layers() const {
  return static_cast<std::size_t>(model_->graph().node_size());
}

std::string OnnxGraph::describeLayer(std::size_t i) const {
  return describe(model_->graph().node(static_cast<int>(i)));
}

std::string OnnxGraph::firstLayers(std::size_t count) const {
  onnx::Model part = *model_;
  onnx::Graph& graph = *part.mutable_graph();
  const int first_dropped = static_cast<int>(count);
  graph.mutable_node()->DeleteSubrange(first_dropped, graph.node_size() - first_dropped);
  setOnlyOutput(graph.node(first_dropped - 1).output(0), graph);
  return part.SerializeAsString();
}

std::string OnnxGraph::bytes() const { return model_->SerializeAsString(); }

}  // namespace place_recognition
