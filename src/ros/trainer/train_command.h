#pragma once

#include <place_recognition/TrainGoal.h>

#include <string>
#include <vector>

namespace place_recognition {

/// The call of place_tool (program and arguments) that carries out `goal`. The goal comes from the
/// network: every field is checked, and bags must be below `bag_roots`. The YAML text of the goal
/// is in the file `yaml_path`. Throws Error naming the invalid field.
std::vector<std::string> trainCommand(const TrainGoal& goal,
                                      const std::vector<std::string>& bag_roots,
                                      const std::string& yaml_path);

}  // namespace place_recognition
