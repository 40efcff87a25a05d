// Rows of a trace become stretches.
#include "frontend/testing/recorded_table.hpp"

#include <algorithm>

#include "analysis/testing/test_signals.hpp"
#include "ir/overlap.hpp"
#include "ir/written_operand.hpp"

namespace rungproof {

namespace {

constexpr std::uint64_t usualUs = 10000;

/// Scans; a time where they are not of the usual length, so that timers come as far in other scans.
TestWait waitOf(const Trace& trace, std::size_t begin, std::size_t end, LongScan single) {
  const bool isLast = end == trace.rows.size();
  const std::uint64_t scans = (isLast ? trace.rows.back().scan + 1 : trace.rows[end].scan) - trace.rows[begin].scan;
  std::uint64_t us = 0;
  bool isKnown = true;
  for (std::size_t i = begin; i < end; ++i) {
    us += trace.rows[i].scanUs;
    isKnown = isKnown && trace.rows[i].scanUs != 0;
  }
  const bool mayBeTime = scans > 1 || (single == LongScan::Time && us > usualUs);
  if (mayBeTime && isKnown && us != scans * usualUs) return {1, us};
  return {scans, 0};
}

}  // namespace

TestTable recordedTable(const Program& program, const PropertySet& set, const Trace& trace, const std::string& name,
                        LongScan single) {
  const TestSignals signals = testSignalsOf(program, set);
  TestTable table;
  std::vector<std::size_t> inputs, outputs;  // columns of the trace
  // A part of a wider input, which sets it too.
  const auto isPart = [&](const Operand& operand) {
    return std::ranges::any_of(trace.signals, [&](const TraceSignal& other) {
      return bits(other.operand.width) > bits(operand.width) && overlaps(other.operand, operand);
    });
  };
  for (std::size_t i = 0; i < trace.signals.size(); ++i) {
    const std::string address = toString(trace.signals[i].operand);
    const bool isInput = std::ranges::any_of(
        signals.inputs, [&](const TestInput& input) { return toString(input.signal.operand) == address; });
    // A terminal that this program does not read; another version may.
    const Area area = trace.signals[i].operand.area;
    const bool isTerminal = area == Area::I || area == Area::AI || area == Area::PI;
    const bool isSet = isInput || (isTerminal && !isWritten(program, trace.signals[i].operand, Actuals::Read));
    if (isSet && !(isTerminal && isPart(trace.signals[i].operand))) {
      inputs.push_back(i);
      table.sets.push_back({StimulusTarget::Memory, trace.signals[i]});
    }
    for (const TraceSignal& output : signals.outputs) {
      if (toString(output.operand) != address) continue;
      outputs.push_back(i);
      table.expects.push_back(trace.signals[i]);
    }
  }
  TestCase& test = table.tests.emplace_back(TestCase{name, {}});
  const auto differ = [&](const std::vector<std::size_t>& columns, std::size_t a, std::size_t b) {
    return std::ranges::any_of(columns,
                               [&](std::size_t i) { return trace.rows[a].values[i] != trace.rows[b].values[i]; });
  };
  for (std::size_t begin = 0; begin < trace.rows.size();) {
    std::size_t end = begin + 1;
    while (end < trace.rows.size() && !differ(inputs, end, begin) && !differ(outputs, end, begin)) ++end;
    TestRow row;
    const bool setsSomething = begin == 0 || differ(inputs, begin, begin - 1);
    row.step = begin == 0 ? "power on" : setsSomething ? "change inputs" : "wait";
    for (const std::size_t i : inputs) row.sets.push_back(setsSomething ? trace.rows[begin].values[i] : std::nullopt);
    for (const std::size_t i : outputs) {
      const std::optional<TraceNumber>& value = trace.rows[begin].values[i];
      row.expects.push_back(value ? std::optional(TestRange{*value, *value}) : std::nullopt);
    }
    const bool isLast = end == trace.rows.size();
    if (trace.isByTime && !isLast)
      row.wait = {1, trace.rows[end].timeUs - trace.rows[begin].timeUs};
    else if (!trace.isByTime)
      row.wait = waitOf(trace, begin, end, single);
    test.rows.push_back(std::move(row));
    begin = end;
  }
  return table;
}

}  // namespace rungproof
