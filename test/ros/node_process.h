#pragma once

#include <ros/master.h>
#include <ros/network.h>
#include <unistd.h>
#include <xmlrpcpp/XmlRpc.h>

#include <fstream>
#include <string>

namespace place_recognition {

/// Returns the process ID that a node reports; 0 if the node does not answer.
inline pid_t processOf(const std::string& node) {
  XmlRpc::XmlRpcValue request, response, payload;
  request[0] = "/test";
  request[1] = node;
  if (!ros::master::execute("lookupNode", request, response, payload, false)) return 0;
  std::string host;
  std::uint32_t port = 0;
  if (!ros::network::splitURI(payload, host, port)) return 0;
  XmlRpc::XmlRpcClient client(host.c_str(), static_cast<int>(port));
  XmlRpc::XmlRpcValue caller;
  caller[0] = "/test";
  if (!client.execute("getPid", caller, response) || response.size() != 3) return 0;
  return static_cast<int>(response[2]);
}

/// Returns the memory in use by a process, MB.
inline double memoryOf(pid_t process) {
  std::ifstream statm("/proc/" + std::to_string(process) + "/statm");
  long size = 0, resident = 0;
  statm >> size >> resident;
  return static_cast<double>(resident * sysconf(_SC_PAGESIZE)) / (1 << 20);
}

}  // namespace place_recognition
