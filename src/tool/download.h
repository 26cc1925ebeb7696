#pragma once

#include <cstddef>
#include <string>

namespace place_recognition::tool {

/// Whether `source` is a URL: http, https or ftp.
bool isUrl(const std::string& source);

/// Downloads at most `limit` bytes from `url` with `curl`. Throws Error, stating the reason, on
/// failure. `progress`: as the option of that name; one line on standard error during the download.
std::string download(const std::string& url, std::size_t limit, const std::string& progress);

}  // namespace place_recognition::tool
