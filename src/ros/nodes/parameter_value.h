#pragma once

#include <xmlrpcpp/XmlRpcValue.h>

#include <string>
#include <vector>

namespace place_recognition {

// Interprets a parameter's value as a person meant it, however it was written: launch files,
// rosparam and rosrun's `_name:=value` guess a type (101 becomes a number, on a truth value), and
// rosrun cannot read lists. A value without a sensible interpretation throws Error, which says what
// `where` (such as "The parameter ~lazy") is and what is expected.

/// A truth value, 0 or 1, or one of the words true, false, yes, no, on, off.
bool toFlag(const XmlRpc::XmlRpcValue& value, const std::string& where);

/// An integer, also written as 4.0 or "4".
int toInteger(const XmlRpc::XmlRpcValue& value, const std::string& where);

/// A finite number, also written as text.
double toReal(const XmlRpc::XmlRpcValue& value, const std::string& where);

/// Text, or a number in its shortest form.
std::string toText(const XmlRpc::XmlRpcValue& value, const std::string& where);

/// The elements of a list. Text that is a YAML list ("[kitchen, 101]") is read as such, with each
/// element as text. Other text, if not empty, and any other value is the only element.
std::vector<XmlRpc::XmlRpcValue> toList(const XmlRpc::XmlRpcValue& value, const std::string& where);

}  // namespace place_recognition
