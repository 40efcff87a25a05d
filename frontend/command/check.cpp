// `rungproof check`: what the editor says of each network - will this text become a program, and can it be shown as
// ladder. Contract: the networks of the JSON report.
#include <fmt/format.h>

#include <map>
#include <unordered_map>

#include "analysis/drawing/editor_verdict.hpp"
#include "analysis/unread/hidden_blocks.hpp"
#include "frontend/cli/cli.hpp"
#include "frontend/command.hpp"
#include "frontend/files/json.hpp"
#include "frontend/input/program_input.hpp"
#include "frontend/input/project_argument.hpp"
#include "frontend/stl/file_block.hpp"
#include "frontend/stl/stl_likeness.hpp"
#include "frontend/text/excerpt.hpp"
#include "frontend/watch.hpp"
#include "ir/s7300/cpu.hpp"
#include "ir/s7300/declarations.hpp"

namespace rungproof {

namespace {

struct CheckArguments {
  std::vector<std::string> files;
  std::string language;
  bool watch = false;
};

/// A block is valid if its head, its declarations and all its networks are.
struct BlockVerdict {
  std::string name;
  bool isValid = true;
  std::string reason;  ///< the first one
};

/// The verdicts on one program, and what they are about.
struct Checked {
  Program program;
  std::vector<NetworkVerdict> verdicts;
  std::vector<std::pair<Span, std::string>> notes;  ///< on blocks that no file holds
  std::vector<s7300::SourceFault> heads;            ///< of an S7-300/400: faults outside of networks
  bool isStl = false;
  bool isGuessed = false;  ///< the language was taken from the program

  std::vector<std::string> names{};  ///< by block; one without a head has the name of its file

