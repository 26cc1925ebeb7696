#include "recognition/vectors_message.h"

#include <cmath>
#include <cstdint>
#include <limits>

#include "place_recognition/error.h"

namespace place_recognition {
namespace {

using proto::Vectors;

// One overload for each alternative of FeatureOptions.
VectorForm formOf(const CrfhOptions&) { return {Vectors::SPARSE}; }
VectorForm formOf(const LocalFeatureOptions&) { return {Vectors::DESCRIPTORS}; }
VectorForm formOf(const Mr8Options&) { return {Vectors::SPARSE}; }
VectorForm formOf(const LbpOptions& options) {
  std::size_t dimension = 0;
  for (const LbpCircle& circle : options.circles) {
    dimension += static_cast<std::size_t>(circle.points) + 2;
  }
  return {Vectors::DENSE, dimension};
}

/// Seven bits a byte, the lowest first; the top bit says that more follow.
void appendVarint(std::string& bytes, std::uint64_t value) {
  for (; value >= 0x80; value >>= 7) bytes += static_cast<char>(value | 0x80);
  bytes += static_cast<char>(value);
}

/// Reads the varints of `bytes` one by one.
class VarintReader {
 public:
  explicit VarintReader(const std::string& bytes) : bytes_(bytes) {}

  std::uint64_t next() {
    std::uint64_t value = 0;
    for (int shift = 0; shift < 64 && position_ < bytes_.size(); shift += 7) {
      const std::uint64_t byte = static_cast<unsigned char>(bytes_[position_++]);
      if (shift == 63 && byte > 1) break;
      value |= (byte & 0x7f) << shift;
      if (byte < 0x80) return value;
    }
    throw Error("the indices of the support vectors are cut or too large");
  }

  bool atEnd() const { return position_ == bytes_.size(); }

 private:
  const std::string& bytes_;
  std::size_t position_ = 0;
};

void append(const SparseVector& vector, Vectors& message) {
  std::uint64_t previous = 0;
  for (const std::uint64_t index : vector.indices) {
    appendVarint(*message.mutable_index_steps(), index - previous);
    previous = index;
  }
  message.mutable_values()->Add(vector.values.begin(), vector.values.end());
  message.add_sizes(static_cast<std::uint32_t>(vector.size()));
}

void append(const DenseVector& vector, Vectors& message) {
  message.mutable_values()->Add(vector.values.begin(), vector.values.end());
  message.add_sizes(static_cast<std::uint32_t>(vector.values.size()));
}

void append(const DescriptorSet& set, Vectors& message) {
  message.mutable_descriptors()->append(set.descriptors.begin(), set.descriptors.end());
  message.add_sizes(static_cast<std::uint32_t>(set.size()));
}

void append(std::monostate, Vectors&) {
  throw Error("A support vector is missing; this is a mistake of the program, please report it.");
}

SparseVector sparseVector(const float* values, std::uint32_t size, VarintReader& steps) {
  SparseVector vector;
  vector.values.assign(values, values + size);
  vector.indices.reserve(size);
  std::uint64_t index = 0;
  for (std::uint32_t i = 0; i < size; ++i) {
    const std::uint64_t step = steps.next();
    const bool ascending = i == 0 || step > 0;
    if (!ascending || step > std::numeric_limits<std::uint64_t>::max() - index) {
      throw Error("the indices of a support vector do not ascend");
    }
    vector.indices.push_back(index += step);
    if (values[i] == 0) throw Error("a support vector holds a zero element");
  }
  return vector;
}

/// That the sizes of the parts add up to what is there, before anything is allocated for them.
void requireSizesFit(const Vectors& message, const VectorForm& form) {
  std::uint64_t total = 0;
  for (const std::uint32_t size : message.sizes()) {
    if (size == 0) throw Error("a support vector is empty");
    if (form.kind == Vectors::DENSE && size != form.dimension) {
      throw Error("a support vector has not the dimension of the extractor's");
    }
    total += size;
  }
  const bool local = form.kind == Vectors::DESCRIPTORS;
  const std::uint64_t descriptor_bytes = local ? total * DescriptorSet::kDimension : 0;
  if (static_cast<std::uint64_t>(message.values_size()) != (local ? 0 : total) ||
      message.descriptors().size() != descriptor_bytes) {
    throw Error("the sizes of the support vectors do not add up");
  }
}

void requireFinite(const Vectors& message) {
  for (const float value : message.values()) {
    if (!std::isfinite(value)) throw Error("a support vector holds a number that is not finite");
  }
}

}  // namespace

VectorForm vectorForm(const FeatureOptions& options) {
  return std::visit([](const auto& feature) { return formOf(feature); }, options);
}

proto::Vectors toMessage(const std::vector<Feature>& features, proto::Vectors::Kind kind) {
  Vectors message;
  message.set_kind(kind);
  for (const Feature& feature : features) {
    std::visit([&message](const auto& vector) { append(vector, message); }, feature);
  }
  return message;
}

std::vector<Feature> fromMessage(const proto::Vectors& message, const VectorForm& form) {
  if (message.kind() != form.kind) {
    throw Error("the support vectors are not what the extractor gives");
  }
  requireSizesFit(message, form);
  requireFinite(message);

  std::vector<Feature> features;
  features.reserve(static_cast<std::size_t>(message.sizes_size()));
  VarintReader steps(message.index_steps());
  const float* values = message.values().data();
  const char* descriptors = message.descriptors().data();
  for (const std::uint32_t size : message.sizes()) {
    if (form.kind == Vectors::SPARSE) {
      features.emplace_back(sparseVector(values, size, steps));
      values += size;
    } else if (form.kind == Vectors::DENSE) {
      features.emplace_back(DenseVector{{values, values + size}});
      values += size;
    } else {
      const char* end = descriptors + std::size_t{size} * DescriptorSet::kDimension;
      features.emplace_back(DescriptorSet{{descriptors, end}});
      descriptors = end;
    }
  }
  if (!steps.atEnd()) throw Error("there are more indices than support vectors");
  return features;
}

}  // namespace place_recognition
