// The encoding is evaluated scan by scan, and the engine runs the same script.
#include "analysis/witness/both_traces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <deque>

#include "analysis/witness/scan_run.hpp"

namespace rungproof {

namespace {

constexpr std::size_t shownScans = 20;  ///< the last ones
constexpr std::size_t shownAddresses = 32;

struct Shown {
  Operand operand;
  int width;
  Node node;
};

std::string lineOf(std::size_t scan, std::uint32_t lengthMs, const std::vector<Shown>& shown,
                   const std::function<std::uint64_t(const Shown&)>& valueOf) {
  std::string line = fmt::format("scan {} ({} ms):", scan + 1, lengthMs);
  for (const Shown& s : shown) line += fmt::format(" {}={}", toString(s.operand), valueOf(s));
  return line;
}

void addLast(std::deque<std::string>& lines, std::string line) {
  lines.push_back(std::move(line));
  if (lines.size() > shownScans) lines.pop_front();
}

/// Those of the property, then inputs that matter at all.
std::vector<Shown> shownOf(EncodedScan& encoding, const Operands& addresses, const std::vector<ReplayScan>& scans) {
  std::vector<Shown> shown;
  const auto add = [&](const Operand& operand) {
    const bool isKnown =
        std::ranges::any_of(shown, [&](const Shown& s) { return toString(s.operand) == toString(operand); });
    if (isKnown || shown.size() >= shownAddresses) return;
    const int width = bits(operand.width);
    const Node node = encoding.atEnd(operand, width);
    if (node != noNode) shown.push_back({operand, width, node});
  };
  for (const Operand& operand : addresses) add(operand);
  for (const ReplayScan& scan : scans) {
    for (const PresetValue& input : scan.inputs) {
      if (input.value != 0) add(input.operand);
    }
  }
  return shown;
}

}  // namespace

BothTraces bothTracesOf(const Program& program, EncodedScan& encoding, const TransitionSystem& system,
                        const WordTrace& trace, const Operands& addresses) {
  const std::vector<ReplayScan> scans = scansOf(encoding, system, trace, encoding.options().time);
  const std::vector<Shown> shown = shownOf(encoding, addresses, scans);
  std::vector<Node> watched;
  for (const Shown& s : shown) watched.push_back(s.node);
  std::deque<std::string> solver, engine;
  ScanRun run(encoding, system, watched);
  run.start();
  for (std::size_t i = 0; i < system.states.size(); ++i) {
    if (system.states[i].init == noNode) run.set(system.states[i].node, trace.initial[i]);
  }
  for (std::size_t scan = 0; scan < trace.inputs.size(); ++scan) {
    for (std::size_t i = 0; i < system.inputs.size(); ++i) run.set(system.inputs[i], trace.inputs[scan][i]);
    run.evaluate();
    addLast(solver, lineOf(scan, run.script().lengthMs, shown, [&](const Shown& s) { return run[s.node]; }));
    if (scan + 1 < trace.inputs.size()) run.advance();
  }
  const std::optional<Concrete::Store> initial = initialOf(encoding, system, trace);
  std::size_t count = 0;
  bool isRunning = true;
  replay(program, encoding.options().choices, scans, initial ? &*initial : nullptr,
         [&](const Concrete::Store& state, std::size_t at) {
           isRunning = state.get(Reg::Running, 0) != 0;
           addLast(engine, lineOf(count++, scans[at].lengthMs, shown,
                                  [&](const Shown& s) { return valueIn(state, s.operand); }));
           return true;
         });
  if (!isRunning && !engine.empty()) engine.back() += " (the program has stopped)";
  return {{solver.begin(), solver.end()}, {engine.begin(), engine.end()}};
}

}  // namespace rungproof
