// `rungproof xref`: who reads and who writes each address, at which width, overlaps and free areas; with --tags also
// what is wrong with the tag list of a panel.
#include "analysis/flow/xref.hpp"

#include <fmt/ranges.h>

#include <filesystem>

#include "analysis/panel/panel_tags.hpp"
#include "frontend/command.hpp"
#include "frontend/files/closest_word.hpp"
#include "frontend/files/json.hpp"
#include "frontend/input/program_input.hpp"
#include "frontend/input/project_argument.hpp"
#include "frontend/input/protected_findings.hpp"
#include "frontend/stl/missing_address.hpp"
#include "frontend/text/columns.hpp"
#include "frontend/text/excerpt.hpp"
#include "ir/iec/cpu.hpp"

namespace rungproof {

namespace {

/// Whether only know-how protected blocks use it: that they do is not told.
bool isOfHiddenCode(const Facts& facts, const XrefEntry& entry) {
  return !entry.uses.empty() && std::ranges::all_of(entry.uses, [&](const Access* use) {
    return isCodeHidden(facts.program(), facts.pouOf(use->instruction));
  });
}

class XrefWriter {
 public:
  XrefWriter(const Facts& facts, const Xref& xref, std::vector<std::size_t> shown, bool whole,
             const std::vector<TagReport>& tags)
      : facts_(facts), xref_(xref), shown_(std::move(shown)), whole_(whole), tags_(tags) {
    for (const std::size_t i : shown_) {
      for (const Access* use : xref_.entries[i].uses) useColumn_ = std::max(useColumn_, useRow(*use).left.size() + 4);
    }
    for (const Access* access : xref_.throughPointers)
      useColumn_ = std::max(useColumn_, useRow(*access).left.size() + 4);
    useColumn_ = std::min<std::size_t>(useColumn_, 60);
  }

  std::string text(const Paint& paint) const {
    std::string text;
    if (shown_.empty())
      text += whole_ ? "no instruction names an address\n\n"
                     : "no instruction names it: nothing writes it, nothing reads it\n\n";
    for (const std::size_t i : shown_) appendEntry(text, xref_.entries[i], paint);
    if (!whole_ && !shown_.empty() && !isWritten()) text += "nothing in the program writes it\n\n";
    if (!xref_.throughPointers.empty()) {
      text += fmt::format("{} (these may touch other addresses too)\n", paint.bold("Through pointers"));
      std::vector<TextRow> rows;
      for (const Access* access : xref_.throughPointers) rows.push_back(useRow(*access));
      appendRows(text, rows, useColumn_);
      text += '\n';
    }
    if (whole_ && !facts_.dialect().memory.isOfVariables) appendFree(text, paint);
    if (!tags_.empty()) appendTags(text, paint);
    if (text.ends_with("\n\n")) text.pop_back();
    return text;
  }

  std::string json() const {
    Json json = {{"tool", "rungproof"},
                 {"command", "xref"},
                 {"addresses", Json::array()},
                 {"pointers", Json::array()},
                 {"free", Json::array()}};
    for (const std::size_t i : shown_) {
      const XrefEntry& entry = xref_.entries[i];
      Json row = {{"address", entryName(entry)},
                  {"symbol", symbolOf(entry)},
                  {"width", bits(entry.width)},
                  {"elements", entry.count},
                  {"block", entry.area == Area::L ? Json(facts_.program().pous[entry.block].name) : Json(nullptr)},
                  {"uses", Json::array()},
                  {"overlaps", Json::array()}};
      for (const Access* use : entry.uses) row["uses"].push_back(useJson(*use));
      for (const std::size_t other : overlapsOf(entry)) row["overlaps"].push_back(entryName(xref_.entries[other]));
      json["addresses"].push_back(std::move(row));
    }
    for (const Access* access : xref_.throughPointers) json["pointers"].push_back(useJson(*access));
    if (whole_) {
      for (const FreeRange& range : xref_.free)
        json["free"].push_back({{"area", areaName(range.area)}, {"first", range.first}, {"last", range.last}});
    }
    if (!tags_.empty()) json["tags"] = Json::array();
    for (const TagReport& tag : tags_) json["tags"].push_back(tagJson(tag));
    return json.dump(2) + "\n";
  }

