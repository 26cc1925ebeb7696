#pragma once

#include <ros/message_traits.h>
#include <ros/serialization.h>

#include <cstdint>
#include <string>
#include <vector>

namespace place_recognition {

/// A field of a message: one value, or the values of a list.
struct MessageField {
  std::string type;  ///< "string", "bool", "uint32" or "float64"; for a list, of its elements
  std::string name;
  std::vector<std::string> values;  ///< text unchanged, numbers in decimal, bool as 0 or 1
};

using MessageBytes = std::vector<std::uint8_t>;

template <typename Message>
MessageBytes serialized(const Message& message) {
  MessageBytes bytes(ros::serialization::serializationLength(message));
  ros::serialization::OStream stream(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  ros::serialization::serialize(stream, message);
  return bytes;
}

/// The fields of a message with this `definition` (the text of its .msg file), in order. They must
/// be strings, bools, uint32, float64, or lists of these (asserted).
std::vector<MessageField> fieldsOf(const std::string& definition, MessageBytes bytes);

template <typename Message>
std::vector<MessageField> fieldsOf(const Message& message) {
  return fieldsOf(ros::message_traits::Definition<Message>::value(), serialized(message));
}

/// The message of type To with the fields of `from`, which must be of the same types and in the
/// same order.
template <typename To, typename From>
To sameFields(const From& from) {
  To to;
  MessageBytes bytes = serialized(from);
  ros::serialization::IStream stream(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  ros::serialization::deserialize(stream, to);
  return to;
}

}  // namespace place_recognition
