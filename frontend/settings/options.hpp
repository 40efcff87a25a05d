// The common options: one row per option, and the values they have in this run. Command line, help, completion,
// configuration file and `rungproof config` all come from this table. Options of a single command are declared by
// the command itself. Golden tests: tests/golden/help.
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/rule.hpp"
#include "engine/start_up.hpp"
#include "frontend/files/failure.hpp"
#include "ir/machine/choices.hpp"
#include "ir/program.hpp"
#include "ir/s7200/cpu.hpp"

namespace rungproof {

enum class Opt : std::uint8_t {
  Cpu,
  Edition,
  Dialect,
  Mnemonics,
  Encoding,
  Symbols,
  Tags,
  External,
  Exclude,
  Program,
  Protected,
  StdinFilename,
  Retentive,
  LibraryMemory,
  ClockMemory,
  CycleMonitoring,
  Start,
  Ob30,
  Ob31,
  Ob32,
  Ob33,
  Ob34,
  Ob35,
  Ob36,
  Ob37,
  Ob38,
  ScanTime,
  Phase,
  Timeout,
  Memory,
  Bound,
  Jobs,
  Cache,
  Seed,
  Without,
  ChoiceOf,
  Select,
  Ignore,
  PortTo,
  Level,
  FailLevel,
  ExitZero,
  NoSuppress,
  Baseline,
  Budget,
  TimeColumn,
  TimeUnit,
  Separator,
  Rename,
  Format,
  Color,
  Quiet,
  Verbose,
  Isolated,
  Config,
  count
};

/// Which commands show an option in their help. Every command accepts all of them.
using OptionGroups = std::uint8_t;
namespace option_group {
inline constexpr OptionGroups Reading = 1, Running = 2, Rules = 4, Output = 8, Configuration = 16, Proving = 32;
inline constexpr OptionGroups All = 63;
inline constexpr OptionGroups Traces = 128;  ///< of files that loggers and simulators wrote
inline constexpr OptionGroups Hidden = 64;   ///< in no help of its own
}  // namespace option_group

enum class Arity : std::uint8_t { Flag, One, List };  ///< List: may be repeated, values are separated by commas

struct OptionInfo {
  Opt id;
  OptionGroups group;
  Arity arity;
  std::string_view name;     ///< without the dashes; also the configuration key
  std::string_view value;    ///< "CPU", or the permitted words "auto|always|never"; empty for flags
  std::string_view initial;  ///< default as text; empty: none, or the command decides
  std::string_view help;
  bool inConfig = true;  ///< may stand in rungproof.toml
};

/// All rows, in the order of Opt.
std::span<const OptionInfo> optionTable();
const OptionInfo& optionInfo(Opt id);
const OptionInfo* optionNamed(std::string_view name);
/// The words of "a|b|c"; empty if the row takes free text.
std::vector<std::string_view> permittedWords(std::string_view value);
/// Why the text is no value for the option, or nothing.
std::optional<Failure> checkValue(const OptionInfo& info, std::string_view text);

using Duration = std::chrono::microseconds;
/// "5ms", "1.5s", "200us", "2min"; nothing for anything else, a negative or a too large duration.
std::optional<Duration> durationNamed(std::string_view text);

/// "500MB", "2GB" in bytes; nothing for anything else or zero.
std::optional<std::uint64_t> memoryNamed(std::string_view text);

/// The length of a scan: anything between the two, ends included.
struct ScanTime {
  Duration low;
  Duration high;
};
/// "5ms..20ms" or one value; nothing if it cannot be read, is zero, or its ends are swapped.
std::optional<ScanTime> scanTimeNamed(std::string_view text);

/// Codes, or beginnings of codes, that a file's findings are not reported for.
struct FileIgnore {
  std::string pattern;  ///< of names: * ? [...]
  std::vector<std::string> codes;
};

/// Values of all options, with the place each comes from.
class Settings {
 public:
  Settings();

