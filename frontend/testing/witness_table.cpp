// The trace of the run becomes the table. What it expects is what every right program shows.
#include "frontend/testing/witness_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "analysis/encoding/asked_properties.hpp"
#include "analysis/testing/robust_check.hpp"
#include "analysis/testing/test_signals.hpp"
#include "frontend/simulation/witness_report.hpp"
#include "frontend/testing/asked_values.hpp"
#include "frontend/testing/recorded_table.hpp"

namespace rungproof {

namespace {

constexpr std::uint32_t usualMs = 10;

class WitnessTable {
 public:
  WitnessTable(const Program& program, const PropertySet& set, const Choices& choices, const std::string& name,
               const Property* broken)
      : program_(program), set_(set), name_(name), broken_(broken), lengthUs_(program.taskMs.value_or(usualMs) * 1000) {
    engine_.choices = choices;
  }

  /// Timers may need the time of a long scan, and steps that one scan passes on may need just one: of both tables the
  /// one that shows what the run shows.
  TestTable of(Trace trace) {
    if (broken_ != nullptr) expectOnlyInLast(trace);
    TestTable first;
    for (const LongScan single : {LongScan::Scan, LongScan::Time}) {
      TestTable table = recordedTable(program_, set_, trace, name_, single);
      if (table.tests.front().rows.empty()) return table;
      TestRow& last = table.tests.front().rows.back();
      if (broken_ != nullptr) last.wait = {1, 0};
      const bool isShown = broken_ != nullptr ? judgeLast(table) : dropWhatVaries(table);
      if (isShown) return table;
      if (single == LongScan::Scan) first = std::move(table);
    }
    const char* const what = broken_ != nullptr ? "the program passes this test" : "the last step is not the run's";
    if (first.expectsAnything())
      addNote(first.tests.front().rows.back(), fmt::format("with scans of {} ms {}", lengthUs_ / 1000, what));
    return first;
  }

  static void addNote(TestRow& row, const std::string& text) { row.note += (row.note.empty() ? "" : "; ") + text; }

 private:
  void expectOnlyInLast(Trace& trace) const {
    const TestSignals signals = testSignalsOf(program_, set_);
    for (std::size_t i = 0; i < trace.signals.size(); ++i) {
      const std::string address = toString(trace.signals[i].operand);
      const bool isOutput = std::ranges::any_of(
          signals.outputs, [&](const TraceSignal& output) { return toString(output.operand) == address; });
      for (std::size_t row = 0; isOutput && row + 1 < trace.rows.size(); ++row) trace.rows[row].values[i].reset();
    }
  }

  std::vector<TestFailure> failuresOf(const TestTable& table) const {
    TestPlayOptions play;
    play.engine = engine_;
    play.length = [us = lengthUs_](std::uint64_t) { return us; };
    play.stopsAtFailure = false;
    Simulator simulator(program_, engine_);
    return playTest(simulator, table, table.tests.front(), play).failures;
  }

  /// Whether the program, which violates the property, fails the table.
  bool judgeLast(TestTable& table) const {
    std::vector<std::uint32_t> lengths{lengthUs_};
    if (!program_.taskMs) lengths.insert(lengths.end(), {1000, 37000, 100000});
    const std::vector<std::optional<bool>> asked = askedValues(program_, engine_, table, *broken_, lengths);
    TestRow& last = table.tests.front().rows.back();
    for (std::size_t i = 0; i < asked.size(); ++i) {
      const TraceNumber value = asked[i].value_or(false) ? 1 : 0;
      last.expects[i] = asked[i] ? std::optional(TestRange{value, value}) : std::nullopt;
    }
    const bool isAsked = table.expectsAnything();
    addNote(last, fmt::format("'{}' was violated here{}", broken_->name, isAsked ? "" : ": write what must be seen"));
    return isAsked && !failuresOf(table).empty();
  }

  /// Gives up what does not come at every length of scans; in the last step the usual one is enough, and the step says
  /// so. Whether everything that the run shows there is expected.
  bool dropWhatVaries(TestTable& table) const {
    TestCase& test = table.tests.front();
    const std::size_t last = test.rows.size() - 1;
    RobustOptions options;
    options.engine = engine_;
    if (program_.taskMs) options.lowUs = options.highUs = lengthUs_;
    const RobustCells cells = RobustCheck(program_, table, options).quick(test);
    for (std::size_t row = 0; row < last; ++row) {
      for (const std::size_t output : cells.failing[row]) test.rows[row].expects[output].reset();
    }
    bool isWhole = true;
    for (const TestFailure& failure : failuresOf(table)) {
      if (failure.step != last) continue;
      isWhole = false;
      if (failure.signal) test.rows[last].expects[*failure.signal].reset();
    }
    std::vector<std::string> names;
    for (const std::size_t output : cells.failing[last]) {
      if (test.rows[last].expects[output]) names.push_back(signalText(table.expects[output]));
    }
    if (!names.empty())
      addNote(test.rows[last], fmt::format("timing: {} with scans of {} ms and inputs in their scan",
                                           fmt::join(names, ", "), lengthUs_ / 1000));
    return isWhole;
  }

  const Program& program_;
  const PropertySet& set_;
  const std::string& name_;
  const Property* const broken_;
  const std::uint32_t lengthUs_;
  SimulatorOptions engine_;
};

}  // namespace

TestTable witnessTable(const Program& program, const PropertySet& set, const Choices& choices, const Witness& witness,
                       const std::string& name, const Property* broken) {
  std::vector<TraceSignal> signals = touchedSignals(program);
  if (broken != nullptr) {
    for (const Operand* operand : addressesOf(*broken)) {  // what only the property names
      const TraceSignal signal = signalOf(program, *operand);
      if (std::ranges::find(signals, signal.name, &TraceSignal::name) == signals.end()) signals.push_back(signal);
    }
  }
  TestTable table = WitnessTable(program, set, choices, name, broken).of(traceOf(program, choices, witness, signals));
  if (table.tests.front().rows.empty()) return table;
  TestRow& first = table.tests.front().rows.front();
  if (const std::string start = startText(program, choices, witness); !start.empty())
    WitnessTable::addNote(first, "the run began with " + start + ", which a table cannot set");
  const auto [least, most] = std::ranges::minmax(witness.scans, {}, &ReplayScan::lengthMs);
  if (least.lengthMs != usualMs || most.lengthMs != usualMs)
    WitnessTable::addNote(first, fmt::format("the run had scans of {} to {} ms", least.lengthMs, most.lengthMs));
  return table;
}

}  // namespace rungproof
