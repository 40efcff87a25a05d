// From arguments to a command.
#include "frontend/cli/cli.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <istream>
#include <new>
#include <ostream>
#include <streambuf>
#include <system_error>

#include "engine/platform/names.hpp"
#include "frontend/cli/argument_parser.hpp"
#include "frontend/cli/last_words.hpp"
#include "frontend/cli/watched_run.hpp"
#include "frontend/files/closest_word.hpp"
#include "frontend/files/disk_file.hpp"
#include "frontend/input/program_input.hpp"
#include "frontend/input/project_argument.hpp"
#include "frontend/settings/config.hpp"
#include "frontend/text/safe_text.hpp"
#include "frontend/watch.hpp"

namespace rungproof {

namespace {

namespace fs = std::filesystem;

/// Messages name files and texts of programs: what a terminal must not get is made visible on the way to it.
class VisibleBuffer : public std::streambuf {
 public:
  VisibleBuffer(std::ostream& stream, bool isTerminal)
      : stream_(stream), visible_(isTerminal ? VisiblePieces::Colors::Kept : VisiblePieces::Colors::Hidden) {}
  ~VisibleBuffer() override { stream_ << visible_.rest() << std::flush; }
  VisibleBuffer(const VisibleBuffer&) = delete;
  VisibleBuffer& operator=(const VisibleBuffer&) = delete;

 private:
  int_type overflow(int_type c) override {
    if (traits_type::eq_int_type(c, traits_type::eof())) return traits_type::not_eof(c);
    const char letter = traits_type::to_char_type(c);
    return xsputn(&letter, 1) == 1 ? c : traits_type::eof();
  }
  std::streamsize xsputn(const char* text, std::streamsize count) override {
    return stream_ << visible_.next({text, static_cast<std::size_t>(count)}) ? count : 0;
  }
  int sync() override { return stream_.flush() ? 0 : -1; }

  std::ostream& stream_;
  VisiblePieces visible_;
};

std::vector<std::string_view> commandNames() {
  std::vector<std::string_view> names;
  for (const Command* command : allCommands()) names.push_back(command->name);
  return names;
}

/// Index of the command's name: the first argument that is neither an option nor an option's value.
std::size_t commandIndex(const std::vector<std::string>& arguments) {
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string& argument = arguments[i];
    if (!argument.starts_with("-") || argument == "-") return i;
    const OptionInfo* info = argument.starts_with("--") ? optionNamed(argument.substr(2)) : nullptr;
    if (info != nullptr && info->arity != Arity::Flag) ++i;
  }
  return arguments.size();
}

/// Folder where the search for the configuration begins: that of the first file argument, else the current one.
fs::path folderOf(const fs::path& file) {
  std::error_code error;
  if (fs::is_directory(file, error)) return file;
  // A program of a project stands in its file.
  if (const auto argument = projectArgument(pathName(file)); argument && !argument->program.empty())
    return folderOf(argument->file);
  const bool isThere = fs::exists(file, error) || heldText(pathName(file)) != nullptr;
  return isThere && file.has_parent_path() ? file.parent_path() : fs::path(".");
}

fs::path configFolder(const ParsedLine& line) {
  return line.arguments.empty() ? fs::path(".") : folderOf(line.arguments.front());
}

/// The values of an option that hold for one side, without their prefix, or those that hold for both.
std::vector<std::string> valuesOf(const std::vector<std::string>& texts, std::string_view prefix) {
  std::vector<std::string> values;
  for (const std::string& text : texts) {
    const bool isOfSide = text.starts_with("old:") || text.starts_with("new:");
    if (prefix.empty() && !isOfSide) values.push_back(text);
    if (!prefix.empty() && text.starts_with(prefix)) values.push_back(text.substr(prefix.size()));
  }
  return values;
}

/// Values of the common options on the command line; also splits --choice KEY=VALUE. `prefix`: of the side whose values
/// count, or empty; `hasSides`: values may have one.
std::optional<Failure> readCommandLine(const ParsedLine& line, Settings& settings, bool hasSides = false,
                                       std::string_view prefix = {}) {
  for (const auto& [option, given] : line.options) {
    const bool isSided = hasSides && (option->group & option_group::Reading) != 0;
    if (!isSided && !prefix.empty()) continue;
    const std::vector<std::string> texts = isSided ? valuesOf(given, prefix) : given;
    if (isSided && texts.empty()) continue;
    const bool isFlag = option->arity == Arity::Flag;
    settings.set(option->id, isFlag ? std::vector<std::string>{"true"} : texts, "command line");
    if (isFlag || option->id == Opt::Format) continue;
    for (const std::string& text : settings.list(option->id)) {
      if (auto failure = checkValue(*option, text)) return failure;
    }
  }
  for (const std::string& text : settings.list(Opt::ChoiceOf)) {
    const std::size_t sign = text.find('=');
    if (sign == std::string::npos)
      return Failure{fmt::format("'{}' is no choice", text), {}, "write --choice KEY=VALUE"};
    if (auto failure = settings.setChoice(text.substr(0, sign), text.substr(sign + 1), "command line")) return failure;
  }
  return std::nullopt;
}

std::optional<Failure> readOutputs(const Settings& settings, const Command& command,
                                   std::vector<OutputRequest>& outputs) {
  const std::vector<std::string_view> permitted = formatsOf(command);
  for (const std::string& text : settings.list(Opt::Format)) {
    const std::size_t sign = text.find('=');
    OutputRequest request{text.substr(0, sign), sign == std::string::npos ? std::string() : text.substr(sign + 1)};
    const bool known = std::find(permitted.begin(), permitted.end(), request.name) != permitted.end();
    // The configuration file names a form for the reports; commands with other forms keep their own.
    if (!known && settings.origin(Opt::Format) != "command line") continue;
    if (!known) {
      const std::string_view meant = closest(request.name, permitted);
      return Failure{fmt::format("'rungproof {}' has no format '{}'", command.name, request.name),
                     {},
                     fmt::format("it can be {}{}", fmt::join(permitted, ", "),
                                 meant.empty() ? "" : fmt::format("; did you mean '{}'?", meant))};
    }
    if (sign != std::string::npos && request.file.empty()) {
      return Failure{fmt::format("--format {} names no file after '='", text), {}, {}};
    }
    outputs.push_back(std::move(request));
  }
  const auto isOnStandardOutput = [](const OutputRequest& output) { return output.file.empty() || output.file == "-"; };
  if (std::ranges::count_if(outputs, isOnStandardOutput) > 1)
    return Failure{"two forms of the report would be mixed on standard output", {}, "write --format NAME=FILE for one"};
  if (outputs.empty()) outputs.push_back({std::string(permitted.front()), {}});
  return std::nullopt;
}

bool wantsColor(const Settings& settings, bool isTerminal) {
  if (settings.text(Opt::Color) != "auto") return settings.text(Opt::Color) == "always";
  const char* off = std::getenv("NO_COLOR");
  const char* terminal = std::getenv("TERM");
  return isTerminal && (off == nullptr || *off == '\0') &&
         (terminal == nullptr || std::string_view(terminal) != "dumb");
}

int failed(std::ostream& err, const Failure& failure) {
  print(err, failure);
  return static_cast<int>(Exit::Failed);
}

/// The settings of programs beside which another configuration lies than beside the first one.
class NearbySettings {
 public:
  NearbySettings(const ParsedLine& line, const Settings& usual, fs::path config, std::ostream& err)
      : line_(line), usual_(usual), config_(std::move(config)), err_(err) {}

