// Replays the run for tables, traces and drawings.
#include "frontend/sides/difference_report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "frontend/run/witness_drawing.hpp"
#include "frontend/run/witness_report.hpp"

namespace rungproof {

namespace {

Witness witnessOf(const EquivalenceRun& run, bool isOld) {
  Witness witness;
  witness.scans = isOld ? run.before : run.after;
  witness.initial = isOld ? run.initialBefore : run.initialAfter;
  witness.scanCount = run.scan;
  witness.milliseconds = run.milliseconds;
  return witness;
}

std::optional<Operand> operandOf(const std::optional<Address>& address) {
  if (!address) return std::nullopt;
  return direct(address->area, Width::Bit, address->index / 8, address->index % 8);
}

/// A result whose property is the differing bit, for what draws networks of a witness.
ProofResult resultOf(const EquivalenceRun& run, bool isOld) {
  ProofResult result;
  result.witness = witnessOf(run, isOld);
  if (const auto operand = operandOf(isOld ? run.addressBefore : run.addressAfter)) {
    ExprNode node;
    node.op = ExprOp::Address;
    node.operand = *operand;
    result.property.first.nodes.push_back(node);
  }
  return result;
}

}  // namespace

std::vector<TraceSignal> DifferenceReport::inputsOfRun() const {
  std::vector<TraceSignal> inputs;
  for (const ReplayScan& scan : run_.before) {
    for (const PresetValue& preset : scan.inputs) {
      TraceSignal signal = signalOf(*sides_.runBefore, preset.operand);
      if (preset.value != 0 &&
          std::ranges::none_of(inputs, [&](const TraceSignal& s) { return s.name == signal.name; }))
        inputs.push_back(std::move(signal));
    }
  }
  std::ranges::sort(inputs, {},
                    [](const TraceSignal& s) { return std::tuple(s.operand.area, s.operand.offset, s.operand.bit); });
  return inputs;
}

Trace DifferenceReport::joined(const std::vector<TraceSignal>& inputs, const std::vector<TraceSignal>& before,
                               const std::vector<TraceSignal>& after) const {
  std::vector<TraceSignal> left = inputs;
  left.insert(left.end(), before.begin(), before.end());
  const Choices& choices = options_.prover.choices;
  Trace trace = traceOf(*sides_.runBefore, choices, witnessOf(run_, true), left);
  const Trace other = traceOf(*sides_.runAfter, choices, witnessOf(run_, false), after);
  for (TraceSignal signal : after) {
    signal.name = "new." + signal.name;
    if (!signal.symbol.empty()) signal.symbol = "new." + signal.symbol;
    trace.signals.push_back(std::move(signal));
  }
  for (std::size_t i = 0; i < trace.rows.size(); ++i) {
    if (i < other.rows.size())
      trace.rows[i].values.insert(trace.rows[i].values.end(), other.rows[i].values.begin(), other.rows[i].values.end());
    else
      trace.rows[i].values.resize(trace.signals.size());
  }
  return trace;
}

Trace DifferenceReport::trace() const {
  const auto outputsOf = [](const Program& program) {
    std::vector<TraceSignal> signals = touchedSignals(program);
    std::erase_if(signals,
                  [](const TraceSignal& s) { return s.operand.area != Area::Q && s.operand.area != Area::AQ; });
    return signals;
  };
  return joined(inputsOfRun(), outputsOf(*sides_.runBefore), outputsOf(*sides_.runAfter));
}

/// "I0.2 becomes 1 in scan 3": the last change of an input before the difference.
std::string DifferenceReport::lastChange(const Trace& table, std::size_t inputs) const {
  for (std::size_t row = table.rows.size(); row-- > 0;) {
    for (std::size_t i = 0; i < inputs; ++i) {
      const std::optional<double> now = table.rows[row].values[i];
      const std::optional<double> then = row == 0 ? std::optional(0.0) : table.rows[row - 1].values[i];
      if (now != then && now)
        return fmt::format("last change of an input: {} becomes {} in scan {}", table.signals[i].name,
                           numberText(*now, table.signals[i].type), table.rows[row].scan);
    }
  }
  return {};
}

void DifferenceReport::describe(Comparison& comparison, const std::string& form) const {
  comparison.scan = static_cast<int>(std::min<std::uint64_t>(run_.scan, 1U << 30));
  comparison.timeMs = static_cast<double>(run_.milliseconds);
  comparison.signal = run_.signal;
  comparison.expected = run_.valueBefore ? 1 : 0;
  comparison.actual = run_.valueAfter ? 1 : 0;
  const std::vector<TraceSignal> inputs = inputsOfRun();
  std::vector<TraceSignal> before, after;
  if (const auto operand = operandOf(run_.addressBefore)) before.push_back(signalOf(*sides_.runBefore, *operand));
  if (const auto operand = operandOf(run_.addressAfter)) after.push_back(signalOf(*sides_.runAfter, *operand));
  const Trace table = joined(inputs, before, after);
  if (const std::string change = lastChange(table, inputs.size()); !change.empty()) comparison.notes.push_back(change);
  for (const bool isOld : {true, false}) {
    const Program& program = isOld ? *sides_.runBefore : *sides_.runAfter;
    const std::string start = startText(program, options_.prover.choices, witnessOf(run_, isOld));
    if (!start.empty())
      comparison.notes.push_back(fmt::format("memory of {} at the start: {}", isOld ? "OLD" : "NEW", start));
  }
  for (const std::string& line : tableOf(table)) comparison.notes.push_back(line);
  if (form == "none") return;
  WitnessDrawingOptions drawing;
  drawing.form = form == "fbd" ? Form::Fbd : form == "stl" ? Form::Stl : Form::Ladder;
  drawing.scans = 1;
  drawing.svg = true;
  for (const bool isOld : {true, false}) {
    const Program& program = isOld ? *sides_.runBefore : *sides_.runAfter;
    for (ShownScan& scan : shownScans(program, options_.prover.choices, resultOf(run_, isOld), drawing)) {
      for (ShownNetwork& network : scan.networks) network.heading = (isOld ? "OLD " : "NEW ") + network.heading;
      comparison.scans.push_back(std::move(scan));
    }
  }
}

}  // namespace rungproof
