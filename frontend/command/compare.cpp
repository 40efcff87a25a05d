// `rungproof compare`: two trace files against each other.
#include <memory>

#include "frontend/command/command.hpp"
#include "frontend/run/comparison.hpp"
#include "frontend/run/stimulus_reader.hpp"
#include "frontend/run/trace_file.hpp"

namespace rungproof {

namespace {

struct Arguments {
  std::string expected;
  std::string actual;
  std::vector<std::string> tolerances;
  unsigned slack = 0;
};

Exit run(const Arguments& arguments, Context& context) {
  std::vector<Failure> failures;
  const std::optional<std::string> expectedText = readFile(context, arguments.expected, failures);
  const std::optional<std::string> actualText = readFile(context, arguments.actual, failures);
  if (!failures.empty()) return failAll(context, failures);
  const Trace expected = readTrace(arguments.expected, *expectedText, failures);
  const Trace actual = readTrace(arguments.actual, *actualText, failures);
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
  if (expected.isByTime != actual.isByTime && !(expected.isByTime && actual.hasTimes)) {
    failures.push_back({"one trace counts scans, the other tells times", arguments.actual,
                        "use 'scan' or 'time_ms' in both, or a trace with both columns"});
  }
  if (!failures.empty()) return failAll(context, failures);

  Report report;
  report.command = "compare";
  report.sources = std::make_shared<SourceSet>();
  report.files = {arguments.expected, arguments.actual};
  report.comparison = comparisonOf(expected, actual, firstDifference(expected, actual, options));
  return finish(context, std::move(report));
}

Action setup(ArgumentTable& table) {
  auto arguments = std::make_shared<Arguments>();
  table.argument("EXPECTED", arguments->expected, "the trace as it should be (CSV)");
  table.argument("ACTUAL", arguments->actual, "the trace as it is (CSV); '-' is standard input");
  table.option("--tolerance", arguments->tolerances, "SIGNAL=VALUE", "how far a value may be off; may be repeated");
  table.number("--slack", arguments->slack, "N", "scans by which a value may come earlier or later");
  return [arguments](Context& context) { return run(*arguments, context); };
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
        "\n"
        "Examples:\n"
        "    rungproof compare expected.csv trace.csv\n"
        "    rungproof compare --tolerance VW10=2 --slack 1 expected.csv trace.csv\n",
    .shows = option_group::Output | option_group::Configuration,
    .setup = setup,
};

}  // namespace rungproof
