#pragma once

namespace place_recognition::tool {

/// From now on SIGINT and SIGTERM ask for a stop instead of ending the process at once, so that
/// nothing half-written is left behind; a second one ends it.
void stopOnSignals();

/// Whether a signal has asked for a stop.
bool stopRequested();

}  // namespace place_recognition::tool
