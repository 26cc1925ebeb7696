#pragma once

#include <ros/node_handle.h>
#include <xmlrpcpp/XmlRpcValue.h>

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace place_recognition {

/// The private parameters of a node at the time of construction. All nodes read their parameters
/// here. Each function returns the parameter ~name or, if it is not set, `otherwise`. A value
/// without a sensible interpretation (parameter_value.h) or out of range throws Error, which names
/// the parameter, its value and what is expected. Not thread-safe.
class Parameters {
 public:
  /// Requests all parameters below the namespace of `private_node` from the master.
  explicit Parameters(const ros::NodeHandle& private_node);
  /// `values`: a mapping of parameter names. `node`: for messages.
  Parameters(std::string node, XmlRpc::XmlRpcValue values);

  bool flag(const std::string& name, bool otherwise);
  int integer(const std::string& name, int otherwise, int least = std::numeric_limits<int>::min(),
              int most = std::numeric_limits<int>::max());
  double real(const std::string& name, double otherwise,
              double least = std::numeric_limits<double>::lowest(),
              double most = std::numeric_limits<double>::max());
  std::string text(const std::string& name, const std::string& otherwise = "");

  /// A list; a single value stands for a list of one, and no value for an empty one.
  std::vector<std::string> texts(const std::string& name);
  std::vector<int> integers(const std::string& name);
  std::vector<double> reals(const std::string& name, double least, double most);

  /// Throws Error: `sentence`, which says why ~name cannot be used, and how to delete the parameter
  /// if an earlier launch left it on the parameter server. The functions above do so as well.
  [[noreturn]] void refuse(const std::string& name, const std::string& sentence) const;

  /// One sentence for everything that may not be what a person meant: each parameter that is set
  /// but not read by any function above, with the name that may be meant, except for those of the
  /// libraries in use; each argument `name:=value` of the program or nodelet that remaps a topic
  /// named like a parameter, which should be `_name:=value`; and each single name with commas if a
  /// list is expected.
  std::vector<std::string> doubts() const;

  /// Logs doubts() as warnings.
  void warnOfDoubts() const;

 private:
  /// Null if the parameter is not set.
  const XmlRpc::XmlRpcValue* find(const std::string& name);
  /// Returns `read()`; its errors are about ~name, see refuse().
  template <typename Read>
  auto reading(const std::string& name, const Read& read) const -> decltype(read());
  /// The known name of which the unknown one may be a misspelling; empty if none.
  std::string meantBy(const std::string& name, const XmlRpc::XmlRpcValue& value) const;

  std::optional<ros::NodeHandle> private_node_;
  std::string node_;
  XmlRpc::XmlRpcValue values_;
  std::vector<std::string> known_;  // names read so far
  std::vector<std::string> notes_;
};

}  // namespace place_recognition