  const Settings& near(const std::string& file) {
    const fs::path config = findConfig(folderOf(file));
    if (config.empty() || isSame(config, config_)) return usual_;
    const auto [known, isNew] = byConfig_.try_emplace(config);
    if (!isNew) return known->second;
    Settings& settings = known->second;
    std::optional<Failure> failure = readConfig(config, settings);
    settings.setRoot(usual_.root());
    if (!failure) failure = readCommandLine(line_, settings);
    if (!failure) failure = settings.check();
    if (failure) {
      print(err_, *failure);
      hasFailed_ = true;
      settings = usual_;
    }
    return settings;
  }
  bool hasFailed() const { return hasFailed_; }

 private:
  static bool isSame(const fs::path& a, const fs::path& b) {
    std::error_code error;
    return !b.empty() && fs::equivalent(a, b, error);
  }

  const ParsedLine& line_;
  const Settings& usual_;
  const fs::path config_;
  std::ostream& err_;
  std::map<fs::path, Settings> byConfig_;
  bool hasFailed_ = false;
};

/// The common options of a line as arguments for another one.
std::vector<std::string> argumentsOf(const ParsedLine& line) {
  std::vector<std::string> arguments;
  for (const auto& [option, texts] : line.options) {
    if (option->arity == Arity::Flag) arguments.push_back(fmt::format("--{}", option->name));
    for (const std::string& text : texts) arguments.push_back(fmt::format("--{}={}", option->name, text));
  }
  return arguments;
}

int runCommand(const Command& command, std::vector<std::string> arguments, const Streams& streams) {
  ArgumentTable table;
  const Action action = command.setup(table);
  const ParsedLine line = parseArguments(command, table, std::move(arguments));
  if (line.helpWanted) {
    streams.out << commandHelp(command, table);
    return static_cast<int>(Exit::Clean);
  }
  if (line.failure) return failed(streams.err, *line.failure);

  Settings settings;
  const ParsedLine::CommonOption* named = line.option(Opt::Config);
  const bool isolated = line.option(Opt::Isolated) != nullptr;
  const fs::path config = named != nullptr ? fs::path(named->texts.back())
                          : isolated       ? fs::path()
                                           : findConfig(configFolder(line));
  if (!config.empty()) {
    if (auto failure = readConfig(config, settings)) {
      if (!command.needsNoConfig) return failed(streams.err, *failure);
      print(streams.err, *failure);
      settings = {};
    }
  }
  if (auto failure = readCommandLine(line, settings, command.comparesTwo)) return failed(streams.err, *failure);
  if (auto failure = settings.check()) return failed(streams.err, *failure);
  if (line.lacking != nullptr) {
    const std::vector<std::string>& inputs = settings.inputs();
    if (inputs.empty())
      return failed(streams.err, {fmt::format("{} is required", line.lacking->names),
                                  {},
                                  fmt::format("usage: rungproof {} {}", command.name, command.usage)});
    if (auto failure = line.lacking->take(inputs)) return failed(streams.err, *failure);
  }
  if (auto failure = folderFailure(line.lacking != nullptr ? settings.inputs() : line.inputs))
    return failed(streams.err, *failure);
  const std::vector<std::string>& inputs = line.lacking != nullptr ? settings.inputs() : line.inputs;
  std::array<Settings, 2> sides{};
  if (!command.comparesTwo) {
    if (auto failure = projectFailure(inputs, settings, command.takesEachProgram)) return failed(streams.err, *failure);
    applyHardware(inputs, settings);
  } else {
    sides = {settings, settings};
    const std::vector<std::string>& compared = line.arguments;  // OLD and NEW
    const auto isProject = [](const std::string& name) { return projectArgument(name) || !projectsIn(name).empty(); };
    const bool isProjectAmong = std::ranges::any_of(compared, isProject);
    for (const std::size_t i : {0U, 1U}) {
      if (auto failure = readCommandLine(line, sides[i], true, i == 0 ? "old:" : "new:"))
        return failed(streams.err, *failure);
      if (auto failure = sides[i].check()) return failed(streams.err, *failure);
      if (i >= compared.size()) continue;
      if (isProject(compared[i]) || !isProjectAmong) {
        if (auto failure = projectFailure({compared[i]}, sides[i], false)) return failed(streams.err, *failure);
      }
      applyHardware({compared[i]}, sides[i]);
    }
    // Blocks out of a CPU and sources tell nothing of its configuration: that of the project beside them counts.
    for (const std::size_t i : {0U, 1U}) {
      if (compared.size() == 2 && isProject(compared[1 - i]) && !isProject(compared[i]))
        applyHardware({compared[1 - i]}, sides[i]);
    }
  }

  Context context{settings,
                  streams.in,
                  streams.out,
                  streams.err,
                  wantsColor(settings, streams.outIsTerminal),
                  streams.errIsTerminal && !settings.flag(Opt::Quiet),
                  {},
                  false,
                  sides};
  context.outIsTerminal = streams.outIsTerminal;
  if (auto failure = readOutputs(settings, command, context.outputs)) return failed(streams.err, *failure);
  NearbySettings nearby(line, settings, config, streams.err);
  if (named == nullptr && !isolated)
    context.settingsNear = [&](const std::string& file) -> const Settings& { return nearby.near(file); };
  context.readSettings = [&](const std::string& file, Settings& fresh) {
    const bool searches = named == nullptr && !isolated;
    const fs::path nearest = searches ? findConfig(folderOf(file)) : config;
    std::optional<Failure> failure = nearest.empty() ? std::nullopt : readConfig(nearest, fresh);
    if (!failure) failure = readCommandLine(line, fresh);
    return failure ? failure : fresh.check();
  };
  context.given = argumentsOf(line);
  Exit exit = action(context);
  if (context.hasLostOutput || nearby.hasFailed()) exit = Exit::Failed;
  return static_cast<int>(exit);
}

/// A file stands where the command is expected: which commands take such a file.
std::optional<Failure> fileForCommand(const std::string& name, const std::vector<std::string>& rest) {
  std::error_code error;
  const fs::path path(name);
  const std::string ending = pathName(path.extension());
  if (!fs::exists(path, error)) {
    if (ending.empty()) return std::nullopt;
    return Failure{fmt::format("'{}' is no command, and no such file is here", name),
                   {},
                   "write the command first, such as: rungproof lint FILE; 'rungproof --help' lists the commands"};
  }
  const std::string message =
      fmt::format("'{}' is a {} and no command", name, fs::is_directory(path, error) ? "folder" : "file");
  const auto isCommand = [](const std::string& word) { return commandNamed(word) != nullptr; };
  if (const auto command = std::ranges::find_if(rest, isCommand); command != rest.end())
    return Failure{message, {}, fmt::format("the command comes first: rungproof {} {}", *command, name)};
  if (ending == ".prop")
    return Failure{message, {}, fmt::format("to prove what it states: rungproof prove PROGRAM --props {}", name)};
  if (ending == ".csv" || ending == ".vcd")
    return Failure{
        message,
        {},
        fmt::format("to run a program on it: rungproof sim PROGRAM --stimulus {0}; to compare two traces: "
                    "rungproof compare EXPECTED {0}; to run a test table: rungproof test PROGRAM --table {0}",
                    name)};
  return Failure{message,
                 {},
                 fmt::format("to check it: rungproof lint {0}; to prove its interlocks: rungproof prove {0}; to run "
                             "it: rungproof sim {0}",
                             name)};
}

bool isWatchable(const Command& command) {
  ArgumentTable table;
  const Action action = command.setup(table);
  return std::ranges::find(table.rows(), watchOption, &Argument::names) != table.rows().end();
}

int runArguments(const std::vector<std::string>& arguments, const Streams& streams) {
  const std::size_t at = commandIndex(arguments);
  if (at == arguments.size()) {
    for (const std::string& argument : arguments) {
      if (argument == "--version" || argument == "-V") {
        streams.out << "rungproof " << programVersion() << '\n';
        return static_cast<int>(Exit::Clean);
      }
      if (argument == "--help" || argument == "-h") {
        streams.out << programHelp();
        return static_cast<int>(Exit::Clean);
      }
    }
    if (arguments.empty()) {
      streams.err << programHelp();
      return static_cast<int>(Exit::Failed);
    }
    return failed(streams.err,
                  {fmt::format("'{}' needs a command", fmt::join(arguments, " ")), {}, "see 'rungproof --help'"});
  }
  std::vector<std::string> rest = arguments;
  rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(at));
  if (arguments[at] == "help") {
    const Command* topic = rest.empty() ? nullptr : commandNamed(rest.front());
    if (topic != nullptr) return runCommand(*topic, {"--help"}, streams);
    streams.out << programHelp();
    return static_cast<int>(Exit::Clean);
  }
  const Command* command = commandNamed(arguments[at]);
  if (command == nullptr) {
    if (const auto failure = fileForCommand(arguments[at], rest)) return failed(streams.err, *failure);
    const std::string_view meant = closest(arguments[at], commandNames());
    return failed(streams.err,
                  {fmt::format("unknown command '{}'", arguments[at]),
                   {},
                   meant.empty() ? "see 'rungproof --help'" : fmt::format("did you mean 'rungproof {}'?", meant)});
  }
  const auto watch = std::ranges::find(rest, watchOption);
  if (watch == rest.end() || !isWatchable(*command)) return runCommand(*command, std::move(rest), streams);
  rest.erase(watch);
  if (std::ranges::find(rest, "-") != rest.end())
    return failed(streams.err, {"standard input cannot be watched", {}, "give the name of a file"});
  WatchedRuns runs{&watchedRunWorker, watchedRunRequest(command->name, rest, streams)};
  runs.clears = streams.outIsTerminal;
  std::ranges::copy_if(rest, std::back_inserter(runs.given),
                       [](const std::string& argument) { return !argument.starts_with("-"); });
  return watchRuns(runs, streams.out, streams.err);
}

}  // namespace

