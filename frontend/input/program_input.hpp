// From the arguments of a command to a program, its properties and the beginning of a report. Every command that reads
// programs goes through here, so that options, standard input and reading errors behave alike everywhere.
#pragma once

#include <initializer_list>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "analysis/property.hpp"
#include "analysis/surroundings.hpp"
#include "analysis/unread/unread_code.hpp"
#include "frontend/command.hpp"
#include "frontend/input/project.hpp"
#include "frontend/property/property_reader.hpp"

namespace rungproof {

/// What the options say about reading.
ReadOptions readOptionsOf(const Settings& settings);

/// A program with the properties of its comments and of property files. Findings of both readers are in
/// Program::findings.
struct ProgramInput {
  Program program;
  PropertySet properties;
  Surroundings surroundings{};
};
/// The program alone: folders expanded, and the CPU guessed where nobody names one.
Program readFiles(const Context& context, const std::vector<std::string>& files);
ProgramInput readInput(const Context& context, const std::vector<std::string>& files,
                       const std::vector<std::string>& propertyFiles = {});
/// By other settings than those of the run.
ProgramInput readInput(const Context& context, const Settings& settings, const std::vector<std::string>& files,
                       const std::vector<std::string>& propertyFiles = {});

/// Gives the program what the project says of the CPU: memory of libraries, periods of cyclic interrupts, cycle
/// monitoring, clock memory. Gives why there is no clock memory where the CPU lacks its byte, which no program can
/// read.
std::optional<std::string> applyProjectSettings(const Settings& settings, Program& program);

/// S7-300/400 programs that are compared or stand alone, where no CPU and no family is named: all for a CPU 417, if one
/// of them has an organization block that no S7-300 starts.
void guessFamily(const Context& context, std::initializer_list<std::pair<const Settings*, Program*>> programs);

/// Leaves the properties that --only names, which may be patterns; assumptions stay. The names that are met.
std::set<std::string> keepOnly(const std::vector<std::string>& only, PropertySet& set);
/// What is said of a name of --only that no property has.
Failure noSuchProperty(const std::string& pattern);

/// Adds what the options and the configuration say beside the program: panel and network, the CPU to port to.
void addSurroundings(const Settings& settings, ProgramInput& input);

/// The operand that an address or a symbol of the program means, for property files, stimuli and command lines.
OperandLookup lookupIn(const Program& program);

/// With --as-downloaded: empties the networks that the editor leaves out of the download, and names them, one line
/// each: "MAIN, network 3 (press.awl:12) is not in the download: ...".
std::vector<std::string> leaveOut(Program& program);
inline constexpr std::string_view asDownloadedHelp =
    "leave out the networks that 'check --language stl' calls invalid, as the editor leaves them out of the download";

/// A report with sources, findings of the readers and coverage filled in.
Report startReport(std::string_view command, const Program& program, const std::vector<std::string>& files);

/// Adds what no command runs (unread_code.hpp): the findings of the rules that refuse it, and how much is left.
void addUnread(Report& report, const Program& program, const UnreadCode& unread);
/// Prints the errors of the readers and what the rules refuse to standard error: for commands that write no report.
void printUnread(const Context& context, std::string_view command, const Program& program, const UnreadCode& unread,
                 const std::vector<std::string>& files);

/// Folders replaced by the programs in and below them, by their ending or their content (program_text.hpp), sorted by
/// name, and, where they are one program, by its symbol tables and data blocks; other names unchanged.
std::vector<std::string> expandFolders(const std::vector<std::string>& names);
/// Why a folder stands for no program.
std::optional<Failure> folderFailure(const std::vector<std::string>& names);
/// The same without the files that the settings exclude.
std::vector<std::string> expandFolders(const std::vector<std::string>& names, const Settings& settings);

/// The files as programs: one group for each file that holds a main program, together with all files that hold none
/// (libraries, symbol tables, data blocks). One group if there is at most one main program.
std::vector<std::vector<std::string>> groupByProgram(const Context& context, const std::vector<std::string>& files);

/// Joins the reports of several programs; files that more than one of them read stand in the result once.
class ReportMerger {
 public:
  void add(const Report& part);
  Report take();

 private:
  std::shared_ptr<SourceSet> sources_ = std::make_shared<SourceSet>();
  std::unordered_map<std::string, std::uint32_t> indices_;  ///< by file name
  Report report_;
  bool isEmpty_ = true;
};

}  // namespace rungproof
