#include "recognition/message_entries.h"

#include <google/protobuf/io/coded_stream.h>

#include <cstdint>

#include "model.pb.h"

namespace place_recognition {
namespace {

using google::protobuf::io::CodedInputStream;

/// More than a command line can name runs; 20 MB once parsed.
constexpr std::uint64_t kMaxEntries = 100000;

/// As the encoding of protobuf numbers them.
enum WireType { kVarint = 0, kFixed64 = 1, kLengthDelimited = 2, kFixed32 = 5 };

bool skipValue(CodedInputStream& input, int wire_type) {
  std::uint64_t ignored = 0;
  switch (wire_type) {
    case kVarint:
      return input.ReadVarint64(&ignored);
    case kFixed64:
      return input.Skip(8);
    case kFixed32:
      return input.Skip(4);
    default:  // groups, which no model has
      return false;
  }
}

/// Adds to `entries` those of the message up to the end of `input`, down through the provenance;
/// false if it is not well-formed.
bool count(CodedInputStream& input, bool in_provenance, std::uint64_t& entries) {
  while (const std::uint32_t tag = input.ReadTag()) {
    const int field = static_cast<int>(tag >> 3), wire_type = tag & 7;
    if (wire_type != kLengthDelimited) {
      if (!skipValue(input, wire_type)) return false;
      continue;
    }
    int length = 0;
    if (!input.ReadVarintSizeAsInt(&length)) return false;
    if (!in_provenance && field == proto::Model::kProvenanceFieldNumber) {
      const CodedInputStream::Limit limit = input.PushLimit(length);
      if (!count(input, true, entries)) return false;
      input.PopLimit(limit);
      continue;
    }
    entries += in_provenance ? field == proto::Provenance::kInputsFieldNumber
                             : field == proto::Model::kPlacesFieldNumber ||
                                   field == proto::Model::kClassifiersFieldNumber;
    if (!input.Skip(length)) return false;
  }
  return input.ConsumedEntireMessage();
}

}  // namespace

bool hasFewEntries(std::string_view payload) {
  CodedInputStream input(reinterpret_cast<const std::uint8_t*>(payload.data()),
                         static_cast<int>(payload.size()));
  std::uint64_t entries = 0;
  return count(input, false, entries) && entries <= kMaxEntries;
}

}  // namespace place_recognition