const Command* commandNamed(std::string_view name) {
  for (const Command* command : allCommands()) {
    if (command->name == name) return command;
  }
  return nullptr;
}

std::vector<std::string_view> formatsOf(const Command& command) {
  if (!command.formats.empty()) {
    const auto words = permittedWords(command.formats);
    return words.empty() ? std::vector<std::string_view>{command.formats} : words;
  }
  std::vector<std::string_view> names = {"human"};
  for (const Reporter* reporter : allReporters()) {
    if (reporter->name != "human") names.push_back(reporter->name);
  }
  return names;
}

int runProgram(const std::vector<std::string>& arguments, const Streams& given) {
  forgetInputs();
  VisibleBuffer visible(given.err, given.errIsTerminal);
  std::ostream err(&visible);
  err.setf(std::ios::unitbuf);
  const Streams streams{given.in, given.out, err, given.outIsTerminal, given.errIsTerminal};
  try {
    const int exit = runArguments(arguments, streams);
    return streams.out.flush() ? exit : failed(streams.err, {"standard output cannot be written"});
  } catch (const std::bad_alloc&) {
    return failed(streams.err, {outOfMemory, {}, "close other programs, or ask less at once"});
  } catch (const std::system_error& error) {
    return failed(streams.err, {fmt::format("the system refuses what is needed: {}", error.code().message())});
  } catch (const std::exception& error) {
    // A broken assertion (ir/check.hpp) or an error of a library must not look like a result.
    return failed(streams.err, {fmt::format("internal error: {}", error.what())});
  }
}

}  // namespace rungproof
