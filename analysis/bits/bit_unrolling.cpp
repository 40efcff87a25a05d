// Adds frames by copying all gates through the hashing constructor.
#include "analysis/bits/bit_unrolling.hpp"

#include "analysis/bits/bit_simulator.hpp"
#include "analysis/schedule/schedule.hpp"

namespace rungproof {

void Unrolling::addFrame() {
  std::vector<Lit> values(system_.variableCount());
  values[0] = falseLit;
  for (const std::uint32_t v : system_.inputs) values[v] = graph_.addInput();
  for (const Latch& latch : system_.latches) {
    Lit& value = values[latch.variable];
    if (!frames_.empty()) {
      value = frames_.back()[variableOf(latch.next)] ^ (latch.next & 1U);
    } else if (start_ == Start::Any || latch.init == LatchInit::Free) {
      value = graph_.addInput();
    } else {
      value = latch.init == LatchInit::One ? trueLit : falseLit;
    }
  }
  for (std::size_t i = 0; i < system_.gates.size(); ++i) {
    const auto [a, b] = system_.gates[i];
    values[system_.gateVariables[i]] =
        graph_.addAnd(values[variableOf(a)] ^ (a & 1U), values[variableOf(b)] ^ (b & 1U));
  }
  frames_.push_back(std::move(values));
}

BitTrace Unrolling::trace(int depth, const BitCnf& cnf) const {
  BitTrace result;
  for (const Latch& latch : system_.latches) result.initial.push_back(cnf.value(frames_[0][latch.variable]));
  for (int frame = 0; frame <= depth; ++frame) {
    std::vector<bool>& scan = result.inputs.emplace_back();
    for (const std::uint32_t v : system_.inputs) scan.push_back(cnf.value(frames_[frame][v]));
  }
  return result;
}

void teach(Sat& sat, int literal, std::span<const int> assumptions, const Budget& budget) {
  std::vector<int> denied(assumptions.begin(), assumptions.end());
  denied.push_back(-literal);
  if (sat.solve(denied, budget.slice(schedule::guideSeconds)) != Sat::Outcome::Unsatisfiable) return;
  std::vector<int> clause{literal};
  for (const int assumed : assumptions) {
    if (sat.failed(assumed)) clause.push_back(-assumed);
  }
  sat.add(clause);
}

void followGuide(const BitSystem& system, Unrolling& steps, int frame, Sat& sat, BitCnf& cnf,
                 std::span<const int> assumptions, const Budget& budget) {
  for (const auto& [gate, isAfter] : system.guide) {
    const Lit l = steps.at(frame + (isAfter ? 1 : 0), gate);
    if (l != trueLit && l != falseLit) teach(sat, cnf.literal(l), assumptions, budget);
  }
}

bool isViolation(const BitSystem& system, const BitTrace& trace) {
  if (trace.inputs.empty() || trace.initial.size() != system.latches.size()) return false;
  BitSimulator simulator(system);
  for (std::size_t i = 0; i < system.latches.size(); ++i) {
    const Latch& latch = system.latches[i];
    if (latch.init != LatchInit::Free && trace.initial[i] != (latch.init == LatchInit::One)) return false;
    simulator.setLatch(i, trace.initial[i] ? ~0ULL : 0);
  }
  for (std::size_t scan = 0; scan < trace.inputs.size(); ++scan) {
    for (std::size_t i = 0; i < system.inputs.size(); ++i) simulator.setInput(i, trace.inputs[scan][i] ? ~0ULL : 0);
    simulator.evaluate();
    for (const Lit constraint : system.constraints) {
      if (simulator.value(constraint) != ~0ULL) return false;
    }
    if (scan + 1 < trace.inputs.size()) simulator.step();
  }
  for (const Lit bad : system.bads) {
    if (simulator.value(bad) == ~0ULL) return true;
  }
  return false;
}

}  // namespace rungproof
