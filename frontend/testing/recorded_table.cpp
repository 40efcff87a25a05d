// Rows of a trace become stretches.
#include "frontend/testing/recorded_table.hpp"

#include <algorithm>

#include "analysis/testing/test_signals.hpp"

namespace rungproof {

TestTable recordedTable(const Program& program, const PropertySet& set, const Trace& trace, const std::string& name) {
  const TestSignals signals = testSignalsOf(program, set);
  TestTable table;
  std::vector<std::size_t> inputs, outputs;  // columns of the trace
  for (std::size_t i = 0; i < trace.signals.size(); ++i) {
    const std::string address = toString(trace.signals[i].operand);
    for (const TestInput& input : signals.inputs) {
      if (toString(input.signal.operand) != address) continue;
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
      const std::optional<double>& value = trace.rows[begin].values[i];
      row.expects.push_back(value ? std::optional(TestRange{*value, *value}) : std::nullopt);
    }
    const bool isLast = end == trace.rows.size();
    if (trace.isByTime && !isLast)
      row.wait = {1, trace.rows[end].timeUs - trace.rows[begin].timeUs};
    else if (!trace.isByTime)
      row.wait.scans = (isLast ? trace.rows.back().scan + 1 : trace.rows[end].scan) - trace.rows[begin].scan;
    test.rows.push_back(std::move(row));
    begin = end;
  }
  return table;
}

}  // namespace rungproof
