// A runner of composite actions, as far as ours goes: reads the steps of action.yml, replaces expressions, runs each
// `run` in bash as the real runner does, and hands outputs from step to step. Steps with `uses` are only noted.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace rungproof::test {

struct ActionStep {
  std::string name, id, uses, condition, run;
  std::map<std::string, std::string> environment;
  std::map<std::string, std::string> with;
};

struct Action {
  std::map<std::string, std::string> defaults;  ///< of its inputs
  std::map<std::string, std::string> outputs;   ///< expressions
  std::vector<ActionStep> steps;
};

/// Reads the forms that action.yml uses: nested maps by indentation, lists with "- ", block texts with "|".
Action actionOf(const std::string& yaml);

struct ActionRun {
  int exit = -1;  ///< of the first step that fails, else 0
  std::string failedStep;
  std::string log;                             ///< both outputs of all steps
  std::map<std::string, std::string> outputs;  ///< of the action
  std::vector<std::string> used;               ///< "actions/cache@v4 path=... key=..." of the steps that would run
};

/// Runs it for a workspace; `actionFolder` holds action.yml.
ActionRun runAction(const Action& action, const std::map<std::string, std::string>& inputs,
                    const std::string& actionFolder, const std::string& workspace);

}  // namespace rungproof::test
