#pragma once

#include <functional>

namespace place_recognition {

/// The program of a node: starts ROS as the node `name`, calls `work` and ends ROS afterwards, so
/// that what `work` says last is still heard. Returns the program's exit code: 1, and the message
/// is logged, if `work` throws.
int runNode(int argc, char** argv, const char* name, const std::function<void()>& work);

/// For `work`: serves callbacks in `threads` threads until the node is asked to end, by Ctrl-C,
/// kill, a terminal that closes, rosnode or requestEnd(). `before_end` is called then, before the
/// callbacks at work are waited for. Warns while simulated time does not start for want of a clock.
void spinUntilEnd(unsigned threads, const std::function<void()>& before_end = {});

/// Ends spinUntilEnd(). From any thread.
void requestEnd();

}  // namespace place_recognition
