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

/// A message of place_tool for someone who sent a goal: without the name of the program, and with
/// fields of the goal instead of options.
std::string inTermsOfGoal(const std::string& message);

}  // namespace place_recognition