  bool flag(Opt id) const { return !values_[index(id)].texts.empty(); }
  bool isSet(Opt id) const { return values_[index(id)].origin != "default"; }
  const std::vector<std::string>& list(Opt id) const { return values_[index(id)].texts; }
  /// The value of an option with Arity::One; empty if it has none.
  std::string_view text(Opt id) const;
  /// The value as a number; `initial` where the option has none.
  std::int64_t number(Opt id, std::int64_t initial) const;
  /// "default", "command line" or "rungproof.toml:3".
  const std::string& origin(Opt id) const { return values_[index(id)].origin; }

  Target target() const;
  Severity level() const;
  /// The CPU of --port-to with its usual edition; nothing: the program stays where it is.
  std::optional<Target> portTo() const;
  Severity failLevel() const;
  /// Nothing if none is named: the default of the CPU.
  std::optional<std::vector<RetentiveRange>> retentive() const;
  std::vector<LibraryMemory> libraryMemory() const;
  std::optional<ScanTime> scanTime() const;
  /// Periods of OB30 to OB38 in ms.
  std::array<std::uint16_t, cyclicBlockCount> cyclicPeriods() const;
  /// Byte of M that the CPU flashes; nothing: none.
  std::optional<std::uint32_t> clockMemory() const;
  std::uint16_t cycleMonitoringMs() const;
  std::optional<Duration> timeout() const;
  /// Time since the last tick of the time bases when RUN begins, in ms.
  std::uint32_t phaseMs() const;
  std::optional<Duration> budget() const;
  /// Bytes; nothing if no limit was given.
  std::optional<std::uint64_t> memory() const;
  Choices choices() const;
  const std::string& choiceOrigin(Choice choice) const { return choiceOrigins_[static_cast<std::size_t>(choice)]; }
  const RuleSettings& ruleSettings() const { return ruleSettings_; }
  /// Folder of the configuration file: findings name files from there; empty without one.
  const std::filesystem::path& root() const { return root_; }
  /// Severities that the configuration gives to rules, by id.
  const std::map<std::string, Severity, std::less<>>& severities() const { return severities_; }
  /// Codes that do not count in files whose name from the root fits the pattern.
  const std::vector<FileIgnore>& fileIgnores() const { return fileIgnores_; }
  /// Programs of the configuration, for a command line that names none.
  const std::vector<std::string>& inputs() const { return inputs_; }
  void setInputs(std::vector<std::string> names) { inputs_ = std::move(names); }
  /// Property files of the configuration.
  const std::vector<std::string>& propertyFiles() const { return propertyFiles_; }
  void setRoot(std::filesystem::path folder) { root_ = std::move(folder); }

  /// Sets a value that checkValue() has passed; lists are split at commas.
  void set(Opt id, const std::vector<std::string>& texts, const std::string& origin);
  std::optional<Failure> setChoice(std::string_view key, std::string_view value, const std::string& origin);
  std::optional<Failure> setSeverity(std::string_view rule, std::string_view severity);
  std::optional<Failure> addFileIgnore(FileIgnore ignore);
  void addPropertyFile(std::string name) { propertyFiles_.push_back(std::move(name)); }
  std::optional<Failure> setRuleOption(std::string_view rule, std::string_view option, std::int64_t value);
  /// Errors that only values together show, such as a CPU that the edition does not know.
  std::optional<Failure> check() const;

 private:
  struct Value {
    std::vector<std::string> texts;
    std::string origin = "default";
  };
  static std::size_t index(Opt id) { return static_cast<std::size_t>(id); }
  std::array<Value, static_cast<std::size_t>(Opt::count)> values_;
  Choices choices_;
  std::array<std::string, static_cast<std::size_t>(Choice::count)> choiceOrigins_;
  RuleSettings ruleSettings_;
  std::map<std::string, Severity, std::less<>> severities_;
  std::vector<FileIgnore> fileIgnores_;
  std::vector<std::string> inputs_;
  std::vector<std::string> propertyFiles_;
  std::filesystem::path root_;
};

}  // namespace rungproof
