#pragma once

#include <string_view>

namespace place_recognition {

/// A kind of file that people give by mistake.
struct FileKind {
  std::string_view name;    ///< as in "it is NAME"
  std::string_view remedy;  ///< what to do, as an imperative
};

/// What a file is that is not what it was taken for, by its first bytes (64 are enough); nullptr if
/// it is nothing that is known.
const FileKind* foreignFile(std::string_view start);

}  // namespace place_recognition
