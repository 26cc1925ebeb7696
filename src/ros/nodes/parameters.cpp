#include "ros/nodes/parameters.h"

#include <ros/console.h>
#include <ros/names.h>

#include <utility>

#include "base/contains.h"
#include "base/nearest_name.h"
#include "base/options.h"
#include "base/text.h"
#include "place_recognition/error.h"
#include "ros/nodes/parameter_value.h"

namespace place_recognition {
namespace {

using XmlRpc::XmlRpcValue;

/// Parameters that diagnostic_updater, image_transport, nodelet, tf2 and actionlib read below a
/// node's name.
const std::vector<std::string> kOfLibraries = {"diagnostic_period",
                                               "diagnostic_updater_use_fqn",
                                               "image_transport",
                                               "num_worker_threads",
                                               "tf_prefix",
                                               "actionlib_status_frequency",
                                               "actionlib_server_pub_queue_size",
                                               "actionlib_server_sub_queue_size"};

std::string where(const std::string& name) { return "The parameter ~" + name; }

std::string whereElement(const std::string& name, std::size_t i) {
  return where(name) + "[" + std::to_string(i) + "]";
}

template <typename Number>
void requireWithin(Number value, Number least, Number most, const std::string& name) {
  if (value >= least && value <= most) return;
  const auto format = [](Number number) { return shortest(static_cast<double>(number)); };
  const bool bounded = most < std::numeric_limits<Number>::max();
  throw Error(
      where(name) + " is " + format(value) + "; give a number " +
      (bounded ? "from " + format(least) + " to " + format(most) : "of at least " + format(least)) +
      ".");
}

/// The value of an argument `name:=value` of the node or nodelet, which ROS interprets as the new
/// name of a topic; empty if there is no such argument.
std::string remapped(const std::string& name, const ros::NodeHandle& private_node) {
  const std::string space = ros::names::parentNamespace(private_node.getNamespace());
  for (const std::string& from :
       {ros::names::append(space, name), ros::names::append(private_node.getNamespace(), name)}) {
    const std::string to = private_node.resolveName(from);
    if (to == from) continue;
    const bool is_below = space != "/" && startsWith(to, space + "/");
    return to.substr(is_below ? space.size() + 1 : 1);
  }
  return "";
}

XmlRpcValue valuesBelow(const ros::NodeHandle& private_node) {
  XmlRpcValue values;
  private_node.getParam("", values);
  return values;
}

}  // namespace

Parameters::Parameters(const ros::NodeHandle& private_node)
    : Parameters(private_node.getNamespace(), valuesBelow(private_node)) {
  private_node_ = private_node;
}

Parameters::Parameters(std::string node, XmlRpcValue values)
    : node_(std::move(node)), values_(std::move(values)) {}

const XmlRpcValue* Parameters::find(const std::string& name) {
  if (!contains(known_, name)) known_.push_back(name);
  const bool is_set = values_.getType() == XmlRpcValue::TypeStruct && values_.hasMember(name);
  return is_set ? &values_[name] : nullptr;
}

void Parameters::refuse(const std::string& name, const std::string& sentence) const {
  throw Error(sentence + " If an earlier launch left it, run: rosparam delete " +
              ros::names::append(node_, name) + ".");
}

template <typename Read>
auto Parameters::reading(const std::string& name, const Read& read) const -> decltype(read()) {
  try {
    return read();
  } catch (const Error& e) {
    refuse(name, e.what());
  }
}

bool Parameters::flag(const std::string& name, bool otherwise) {
  const XmlRpcValue* value = find(name);
  if (value == nullptr) return otherwise;
  return reading(name, [&] { return toFlag(*value, where(name)); });
}

int Parameters::integer(const std::string& name, int otherwise, int least, int most) {
  const XmlRpcValue* value = find(name);
  if (value == nullptr) return otherwise;
  return reading(name, [&] {
    const int number = toInteger(*value, where(name));
    requireWithin(number, least, most, name);
    return number;
  });
}

double Parameters::real(const std::string& name, double otherwise, double least, double most) {
  const XmlRpcValue* value = find(name);
  if (value == nullptr) return otherwise;
  return reading(name, [&] {
    const double number = toReal(*value, where(name));
    requireWithin(number, least, most, name);
    return number;
  });
}

std::string Parameters::text(const std::string& name, const std::string& otherwise) {
  const XmlRpcValue* value = find(name);
  if (value == nullptr) return otherwise;
  return reading(name, [&] { return toText(*value, where(name)); });
}

std::vector<std::string> Parameters::texts(const std::string& name) {
  std::vector<std::string> texts;
  const XmlRpcValue* value = find(name);
  if (value == nullptr) return texts;
  reading(name, [&] {
    for (const XmlRpcValue& element : toList(*value, where(name))) {
      texts.push_back(toText(element, whereElement(name, texts.size())));
    }
  });
  const bool is_single = value->getType() == XmlRpcValue::TypeString && texts.size() == 1 &&
                         texts[0] == static_cast<const std::string&>(*value);
  if (is_single && texts[0].find(',') != std::string::npos) {
    notes_.push_back(where(name) + " is the single name '" + texts[0] +
                     "'; for a list, write it in brackets: [" + texts[0] + "].");
  }
  return texts;
}

std::vector<int> Parameters::integers(const std::string& name) {
  std::vector<int> integers;
  const XmlRpcValue* value = find(name);
  if (value == nullptr) return integers;
  reading(name, [&] {
    for (const XmlRpcValue& element : toList(*value, where(name))) {
      integers.push_back(toInteger(element, whereElement(name, integers.size())));
    }
  });
  return integers;
}

std::vector<double> Parameters::reals(const std::string& name, double least, double most) {
  std::vector<double> reals;
  const XmlRpcValue* value = find(name);
  if (value == nullptr) return reals;
  reading(name, [&] {
    for (const XmlRpcValue& element : toList(*value, where(name))) {
      reals.push_back(toReal(element, whereElement(name, reals.size())));
      requireWithin(reals.back(), least, most, name);
    }
  });
  return reals;
}

std::string Parameters::meantBy(const std::string& name, const XmlRpcValue& value) const {
  if (value.getType() != XmlRpcValue::TypeStruct) return nearestName(name, known_);
  // A mapping is the namespace of another node or of a library, or was indented too far.
  for (const std::string& known : known_) {
    if (value.hasMember(known)) return known;
  }
  return "";
}

std::vector<std::string> Parameters::doubts() const {
  std::vector<std::string> sentences = notes_;
  if (values_.getType() == XmlRpcValue::TypeStruct) {
    XmlRpcValue values = values_;  // only non-const values can be iterated
    for (const auto& [name, value] : values) {
      if (contains(known_, name) || contains(kOfLibraries, name)) continue;
      const std::string meant = meantBy(name, value);
      if (meant.empty() && value.getType() == XmlRpcValue::TypeStruct) continue;
      sentences.push_back(where(name) + " of " + node_ + " is not known and has no effect; " +
                          (meant.empty() ? "known are ~" + listed(known_, ", ~") + "."
                                         : "did you mean ~" + meant + "?"));
    }
  }
  for (const std::string& name : known_) {
    const std::string value = private_node_ ? remapped(name, *private_node_) : "";
    if (value.empty()) continue;
    sentences.push_back("The argument " + name + ":=" + value + " sets no parameter of " + node_ +
                        "; write _" + name + ":=" + value + ".");
  }
  return sentences;
}

void Parameters::warnOfDoubts() const {
  for (const std::string& sentence : doubts()) ROS_WARN("%s", sentence.c_str());
}

}  // namespace place_recognition
