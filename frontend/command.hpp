// A command of the program: one file of this folder each, nothing else to edit. `setup` declares the command's own
// arguments and options as rows and returns what is to run after parsing; the common options (options.hpp) are
// added by the framework and arrive in Context::settings.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <iosfwd>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "frontend/files/disk_file.hpp"
#include "frontend/files/exit.hpp"
#include "frontend/files/failure.hpp"
#include "frontend/report.hpp"
#include "frontend/settings/arguments.hpp"
#include "frontend/settings/options.hpp"

namespace rungproof {

/// One `--format NAME[=FILE]`; no file: standard output.
struct OutputRequest {
  std::string name;
  std::string file;
};

/// The programs of a command that compares two.
enum class ProgramSide : std::uint8_t { Old, New };

/// What a command works with. Results go to `out`; diagnostics of the tool itself and progress to `err`.
struct Context {
  const Settings& settings;
  std::istream& in;
  std::ostream& out;
  std::ostream& err;
  bool color = false;                  ///< colours on `out`
  bool progress = false;               ///< `err` is a terminal and --quiet was not given
  std::vector<OutputRequest> outputs;  ///< never empty; names are permitted ones
  mutable bool hasLostOutput = false;  ///< some write() has failed: the exit code says so, whatever was found
  std::array<Settings, 2> sides{};     ///< of a command that compares two programs: the settings of each
  /// By configuration nearest to a program; empty: those of the run.
  std::function<const Settings&(const std::string& file)> settingsNear{};

  /// The settings of a run that is given this file alone, read anew from the configuration that counts for it.
  std::function<std::optional<Failure>(const std::string& file, Settings& settings)> readSettings{};
  std::vector<std::string> given{};  ///< the common options of the command line, as arguments for another run
  bool outIsTerminal = false;        ///< otherwise what is no report goes out byte by byte: a patch, a source

  const Settings& settingsOf(const std::vector<std::string>& files) const {
    return settingsNear && !files.empty() ? settingsNear(files.front()) : settings;
  }

  const Settings& side(ProgramSide which) const { return sides[static_cast<std::size_t>(which)]; }

  /// Prints the reason to `err` and gives the exit code for it.
  Exit fail(const Failure& failure) const;
  /// Writes the text of one output: to `out`, or to a file (disk_file.hpp). Prints the reason if it cannot. What people
  /// read shows control characters instead of sending them (safe_text.hpp).
  bool write(const OutputRequest& output, std::string_view text, InputFile input = InputFile::Refuse) const;
  bool write(const OutputRequest& output, const PiecewiseText& text, InputFile input = InputFile::Refuse) const;
};

/// Drops findings below --level, sorts, writes the report in every requested form, and gives the exit code.
Exit finish(const Context& context, Report report);

using Action = std::function<Exit(Context&)>;

struct Command {
  std::string_view name;
  std::string_view usage;                  ///< arguments after the name: "FILE... [--props FILE]..."
  std::string_view summary;                ///< one line, for the list of commands
  std::string_view details;                ///< paragraphs and examples for `CMD --help`; may be empty
  OptionGroups shows = option_group::All;  ///< common options that its help lists
  bool needsNoConfig = false;              ///< does its work beside a broken configuration too
  bool comparesTwo = false;                ///< options about reading may be given for one side: --cpu old:224
  std::string_view formats = {};           ///< "text|json": forms of its output, default first; empty: every Reporter
  bool takesEachProgram = false;           ///< of a STEP 7 project with several programs it does one after the other
  Action (*setup)(ArgumentTable& table) = nullptr;
};

std::span<const Command* const> allCommands();
const Command* commandNamed(std::string_view name);
/// Forms that the command can write, default first.
std::vector<std::string_view> formatsOf(const Command& command);

}  // namespace rungproof
