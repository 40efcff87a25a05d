// From arguments to a command.
#include "frontend/cli.hpp"

#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <istream>
#include <ostream>

#include "frontend/config.hpp"

namespace rungproof {

namespace {

namespace fs = std::filesystem;

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

std::vector<std::string> optionNames(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

/// What CLI11 says of wrong arguments, in our words.
Failure usageFailure(const CLI::ParseError& error, const CLI::App& app, const Command& command) {
  const std::string seeHelp = fmt::format("see 'rungproof {} --help'", command.name);
  if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr) {
    const std::vector<std::string> rest = app.remaining();
    const std::string first = rest.empty() ? std::string() : rest.front();
    if (!first.starts_with("-")) return {fmt::format("unexpected argument '{}' for 'rungproof {}'", first, command.name), {}, seeHelp};
    const std::string name = first.substr(0, first.find('='));
    const std::vector<std::string> names = optionNames(app);
    const std::string_view meant = closest(name, names);
    return {fmt::format("unknown option '{}' for 'rungproof {}'", name, command.name), {},
            meant.empty() ? seeHelp : fmt::format("did you mean '{}'? {}", meant, seeHelp)};
  }
  if (dynamic_cast<const CLI::RequiredError*>(&error) != nullptr) {
    return {error.what(), {}, fmt::format("usage: rungproof {} {}", command.name, command.usage)};
  }
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr) {
    const std::string what = error.what();
    return {fmt::format("{} needs a value", what.substr(0, what.find(':'))), {}, seeHelp};
  }
  return {error.what(), {}, seeHelp};
}

/// Folder where the search for the configuration begins: that of the first file argument, else the current one.
fs::path configFolder(const CLI::App& app) {
  for (const CLI::Option* option : app.get_options()) {
    if (!option->get_positional() || option->results().empty()) continue;
    std::error_code error;
    const fs::path file(option->results().front());
    if (fs::exists(file, error)) return file.has_parent_path() ? file.parent_path() : fs::path(".");
  }
  return ".";
}

/// Values of the common options on the command line; also splits --choice KEY=VALUE.
std::optional<Failure> readCommandLine(const CLI::App& app, Settings& settings) {
  for (const OptionInfo& info : optionTable()) {
    const CLI::Option* option = app.get_option_no_throw("--" + std::string(info.name));
    if (option == nullptr || option->count() == 0) continue;
    const std::vector<std::string> given = info.arity == Arity::Flag ? std::vector<std::string>{"true"} : option->results();
    settings.set(info.id, given, "command line");
    if (info.arity == Arity::Flag || info.id == Opt::Format) continue;
    for (const std::string& text : settings.list(info.id)) {
      if (auto failure = checkValue(info, text)) return failure;
    }
  }
  for (const std::string& text : settings.list(Opt::ChoiceOf)) {
    const std::size_t sign = text.find('=');
    if (sign == std::string::npos) return Failure{fmt::format("'{}' is no choice", text), {}, "write --choice KEY=VALUE"};
    if (auto failure = settings.setChoice(text.substr(0, sign), text.substr(sign + 1), "command line")) return failure;
  }
  return std::nullopt;
}

std::optional<Failure> readOutputs(const Settings& settings, const Command& command, std::vector<OutputRequest>& outputs) {
  const std::vector<std::string_view> permitted = formatsOf(command);
  for (const std::string& text : settings.list(Opt::Format)) {
    const std::size_t sign = text.find('=');
    OutputRequest request{text.substr(0, sign), sign == std::string::npos ? std::string() : text.substr(sign + 1)};
    const bool known = std::find(permitted.begin(), permitted.end(), request.name) != permitted.end();
    // The configuration file names a form for the reports; commands with other forms keep their own.
    if (!known && settings.origin(Opt::Format) != "command line") continue;
    if (!known) {
      const std::string_view meant = closest(request.name, permitted);
      return Failure{fmt::format("'rungproof {}' has no format '{}'", command.name, request.name), {},
                     fmt::format("it can be {}{}", fmt::join(permitted, ", "),
                                 meant.empty() ? "" : fmt::format("; did you mean '{}'?", meant))};
    }
    if (sign != std::string::npos && request.file.empty()) {
      return Failure{fmt::format("--format {} names no file after '='", text), {}, {}};
    }
    outputs.push_back(std::move(request));
  }
  if (outputs.empty()) outputs.push_back({std::string(permitted.front()), {}});
  return std::nullopt;
}

bool wantsColor(const Settings& settings, bool isTerminal) {
  if (settings.text(Opt::Color) != "auto") return settings.text(Opt::Color) == "always";
  const char* off = std::getenv("NO_COLOR");
  const char* terminal = std::getenv("TERM");
  return isTerminal && (off == nullptr || *off == '\0') && (terminal == nullptr || std::string_view(terminal) != "dumb");
}

int failed(std::ostream& err, const Failure& failure) {
  print(err, failure);
  return static_cast<int>(Exit::Failed);
}

int runCommand(const Command& command, std::vector<std::string> arguments, const Streams& streams) {
  CLI::App app(std::string(command.summary), std::string(command.name));
  const Action action = command.setup(app);
  addCommonOptions(app);
  try {
    std::reverse(arguments.begin(), arguments.end());  // CLI11 takes them from the back
    app.parse(std::move(arguments));
  } catch (const CLI::CallForHelp&) {
    streams.out << commandHelp(command, app);
    return static_cast<int>(Exit::Clean);
  } catch (const CLI::ParseError& error) {
    return failed(streams.err, usageFailure(error, app, command));
  }

  Settings settings;
  const bool isolated = app.count("--isolated") > 0;
  const CLI::Option* named = app.get_option("--config");
  const fs::path config = named->count() > 0 ? fs::path(named->results().back()) : isolated ? fs::path() : findConfig(configFolder(app));
  if (!config.empty()) {
    if (auto failure = readConfig(config, settings)) return failed(streams.err, *failure);
  }
  if (auto failure = readCommandLine(app, settings)) return failed(streams.err, *failure);
  if (auto failure = settings.check()) return failed(streams.err, *failure);

  Context context{settings, streams.in, streams.out, streams.err, wantsColor(settings, streams.outIsTerminal),
                  streams.errIsTerminal && !settings.flag(Opt::Quiet), {}};
  if (auto failure = readOutputs(settings, command, context.outputs)) return failed(streams.err, *failure);
  const Exit exit = action(context);
  streams.out.flush();
  if (!streams.out) return failed(streams.err, {"standard output cannot be written"});
  return static_cast<int>(exit);
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
    return failed(streams.err, {fmt::format("'{}' needs a command", fmt::join(arguments, " ")), {}, "see 'rungproof --help'"});
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
    const std::string_view meant = closest(arguments[at], commandNames());
    return failed(streams.err, {fmt::format("unknown command '{}'", arguments[at]), {},
                                meant.empty() ? "see 'rungproof --help'" : fmt::format("did you mean 'rungproof {}'?", meant)});
  }
  return runCommand(*command, std::move(rest), streams);
}

}  // namespace

std::string_view programVersion() { return RUNGPROOF_VERSION; }

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

void addCommonOptions(CLI::App& app) {
  for (const OptionInfo& info : optionTable()) {
    std::string name = "--" + std::string(info.name);
    if (app.get_option_no_throw(name) != nullptr) continue;
    if (info.arity == Arity::Flag) {
      app.add_flag(info.id == Opt::Quiet ? "-q," + name : name);
      continue;
    }
    CLI::Option* option = app.add_option(name, [](const CLI::results_t&) { return true; }, std::string(info.help));
    option->expected(1)->allow_extra_args(false);
    option->multi_option_policy(info.arity == Arity::List ? CLI::MultiOptionPolicy::TakeAll : CLI::MultiOptionPolicy::TakeLast);
  }
}

int runProgram(const std::vector<std::string>& arguments, const Streams& streams) {
  try {
    return runArguments(arguments, streams);
  } catch (const std::exception& error) {
    // Nothing of ours throws; what arrives here comes from a library and must not look like a result.
    return failed(streams.err, {fmt::format("internal error: {}", error.what())});
  }
}

}  // namespace rungproof
