#pragma once

#include <cstddef>
#include <string>

namespace place_recognition::tool {

/// Whether `source` is something to download: http, https or ftp.
bool isUrl(const std::string& source);

/// What `curl` gets from `url`, at most `limit` bytes. Throws Error, saying why, if that is
/// nothing. `progress`: as the option of that name; a line on standard error while it lasts.
std::string download(const std::string& url, std::size_t limit, const std::string& progress);

}  // namespace place_recognition::tool
