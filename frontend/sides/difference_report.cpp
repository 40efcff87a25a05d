// Replays the run for tables, traces and drawings.
#include "frontend/sides/difference_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "frontend/simulation/given_columns.hpp"
#include "frontend/simulation/witness_drawing.hpp"
#include "frontend/simulation/witness_report.hpp"
#include "frontend/testing/witness_table.hpp"
#include "ir/iec/variables.hpp"

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
  return operandAt(*address);
}

void addOperand(std::vector<TraceSignal>& list, const Program& program, const std::optional<Address>& address) {
  const auto operand = operandOf(address);
  if (!operand) return;
  TraceSignal signal = signalOf(program, wholeVariable(program, *operand));
  if (std::ranges::find(list, signal.name, &TraceSignal::name) == list.end()) list.push_back(std::move(signal));
}

/// What the value contributes to the whole: bytes of a variable come one by one, the highest first.
std::uint64_t partOf(const Operand& whole, const PresetValue& preset) {
  const auto last = whole.offset + static_cast<std::uint32_t>(std::max(bytes(whole.width), 1)) - 1;
  return whole.width == preset.operand.width ? preset.value : preset.value << (8 * (last - preset.operand.offset));
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

DifferenceReport::Inputs DifferenceReport::inputs() const {
  using Values = std::vector<std::uint64_t>;
  const auto valuesIn = [](const Program& program, const std::vector<ReplayScan>& scans) {
    std::map<std::string, std::pair<TraceSignal, Values>> found;
    for (std::size_t k = 0; k < scans.size(); ++k) {
      for (const PresetValue& preset : scans[k].inputs) {
        const Operand whole = wholeVariable(program, preset.operand);
        TraceSignal signal = signalOf(program, whole);
        Values& values = found.try_emplace(signal.name, signal, Values{}).first->second.second;
        values.resize(scans.size());
        values[k] |= partOf(whole, preset);
      }
    }
    return found;
  };
  const auto before = valuesIn(*sides_.runBefore, run_.before), after = valuesIn(*sides_.runAfter, run_.after);
  const auto isIdleIn = [](const Values& values) { return std::ranges::all_of(values, [](auto v) { return v == 0; }); };
  const bool isOfOne = sides_.pairs.isSeparate();  // each column is of one program
  Inputs result;
  for (const auto& [name, column] : before) {
    if (isOfOne) result.before.push_back(column.first);
    if (isOfOne) continue;
    const auto other = after.find(name);
    const bool isAlike = other == after.end()
                             ? !sides_.pairs.after(addressOf(column.first.operand)) || sides_.pairs.empty()
                             : other->second.second == column.second;
    if (isAlike && isIdleIn(column.second)) continue;
    (isAlike ? result.common : result.before).push_back(column.first);
  }
  for (const auto& [name, column] : after) {
    if (isOfOne) result.after.push_back(column.first);
    if (isOfOne) continue;
    const auto other = before.find(name);
    const bool isAlike = other == before.end() ? sides_.pairs.empty() : other->second.second == column.second;
    if (other != before.end() && isAlike) continue;
    if (!(isAlike && isIdleIn(column.second))) result.after.push_back(column.first);
  }
  for (std::vector<TraceSignal>* list : {&result.common, &result.before, &result.after})
    std::ranges::sort(*list, {},
                      [](const TraceSignal& s) { return std::tuple(s.operand.area, s.operand.offset, s.operand.bit); });
  return result;
}

Trace DifferenceReport::joined(const std::vector<TraceSignal>& common, std::vector<TraceSignal> before,
                               std::vector<TraceSignal> after) const {
  std::vector<TraceSignal> left = common;
  left.insert(left.end(), before.begin(), before.end());
  const Choices& choices = options_.prover.choices;
  Trace trace = traceOf(*sides_.runBefore, choices, witnessOf(run_, true), left);
  const Trace other = traceOf(*sides_.runAfter, choices, witnessOf(run_, false), after);
  const auto named = [](TraceSignal signal, std::string_view prefix) {
    signal.name = std::string(prefix) + signal.name;
    if (!signal.symbol.empty()) signal.symbol = std::string(prefix) + signal.symbol;
    return signal;
  };
  for (std::size_t i = common.size(); i < trace.signals.size(); ++i)
    trace.signals[i] = named(trace.signals[i], oldSidePrefix);
  for (const TraceSignal& signal : after) trace.signals.push_back(named(signal, newSidePrefix));
  trace.hasTwoSides = true;
  for (std::size_t i = 0; i < trace.rows.size() && i < other.rows.size(); ++i) {
    trace.rows[i].newEvents = other.rows[i].events;
    trace.rows[i].newDevices = other.rows[i].devices;
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
  const auto addOutputs = [](std::vector<TraceSignal>& list, const Program& program) {
    for (TraceSignal& signal : touchedSignals(program)) {
      if (isOutputArea(signal.operand.area)) list.push_back(std::move(signal));
    }
  };
  Inputs columns = inputs();
  addOutputs(columns.before, *sides_.runBefore);
  addOutputs(columns.after, *sides_.runAfter);
  // What differs may be written through a pointer alone.
  addOperand(columns.before, *sides_.runBefore, run_.addressBefore);
  addOperand(columns.after, *sides_.runAfter, run_.addressAfter);
  Trace trace = joined(columns.common, columns.before, columns.after);
  const Choices& choices = options_.prover.choices;
  const Witness before = witnessOf(run_, true), after = witnessOf(run_, false);
  GivenSide left{*sides_.runBefore, choices, before, {}}, right{*sides_.runAfter, choices, after, {}};
  std::size_t index = 0;
  for (const TraceSignal& signal : columns.common) {
    left.columns.emplace_back(index, signal);
    right.columns.emplace_back(index++, signal);
  }
  for (const TraceSignal& signal : columns.before) left.columns.emplace_back(index++, signal);
  for (const TraceSignal& signal : columns.after) right.columns.emplace_back(index++, signal);
  addGivenOfTwo(left, right, trace);
  return trace;
}

TestTable DifferenceReport::table() const {
  return witnessTable(*sides_.runBefore, sides_.before.properties, options_.prover.choices, witnessOf(run_, true),
                      run_.signal + " differs", nullptr);
}

/// "I0.2 becomes 1 in scan 3": the last change of an input before the difference.
std::string DifferenceReport::lastChange(const Trace& table, std::size_t inputs) const {
  for (std::size_t row = table.rows.size(); row-- > 0;) {
    for (std::size_t i = 0; i < inputs; ++i) {
      const std::optional<TraceNumber> now = table.rows[row].values[i];
      const std::optional<TraceNumber> then = row == 0 ? std::optional(TraceNumber{0}) : table.rows[row - 1].values[i];
      if (now != then && now)
        return fmt::format("last change of an input: {} becomes {} in scan {}", table.signals[i].name,
                           numberText(*now, table.signals[i].type), table.rows[row].scan);
    }
  }
  return {};
}

void DifferenceReport::describe(Comparison& comparison, const std::string& form, int width) const {
  comparison.scan = static_cast<int>(std::min<std::uint64_t>(run_.scan, 1U << 30));
  comparison.timeMs = static_cast<double>(run_.milliseconds);
  comparison.signal = run_.signal;
  const auto numberFor = [](std::uint64_t value, const std::optional<Address>& address) {
    const bool isAnalog = address && isAnalogue(address->area);
    return isAnalog ? static_cast<double>(static_cast<std::int16_t>(value)) : static_cast<double>(value);
  };
  const std::optional<Address>& some = run_.addressBefore ? run_.addressBefore : run_.addressAfter;
  comparison.expected = numberFor(run_.valueBefore, some);
  comparison.actual = numberFor(run_.valueAfter, some);
  if (run_.signal.ends_with(".mode"))
    comparison.notes.emplace_back(
        "modes of a pulse output: 0 none, 1 pulse train, 2 PWM, 3 profile, 4 always 0, 5 always 1");
  const Inputs read = inputs();
  std::vector<TraceSignal> common = read.common, before, after;
  common.insert(common.end(), read.before.begin(), read.before.end());
  addOperand(before, *sides_.runBefore, run_.addressBefore);
  addOperand(after, *sides_.runAfter, run_.addressAfter);
  const Trace table = joined(common, before, after);
  const bool isOldOfVariables = dialectOf(sides_.runBefore->target).memory.isOfVariables;
  const bool hasVariables = isOldOfVariables || dialectOf(sides_.runAfter->target).memory.isOfVariables;
  if (hasVariables && !before.empty() && !after.empty() && !table.rows.empty()) {
    comparison.signal = (isOldOfVariables ? before : after).front().name;  // the variable, not its bit
    const auto then = table.rows.end() - 1 - std::min<std::ptrdiff_t>(options_.latency, std::ssize(table.rows) - 1);
    comparison.expected = then->values[common.size()].value_or(0);
    comparison.actual = table.rows.back().values[common.size() + before.size()].value_or(0);
  }
  if (const std::string change = lastChange(table, common.size()); !change.empty()) comparison.notes.push_back(change);
  for (const auto& [choice, value] : run_.readings) {
    const ChoiceInfo& info = choiceInfo(choice);
    comparison.notes.push_back(fmt::format("under {0} = {1} (sim: --choice {0}={1})", info.key, info.values[value]));
  }
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
  drawing.lastScans = 1;
  drawing.lastOnly = true;
  drawing.width = width;
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
