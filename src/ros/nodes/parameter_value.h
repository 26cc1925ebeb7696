#pragma once

#include <xmlrpcpp/XmlRpcValue.h>

#include <string>
#include <vector>

namespace place_recognition {

// What a person meant by a parameter's value, whichever way it was written: launch files, rosparam
// and rosrun's `_name:=value` guess a type (101 becomes a number, on a truth value), and rosrun
// reads no list at all. A value that cannot be meant throws Error, which says what `where` (as in
// "The parameter ~lazy") is and what is wanted.

/// A truth value, 0 or 1, or one of the words true, false, yes, no, on, off.
bool toFlag(const XmlRpc::XmlRpcValue& value, const std::string& where);

/// A whole number, also as 4.0 or "4".
int toInteger(const XmlRpc::XmlRpcValue& value, const std::string& where);

/// A finite number, whole or not, also as text.
double toReal(const XmlRpc::XmlRpcValue& value, const std::string& where);

/// Text, or a number in its shortest form.
std::string toText(const XmlRpc::XmlRpcValue& value, const std::string& where);

/// The elements of a list. Text that is a YAML list ("[kitchen, 101]") is read as such, each
/// element as the text that it is; other text, if it is not empty, and any other value is the only
/// element.
std::vector<XmlRpc::XmlRpcValue> toList(const XmlRpc::XmlRpcValue& value, const std::string& where);

}  // namespace place_recognition