 private:
  std::vector<std::size_t> overlapsOf(const XrefEntry& entry) const {
    std::vector<std::size_t> overlaps = entry.overlaps;
    std::erase_if(overlaps, [&](std::size_t other) { return isOfHiddenCode(facts_, xref_.entries[other]); });
    return overlaps;
  }

  /// Whether an instruction writes what is shown, or something outside does.
  bool isWritten() const {
    return std::ranges::any_of(shown_, [&](std::size_t i) {
      const XrefEntry& entry = xref_.entries[i];
      return isReadOnlyArea(entry.area) || entry.area == Area::I || entry.area == Area::SM ||
             std::ranges::any_of(entry.uses, [](const Access* use) { return use->write || use->maybe; });
    });
  }

  std::string symbolOf(const XrefEntry& entry) const {
    const Symbol* symbol = facts_.symbolOf(direct(entry.area, entry.width, entry.offset, entry.bit));
    return symbol == nullptr ? std::string() : symbol->name;
  }

  static std::string_view kindOf(const Access& access) {
    return access.maybe ? "read/write?" : access.write ? access.isBox ? "box" : "write" : "read";
  }

  /// The instruction, unless its block shows none to anybody.
  std::string said(const Access& access) const {
    return isCodeHidden(facts_.program(), facts_.pouOf(access.instruction))
               ? std::string("know-how protected")
               : Facts::text(*facts_.place(access.instruction).instruction);
  }

  TextRow useRow(const Access& access) const {
    const InstructionPlace& place = facts_.place(access.instruction);
    const Pou& pou = facts_.pouOf(access.instruction);
    const Network& network = facts_.networkOf(access.instruction);
    const SourceSet& sources = *facts_.program().sources;
    return {fmt::format("  {:<6} {}", kindOf(access), placeText(sources, place.instruction->span)),
            fmt::format("{}, network {}: {}", pou.name, network.number, said(access))};
  }

  Json useJson(const Access& access) const {
    const InstructionPlace& place = facts_.place(access.instruction);
    const SourceSet& sources = *facts_.program().sources;
    const Position position = sources.position(place.instruction->span);
    return {{"access", kindOf(access)},
            {"file", sources.file(place.instruction->span.file).name()},
            {"line", position.line},
            {"column", position.column},
            {"pou", facts_.pouOf(access.instruction).name},
            {"network", facts_.networkOf(access.instruction).number},
            {"instruction", said(access)}};
  }

  void appendEntry(std::string& text, const XrefEntry& entry, const Paint& paint) const {
    const std::string symbol = symbolOf(entry);
    const bool isVariable = facts_.dialect().memory.isOfVariables && !symbol.empty();  // where it lies is ours
    text += paint.bold(isVariable ? symbol : entryName(entry));
    if (!symbol.empty() && !isVariable) text += fmt::format("  {}", symbol);
    if (entry.area == Area::L) text += fmt::format("  in {}", facts_.program().pous[entry.block].name);
    text += '\n';
    std::vector<TextRow> rows;
    for (const Access* use : entry.uses) rows.push_back(useRow(*use));
    appendRows(text, rows, useColumn_);
    if (const std::vector<std::size_t> overlaps = overlapsOf(entry); !overlaps.empty()) {
      std::vector<std::string> names;
      for (const std::size_t other : overlaps) names.push_back(entryName(xref_.entries[other]));
      appendParagraph(text, fmt::format("overlaps {}", fmt::join(names, ", ")), 4);
    }
    text += '\n';
  }

