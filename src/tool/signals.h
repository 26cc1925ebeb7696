#pragma once

namespace place_recognition::tool {

/// Makes SIGINT and SIGTERM request a stop instead of ending the process at once, so that nothing
/// half-written is left behind; a second signal ends it.
void stopOnSignals();

/// Whether a signal has requested a stop.
bool stopRequested();

}  // namespace place_recognition::tool
