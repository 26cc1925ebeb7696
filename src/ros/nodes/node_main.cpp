#include "ros/nodes/node_main.h"

#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <ros/xmlrpc_manager.h>

#include <algorithm>
#include <atomic>
#include <clocale>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <string>
#include <thread>
#include <vector>

#include "base/child_process.h"
#include "place_recognition/error.h"

namespace place_recognition {
namespace {

/// Interval at which spinUntilEnd() checks whether to end, s.
constexpr double kPoll = 0.05;
/// Time for simulated time to start, s of wall time; afterwards, the interval between warnings.
constexpr double kClockPatience = 5;
constexpr double kClockWarningPeriod = 60;
/// Interval between two errors of callbacks, s.
constexpr double kErrorPeriod = 10;

std::atomic<bool> end_requested{false};
static_assert(std::atomic<bool>::is_always_lock_free, "set by signal handlers");

/// Handles rosnode kill, and a new node with the same name. Does what roscpp does, except that
/// logging continues.
void onShutdownCall(XmlRpc::XmlRpcValue& params, XmlRpc::XmlRpcValue& result) {
  if (params.getType() == XmlRpc::XmlRpcValue::TypeArray && params.size() > 1 &&
      params[1].getType() == XmlRpc::XmlRpcValue::TypeString) {
    ROS_WARN("Asked to end: %s", static_cast<std::string&>(params[1]).c_str());
  }
  requestEnd();
  result = ros::xmlrpc::responseInt(1, "", 0);
}

/// Replaces roscpp's handlers, which shut down logging and connections first.
void endOnRequest() {
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
    const auto before = std::signal(number, [](int) {
      // The second request ends the node at once, because it may be waiting for a master that is
      // gone.
      if (end_requested.exchange(true)) ros::requestShutdown();
    });
    if (number == SIGHUP && before == SIG_IGN) std::signal(number, SIG_IGN);  // nohup
  }
  std::signal(SIGXFSZ, SIG_IGN);  // a write stopped by a limit fails as on a full disk
  ros::XMLRPCManager::instance()->unbind("shutdown");
  ros::XMLRPCManager::instance()->bind("shutdown", onShutdownCall);
}

/// roscpp treats anything but the Boolean value as false; other nodes may not.
void warnOfBadClockParameter() {
  XmlRpc::XmlRpcValue value;
  if (ros::param::get("/use_sim_time", value) &&
      value.getType() != XmlRpc::XmlRpcValue::TypeBoolean) {
    ROS_WARN(
        "/use_sim_time is neither true nor false, so this node assumes false; correct it: "
        "rosparam set /use_sim_time false.");
  }
}

/// Warns from time to time while simulated time is required but does not start.
class ClockWatch {
 public:
  void look() {
    const ros::WallTime now = ros::WallTime::now();
    if (!ros::Time::isSimTime() || !ros::Time::now().isZero()) {
      next_warning_ = now + ros::WallDuration(kClockPatience);
    } else if (now >= next_warning_) {
      ROS_WARN(
          "%s is true, but no /clock has arrived: ROS time stands still, and this node waits. "
          "Start a publisher of /clock (rosbag play --clock, a simulator). If the parameter is "
          "left over, run: rosparam set %s false, and start this node again.",
          parameter_.c_str(), parameter_.c_str());
      next_warning_ = now + ros::WallDuration(kClockWarningPeriod);
    }
  }

 private:
  const std::string parameter_ = ros::names::resolve("/use_sim_time");  // it may be remapped
  ros::WallTime next_warning_ = ros::WallTime::now() + ros::WallDuration(kClockPatience);
};

/// Serves callbacks in some threads. An exception of a callback, for example because a message has
/// a time beyond the range of ros::Duration, is logged, and the node continues.
class Spinner {
 public:
  explicit Spinner(unsigned threads) {
    for (unsigned i = 0; i < threads; ++i) threads_.emplace_back([this] { serve(); });
  }
  ~Spinner() {
    ends_ = true;
    for (std::thread& thread : threads_) thread.join();
  }

 private:
  void serve() {
    while (!ends_ && ros::ok()) {
      try {
        ros::getGlobalCallbackQueue()->callOne(ros::WallDuration(kPoll));
      } catch (const std::exception& e) {
        ROS_ERROR_THROTTLE(kErrorPeriod, "A message cannot be handled: %s", e.what());
      }
    }
  }

  std::atomic<bool> ends_{false};
  std::vector<std::thread> threads_;
};

/// Starts ROS; returns the arguments that have no meaning to it. Throws Error for an argument that
/// must be a mistake.
std::vector<std::string> initialize(int argc, char** argv, const char* name) {
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  try {
    ros::init(argc, argv, name, ros::init_options::NoSigintHandler);
  } catch (const ros::InvalidNameException& e) {
    for (const std::string& argument : arguments) {
      const std::size_t to = argument.find(":=");
      std::string ignored;
      if (to == std::string::npos || to == 0 || argument[0] == '_' ||
          (ros::names::validate(argument.substr(0, to), ignored) &&
           ros::names::validate(argument.substr(to + 2), ignored))) {
        continue;
      }
      throw Error("The argument " + argument +
                  " does not remap one name to another; if it is a "
                  "parameter, write _" +
                  argument + ".");
    }
    throw Error(e.what());
  } catch (const ros::InvalidNodeNameException& e) {
    throw Error(std::string(e.what()) +
                "; give __name:=NAME without / and ~, and the namespace as __ns:=NAMESPACE.");
  }
  return {argv + std::min(argc, 1), argv + argc};
}

}  // namespace

int runNode(int argc, char** argv, const char* name, const std::function<void()>& work) {
  reserveStandardStreams();
  // Names of rooms are UTF-8; without this, log4cxx writes '?' for all non-ASCII characters.
  std::setlocale(LC_CTYPE, "C.UTF-8");
  std::vector<std::string> strange;
  try {
    strange = initialize(argc, argv, name);
  } catch (const Error& e) {
    std::cerr << name << ": " << e.what() << "\n";
    return EXIT_FAILURE;
  }
  ros::start();  // else the end of the last NodeHandle would shut down ROS, with logging
  endOnRequest();
  for (const std::string& argument : strange) {
    ROS_WARN("The argument %s has no effect; write a parameter as _name:=value.", argument.c_str());
  }
  int status = EXIT_SUCCESS;
  try {
    work();
  } catch (const std::exception& e) {
    ROS_FATAL("%s", e.what());
    status = EXIT_FAILURE;
  }
  ros::shutdown();
  return status;
}

void spinUntilEnd(unsigned threads, const std::function<void()>& before_end) {
  warnOfBadClockParameter();
  const Spinner spinner(threads);
  for (ClockWatch clock; ros::ok() && !end_requested; clock.look())
    ros::WallDuration(kPoll).sleep();
  if (before_end) before_end();
}

void requestEnd() { end_requested = true; }

}  // namespace place_recognition