  void appendFree(std::string& text, const Paint& paint) const {
    text += fmt::format("{} on the CPU {}\n", paint.bold("Free"), cpuName(facts_.target().cpu));
    std::vector<TextRow> rows;
    for (std::size_t i = 0; i < xref_.free.size();) {
      const Area area = xref_.free[i].area;
      std::vector<std::string> names;
      for (; i < xref_.free.size() && xref_.free[i].area == area; ++i) names.push_back(rangeName(xref_.free[i]));
      rows.push_back({std::string(areaName(area)), fmt::format("{}", fmt::join(names, ", "))});
    }
    appendRows(text, rows, 6);
  }

  void appendTags(std::string& text, const Paint& paint) const {
    const SourceSet& sources = *facts_.program().sources;
    std::vector<TextRow> rows;
    std::size_t width = 0;
    for (const TagReport& report : tags_) {
      for (const TagProblem& problem : report.problems) {
        std::string place =
            problem.place == nullptr ? std::string() : fmt::format(" ({})", placeText(sources, problem.place->span));
        rows.push_back(
            {fmt::format("  {} {}", placeText(sources, report.tag->span), report.tag->name), problem.message + place});
        width = std::max(width, rows.back().left.size() + 2);
      }
    }
    if (!text.ends_with("\n\n")) text += '\n';
    text += fmt::format("{}: {} tag{}, {}\n", paint.bold("Panel"), tags_.size(), tags_.size() == 1 ? "" : "s",
                        rows.empty()       ? std::string("nothing wrong with them")
                        : rows.size() == 1 ? std::string("one problem")
                                           : fmt::format("{} problems", rows.size()));
    appendRows(text, rows, std::min<std::size_t>(width, 50));
  }

  Json tagJson(const TagReport& report) const {
    const SourceSet& sources = *facts_.program().sources;
    const Position position = sources.position(report.tag->span);
    Json row = {{"name", report.tag->name},     {"address", toString(report.tag->address)},
                {"type", report.tag->typeText}, {"file", sources.file(report.tag->span.file).name()},
                {"line", position.line},        {"reads", report.readers},
                {"writes", report.writers},     {"problems", Json::array()}};
    for (const TagProblem& problem : report.problems)
      row["problems"].push_back({{"problem", tagFaultName(problem.fault)}, {"message", problem.message}});
    return row;
  }

