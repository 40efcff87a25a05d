// STEP 7 projects among the arguments of a command: each of their programs is an input of its own, named like a file in
// the project: "Plant.s7p/SIMATIC 300(1)/CPU 315-2 DP/S7 Program(1)". Tested by tests/s7project/project_test.cpp.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "frontend/files/failure.hpp"
#include "frontend/s7project/s7_project.hpp"
#include "frontend/settings/options.hpp"

namespace rungproof {

/// A project file or archive, and one of its programs.
struct ProjectArgument {
  std::string file;
  std::string program;  ///< its path; empty: none is named
};

/// What an argument names of a project: the project file, its folder, its archive, or a program by the name that
/// expandProjects() gave. Nothing: it is something else.
std::optional<ProjectArgument> projectArgument(const std::string& name);
/// The project files in a folder, at most one folder below it; empty: it is the folder of no project.
std::vector<std::string> projectsIn(const std::string& folder);

/// Projects replaced by their programs that hold blocks, of those the ones that --program means.
std::vector<std::string> expandProjects(const std::vector<std::string>& names, const Settings& settings);
/// Whether the name is one that expandProjects() gave.
bool isProjectProgram(const std::string& name);

/// Why a command cannot work with the projects among its arguments: they are not read, --program means none, or one
/// program is wanted and several are there.
std::optional<Failure> projectFailure(const std::vector<std::string>& names, const Settings& settings,
                                      bool takesEachProgram);
/// Sets what the hardware configuration of the one program says, where nothing else does.
void applyHardware(const std::vector<std::string>& names, Settings& settings);

/// The stored blocks among the files of one program: those of its project, and single ones out of a CPU.
std::vector<mc7::StoredBlock> storedBlocksOf(const std::vector<std::string>& files, const Settings& settings);
/// Whether each of them is a single block out of a CPU.
bool areUploads(const std::vector<std::string>& files);

/// The tree of a project, for people.
std::string projectTree(const s7project::S7Project& project);

}  // namespace rungproof
