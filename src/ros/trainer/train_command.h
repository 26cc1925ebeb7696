#pragma once

#include <place_recognition/TrainGoal.h>

#include <string>
#include <vector>

namespace place_recognition {

/// The call of place_tool (program and arguments) that does what `goal` asks for. The goal comes
/// from the network: every field is checked, and bags must lie below `bag_roots`. The YAML text of
/// the goal has been written to the file `yaml_path`. Throws Error naming the field at fault.
std::vector<std::string> trainCommand(const TrainGoal& goal,
                                      const std::vector<std::string>& bag_roots,
                                      const std::string& yaml_path);

}  // namespace place_recognition
