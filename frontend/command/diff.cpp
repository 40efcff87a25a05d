// `rungproof diff`: which networks changed in what they do, and which outputs can differ because of it.
#include <fmt/format.h>

#include <algorithm>

#include "frontend/command.hpp"
#include "frontend/input/proof_input.hpp"
#include "frontend/sides/difference_view.hpp"
#include "frontend/simulation/trace_file.hpp"
#include "frontend/text/excerpt.hpp"
#include "frontend/text/safe_text.hpp"

namespace rungproof {

namespace {

struct DiffArguments {
  SideArguments sides;
  std::string form = "ladder";
  int width = 140;
  std::vector<std::string> rest;
};

/// Git calls an external diff with path, old file, old hash, old mode, new file, new hash, new mode, and for a file
/// that was renamed its new path and a remark.
bool isFromGit(const DiffArguments& arguments) { return arguments.rest.size() == 5 || arguments.rest.size() == 7; }

constexpr std::string_view noFile = "/dev/null";

/// The path in the repository; the arguments become those of a user.
std::string takeFromGit(DiffArguments& arguments) {
  std::string path = arguments.sides.before;
  if (arguments.rest.size() == 7) path += " -> " + arguments.rest[5];
  arguments.sides.before = arguments.sides.after;
  arguments.sides.after = arguments.rest[2];
  arguments.rest.clear();
  return path;
}

Exit compareForDiff(const DiffArguments& arguments, Context& context);

/// For git a difference is no failure: any other exit code than 0 would end its run.
Exit runDiff(DiffArguments arguments, Context& context) {
  if (!isFromGit(arguments)) return compareForDiff(arguments, context);
  const std::string path = takeFromGit(arguments);
  const bool isAdded = arguments.sides.before == noFile, isRemoved = arguments.sides.after == noFile;
  context.out << Paint{context.color}.bold(lineText(path))
              << (isAdded     ? ": added\n"
                  : isRemoved ? ": removed\n"
                              : "\n");
  if (isAdded || isRemoved) return Exit::Clean;
  context.out << std::flush;
  const Exit exit = compareForDiff(arguments, context);
  return exit == Exit::Failed ? exit : Exit::Clean;
}

/// Statements about the world that could not be read: without them outputs may differ that never do. Whether there are
/// some.
bool sayUnreadStatements(const Sides& sides, Context& context) {
  bool isOpen = false;
  for (const ProgramInput* input : {&sides.before, &sides.after}) {
    Report report = startReport("diff", input->program, input == &sides.before ? sides.filesBefore : sides.filesAfter);
    std::erase_if(report.findings, [](const Finding& finding) {
      return finding.severity != Severity::Error || !finding.rule.starts_with("PRP");
    });
    if (report.findings.empty() && input->properties.unread.empty()) continue;
    isOpen = true;
    sortFindings(report);
    reporterNamed("human")->write(report, {false, true}, context.err);
    for (const UnreadStatement& statement : input->properties.unread)
      context.err << fmt::format(
          "rungproof: '{}' ({}:{}) could not be read: what it may assume of the world is not assumed\n", statement.text,
          input->program.sources->file(statement.span.file).name(),
          input->program.sources->position(statement.span).line);
  }
  return isOpen;
}

Exit compareForDiff(const DiffArguments& arguments, Context& context) {
  if (!arguments.rest.empty())
    return context.fail({fmt::format("unexpected argument '{}' for 'rungproof diff'", arguments.rest.front()),
                         {},
                         "give OLD and NEW; more files of a side with --with"});
  std::vector<Failure> failures;
  const Sides sides = readSides(context, arguments.sides, failures);
  if (!failures.empty()) return failAll(context, failures);
  for (const std::vector<std::string>* lines : {&sides.leftOutBefore, &sides.leftOutAfter}) {
    for (const std::string& line : *lines) context.err << fmt::format("left out: {}\n", line);
  }
  bool isUnread = false, isRefused = false;
  for (const ProgramInput* input : {&sides.before, &sides.after}) {
    const UnreadCode& unread = input == &sides.before ? *sides.unreadBefore : *sides.unreadAfter;
    if (!unread.isRefused()) continue;
    isRefused = true;
    isUnread = isUnread || unread.hinderRuns();
    Report report = startReport("diff", input->program, input == &sides.before ? sides.filesBefore : sides.filesAfter);
    addUnread(report, input->program, unread);
    sortFindings(report);
    reporterNamed("human")->write(report, {false, true}, context.err);
  }
  if (isUnread) return Exit::Failed;
  const bool isOpen = sayUnreadStatements(sides, context);

  EquivalenceOptions options;
  options.prover = proverOptionsOf(context.settings, {&sides.before.program, &sides.after.program});
  options.pairs = sides.pairs;
  options.observed = sides.observed;
  options.assumptions = sides.assumptions;
  const ProgramDifference difference = differenceOf(sides, options, arguments.form, arguments.width - 2);
  DifferenceStyle style;
  style.form = arguments.form == "fbd" ? Form::Fbd : arguments.form == "stl" ? Form::Stl : Form::Ladder;
  style.width = arguments.width;
  Exit exit = difference.countOf(Equality::Different) > 0 || !difference.verdicts.empty() ? Exit::Found
              : difference.countOf(Equality::Unknown) > 0                                 ? Exit::Undecided
                                                                                          : Exit::Clean;
  for (const OutputRequest& output : context.outputs) {
    style.color = context.color && output.file.empty();
    std::string text;
    if (output.name == "json")
      text = differenceJson(sides, difference);
    else if (output.name == "html")
      text = differencePage(sides, difference, style);
    else if (output.name == "svg")
      text = differencePicture(sides, difference, style);
    else
      text = differenceText(sides, difference, style) +
             (context.settings.flag(Opt::Quiet) ? "" : closingLine(difference) + '\n');
    if (!context.write(output, text)) exit = Exit::Failed;
  }
  for (const Disagreement& disagreement : difference.equivalence.disagreements) {
    context.err << fmt::format("rungproof: internal disagreement on '{}': {}\n", disagreement.name,
                               disagreement.explanation);
    exit = Exit::Failed;
  }
  return isOpen || isRefused ? Exit::Failed : exit;
}

Action setUpDiff(ArgumentTable& table) {
  auto arguments = std::make_shared<DiffArguments>();
  arguments->sides.declare(table);
  table.arguments("GIT", arguments->rest, "what git adds where this is its external diff", true);
  table.word("--as", arguments->form, {"ladder", "lad", "fbd", "stl"}, "ladder|fbd|stl",
             "how changed networks are drawn");
  table.number("--width", arguments->width, "N", "columns of the text, both programs together", 60, 400);
  return [arguments](Context& context) { return runDiff(*arguments, context); };
}

}  // namespace

extern constexpr Command diffCommand = {
    .name = "diff",
    .usage = "OLD NEW [--map FILE]",
    .summary = "which networks changed in what they do, and which outputs can differ because of it",
    .details =
        "Layout, comments, titles, network numbers, the order of blocks, the set of mnemonics and symbol names do not\n"
        "count. Of every changed network: OLD and NEW side by side, the outputs and the memory that it can influence,\n"
        "and whether each of these outputs can differ, is proved equal, or is undecided. The run of the first\n"
        "difference stands at the end, lit in both programs ('rungproof equiv' writes it as a trace). Properties that\n"
        "OLD declares are proved of both; a verdict that changed stands at the top.\n"
        "\n"
        "Exit codes: 0 no output can differ, 1 some can, 3 undecided.\n"
        "\n"
        "With git: GIT_EXTERNAL_DIFF='rungproof diff' git diff, or in .gitattributes '*.awl diff=awl' with\n"
        "git config diff.awl.command 'rungproof diff'; git config diff.awl.textconv 'rungproof show --as stl'\n"
        "shows statement lists whatever their encoding.\n"
        "\n"
        "Examples:\n"
        "    rungproof diff press.awl press_new.awl\n"
        "    rungproof diff old/ new/ --format html=changes.html\n",
    .shows = option_group::Reading | option_group::Running | option_group::Output | option_group::Configuration,
    .comparesTwo = true,
    .formats = "text|json|html|svg",
    .setup = setUpDiff,
};

}  // namespace rungproof
