#pragma once

#include <ros/node_handle.h>
#include <xmlrpcpp/XmlRpcValue.h>

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace place_recognition {

/// The private parameters of a node, as they are when this is made. All nodes read theirs here.
/// Each function returns the parameter ~name or, if it is not set, `otherwise`; a value that cannot
/// be meant (parameter_value.h) or lies out of its limits throws Error, which names the parameter,
/// what it is and what is wanted. Not thread-safe.
class Parameters {
 public:
  /// Asks the master for all parameters below the namespace of `private_node`.
  explicit Parameters(const ros::NodeHandle& private_node);
  /// `values`: a mapping of the parameters' names. `node`: for messages.
  Parameters(std::string node, XmlRpc::XmlRpcValue values);

  bool flag(const std::string& name, bool otherwise);
  int integer(const std::string& name, int otherwise, int least = std::numeric_limits<int>::min(),
              int most = std::numeric_limits<int>::max());
  double real(const std::string& name, double otherwise,
              double least = std::numeric_limits<double>::lowest(),
              double most = std::numeric_limits<double>::max());
  std::string text(const std::string& name, const std::string& otherwise = "");

  /// A list; a single value stands for a list of one, and nothing for an empty one.
  std::vector<std::string> texts(const std::string& name);
  std::vector<int> integers(const std::string& name);
  std::vector<double> reals(const std::string& name, double least, double most);

  /// A sentence for all that a person may have meant otherwise: each parameter that is set but that
  /// no function above was asked for, with the name that may be meant, but for those that belong to
  /// the libraries in use; each argument `name:=value` of the program or nodelet that remaps a
  /// topic by the name of a parameter, which is to be `_name:=value`; and each single name with
  /// commas where a list is wanted.
  std::vector<std::string> doubts() const;

  /// Logs doubts() as warnings.
  void warnOfDoubts() const;

 private:
  /// Null: it is not set.
  const XmlRpc::XmlRpcValue* find(const std::string& name);
  /// The known name that the unknown one may stand for; empty: none.
  std::string meantBy(const std::string& name, const XmlRpc::XmlRpcValue& value) const;

  std::optional<ros::NodeHandle> private_node_;
  std::string node_;
  XmlRpc::XmlRpcValue values_;
  std::vector<std::string> known_;  // those asked for
  std::vector<std::string> notes_;
};

}  // namespace place_recognition
