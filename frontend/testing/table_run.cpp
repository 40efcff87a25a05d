// A test is played until its first failure; then once more up to some scans behind it, to show them.
#include "frontend/testing/table_run.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "analysis/proof/prover.hpp"
#include "engine/instruction_recorder.hpp"
#include "frontend/logger/trace_cell.hpp"
#include "frontend/picture/network_view.hpp"
#include "frontend/simulation/comparison.hpp"
#include "frontend/simulation/scan_lengths.hpp"
#include "frontend/simulation/witness_drawing.hpp"
#include "ir/hazard.hpp"

namespace rungproof {

namespace {

constexpr std::size_t columnsShownAround = 8;

/// Hands on what is observed, and begins each scan.
TestPlayOptions playOptionsOf(const TableRunOptions& options) {
  TestPlayOptions play;
  play.engine = options.engine;
  play.length = scanLengthsOf(options.scanTime, options.engine.seed);
  return play;
}

/// The networks that drive the signal, lit in the scan that the recorder has seen.
ShownScan drawn(const Program& program, const TraceSignal& signal, const InstructionRecorder& recorder,
                const TableRunOptions& options) {
  ProofResult asked;
  ExprNode node;
  node.op = ExprOp::Address;
  node.operand = signal.operand;
  asked.property.first.nodes.push_back(node);
  ViewOptions view;
  view.recorder = &recorder;
  ShownScan shown;
  for (const auto& [pou, network] : networksThatMatter(program, asked)) {
    view.form = options.shows.value_or(network->drawing != nullptr ? formAsRead(*network) : Form::Ladder);
    const NetworkView picture = networkView(program, *pou, *network, view);
    ShownNetwork& one =
        shown.networks.emplace_back(ShownNetwork{fmt::format("{}, {}", pou->name, picture.heading), {}, {}});
    if (options.hasPage) one.svg = pictureSvg(picture);
    if (options.shows) one.text = contentLines(picture, {});
  }
  return shown;
}

/// The scans around a failure, and its drawing.
void showFailure(const Program& program, const TestTable& table, const TestCase& test, const TableRunOptions& options,
                 const TestFailure& failure, TestResult& result) {
  std::vector<TraceSignal> signals;
  const auto addColumn = [&](const TraceSignal& signal) {
    const bool isThere = std::ranges::any_of(
        signals, [&](const TraceSignal& s) { return toString(s.operand) == toString(signal.operand); });
    if (!isThere && signals.size() < columnsShownAround) signals.push_back(signal);
  };
  if (failure.signal) addColumn(table.expects[*failure.signal]);
  for (std::size_t i = 0; i < table.sets.size(); ++i) {
    const bool isSet = std::ranges::any_of(test.rows, [&](const TestRow& row) { return row.sets[i].has_value(); });
    if (isSet && table.sets[i].target == StimulusTarget::Memory) addColumn(table.sets[i].signal);
  }
  for (std::size_t i = 0; i < table.expects.size(); ++i) addColumn(table.expects[i]);
  for (const TraceSignal& signal : signals) result.columns.push_back(signal.name);
  const bool draws = failure.signal && (options.shows || options.hasPage);
  InstructionRecorder recorder(draws ? program.instructionCount() : 0);
  TestPlayOptions play = playOptionsOf(options);
  play.stopsAtFailure = false;
  if (draws) play.observer = &recorder;
  bool isFar = false;
  play.beforeScan = [&](std::uint64_t scan) {
    if (draws) recorder.beginScan(scan == failure.scan);
    isFar = scan > failure.scan + scansAround;
  };
  play.afterScan = [&](const Simulator& simulator, std::size_t) {
    const std::uint64_t scan = simulator.scanCount();
    if (scan + scansAround < failure.scan || isFar) return;
    TestResult::Scan& row = result.around.emplace_back();
    row.scan = scan;
    row.timeMs = static_cast<double>(simulator.timeUs()) / 1000;
    const std::vector<std::optional<TraceNumber>> values = sampleValues(simulator.store(), signals);
    for (std::size_t i = 0; i < signals.size(); ++i)
      row.values.push_back(values[i] ? numberText(*values[i], signals[i].type) : "");
    if (draws && scan == failure.scan) {
      result.shown.push_back(drawn(program, table.expects[*failure.signal], recorder, options));
      result.shown.back().scan = scan;
      result.shown.back().timeMs = row.timeMs;
    }
  };
  Simulator again(program, options.engine);
  playTest(again, table, test, play);
}

TestResult runTest(const Program& program, const TestTable& table, const TestCase& test,
                   const TableRunOptions& options) {
  TestResult result;
  result.name = test.name;
  result.table = table.file;
  result.steps = test.rows.size();
  result.isDecided = std::ranges::any_of(test.rows, [](const TestRow& row) {
    return std::ranges::any_of(row.expects, [](const auto& cell) { return cell.has_value(); });
  });
  Simulator simulator(program, options.engine);
  TestPlayOptions play = playOptionsOf(options);
  // What is covered does not depend on what is expected: the test is played to its end.
  play.stopsAtFailure = options.coverage == nullptr;
  if (options.coverage != nullptr) {
    play.observer = options.coverage;
    play.beforeScan = [&](std::uint64_t) { options.coverage->beginScan(); };
  }
  const TestPlay played = playTest(simulator, table, test, play);
  if (played.failures.empty()) return result;
  const TestFailure& failure = played.failures.front();
  const TestRow& row = test.rows[failure.step];
  result.passed = false;
  result.step = failure.step + 1;
  result.stepText = row.step;
  result.line = row.line;
  result.scan = failure.scan;
  result.timeMs = static_cast<double>(failure.timeUs) / 1000;
  if (lowered(row.note).starts_with("timing")) result.timing = row.note;
  if (failure.signal) {
    const TraceSignal& signal = table.expects[*failure.signal];
    result.signal = signal.name;
    result.expected = rangeText(*row.expects[*failure.signal], signal.type);
    result.actual = numberText(failure.actual, signal.type);
  } else if (const RunTimeError* fatal = simulator.errors().fatal()) {
    result.reason = fmt::format("the CPU stopped: {}", hazardInfo(fatal->hazard).text);
  }
  showFailure(program, table, test, options, failure, result);
  return result;
}

}  // namespace

std::vector<TestResult> runTable(const Program& program, const TestTable& table, const TableRunOptions& options) {
  std::vector<TestResult> results;
  for (const TestCase& test : table.tests) results.push_back(runTest(program, table, test, options));
  return results;
}

namespace {

std::string goalPlace(const CoverageMap& map, const CoverageGoal& item) {
  switch (item.measure) {
    case Measure::Networks: return map.placeText(map.networks()[item.index]);
    case Measure::Contacts: {
      const CoverageLeaf& contact = map.leaves()[item.index];
      return map.placeText(contact.place) + " " + map.instructionText(*contact.instruction);
    }
    case Measure::Transitions: {
      const StepTransition& step = map.transitions()[item.index];
      return map.placeText(step.place) + " " + step.text;
    }
    case Measure::Mcdc: break;
  }
  const Decision& d = map.decisions()[item.index];
  return fmt::format("{} {}: {}", map.placeText(d.place), map.instructionText(*d.instruction),
                     map.instructionText(*map.leaves()[d.leaves[item.condition]].instruction));
}

std::string whatIsMissing(const CoverageItem& item) {
  switch (item.first.measure) {
    case Measure::Networks: return "no power flow reached a coil or box";
    case Measure::Transitions: return "it was not taken";
    case Measure::Contacts:
      return item.open.size() > 1 ? "it was never executed" : fmt::format("its bit was never {:d}", item.open[0].value);
    case Measure::Mcdc: break;
  }
  if (item.open[0].isOutcome)
    return fmt::format("as 0 and as 1 it decided the outcome, which was never {:d}", item.open[0].value);
  return item.open.size() > 1 ? "it never decided the outcome"
                              : fmt::format("it did not decide the outcome as {:d}", item.open[0].value);
}

}  // namespace

CoverageResult coverageOf(const CoverageRecorder& recorder) {
  CoverageResult result;
  for (CoverageItem& item : coverageItems(recorder)) {
    MeasureResult& measure = result.measures[item.first.measure];
    ++measure.total;
    if (item.isCovered) {
      ++measure.covered;
      if (item.first.measure != Measure::Mcdc) continue;
      const bool isUnique = recorder.pair(item.first.index, item.first.condition) == PairState::Unique;
      ++(isUnique ? result.uniqueCause : result.masking);
      continue;
    }
    ++measure.open;
    MissingGoal missing{goalPlace(recorder.map(), item.first), whatIsMissing(item)};
    missing.open = std::move(item.open);
    measure.missing.push_back(std::move(missing));
  }
  return result;
}

}  // namespace rungproof