  const Facts& facts_;
  const Xref& xref_;
  std::vector<std::size_t> shown_;
  bool whole_;
  const std::vector<TagReport>& tags_;
  std::size_t useColumn_ = 0;  ///< where the second column begins
};

/// The last argument is an address if no file has that name and the program knows it.
std::optional<Operand> takeAddress(std::vector<std::string>& arguments, const Context& context) {
  std::error_code error;
  if (arguments.size() < 2 || std::filesystem::exists(arguments.back(), error)) return std::nullopt;
  const std::vector<std::string> files(arguments.begin(), arguments.end() - 1);
  Operand address;
  if (auto direct = lookupIn(Program{})(arguments.back())) {
    address = *direct;
  } else if (auto named = lookupIn(readProgram(files, readOptionsOf(context.settings)))(arguments.back())) {
    address = *named;
  } else {
    return std::nullopt;
  }
  arguments = files;
  return address;
}

/// A last argument that is no file either, and does not look like the name of one.
std::optional<Failure> unknownName(const std::vector<std::string>& arguments, const Context& context) {
  std::error_code error;
  const std::string& name = arguments.back();
  if (arguments.size() < 2 || name == "-" || name.find_first_of("./\\*") != std::string::npos ||
      std::filesystem::exists(name, error))
    return std::nullopt;
  const Program program = readProgram({arguments.begin(), arguments.end() - 1}, readOptionsOf(context.settings));
  std::vector<std::string> names;
  for (const Symbol& symbol : program.symbols) names.push_back(symbol.name);
  const std::string_view meant = closest(name, names);
  return Failure{fmt::format("'{}' is no file, no address and no symbol of the program", name),
                 {},
                 meant.empty() ? "give the symbol table with --symbols, or write the address"
                               : fmt::format("did you mean '{}'?", meant)};
}

/// `heading`: above the text; empty: none.
Exit listProgram(Context& context, const std::vector<std::string>& arguments, const std::optional<Operand>& address,
                 const std::string& heading) {
  ProgramInput input = readInput(context, arguments);
  if (const auto missing = address ? missingFrom(input.program.target, *address) : std::nullopt)
    return context.fail({*missing, {}, "choose the CPU with --cpu"});
  const UnreadCode unread(input.program);
  // The list may be wrong where the program was not understood, so the places are shown beside it.
  if (!unread.empty()) printUnread(context, "xref", input.program, unread, arguments);
  const Facts facts(input.program, input.properties.externals, input.surroundings);
  Xref xref = crossReference(facts);
  std::vector<std::size_t> shown;
  if (address) {
    std::erase_if(xref.throughPointers, [&](const Access* access) {
      return access->pointed == Pointed::InArea && access->area != address->area;
    });
    shown = entriesTouching(xref, *address);
  } else {
    for (std::size_t i = 0; i < xref.entries.size(); ++i) {
      if (!isOfHiddenCode(facts, xref.entries[i])) shown.push_back(i);
    }
  }
  std::vector<TagReport> tags;
  if (!address) tags = tagReports(facts, retentiveRanges(input.program, context.settings.retentive()));
  const XrefWriter writer(facts, xref, std::move(shown), !address, tags);
  Exit exit = unread.isRefused() ? Exit::Failed : Exit::Clean;
  if (std::ranges::any_of(tags, [](const TagReport& tag) { return !tag.problems.empty(); }))
    exit = worse(exit, Exit::Found);
  for (const OutputRequest& output : context.outputs) {
    const std::string text =
        output.name == "json" ? writer.json() : heading + writer.text(Paint{context.color && output.file.empty()});
    if (!context.write(output, text)) exit = Exit::Failed;
  }
  return exit;
}

Exit runXref(Context& context, std::vector<std::string> arguments) {
  const std::optional<Operand> address = takeAddress(arguments, context);
  if (!address) {
    if (const auto failure = unknownName(arguments, context)) return context.fail(*failure);
  }
  const std::vector<std::string> programs = expandProjects(arguments, context.settings);
  if (!std::ranges::all_of(programs, isProjectProgram)) return listProgram(context, arguments, address, {});
  const bool isJson = std::ranges::any_of(context.outputs, [](const OutputRequest& out) { return out.name == "json"; });
  if (isJson && programs.size() > 1)
    return context.fail({fmt::format("JSON is written of one program, and there are {}", programs.size()),
                         arguments.front(), "name one with --program; 'rungproof show --list' lists them"});
  Exit exit = Exit::Clean;
  for (const std::string& program : programs)
    exit = worse(exit, listProgram(context, {program}, address, programs.size() > 1 ? program + "\n" : ""));
  return exit;
}

Action setUpXref(ArgumentTable& table) {
  auto arguments = std::make_shared<std::vector<std::string>>();
  table.arguments("FILE", *arguments,
                  "files of the program; a last argument that is no file is an address or symbol to show");
  return [arguments](Context& context) { return runXref(context, *arguments); };
}

}  // namespace

extern constexpr Command xrefCommand = {
    .name = "xref",
    .usage = "FILE... [ADDRESS]",
    .summary = "list who reads and writes each address, overlaps and free areas",
    .details =
        "Examples:\n"
        "    rungproof xref press.awl\n"
        "    rungproof xref press.awl VW10\n"
        "    rungproof xref press.awl --tags panel.csv    tags that nothing uses, of wrong width or type, with two\n"
        "                                                 masters, or cleared by a power failure: exit code 1\n",
    .shows = option_group::Reading | option_group::Output | option_group::Configuration,
    .formats = "text|json",
    .takesEachProgram = true,
    .setup = setUpXref,
};

}  // namespace rungproof
