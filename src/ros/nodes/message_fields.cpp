#include "ros/nodes/message_fields.h"

#include <cassert>
#include <sstream>

#include "base/text.h"

namespace place_recognition {
namespace {

using Stream = ros::serialization::IStream;

std::string readValue(const std::string& type, Stream& stream) {
  if (type == "string") {
    std::string text;
    stream.next(text);
    return text;
  }
  if (type == "bool") {
    std::uint8_t flag = 0;
    stream.next(flag);
    return std::to_string(flag);
  }
  if (type == "float64") {
    double number = 0;
    stream.next(number);
    return significant(number, 15);
  }
  assert(type == "uint32");
  std::uint32_t number = 0;
  stream.next(number);
  return std::to_string(number);
}

MessageField readField(std::string type, const std::string& name, Stream& stream) {
  std::uint32_t count = 1;
  const std::size_t bracket = type.find("[]");
  if (bracket != std::string::npos) {
    type.resize(bracket);
    stream.next(count);
  }
  MessageField field{type, name, {}};
  for (std::uint32_t i = 0; i < count; ++i) field.values.push_back(readValue(type, stream));
  return field;
}

}  // namespace

std::vector<MessageField> fieldsOf(const std::string& definition, MessageBytes bytes) {
  Stream stream(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  std::vector<MessageField> fields;
  std::istringstream lines(definition);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line.substr(0, line.find('#')));
    std::string type, name;
    if (words >> type >> name) fields.push_back(readField(type, name, stream));
  }
  assert(stream.getLength() == 0);
  return fields;
}

}  // namespace place_recognition
