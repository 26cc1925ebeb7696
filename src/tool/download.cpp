#include "tool/download.h"

#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>

#include "base/child_process.h"
#include "base/text.h"
#include "place_recognition/error.h"
#include "place_recognition/progress.h"
#include "tool/progress_display.h"
#include "tool/signals.h"

namespace place_recognition::tool {
namespace {

constexpr int kMaxSeconds = 1800;
constexpr int kPollMilliseconds = 100;
constexpr int kNotFound = 127;  // exit code of env without the program

}  // namespace

bool isUrl(const std::string& source) {
  return startsWith(source, "https://") || startsWith(source, "http://") ||
         startsWith(source, "ftp://");
}

std::string download(const std::string& url, std::size_t limit, const std::string& progress) {
  ProgressDisplay display(progress);
  const Progress callback = display.callback();
  const std::string most = std::to_string(limit);
  ChildProcess curl({"/usr/bin/env", "curl", "--fail", "--location", "--silent", "--show-error",
                     "--proto", "=https,http,ftp", "--max-filesize", most, "--max-time",
                     std::to_string(kMaxSeconds), "--url", url},
                    ChildProcess::Stderr::kPipe);
  std::string bytes;
  // The total is not known; the bar only shows that data arrives.
  const auto tell = [&] {
    report(callback, "Downloading " + url,
           static_cast<double>(bytes.size()) / static_cast<double>(limit));
  };
  std::array<char, 1 << 16> buffer;
  for (;;) {
    tell();
    pollfd arrival{curl.output(), POLLIN, 0};
    if (poll(&arrival, 1, kPollMilliseconds) <= 0) continue;
    const ssize_t count = read(curl.output(), buffer.data(), buffer.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) break;
    bytes.append(buffer.data(), static_cast<std::size_t>(count));
    if (bytes.size() > limit) throw Error(url + " is larger than " + most + " bytes.");
  }
  std::string complaint;
  while (curl.readLines(
      std::chrono::seconds(1), [](const std::string&) {},
      [&complaint](const std::string& line) { complaint = line; })) {
    tell();
  }
  const int status = curl.wait();
  display.clear();
  if (status == 0) return bytes;
  if (stopRequested()) throw Cancelled();  // Ctrl-C ends curl, too
  throw Error("Cannot download " + url + ": " +
              (WIFEXITED(status) && WEXITSTATUS(status) == kNotFound
                   ? "there is no curl; install it (apt install curl)"
               : complaint.empty() ? "curl ended with " + describeExit(status)
                                   : complaint) +
              ".");
}

}  // namespace place_recognition::tool
