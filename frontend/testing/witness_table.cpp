// The trace of the run becomes the table; the last step is then judged by the monitor of the property.
#include "frontend/testing/witness_table.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "analysis/encoding/asked_properties.hpp"
#include "analysis/witness/follower.hpp"
#include "analysis/witness/state_pool.hpp"
#include "frontend/simulation/witness_report.hpp"
#include "frontend/testing/recorded_table.hpp"

namespace rungproof {

namespace {

constexpr std::uint32_t usualMs = 10;

/// Whether the run breaks the property in its last scan, with one output bit changed there (or none).
bool isBroken(const Program& program, const Choices& choices, const Witness& witness, const Property& property,
              const Operand* changed) {
  Follower follower(property);
  StillOutside outside;
  Concrete domain{outside};
  std::uint64_t scans = 0;
  bool isLastBroken = false;
  replay(program, choices, witness.scans, witness.initial ? &*witness.initial : nullptr,
         [&](const Concrete::Store& state, std::size_t scan) {
           const bool isLast = ++scans == witness.scanCount;
           if (!isLast || changed == nullptr) {
             isLastBroken = follower.evaluate(domain, state, witness.scans[scan], scans == 1);
             return true;
           }
           Concrete::Store other = state;
           const std::uint32_t bit = changed->offset * 8 + changed->bit;
           other.save(changed->area, bit, 1, other.load(changed->area, bit, 1) ^ 1U, true);
           isLastBroken = follower.evaluate(domain, other, witness.scans[scan], scans == 1);
           return true;
         });
  return isLastBroken;
}

void judgeLast(TestTable& table, const Program& program, const Choices& choices, const Witness& witness,
               const Property& broken) {
  TestRow& last = table.tests.front().rows.back();
  std::vector<std::size_t> read, mending;
  for (std::size_t i = 0; i < table.expects.size(); ++i) {
    const Operand& output = table.expects[i].operand;
    const auto isIt = [&](const Operand* o) { return toString(*o) == toString(output); };
    if (!std::ranges::any_of(addressesOf(broken), isIt)) continue;
    read.push_back(i);
    const bool isBit = output.width == Width::Bit;
    if (isBit && isBroken(program, choices, witness, broken, nullptr) &&
        !isBroken(program, choices, witness, broken, &output))
      mending.push_back(i);
  }
  for (const std::size_t i : read) {
    const bool isMended = mending.size() == 1 && mending.front() == i && last.expects[i];
    if (isMended)
      last.expects[i] = TestRange{1 - last.expects[i]->low, 1 - last.expects[i]->high};
    else if (mending.size() != 1)
      last.expects[i].reset();
  }
  last.note = mending.size() == 1 ? fmt::format("'{}' was violated here", broken.name)
                                  : fmt::format("'{}' was violated here: write what must be seen", broken.name);
}

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
  const Trace trace = traceOf(program, choices, witness, signals);
  TestTable table = recordedTable(program, set, trace, name);
  if (table.tests.front().rows.empty()) return table;
  if (broken != nullptr) judgeLast(table, program, choices, witness, *broken);
  std::string& note = table.tests.front().rows.front().note;
  const auto add = [&](const std::string& text) { note += (note.empty() ? "" : "; ") + text; };
  if (const std::string start = startText(program, choices, witness); !start.empty())
    add("the run began with " + start + ", which a table cannot set");
  const auto [least, most] = std::ranges::minmax(witness.scans, {}, &ReplayScan::lengthMs);
  if (least.lengthMs != usualMs || most.lengthMs != usualMs)
    add(fmt::format("the run had scans of {} to {} ms", least.lengthMs, most.lengthMs));
  return table;
}

}  // namespace rungproof
