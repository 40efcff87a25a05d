// `rungproof export`: the transition system of a program with its properties, for other model checkers.
#include <fmt/format.h>

#include <algorithm>

#include "analysis/export/system.hpp"
#include "analysis/proof/question_system.hpp"
#include "analysis/unread/hidden_blocks.hpp"
#include "frontend/command.hpp"
#include "frontend/input/proof_input.hpp"
#include "frontend/input/protected_findings.hpp"

namespace rungproof {

namespace {

struct ExportArguments {
  std::vector<std::string> files;
  std::vector<std::string> properties;
  std::vector<std::string> only;
  bool asDownloaded = false;
  bool builtin = false;
  std::string output;
};

std::string textOfExport(const std::string& format, const TransitionSystem& system, int bound,
                         const ExportRemarks& remarks) {
  if (format == "aiger") return exportAiger(system, remarks);
  if (format == "aiger-ascii") return exportAigerText(system, remarks);
  if (format == "smt2") return exportSmt2(system, std::max(bound, 1), remarks);
  if (format == "smv") return exportSmv(system, remarks);
  return exportBtor2(system, remarks);
}

/// What the reader of the file must know to read its answers as ours.
ExportRemarks remarksOf(const ProgramInput& input, QuestionSystem& side, const ProverOptions& options) {
  ExportRemarks remarks;
  for (const std::string& text : environmentTexts(input.program, input.properties, options.time, options.choices))
    remarks.push_back("assumes: " + text);
  for (const std::string& text : approximationTexts(input.program, side.askedProperties()))
    remarks.push_back("approximated: " + text);
  return remarks;
}

/// The program as it is written, so that a reader of the file need not believe our simplifications; where that cannot
/// be made, simplified.
std::unique_ptr<QuestionSystem> asWritten(const ProgramInput& input, const std::vector<Property>& goals,
                                          EncoderOptions options, const CheckGroups& groups) {
  options.trail = std::make_shared<Trail>();
  auto simplified = std::make_unique<QuestionSystem>(input.program, input.properties, goals, options, groups);
  options.trail->isFollowed = true;
  try {
    return std::make_unique<QuestionSystem>(input.program, input.properties, goals, options, groups);
  } catch (const DecisionsDiverge&) {
    return simplified;
  }
}

/// Takes out the goals that depend on what was not read; one line for each.
std::vector<std::string> leaveOutDependent(ProgramInput& input, const UnreadCode& unread) {
  std::vector<std::string> lines;
  std::erase_if(input.properties.properties, [&](const Property& property) {
    const std::vector<std::string> reasons = unread.reasons(property);
    if (!property.isGoal() || reasons.empty()) return false;
    lines.push_back(fmt::format("{}: {}", property.name, reasons.front()));
    return true;
  });
  return lines;
}

/// Whether some goals are left that depend on nothing else: no assumption is open, no statement about the world, and no
/// device of another family.
bool isExportable(const ProgramInput& input, const UnreadCode& unread, bool builtin) {
  const std::vector<Property>& properties = input.properties.properties;
  const bool isOpen = std::ranges::any_of(
      properties, [&](const Property& property) { return !property.isGoal() && !unread.reasons(property).empty(); });
  return formOf(input.program.target) == StatementForm::Accumulators && !unread.isUnlimited() && !isOpen && !builtin &&
         input.properties.unread.empty() && std::ranges::any_of(properties, &Property::isGoal);
}

Exit runExport(const ExportArguments& arguments, Context& context) {
  ProgramInput input = readInput(context, arguments.files, arguments.properties);
  if (hasHiddenCode(input.program))
    return context.fail({"the program has know-how protected blocks, whose code is written nowhere",
                         arguments.files.front(),
                         "--protected contract exports the rest, with these blocks as hidden"});
  const std::set<std::string> met = keepOnly(arguments.only, input.properties);
  for (const std::string& pattern : arguments.only) {
    if (!met.contains(pattern)) return context.fail(noSuchProperty(pattern));
  }
  const std::vector<std::string> leftOut =
      arguments.asDownloaded ? leaveOut(input.program) : std::vector<std::string>();
  const UnreadCode unread(input.program, context.settings.choices());
  const bool isUnread = std::ranges::any_of(input.program.findings, isReadError) || !unread.empty();
  // A system of what was understood would prove the wrong thing, so the reasons are shown instead; what does not depend
  // on it is exported.
  if (isUnread) printUnread(context, "export", input.program, unread, arguments.files);
  const std::vector<std::string> notCovered = isUnread ? leaveOutDependent(input, unread) : std::vector<std::string>();
  if (isUnread && !isExportable(input, unread, arguments.builtin)) return Exit::Failed;
  if (!unread.isWhole()) input.program = unread.executable();
  if (input.program.main() == nullptr)
    return context.fail(
        {"there is no main program to export", arguments.files.front(), "give the file that holds the main program"});
  const std::vector<ExternalRange> byCalls = externalsOfCalls(Facts(input.program));
  input.properties.externals.insert(input.properties.externals.end(), byCalls.begin(), byCalls.end());
  const ProverOptions options = proverOptionsOf(context.settings, {&input.program});
  std::vector<Property> goals;
  for (const Property& property : input.properties.properties) {
    if (property.isGoal()) goals.push_back(property);
  }
  const std::unique_ptr<QuestionSystem> written =
      asWritten(input, goals, encoderOptionsOf(options), {.builtin = arguments.builtin});
  QuestionSystem& side = *written;
  if (side.system().questions.empty()) {
    return context.fail({fmt::format("no property is declared in {}", arguments.files.front()),
                         {},
                         "declare some, or give --builtin; see 'rungproof prove --help'"});
  }
  ExportRemarks remarks = remarksOf(input, side, options);
  for (const std::string& line : leftOut) remarks.push_back("left out: " + line);
  for (const std::string& line : notCovered) remarks.push_back("not covered: " + line);
  const TransitionSystem system = withExactReals(side.system(), RealScope::All);
  bool isWritten = true;
  for (const OutputRequest& request : context.outputs) {
    const OutputRequest target{request.name, request.file.empty() ? arguments.output : request.file};
    isWritten = context.write(target, textOfExport(request.name, system, options.bound, remarks)) && isWritten;
  }
  return isWritten && !isUnread ? Exit::Clean : Exit::Failed;
}

Action setUpExport(ArgumentTable& table) {
  auto arguments = std::make_shared<ExportArguments>();
  table.arguments("FILE", arguments->files, "programs, symbol tables and data blocks; '-' is standard input");
  table.option("--props", arguments->properties, "FILE", "property file; may be repeated");
  table.list("--only", arguments->only, "NAME", "export these properties only; * and ? stand for any characters");
  table.flag("--builtin", arguments->builtin, "also the questions of the built-in checks");
  table.flag("--as-downloaded", arguments->asDownloaded, asDownloadedHelp);
  table.option("-o,--output", arguments->output, "FILE", "write there instead of standard output");
  return [arguments](Context& context) { return runExport(*arguments, context); };
}

}  // namespace

extern constexpr Command exportCommand = {
    .name = "export",
    .usage = "FILE... --format btor2|aiger|smt2|smv",
    .summary = "write the transition system with its properties for other model checkers",
    .details =
        "One scan is one step of the system. A 'prove' is a bad state at its violation, a 'reach' one at its goal, so "
        "that\n"
        "an unreachable bad state means PROVED or UNREACHABLE. Assumptions are constraints; comments name everything\n"
        "that was assumed or approximated. Sine, logarithm and the like of REAL numbers are free inputs.\n"
        "    btor2        words, for btormc, Pono, AVR\n"
        "    aiger        bits, binary, latches from 0 and no constraints, for ABC and rIC3\n"
        "    aiger-ascii  bits, AIGER 1.9 with constraints and resets, to be read\n"
        "    smt2         words, --bound N scans in a row (1), one check-sat for each property\n"
        "    smv          words, for NuSMV and nuXmv\n"
        "\n"
        "Examples:\n"
        "    rungproof export press.awl --format aiger -o press.aig\n"
        "    rungproof export press.awl --format smv --scan-time 10ms\n",
    .shows = option_group::Reading | option_group::Running | option_group::Output | option_group::Configuration,
    .formats = "btor2|aiger|aiger-ascii|smt2|smv",
    .setup = setUpExport,
};

}  // namespace rungproof
