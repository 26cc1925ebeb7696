#pragma once

#include <string_view>

namespace place_recognition {

/// A kind of file that people pass by mistake.
struct FileKind {
  std::string_view name;    ///< as in "it is NAME"
  std::string_view remedy;  ///< what to do, in the imperative
};

/// Identifies a file of the wrong kind by its first bytes (64 are enough); nullptr if the kind is
/// not known.
const FileKind* foreignFile(std::string_view start);

}  // namespace place_recognition
