#pragma once

#include <functional>

namespace place_recognition {

/// The main program of a node: starts ROS as the node `name`, calls `work` and shuts ROS down
/// afterwards, so that the last messages of `work` are still delivered. Returns the exit code of
/// the program: 1, after logging the message, if `work` throws.
int runNode(int argc, char** argv, const char* name, const std::function<void()>& work);

/// For `work`: serves callbacks in `threads` threads until the node is asked to end by Ctrl-C,
/// kill, the closing of its terminal, rosnode or requestEnd(). A callback that throws is logged.
/// `before_end` is called then, before the running callbacks finish. Warns while simulated time
/// does not start because there is no clock.
void spinUntilEnd(unsigned threads, const std::function<void()>& before_end = {});

/// Ends spinUntilEnd(). Safe from any thread.
void requestEnd();

}  // namespace place_recognition