  const Pou& pouOf(const NetworkVerdict& verdict) const { return program.pous[verdict.place.block]; }
  const std::string& nameOf(const NetworkVerdict& verdict) const { return names[verdict.place.block]; }
  void nameBlocks() {
    for (const Pou& pou : program.pous) {
      const SourceFile& file = program.sources->file(pou.span.file);
      const bool isHeadless = pou.kind == PouKind::Main && pou.name == "MAIN" && !program.olderDialect &&
                              !pou.networks.empty() && pou.networks.front().form == Form::Stl &&
                              !stlLikeness(file.text()).hasHeading;
      names.push_back(isHeadless ? fileBlock(file.name()).name : pou.name);
    }
  }
  int numberOf(const NetworkVerdict& verdict) const { return pouOf(verdict).networks[verdict.place.network].number; }
  std::string placeOf(Span span) const {
    const Position position = program.sources->position(span);
    return fmt::format("{}:{}:{}", program.sources->file(span.file).name(), position.line, position.column);
  }
  /// Of an S7-300/400; of a program without block verdicts none.
  std::vector<BlockVerdict> blocks() const {
    std::vector<BlockVerdict> result;
    if (program.declarations == nullptr) return result;
    std::unordered_map<std::string, std::size_t> byName;
    const auto refuse = [&](const std::string& name, const std::string& reason) {
      const auto [found, isNew] = byName.try_emplace(name, result.size());
      if (isNew) result.push_back({name, true, ""});
      BlockVerdict& block = result[found->second];
      if (block.isValid && !reason.empty()) block = {name, false, reason};
    };
    for (const Pou& pou : program.pous) {
      if (!pou.isBuiltIn) refuse(pou.name, "");
    }
    for (const s7300::SourceFault& fault : heads) refuse(fault.block, fault.reason);
    for (const NetworkVerdict& verdict : verdicts) refuse(nameOf(verdict), verdict.reason);
    return result;
  }
  std::size_t invalid() const {
    return static_cast<std::size_t>(
        std::ranges::count_if(verdicts, [](const NetworkVerdict& v) { return !v.reason.empty(); }));
  }
};

/// What the editor of STEP 7 refuses makes its network invalid, or its block.
void takeSourceFaults(Checked& check) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> byPlace;  // blocks by file and where they begin
  for (std::uint32_t block = 0; block < check.program.pous.size(); ++block)
    byPlace.try_emplace({check.program.pous[block].span.file, check.program.pous[block].span.offset}, block);
  std::map<std::pair<std::uint32_t, int>, NetworkVerdict*> byNumber;
  for (NetworkVerdict& verdict : check.verdicts)
    byNumber.try_emplace({verdict.place.block, check.numberOf(verdict)}, &verdict);
  const auto blockAt = [&](Span span) -> std::optional<std::uint32_t> {
    const auto behind = byPlace.upper_bound({span.file, span.offset});
    if (behind == byPlace.begin()) return std::nullopt;
    const std::uint32_t block = std::prev(behind)->second;
    return span.beginsIn(check.program.pous[block].span) ? std::optional(block) : std::nullopt;
  };
  for (const s7300::SourceFault& fault : check.program.declarations->sourceFaults) {
    if (fault.network == 0) {
      check.heads.push_back(fault);
      if (const auto block = blockAt(fault.span)) check.heads.back().block = check.program.pous[*block].name;
      continue;
    }
    const auto block = blockAt(fault.span);
    const auto found = block ? byNumber.find({*block, fault.network}) : byNumber.end();
    if (found == byNumber.end() || !found->second->reason.empty()) continue;
    found->second->reason = fault.reason;
    found->second->span = fault.span;
  }
}

Checked checked(const Context& context, const CheckArguments& arguments, const std::vector<std::string>& files) {
  Checked result;
  result.program = readInput(context, files).program;
  result.nameBlocks();
  // The rule of one rung a network is an editor's of the S7-200 SMART.
  const bool isOtherEditor = formOf(result.program.target) != StatementForm::Rungs;
  result.isGuessed = arguments.language.empty() && !isOtherEditor;
  result.isStl = isOtherEditor || (result.isGuessed ? isWrittenAsStl(result.program) : arguments.language == "stl");
  const UnreadCode unread(result.program);
  result.verdicts = editorVerdicts(result.program, unread, result.isStl ? EditorLanguage::Stl : EditorLanguage::Ladder);
  if (result.program.declarations != nullptr) takeSourceFaults(result);
  for (const MissingBlock& block : missingBlocks(unread.facts()))
    result.notes.emplace_back(block.firstCall->span, missingText(block));
  return result;
}

std::string plural(std::size_t count, std::string_view word) {
  return fmt::format("{} {}{}", count, word, count == 1 ? "" : "s");
}

std::string textOfCheck(const Checked& check, const Paint& paint, bool isQuiet) {
  std::string text;
  if (check.isStl && check.isGuessed)
    text +=
        "note: most networks hold several rungs, so the program is judged as STL; --language ladder judges it as "
        "ladder\n";
  std::size_t notDrawn = 0;
  for (const NetworkVerdict& verdict : check.verdicts) {
    if (!verdict.isDrawn) ++notDrawn;
    if (verdict.reason.empty()) continue;
    text += fmt::format("{}: {}, network {} is {}: {}\n", check.placeOf(verdict.span), check.nameOf(verdict),
                        check.numberOf(verdict), paint.red("invalid"), verdict.reason);
  }
  for (const s7300::SourceFault& fault : check.heads)
    text +=
        fmt::format("{}: {} is {}: {}\n", check.placeOf(fault.span), fault.block, paint.red("invalid"), fault.reason);
  for (const NetworkVerdict& verdict : check.verdicts) {
    if (verdict.isDrawn) continue;
    text += fmt::format("{}: note: {}, network {} is valid, but the ladder view may not be able to show it\n",
                        check.placeOf(verdict.span), check.nameOf(verdict), check.numberOf(verdict));
  }
  for (const auto& [span, note] : check.notes) text += fmt::format("{}: note: {}\n", check.placeOf(span), note);
  if (isQuiet) return text;
  const std::size_t invalid = check.invalid();
  text += fmt::format("{}: {} valid, {} invalid\n", plural(check.verdicts.size(), "network"),
                      check.verdicts.size() - invalid, invalid);
  const std::vector<BlockVerdict> blocks = check.blocks();
  const auto bad = static_cast<std::size_t>(std::ranges::count(blocks, false, &BlockVerdict::isValid));
  return blocks.empty() ? text
                        : text + fmt::format("{}: {} valid, {} invalid\n", plural(blocks.size(), "block"),
                                             blocks.size() - bad, bad);
}

void addTo(Json& json, const Checked& check) {
  for (const NetworkVerdict& verdict : check.verdicts) {
    const Position position = check.program.sources->position(verdict.span);
    json["networks"].push_back({{"pou", check.nameOf(verdict)},
                                {"network", check.numberOf(verdict)},
                                {"valid", verdict.reason.empty()},
                                {"reason", verdict.reason.empty() ? Json(nullptr) : Json(verdict.reason)},
                                {"displayable", verdict.reason.empty() && verdict.isDrawn},
                                {"file", check.program.sources->file(verdict.span.file).name()},
                                {"line", position.line}});
  }
  for (const BlockVerdict& block : check.blocks())
    json["blocks"].push_back({{"block", block.name},
                              {"valid", block.isValid},
                              {"reason", block.isValid ? Json(nullptr) : Json(block.reason)}});
  for (const auto& [span, note] : check.notes) json["notes"].push_back(note);
}

std::string jsonOf(const std::vector<Checked>& checks) {
  Json json = {{"tool", "rungproof"},       {"version", programVersion()},
               {"command", "check"},        {"language", checks.front().isStl ? "stl" : "ladder"},
               {"networks", Json::array()}, {"notes", Json::array()}};
  for (const Checked& check : checks) addTo(json, check);
  return json.dump(2) + "\n";
}

/// What is wrong outside of networks goes to standard error.
Exit judge(const Checked& check, const std::string& file, Context& context) {
  // A fault outside every network, such as a file that cannot be read, leaves nothing to judge.
  const auto isOutside = [](const Finding& finding) {
    return finding.severity == Severity::Error && finding.network == 0;
  };
  const bool isUnread = check.verdicts.empty() || std::ranges::any_of(check.program.findings, isOutside);
  Exit exit = isUnread ? Exit::Failed : check.invalid() + check.heads.size() > 0 ? Exit::Found : Exit::Clean;
  for (const Finding& finding : check.program.findings) {
    if (!isOutside(finding)) continue;
    const Position position = check.program.sources->position(finding.span);
    print(context.err,
          {finding.message, fmt::format("{}:{}", check.program.sources->file(finding.span.file).name(), position.line),
           finding.help});
  }
  if (check.verdicts.empty())
    print(context.err, {"no network was found", file, "give a program, or the folder of a project"});
  return exit;
}

Exit runCheck(const CheckArguments& arguments, Context& context) {
  // The programs of a project come one after the other, each below its name; all else is one program.
  const std::vector<std::string> programs = expandProjects(arguments.files, context.settings);
  const bool isProject = std::ranges::all_of(programs, isProjectProgram);
  std::vector<Checked> checks;
  Exit exit = Exit::Clean;
  for (std::size_t i = 0; i < (isProject ? programs.size() : 1); ++i) {
    const std::vector<std::string> files = isProject ? std::vector{programs[i]} : arguments.files;
    checks.push_back(checked(context, arguments, files));
    exit = worse(exit, judge(checks.back(), files.front(), context));
  }
  for (const OutputRequest& output : context.outputs) {
    std::string text;
    if (output.name == "json") {
      text = jsonOf(checks);
    } else {
      for (std::size_t i = 0; i < checks.size(); ++i) {
        if (checks.size() > 1) text += programs[i] + "\n";
        text += textOfCheck(checks[i], Paint{context.color && output.file.empty()}, context.settings.flag(Opt::Quiet));
      }
    }
    if (!context.write(output, text)) exit = Exit::Failed;
  }
  return exit;
}

Action setUpCheck(ArgumentTable& table) {
  auto arguments = std::make_shared<CheckArguments>();
  table.arguments("FILE", arguments->files, "files of one program; a folder stands for its programs");
  table.word("--language", arguments->language, {"ladder", "stl"}, "ladder|stl",
             "view that must show the networks; in stl a network may hold several rungs (from the program)");
  table.flag(watchOption, arguments->watch, watchHelp);
  return [arguments](Context& context) { return runCheck(*arguments, context); };
}

}  // namespace

extern constexpr Command checkCommand = {
    .name = "check",
    .usage = "FILE...",
    .summary = "say of each network whether the editor takes it",
    .details =
        "An editor of the S7-200 SMART leaves an invalid network out of the download without an error: an unknown\n"
        "mnemonic or symbol, a wrong operand, no load at the start, a second rung, FOR and NEXT together.\n"
        "Sources of an S7-300/400 are judged as SIMATIC Manager compiles them: semicolons, lengths of labels and "
        "names,\n"
        "start values, blocks before their use; each block is valid or not.\n"
        "Exit code 0: all networks are valid; 1: some are not; 2: the files could not be read.\n"
        "\n"
        "Examples:\n"
        "    rungproof check --cpu ST40 press.awl\n"
        "    rungproof check --language stl --format json project/\n",
    .shows = option_group::Reading | option_group::Output | option_group::Configuration,
    .formats = "text|json",
    .takesEachProgram = true,
    .setup = setUpCheck,
};

}  // namespace rungproof
