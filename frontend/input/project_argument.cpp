// Which programs are meant.
#include "frontend/input/project_argument.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "engine/platform/names.hpp"
#include "frontend/files/disk_file.hpp"
#include "frontend/files/file_reader.hpp"
#include "frontend/mc7/block_source.hpp"
#include "frontend/mc7/upload.hpp"
#include "frontend/s7project/archive.hpp"
#include "frontend/stl/stl_lexer.hpp"

namespace rungproof {

namespace fs = std::filesystem;

namespace {

using s7project::ProjectProgram;
using s7project::S7Project;

bool isProjectArchive(const std::string& name) {
  if (!endsInAny(name, {".zip"}) || confinedAgainst(name)) return false;
  std::ifstream file(fs::path(name), std::ios::binary);
  std::string head(4, '\0');
  if (!file.read(head.data(), 4) || !s7project::Archive::isArchive(head)) return false;
  const InputBytes input = inputBytes(name, longestProgram);
  if (!input.bytes) return false;
  const s7project::Archive archive(*input.bytes);
  return std::ranges::any_of(archive.entries(), [](const s7project::Archive::Entry& entry) {
    return s7project::isProjectFileName(entry.name);
  });
}

bool isProjectOnDisk(const std::string& name) {
  std::error_code error;
  if (!fs::is_regular_file(name, error)) return false;
  return s7project::isProjectFileName(name) || isProjectArchive(name);
}

/// Whether --program means it: its path, the end of that behind a /, or its name, in any case of letters.
bool isMeant(const ProjectProgram& program, std::string_view wanted) {
  if (wanted.empty() || equalsIgnoringCase(program.path, wanted) || equalsIgnoringCase(program.name, wanted))
    return true;
  const std::string end = fmt::format("/{}", wanted);
  return program.path.size() > end.size() &&
         equalsIgnoringCase(std::string_view(program.path).substr(program.path.size() - end.size()), end);
}

std::vector<const ProjectProgram*> programsOf(const S7Project& project, std::string_view wanted) {
  std::vector<const ProjectProgram*> programs;
  for (const ProjectProgram& program : project.programs) {
    if (!program.blocks.empty() && isMeant(program, wanted)) programs.push_back(&program);
  }
  return programs;
}

TextEncoding encodingOf(const Settings& settings) { return *encodingNamed(settings.text(Opt::Encoding)); }

std::string programList(const std::vector<const ProjectProgram*>& programs) {
  std::vector<std::string> names;
  for (const ProjectProgram* program : programs) names.push_back("'" + program->path + "'");
  return fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace

std::vector<std::string> projectsIn(const std::string& folder) {
  std::error_code error;
  std::vector<std::string> found;
  if (!fs::is_directory(folder, error)) return found;
  const auto look = [&](const fs::path& in, auto&& self, int depth) -> void {
    std::error_code inner;
    for (fs::directory_iterator entry(in, fs::directory_options::skip_permission_denied, inner), end;
         !inner && entry != end; entry.increment(inner)) {
      std::error_code unknown;
      if (entry->is_directory(unknown) && depth > 0)
        self(entry->path(), self, depth - 1);
      else if (s7project::isProjectFileName(pathName(entry->path())) && entry->is_regular_file(unknown))
        found.push_back(pathName(entry->path()));
    }
  };
  look(folder, look, 1);
  std::ranges::sort(found);
  return found;
}

std::optional<ProjectArgument> projectArgument(const std::string& name) {
  if (isProjectOnDisk(name)) return ProjectArgument{name, {}};
  // Behind the project file the path of a program follows.
  for (std::size_t at = name.find('/', 1); at != std::string::npos; at = name.find('/', at + 1)) {
    const std::string file = name.substr(0, at);
    if (endsInAny(file, {".s7p", ".s7l", ".zip"}) && isProjectOnDisk(file))
      return ProjectArgument{file, name.substr(at + 1)};
  }
  return std::nullopt;
}

bool isProjectProgram(const std::string& name) {
  const std::optional<ProjectArgument> argument = projectArgument(name);
  return argument && !argument->program.empty();
}

std::vector<std::string> expandProjects(const std::vector<std::string>& names, const Settings& settings) {
  std::vector<std::string> expanded;
  for (const std::string& name : names) {
    std::vector<std::string> files = projectsIn(name);
    const std::optional<ProjectArgument> argument = files.empty() ? projectArgument(name) : std::nullopt;
    if (argument && argument->program.empty()) files.push_back(argument->file);
    if (files.empty()) expanded.push_back(name);
    for (const std::string& file : files) {
      const auto project = s7project::s7ProjectOf(file, encodingOf(settings));
      for (const ProjectProgram* program : programsOf(*project, settings.text(Opt::Program)))
        expanded.push_back(file + "/" + program->path);
    }
  }
  return expanded;
}

std::optional<Failure> projectFailure(const std::vector<std::string>& names, const Settings& settings,
                                      bool takesEachProgram) {
  const std::string_view wanted = settings.text(Opt::Program);
  bool isProject = false;
  for (const std::string& name : names) {
    std::vector<std::string> files = projectsIn(name);
    const std::optional<ProjectArgument> argument = files.empty() ? projectArgument(name) : std::nullopt;
    if (argument) files.push_back(argument->file);
    isProject = isProject || !files.empty();
    for (const std::string& file : files) {
      const auto project = s7project::s7ProjectOf(file, encodingOf(settings));
      if (project->failure) return project->failure;
      const std::vector<const ProjectProgram*> all = programsOf(*project, {});
      if (all.empty()) {
        const std::string help = "'rungproof show --list' prints its tree";
        if (project->faults.empty()) return Failure{"the project holds no blocks", file, help};
        return Failure{"the project holds no blocks: " + project->faults.front().text, file, help};
      }
      const std::string_view meant = argument && !argument->program.empty() ? argument->program : wanted;
      const std::vector<const ProjectProgram*> programs = programsOf(*project, meant);
      if (programs.empty())
        return Failure{fmt::format("the project has no program '{}'", meant), file, "it has " + programList(all)};
      if (programs.size() > 1 && !takesEachProgram)
        return Failure{wanted.empty() ? fmt::format("the project has {} programs", programs.size())
                                      : fmt::format("'{}' means {} programs", wanted, programs.size()),
                       file, "name one with --program: " + programList(programs)};
    }
  }
  if (!wanted.empty() && !isProject)
    return Failure{"--program names a program of a STEP 7 project, and none is given", {}, "leave it out"};
  return std::nullopt;
}

void applyHardware(const std::vector<std::string>& names, Settings& settings) {
  const std::vector<std::string> programs = expandProjects(names, settings);
  if (programs.size() != 1) return;
  const std::optional<ProjectArgument> argument = projectArgument(programs.front());
  if (!argument || argument->program.empty()) return;
  const auto project = s7project::s7ProjectOf(argument->file, encodingOf(settings));
  for (const ProjectProgram& program : project->programs) {
    if (program.path != argument->program || !program.cpu) continue;
    std::map<Opt, std::vector<std::string>> values;
    for (const auto& [name, value] : program.cpu->options()) {
      const OptionInfo* info = optionNamed(name);
      if (info != nullptr && !settings.isSet(info->id) && !checkValue(*info, value)) values[info->id].push_back(value);
    }
    for (const auto& [option, texts] : values) settings.set(option, texts, argument->file);
  }
}

std::vector<mc7::StoredBlock> storedBlocksOf(const std::vector<std::string>& files, const Settings& settings) {
  std::vector<mc7::StoredBlock> blocks;
  for (const std::string& file : files) {
    if (const std::optional<ProjectArgument> argument = projectArgument(file)) {
      const auto project = s7project::s7ProjectOf(argument->file, encodingOf(settings));
      for (const ProjectProgram* program : programsOf(*project, argument->program))
        blocks.insert(blocks.end(), program->blocks.begin(), program->blocks.end());
    } else if (areUploads({file})) {
      const InputBytes input = inputBytes(file, longestProgram);
      if (input.bytes) blocks.push_back(mc7::readUpload(*input.bytes, file));
    }
  }
  return blocks;
}

bool areUploads(const std::vector<std::string>& files) {
  return !files.empty() && std::ranges::all_of(files, [](const std::string& name) {
    std::ifstream file(fs::path(name), std::ios::binary);
    std::string head(6, '\0');
    return file.read(head.data(), 6) && mc7::isUpload(head);
  });
}

std::string projectTree(const S7Project& project) {
  std::string text = fmt::format("{}  code page {}{}\n", project.file, project.codePage,
                                 project.isCodePageKnown ? "" : " (the project names none)");
  const auto plural = [](std::size_t count, std::string_view word) {
    return fmt::format("{} {}{}", count, word, count == 1 ? "" : "s");
  };
  for (const ProjectProgram& program : project.programs) {
    text += fmt::format("  {}\n", program.path);
    if (program.cpu) {
      text += fmt::format("    CPU {}{}\n", program.cpu->name,
                          program.cpu->orderNumber.empty() ? "" : "  " + program.cpu->orderNumber);
      for (const auto& [name, value] : program.cpu->options()) text += fmt::format("      {} {}\n", name, value);
      constexpr std::string_view none = " (the default of the CPU)\n";
      if (!program.cpu->scanLimitMs) text += fmt::format("      cycle-monitoring 150ms{}", none);
      if (!program.cpu->clockByte) text += fmt::format("      no clock memory{}", none);
      if (!program.cpu->retention) text += fmt::format("      retentive MB0..MB15, C0..C7{}", none);
      if (!program.cpu->cyclicMs.contains(35)) text += fmt::format("      ob35 100ms{}", none);
    }
    text += fmt::format("    {}, {}, {}, {}\n", plural(program.blocks.size(), "block"),
                        plural(program.symbols.size(), "symbol"), plural(program.sources.size(), "text source"),
                        plural(program.variableTables, "variable table"));
    const std::vector<mc7::BlockSource> sources = mc7::sourcesOf(program.blocks, false);
    std::size_t next = 0;
    for (const mc7::StoredBlock& block : program.blocks) {
      std::string line = fmt::format("    {}", toString(block.key));
      const mc7::BlockSource* source =
          next < sources.size() && sources[next].key == block.key ? &sources[next] : nullptr;
      if (source != nullptr) ++next;
      if (block.isCode() && source != nullptr) {
        line += fmt::format("  {}  {}, {}", mc7::languageName(block.language), plural(source->networks, "network"),
                            plural(source->instructions, "instruction"));
        if (block.isProtected) line += ", protected";
      }
      if (!block.title.empty()) line += "  " + block.title;
      if (source != nullptr && !source->damage.empty()) line += "  damaged: " + source->damage;
      text += line + "\n";
    }
    for (const s7project::TextSource& source : program.sources)
      text += fmt::format("    source {}{}\n", source.name, source.isScl ? "  SCL" : "");
  }
  for (const s7project::ProjectFault& fault : project.faults) text += fmt::format("  damaged: {}\n", fault.text);
  return text;
}

}  // namespace rungproof
