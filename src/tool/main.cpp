#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <iostream>
#include <new>
#include <opencv2/core/utils/logger.hpp>
#include <string>

#include "place_recognition/error.h"
#include "place_recognition/progress.h"
#include "tool/stop.h"
#include "tool/verbs.h"

namespace {

constexpr int kBadInput = 1;
constexpr int kBadUsage = 2;
constexpr int kStopped = 130;  // as a shell has it: 128 + SIGINT

/// One line on stderr, whatever the message holds.
int fail(const CLI::App& tool, std::string message, int status) {
  std::replace_if(
      message.begin(), message.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  std::string verb;
  for (const CLI::App* parsed : tool.get_subcommands()) verb = " " + parsed->get_name();
  std::cout << std::flush;
  std::cerr << "place_tool" << verb << ": " << message << std::endl;
  return status;
}

int run(CLI::App& tool, int argc, char** argv) {
  using place_recognition::Cancelled;
  using place_recognition::Error;
  try {
    tool.parse(argc, argv);
    return 0;
  } catch (const CLI::ParseError& e) {
    if (e.get_exit_code() == 0) return tool.exit(e);  // --help, --version
    return fail(tool, std::string(e.what()) + "; see --help.", kBadUsage);
  } catch (const Cancelled&) {
    return fail(tool, "stopped.", kStopped);
  } catch (const Error& e) {
    return fail(tool, e.what(), kBadInput);
  } catch (const std::bad_alloc&) {
    return fail(tool, "out of memory; give fewer or smaller pictures.", kBadInput);
  } catch (const std::exception& e) {
    return fail(tool, std::string("failed unexpectedly: ") + e.what(), kBadInput);
  }
}

}  // namespace

int main(int argc, char** argv) {
  // What OpenCV and libpng find wrong with a picture is told in one line by whoever reads it.
  cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
  place_recognition::tool::stopOnSignals();

  CLI::App tool("Learns the rooms of a building from labelled bags or pictures, and names them.",
                "place_tool");
  tool.require_subcommand(1);
  tool.set_version_flag("--version", PLACE_RECOGNITION_VERSION);
  place_recognition::tool::addVerbs(tool);
  return run(tool, argc, argv);
}
