#include "ros/nodes/node_main.h"

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
#include <vector>

#include "place_recognition/error.h"

namespace place_recognition {
namespace {

/// How often spinUntilEnd() looks whether it is to end, s.
constexpr double kPoll = 0.05;
/// How long simulated time may take to start, s of wall time; afterwards, between two warnings.
constexpr double kClockPatience = 5;
constexpr double kClockWarningPeriod = 60;

std::atomic<bool> end_requested{false};
static_assert(std::atomic<bool>::is_always_lock_free, "set by signal handlers");

/// rosnode kill, and a new node of the same name. As roscpp has it, but logging goes on.
void onShutdownCall(XmlRpc::XmlRpcValue& params, XmlRpc::XmlRpcValue& result) {
  if (params.getType() == XmlRpc::XmlRpcValue::TypeArray && params.size() > 1 &&
      params[1].getType() == XmlRpc::XmlRpcValue::TypeString) {
    ROS_WARN("Asked to end: %s", static_cast<std::string&>(params[1]).c_str());
  }
  requestEnd();
  result = ros::xmlrpc::responseInt(1, "", 0);
}

/// Instead of roscpp's handlers, which end logging and connections before anything else.
void endOnRequest() {
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
    const auto before = std::signal(number, [](int) {
      // The second time at once, for a node may wait for a master that is gone.
      if (end_requested.exchange(true)) ros::requestShutdown();
    });
    if (number == SIGHUP && before == SIG_IGN) std::signal(number, SIG_IGN);  // nohup
  }
  std::signal(SIGXFSZ, SIG_IGN);  // a write that a limit stops fails like one on a full disk
  ros::XMLRPCManager::instance()->unbind("shutdown");
  ros::XMLRPCManager::instance()->bind("shutdown", onShutdownCall);
}

/// roscpp takes anything but the truth value for false, and other nodes may not.
void warnOfBadClockParameter() {
  XmlRpc::XmlRpcValue value;
  if (ros::param::get("/use_sim_time", value) &&
      value.getType() != XmlRpc::XmlRpcValue::TypeBoolean) {
    ROS_WARN(
        "/use_sim_time is neither true nor false, so this node takes it for false; correct it: "
        "rosparam set /use_sim_time false.");
  }
}

/// Warns now and then while simulated time is wanted but does not come.
class ClockWatch {
 public:
  void look() {
    const ros::WallTime now = ros::WallTime::now();
    if (!ros::Time::isSimTime() || !ros::Time::now().isZero()) {
      next_warning_ = now + ros::WallDuration(kClockPatience);
    } else if (now >= next_warning_) {
      ROS_WARN(
          "/use_sim_time is true, but no /clock has come: ROS' time stands still, and this node "
          "waits. "
          "Start what publishes /clock (rosbag play --clock, a simulator), or, if the parameter "
          "was "
          "left over: rosparam set /use_sim_time false, and start this node again.");
      next_warning_ = now + ros::WallDuration(kClockWarningPeriod);
    }
  }

 private:
  ros::WallTime next_warning_ = ros::WallTime::now() + ros::WallDuration(kClockPatience);
};

/// Starts ROS; returns the arguments that mean nothing to it. Throws Error if one cannot be meant.
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
                  " is no remapping of one name to another; if it is a "
                  "parameter, write _" +
                  argument + ".");
    }
    throw Error(e.what());
  }
  return {argv + std::min(argc, 1), argv + argc};
}

}  // namespace

int runNode(int argc, char** argv, const char* name, const std::function<void()>& work) {
  // Names of rooms are UTF-8; without it log4cxx writes '?' for all that is not ASCII.
  std::setlocale(LC_CTYPE, "C.UTF-8");
  std::vector<std::string> strange;
  try {
    strange = initialize(argc, argv, name);
  } catch (const Error& e) {
    std::cerr << name << ": " << e.what() << "\n";
    return EXIT_FAILURE;
  }
  ros::start();  // else the last NodeHandle to go would end ROS, and logging with it
  endOnRequest();
  for (const std::string& argument : strange) {
    ROS_WARN("The argument %s changes nothing; a parameter is written _name:=value.",
             argument.c_str());
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
  ros::AsyncSpinner spinner(threads);
  spinner.start();
  for (ClockWatch clock; ros::ok() && !end_requested; clock.look())
    ros::WallDuration(kPoll).sleep();
  if (before_end) before_end();
}

void requestEnd() { end_requested = true; }

}  // namespace place_recognition
