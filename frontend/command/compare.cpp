// `rungproof compare`: two trace files against each other.
#include <fmt/format.h>

#include <memory>

#include "frontend/command.hpp"
#include "frontend/input/program_input.hpp"
#include "frontend/logger/trace_import.hpp"
#include "frontend/simulation/comparison.hpp"
#include "frontend/simulation/expected_lanes.hpp"
#include "frontend/simulation/stimulus_reader.hpp"
#include "frontend/simulation/trace_file.hpp"
#include "frontend/stl/syntax_message.hpp"

namespace rungproof {

namespace {

struct CompareArguments {
  std::string expected;
  std::string actual;
  std::vector<std::string> tolerances;
  std::vector<std::string> traces;
  unsigned slack = 0;
};

/// The symbols of the tables that --symbols names.
std::vector<Symbol> symbolsOf(const Context& context, std::vector<Failure>& failures) {
  if (context.settings.list(Opt::Symbols).empty()) return {};
  const Program program = readProgram({}, readOptionsOf(context.settings));
  for (const Finding& finding : program.findings) {
    const SourceFile& file = program.sources->file(finding.span.file);
    const Position at = file.position(finding.span.offset);
    if (finding.severity == Severity::Error && finding.rule != syntaxMessage(Syntax::NoInstruction).id)
      failures.push_back({finding.message, fmt::format("{}:{}:{}", file.name(), at.line, at.column), finding.help});
  }
  return program.symbols;
}

Exit runCompare(const CompareArguments& arguments, Context& context) {
  std::vector<Failure> failures;
  const std::optional<std::string> expectedText = readFile(context, arguments.expected, failures);
  const std::optional<std::string> actualText = readFile(context, arguments.actual, failures);
  if (!failures.empty()) return failAll(context, failures);
  const TraceImport import = traceImportOf(context.settings, failures);
  const std::vector<Symbol> symbols = symbolsOf(context, failures);
  for (const std::string& name : arguments.traces) {
    if (auto failure = checkTraceName(name)) failures.push_back(*failure);
  }
  if (!failures.empty()) return failAll(context, failures);
  const Trace expected = readTrace(arguments.expected, *expectedText, failures, import, symbols);
  const Trace actual = readTrace(arguments.actual, *actualText, failures, import, symbols);
  if (failures.empty()) checkRenames(import, arguments.expected + ", " + arguments.actual, failures);
  if (!failures.empty()) return failAll(context, failures);
  if (!expectsAnything(expected)) return context.fail(expectsNothing(arguments.expected));

  CompareOptions options;
  options.slack = arguments.slack;
  for (const std::string& text : arguments.tolerances) {
    Failure failure;
    const std::optional<Tolerance> tolerance = toleranceIn(text, expected, failure);
    if (!tolerance) return context.fail(failure);
    options.tolerances.push_back(*tolerance);
  }
  for (const std::string& name : missingSignals(expected, actual)) {
    failures.push_back(
        {"the actual trace has no column '" + name + "'", arguments.actual, "write both traces with the same signals"});
  }
  if (expected.isByTime != actual.isByTime && !(expected.hasTimes && actual.hasTimes)) {
    failures.push_back({"one trace counts scans, the other tells times", arguments.actual,
                        "use 'scan' or 'time_ms' in both, or a trace with both columns"});
  }
  if (!failures.empty()) return failAll(context, failures);

  const TraceBeside beside = arguments.traces.empty() ? TraceBeside{} : besideExpected(expected, actual, options);
  for (const std::string& name : arguments.traces) {
    const bool isPage = name.ends_with(".html");
    if (!(isPage ? writePage(context, name, beside.trace, arguments.actual, {}, beside.lanes)
                 : writeTrace(context, name, beside.trace, arguments.actual)))
      return Exit::Failed;
  }

  Report report;
  report.command = "compare";
  report.sources = std::make_shared<SourceSet>();
  report.files = {arguments.expected, arguments.actual};
  report.comparison = comparisonOf(expected, actual, firstDifference(expected, actual, options));
  return finish(context, std::move(report));
}

Action setUpCompare(ArgumentTable& table) {
  auto arguments = std::make_shared<CompareArguments>();
  table.argument("EXPECTED", arguments->expected, "the trace as it should be (CSV, VCD)");
  table.argument("ACTUAL", arguments->actual, "the trace as it is (CSV, VCD); '-' is standard input");
  table.option("--tolerance", arguments->tolerances, "SIGNAL=VALUE", "how far a value may be off; may be repeated");
  table.number("--slack", arguments->slack, "N", "scans by which a value may come earlier or later");
  table.option("--trace", arguments->traces, "FILE",
               "write both, each expected curve below the actual one: .html .svg .vcd .json; may be repeated");
  return [arguments](Context& context) { return runCompare(*arguments, context); };
}

}  // namespace

extern constexpr Command compareCommand = {
    .name = "compare",
    .usage = "EXPECTED ACTUAL",
    .summary = "compare two traces",
    .details =
        "Both files have 'scan' or 'time_ms' in the first column and a signal in every other one. Empty\n"
        "cells and x in EXPECTED match anything; columns that only ACTUAL has are passed over. The first\n"
        "difference is shown with the scans around it, and the exit code is 1.\n"
        "Columns are the same if they mean the same address: E0.0 and I0.0, with --symbols also names. Files of\n"
        "loggers, oscilloscopes and simulators (CSV of any separator, VCD) are read too: --time-column and\n"
        "--time-unit say what the time is; dates count from the first row. A trace with both 'scan' and 'time_ms' is\n"
        "compared by time with one that tells times only. The time of a scan is that of its end: it is the scan's\n"
        "own, and a time between two ends belongs to the scan that ends next.\n"
        "\n"
        "Examples:\n"
        "    rungproof compare expected.csv trace.csv\n"
        "    rungproof compare --tolerance VW10=2 --slack 1 expected.csv trace.csv\n"
        "    rungproof compare trace.csv scope.vcd --rename CH1=Q0.0 --trace both.html\n",
    .shows = option_group::Traces | option_group::Output | option_group::Configuration,
    .setup = setUpCompare,
};

}  // namespace rungproof
