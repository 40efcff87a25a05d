// Old and new side by side.
#include "frontend/sides/difference_view.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "frontend/cli/cli.hpp"
#include "frontend/files/json.hpp"
#include "frontend/text/excerpt.hpp"
#include "frontend/text/safe_text.hpp"

namespace rungproof {

namespace {

/// Columns that a line of UTF-8 text takes, drawings and letters being one column wide.
std::size_t textColumns(std::string_view line) {
  return static_cast<std::size_t>(
      std::ranges::count_if(line, [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

std::string_view equalityWord(Equality equality) {
  switch (equality) {
    case Equality::Equal: return "proved equal";
    case Equality::Different: return "can differ";
    case Equality::Unknown: return "undecided";
  }
  return "undecided";
}

std::string_view changeWord(const NetworkPair& pair) {
  return pair.before && pair.after ? "changed" : pair.after ? "added" : "removed";
}

const Network& networkOf(const Program& program, const NetworkRef& where) {
  return program.pous[where.pou].networks[where.network];
}
std::string networkPlace(const Program& program, const NetworkRef& where) {
  const Network& network = networkOf(program, where);
  const std::string place = fmt::format("{}, Network {}", program.pous[where.pou].name, network.number);
  return network.title.empty() ? place : fmt::format("{}  {}", place, network.title.view());
}

/// Where a text has it; nothing of a drawing that was read from no lines.
const SourceFile* fileOf(const Program& program, const NetworkRef& where) {
  const Span span = networkOf(program, where).span;
  return span.file < program.sources->size() ? &program.sources->file(span.file) : nullptr;
}

std::vector<std::string> linesOf(const Program& program, const std::optional<NetworkRef>& where,
                                 const DifferenceStyle& style) {
  if (!where) return {"(not there)"};
  return contentLines(changedView(program, *where, style), {});
}

std::string listOf(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

std::string outputsWith(const NetworkChange& change, Equality equality) {
  std::vector<std::string> names;
  for (const InfluencedOutput& output : change.outputs) {
    if (output.equality == equality) names.push_back(output.name);
  }
  return listOf(names);
}

}  // namespace

NetworkView changedView(const Program& program, const NetworkRef& where, const DifferenceStyle& style) {
  ViewOptions options;
  options.form = style.form;
  options.width = style.width / 2 - 2;
  return networkView(program, program.pous[where.pou], networkOf(program, where), options);
}

std::string changeHeading(const Sides& sides, const NetworkPair& pair) {
  const std::string before = pair.before ? networkPlace(*sides.runBefore, *pair.before) : "";
  const std::string after = pair.after ? networkPlace(*sides.runAfter, *pair.after) : "";
  if (before.empty() || after.empty() || before == after)
    return fmt::format("{}: {}", before.empty() ? after : before, changeWord(pair));
  return fmt::format("{} (before: {}): {}", after, before, changeWord(pair));
}

std::string sideHeading(const Sides& sides, const NetworkPair& pair, bool isOld) {
  const std::string side = isOld ? "OLD" : "NEW";
  const Program& program = isOld ? *sides.runBefore : *sides.runAfter;
  const std::optional<NetworkRef>& where = isOld ? pair.before : pair.after;
  if (!where || fileOf(program, *where) == nullptr) return side;
  return fmt::format("{}  {}:{}", side, fileOf(program, *where)->name(),
                     program.sources->position(networkOf(program, *where).span).line);
}

std::vector<InfluenceLine> influenceLines(const NetworkChange& change) {
  std::vector<InfluenceLine> lines;
  for (const Equality equality : {Equality::Different, Equality::Unknown, Equality::Equal}) {
    const std::string names = outputsWith(change, equality);
    if (!names.empty()) lines.push_back({fmt::format("{}: {}", equalityWord(equality), names), equality});
  }
  if (change.isOfPart)
    lines.push_back({"may influence outputs: who runs it is not known", Equality::Unknown});
  else if (change.outputs.empty())
    lines.push_back({"influences no output", {}});
  if (!change.memory.empty()) lines.push_back({"influences: " + listOf(change.memory), {}});
  if (change.isEverything)
    lines.push_back(
        {"may influence any memory: it writes through a pointer, sets a device going, or stops the program", {}});
  return lines;
}

std::vector<std::string> valueLines(const ProgramDifference& difference) {
  constexpr std::size_t most = 20;
  std::vector<std::string> lines;
  for (const ValueChange& value : difference.values) {
    if (lines.size() == most) {
      lines.push_back(fmt::format("{} more begin with other values", difference.values.size() - most));
      break;
    }
    lines.push_back(changeText(value));
  }
  return lines;
}

std::string closingLine(const ProgramDifference& difference) {
  const auto counted = [](std::size_t n, std::string_view one, std::string_view many) {
    return fmt::format("{} {}", n, n == 1 ? one : many);
  };
  std::string text =
      counted(difference.changes.size(), "network changed", "networks changed") + ", " +
      (difference.values.empty() ? ""
                                 : counted(difference.values.size(), "first value", "first values") + " changed, ") +
      counted(difference.countOf(Equality::Different), "output can differ", "outputs can differ");
  if (const std::size_t open = difference.countOf(Equality::Unknown); open > 0)
    text += fmt::format(", {} undecided", open);
  return text;
}

namespace {

/// The run of the first difference: its table, and what drives the output in either program, lit by its last scan.
std::string firstDifference(const Comparison& run, const Paint& paint) {
  std::string text = fmt::format("\n{} {}\n", paint.red("first difference:"), messageText(differenceText(run)));
  for (const std::string& note : run.notes) text += fmt::format("  {} {}\n", paint.blue("="), messageText(note));
  for (const ShownScan& scan : run.scans) {
    for (const ShownNetwork& network : scan.networks) {
      if (network.text.empty()) continue;
      text += fmt::format("  {}\n", messageText(network.heading));
      for (const std::string& line : network.text) text += fmt::format("  {}\n", line);
    }
  }
  return text + '\n';
}

}  // namespace

std::string differenceText(const Sides& sides, const ProgramDifference& difference, const DifferenceStyle& style) {
  const Paint paint{style.color};
  std::string text;
  for (const VerdictChange& verdict : difference.verdicts)
    text += fmt::format("{}: '{}' was {}, is {}\n", paint.red("verdict"), verdict.name, verdict.before, verdict.after);
  for (const std::string& line : valueLines(difference)) text += fmt::format("{}: {}\n", paint.yellow("value"), line);
  for (const NetworkChange& change : difference.changes) {
    text += (text.empty() ? "" : "\n") + paint.bold(changeHeading(sides, change.networks)) + '\n';
    const std::vector<std::string> left = linesOf(*sides.runBefore, change.networks.before, style),
                                   right = linesOf(*sides.runAfter, change.networks.after, style);
    const std::array headings = {messageText(sideHeading(sides, change.networks, true)),
                                 messageText(sideHeading(sides, change.networks, false))};
    std::size_t width = textColumns(headings[0]);
    for (const std::string& line : left) width = std::max(width, textColumns(line));
    const auto row = [&](std::string_view a, std::string_view b) {
      std::string line = fmt::format("  {}{} | {}", a, std::string(width - std::min(width, textColumns(a)), ' '), b);
      line.erase(line.find_last_not_of(' ') + 1);
      text += line + '\n';
    };
    row(headings[0], headings[1]);
    for (std::size_t i = 0; i < std::max(left.size(), right.size()); ++i)
      row(i < left.size() ? left[i] : "", i < right.size() ? right[i] : "");
    for (const InfluenceLine& line : influenceLines(change))
      text += fmt::format("  {} {}\n", paint.blue("="), line.text);
  }
  for (const std::string& note : difference.equivalence.notes)
    text += fmt::format("{}: {}\n", paint.yellow("note"), note);
  if (difference.first) text += firstDifference(*difference.first, paint);
  return text;
}

std::string differenceJson(const Sides& sides, const ProgramDifference& difference) {
  Json json = {{"tool", "rungproof"}, {"version", programVersion()}, {"command", "diff"}};
  json["changes"] = Json::array();
  for (const NetworkChange& change : difference.changes) {
    const auto place = [](const Program& program, const std::optional<NetworkRef>& where) -> Json {
      if (!where) return nullptr;
      const Network& network = networkOf(program, *where);
      const SourceFile* file = fileOf(program, *where);
      return {{"pou", program.pous[where->pou].name},
              {"network", network.number},
              {"title", network.title.view()},
              {"file", file != nullptr ? Json(file->name()) : Json()},
              {"line", file != nullptr ? Json(program.sources->position(network.span).line) : Json()}};
    };
    Json outputs = Json::array();
    for (const InfluencedOutput& output : change.outputs)
      outputs.push_back({{"name", output.name}, {"verdict", equalityWord(output.equality)}});
    json["changes"].push_back({{"kind", changeWord(change.networks)},
                               {"old", place(*sides.runBefore, change.networks.before)},
                               {"new", place(*sides.runAfter, change.networks.after)},
                               {"outputs", outputs},
                               {"memory", change.memory}});
  }
  json["verdicts"] = Json::array();
  for (const VerdictChange& verdict : difference.verdicts)
    json["verdicts"].push_back({{"name", verdict.name}, {"old", verdict.before}, {"new", verdict.after}});
  json["values"] = Json::array();
  for (const ValueChange& value : difference.values)
    json["values"].push_back({{"name", value.name}, {"old", value.before}, {"new", value.after}});
  json["first_difference"] = nullptr;
  if (const auto& run = difference.first)
    json["first_difference"] = {{"scan", run->scan},
                                {"time_ms", run->timeMs},
                                {"signal", run->signal},
                                {"old", run->expected},
                                {"new", run->actual}};
  json["summary"] = {{"changed", difference.changes.size()},
                     {"different", difference.countOf(Equality::Different)},
                     {"equal", difference.countOf(Equality::Equal)},
                     {"undecided", difference.countOf(Equality::Unknown)}};
  return json.dump(2) + '\n';
}

}  // namespace rungproof
