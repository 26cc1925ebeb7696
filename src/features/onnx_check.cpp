#include "features/onnx_check.h"

#include <cstdint>
#include <map>
#include <set>

#include "base/data_folder.h"
#include "base/require.h"
#include "base/text.h"

namespace place_recognition {
namespace {

constexpr int kMaxLayers = 10000;
constexpr std::int64_t kMaxElements = std::int64_t{1} << 28;
constexpr std::int64_t kMaxStep = 8192;  // of strides and similar attributes, pixels

/// The number of dimensions of each constant.
using Ranks = std::map<std::string, int>;

/// The types of elements, with the numbers of ONNX.
enum ElementType { kFloat = 1, kUint8, kInt8, kInt32 = 6, kInt64, kBool = 9, kHalf, kDouble };

std::size_t bytesOf(int element_type) {
  switch (element_type) {
    case kUint8:
    case kInt8:
    case kBool:
      return 1;
    case kHalf:
      return 2;
    case kFloat:
    case kInt32:
      return 4;
    case kInt64:
    case kDouble:
      return 8;
    default:
      return 0;
  }
}

/// Number of elements that are listed by type instead of stored as raw bytes.
int listedElements(const onnx::Tensor& tensor) {
  switch (tensor.data_type()) {
    case kFloat:
      return tensor.float_data_size();
    case kInt64:
      return tensor.int64_data_size();
    case kDouble:
      return tensor.double_data_size();
    default:
      return tensor.int32_data_size();
  }
}

void checkTensor(const onnx::Tensor& tensor, const std::string& of) {
  require(tensor.external_data_size() == 0, of + " is stored in another file");
  const std::size_t element_bytes = bytesOf(tensor.data_type());
  require(element_bytes > 0, of + " has an unknown type");
  // OpenCV divides by the sides of weights. An empty list of numbers is common, as of axes.
  const std::int64_t least = tensor.dims_size() > 1 ? 1 : 0;
  std::int64_t elements = 1;
  for (const std::int64_t dim : tensor.dims()) {
    require(dim >= least && dim <= kMaxElements, of + " has an impossible shape");
    elements *= dim;
    require(elements <= kMaxElements, of + " is too large");
  }
  const bool fits = tensor.has_raw_data()
                        ? tensor.raw_data().size() == element_bytes * elements
                        : static_cast<std::int64_t>(listedElements(tensor)) == elements;
  require(fits, of + " has a length that does not match its shape");
}

/// OpenCV divides by some of these, so they must not be zero.
void checkSteps(const onnx::Attribute& attribute, const std::string& of) {
  const std::string& name = attribute.name();
  const bool is_step = name == "strides" || name == "dilations" || name == "kernel_shape";
  if (!is_step && name != "pads") return;
  for (const std::int64_t step : attribute.ints()) {
    require(step >= (is_step ? 1 : 0) && step <= kMaxStep, of + ": '" + name + "' is out of range");
  }
}

/// OpenCV joins constants when it reads a network, and writes beyond them if the axis is negative
/// or missing.
void checkConcat(const onnx::Node& node, const Ranks& constants) {
  if (node.op_type() != "Concat") return;
  for (const onnx::Attribute& attribute : node.attribute()) {
    if (attribute.name() != "axis") continue;
    for (const std::string& input : node.input()) {
      const auto constant = constants.find(input);
      if (constant == constants.end()) continue;
      require(attribute.i() >= 0 && attribute.i() < constant->second,
              "layer " + describe(node) + ": 'axis' is out of range");
    }
  }
}

void checkAttributes(const onnx::Node& node) {
  const std::string of = "layer " + describe(node);
  for (const onnx::Attribute& attribute : node.attribute()) {
    require(!attribute.has_g() && attribute.graphs_size() == 0,
            of + " contains a graph of its own");
    if (attribute.has_t()) checkTensor(attribute.t(), of + ": its tensor");
    for (const onnx::Tensor& tensor : attribute.tensors()) checkTensor(tensor, of + ": its tensor");
    checkSteps(attribute, of);
    if (attribute.name() == "group") {
      require(attribute.i() >= 1 && attribute.i() <= kMaxElements,
              of + ": 'group' is out of range");
    }
  }
}

}  // namespace

std::string describe(const onnx::Node& node) {
  const std::string name =
      node.name().empty() && node.output_size() > 0 ? node.output(0) : node.name();
  return inQuotes(name) + " (" + inQuotes(node.op_type()).substr(1, node.op_type().size()) + ")";
}

void checkGraph(const onnx::Graph& graph) {
  require(graph.node_size() > 0, "it has no layers");
  require(graph.node_size() <= kMaxLayers, "it has too many layers");
  std::set<std::string> known;
  Ranks constants;
  for (const onnx::Tensor& tensor : graph.initializer()) {
    checkTensor(tensor, "the tensor " + inQuotes(tensor.name()));
    known.insert(tensor.name());
    constants[tensor.name()] = tensor.dims_size();
  }
  for (const onnx::ValueInfo& input : graph.input()) known.insert(input.name());
  for (const onnx::Node& node : graph.node()) {
    for (const std::string& input : node.input()) {
      require(input.empty() || known.count(input) > 0, "layer " + describe(node) + " uses " +
                                                           inQuotes(input) +
                                                           ", which nothing before it provides");
    }
    require(node.output_size() > 0, "layer " + describe(node) + " has no output");
    known.insert(node.output().begin(), node.output().end());
    checkAttributes(node);
    checkConcat(node, constants);
    for (const onnx::Attribute& attribute : node.attribute()) {
      if (attribute.has_t()) constants[node.output(0)] = attribute.t().dims_size();
    }
  }
}

}  // namespace place_recognition
