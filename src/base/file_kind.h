#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace place_recognition {

/// A kind of file that people pass by mistake.
struct FileKind {
  std::string_view name;    ///< as in "it is NAME"
  std::string_view remedy;  ///< what to do, in the imperative
};

/// The first 512 bytes of a file; fewer if it is shorter, and none if it is not a regular file or
/// cannot be read.
std::string startOfFile(const std::string& path);

/// Identifies a file of the wrong kind by its first bytes (64 are enough); nullptr if the kind is
/// not known.
const FileKind* foreignFile(std::string_view start);

}  // namespace place_recognition
