#include "tool/signals.h"

#include <csignal>

namespace place_recognition::tool {
namespace {

volatile std::sig_atomic_t g_stop_requested = 0;

extern "C" void requestStop(int /*signal*/) { g_stop_requested = 1; }

}  // namespace

void stopOnSignals() {
  struct sigaction action = {};
  action.sa_handler = requestStop;
  action.sa_flags = SA_RESTART | static_cast<int>(SA_RESETHAND);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  struct sigaction before = {};
  sigaction(SIGHUP, &action, &before);                                    // the terminal is closed
  if (before.sa_handler == SIG_IGN) sigaction(SIGHUP, &before, nullptr);  // nohup
}

bool stopRequested() { return g_stop_requested != 0; }

}  // namespace place_recognition::tool
