#include <algorithm>
#include <csignal>
#include <exception>
#include <iostream>
#include <new>
#include <opencv2/core/utils/logger.hpp>
#include <string>
#include <vector>

#include "base/child_process.h"
#include "place_recognition/error.h"
#include "place_recognition/network.h"
#include "place_recognition/progress.h"
#include "tool/command_line.h"
#include "tool/signals.h"
#include "tool/verbs.h"

namespace {

using place_recognition::tool::CommandLine;
using place_recognition::tool::UsageError;

constexpr int kBadInput = 1;
constexpr int kBadUsage = 2;
constexpr int kStopped = 130;  // as in shells: 128 + SIGINT

/// Prints one line on stderr, whatever the message contains.
int fail(const CommandLine& tool, std::string message, int status) {
  std::replace_if(
      message.begin(), message.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  std::cout << std::flush;
  std::cerr << tool.name() << ": " << message << std::endl;
  return status;
}

int run(CommandLine& tool, const std::vector<std::string>& words) {
  using place_recognition::Cancelled;
  using place_recognition::Error;
  try {
    tool.run(words);
    if (std::cout.flush()) return 0;
    return fail(tool, "cannot write to the standard output; make room, or redirect it.", kBadInput);
  } catch (const UsageError& e) {
    return fail(tool, std::string(e.what()) + "; see " + tool.name() + " --help.", kBadUsage);
  } catch (const Cancelled&) {
    return fail(tool, "stopped.", kStopped);
  } catch (const Error& e) {
    // Ctrl-C also reaches child processes, whose end is not an error then.
    if (place_recognition::tool::stopRequested()) return fail(tool, "stopped.", kStopped);
    return fail(tool, e.what(), kBadInput);
  } catch (const std::bad_alloc&) {
    return fail(tool, "out of memory; give fewer or smaller images.", kBadInput);
  } catch (const std::exception& e) {
    return fail(tool, std::string("failed unexpectedly: ") + e.what(), kBadInput);
  }
}

}  // namespace

int main(int argc, char** argv) {
  place_recognition::reserveStandardStreams();
  // The code that reads an image reports problems that OpenCV and libpng find with it.
  cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
  place_recognition::limitOpenCvToOneThread();
  place_recognition::tool::stopOnSignals();
  // A file that exceeds the permitted size (ulimit -f) is an error like a full disk.
  std::signal(SIGXFSZ, SIG_IGN);

  CommandLine tool(
      "place_tool",
      "Learns the rooms of a building from labelled bags or images, and recognizes them.",
      PLACE_RECOGNITION_VERSION);
  place_recognition::tool::addVerbs(tool);
  return run(tool, {argv + std::min(argc, 1), argv + argc});
}
