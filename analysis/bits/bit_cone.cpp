// Cone of influence by a backward search from the bad literal over gates and next-state functions.
#include "analysis/bits/bit_cone.hpp"

#include <algorithm>

#include "analysis/bits/bit_cnf.hpp"
#include "analysis/bits/bit_simulator.hpp"
#include "analysis/schedule/schedule.hpp"
#include "ir/check.hpp"

namespace rungproof {

namespace {

class ConeSearch {
 public:
  ConeSearch(const BitSystem& system, const EqualLiterals& equal)
      : system_(system), equal_(equal), needed_(system.variableCount(), false) {}

  Lit representative(Lit l) const { return equal_.empty() ? l : equal_[variableOf(l)] ^ (l & 1U); }

  void need(Lit root) {
    stack_.push_back(variableOf(representative(root)));
    while (!stack_.empty()) {
      const std::uint32_t v = stack_.back();
      stack_.pop_back();
      if (needed_[v]) continue;
      needed_[v] = true;
      const auto follow = [&](Lit l) { stack_.push_back(variableOf(representative(l))); };
      if (system_.kind[v] == BitSystem::Kind::Gate) {
        follow(system_.gateOf(positive(v)).left);
        follow(system_.gateOf(positive(v)).right);
      } else if (system_.kind[v] == BitSystem::Kind::Latch) {
        follow(system_.latches[system_.position[v]].next);
      }
    }
  }

  /// Does some input or latch under the literal belong to the cone already?
  bool sharesVariables(Lit root) const {
    std::vector<bool> seen(system_.variableCount(), false);
    std::vector<std::uint32_t> stack{variableOf(representative(root))};
    while (!stack.empty()) {
      const std::uint32_t v = stack.back();
      stack.pop_back();
      if (seen[v]) continue;
      seen[v] = true;
      if (system_.kind[v] == BitSystem::Kind::Gate) {
        stack.push_back(variableOf(representative(system_.gateOf(positive(v)).left)));
        stack.push_back(variableOf(representative(system_.gateOf(positive(v)).right)));
      } else if (v != 0 && needed_[v]) {
        return true;
      }
    }
    return false;
  }

  bool isNeeded(std::uint32_t v) const { return needed_[v]; }

 private:
  const BitSystem& system_;
  const EqualLiterals& equal_;
  std::vector<bool> needed_;
  std::vector<std::uint32_t> stack_;
};

/// Marks the gates under the literals, without going through latches.
std::vector<bool> gatesUnder(const BitSystem& system, const std::vector<Lit>& roots) {
  std::vector<bool> marked(roots.empty() ? 0 : system.variableCount(), false);
  std::vector<std::uint32_t> stack;
  for (const Lit l : roots) stack.push_back(variableOf(l));
  while (!stack.empty()) {
    const std::uint32_t v = stack.back();
    stack.pop_back();
    if (marked[v] || system.kind[v] != BitSystem::Kind::Gate) continue;
    marked[v] = true;
    stack.push_back(variableOf(system.gateOf(positive(v)).left));
    stack.push_back(variableOf(system.gateOf(positive(v)).right));
  }
  return marked;
}

}  // namespace

std::vector<std::vector<Lit>> BitCone::translated(const std::vector<std::vector<Lit>>& clauses) const {
  std::vector<std::vector<Lit>> result;
  for (const std::vector<Lit>& clause : clauses) {
    std::vector<Lit> inCone;
    bool useful = true;
    for (const Lit l : clause) {
      const Lit t = translated(l);
      useful =
          useful && t != outside && t != trueLit && std::find(inCone.begin(), inCone.end(), negate(t)) == inCone.end();
      if (t != falseLit) inCone.push_back(t);
    }
    if (useful) result.push_back(std::move(inCone));
  }
  return result;
}

BitCone makeCone(const BitSystem& system, const std::vector<Lit>& bads, const std::vector<bool>& isTotal,
                 const EqualLiterals& equal, const std::vector<Lit>& wanted) {
  ConeSearch search(system, equal);
  for (const Lit bad : bads) search.need(bad);
  std::vector<bool> kept(system.constraints.size(), false);
  const auto keep = [&](std::size_t i) {
    kept[i] = true;
    search.need(system.constraints[i]);
  };
  for (std::size_t i = 0; i < kept.size(); ++i) {
    if (!isTotal[i]) keep(i);
  }
  for (bool grown = true; grown;) {
    grown = false;
    for (std::size_t i = 0; i < kept.size(); ++i) {
      if (kept[i] || !search.sharesVariables(system.constraints[i])) continue;
      keep(i);
      grown = true;
    }
  }

  BitCone cone;
  cone.toCone.assign(system.variableCount(), BitCone::outside);
  cone.toCone[0] = falseLit;
  for (std::size_t i = 0; i < system.inputs.size(); ++i) {
    if (!search.isNeeded(system.inputs[i])) continue;
    cone.toCone[system.inputs[i]] = cone.system.addInput();
    cone.inputs.push_back(static_cast<std::uint32_t>(i));
  }
  for (std::size_t i = 0; i < system.latches.size(); ++i) {
    const Latch& latch = system.latches[i];
    if (!search.isNeeded(latch.variable)) continue;
    cone.toCone[latch.variable] = cone.system.addLatch({}, latch.init);
    cone.latches.push_back(static_cast<std::uint32_t>(i));
  }
  for (std::size_t i = 0; !equal.empty() && i < system.latches.size(); ++i) {
    const std::uint32_t v = system.latches[i].variable;
    const Lit r = equal[v];
    if (variableOf(r) != v) cone.toCone[v] = cone.translated(r);
  }
  const auto literal = [&](Lit l) {
    const Lit result = cone.translated(l);
    CHECK(result != BitCone::outside, "the cone is closed");
    return result;
  };
  const std::vector<bool> isWanted = gatesUnder(system, wanted);
  for (std::size_t i = 0; i < system.gates.size(); ++i) {
    const auto [a, b] = system.gates[i];
    const std::uint32_t v = system.gateVariables[i];
    const bool possible = !isWanted.empty() && isWanted[v] && cone.translated(a) != BitCone::outside &&
                          cone.translated(b) != BitCone::outside;
    if (search.isNeeded(v) || possible) cone.toCone[v] = cone.system.addAnd(literal(a), literal(b));
  }
  for (std::size_t i = 0; i < cone.latches.size(); ++i) {
    cone.system.setNext(positive(cone.system.latches[i].variable), literal(system.latches[cone.latches[i]].next));
  }
  for (std::size_t i = 0; i < kept.size(); ++i) {
    if (!kept[i]) continue;
    const Lit l = literal(system.constraints[i]);
    if (l == trueLit) continue;
    cone.system.constraints.push_back(l);
    cone.isTotal.push_back(isTotal[i]);
  }
  for (const Lit bad : bads) cone.system.bads.push_back(literal(bad));
  return cone;
}

std::optional<BitTrace> completeTrace(const BitSystem& system, const BitCone& cone, const BitTrace& trace) {
  BitTrace result;
  for (const Latch& latch : system.latches) result.initial.push_back(latch.init == LatchInit::One);
  for (std::size_t i = 0; i < cone.latches.size(); ++i) result.initial[cone.latches[i]] = trace.initial[i];
  BitSimulator simulator(system);
  for (std::size_t i = 0; i < system.latches.size(); ++i) simulator.setLatch(i, result.initial[i] ? ~0ULL : 0);
  Sat sat(Sat::Use::Many);
  BitCnf cnf(system, sat);
  for (const Lit constraint : system.constraints) sat.add({cnf.literal(constraint)});
  const Budget budget = Budget::seconds(schedule::completionSeconds);
  std::vector<bool> scan(system.inputs.size(), false);
  std::vector<bool> isFixed(system.inputs.size(), false);
  for (const std::uint32_t i : cone.inputs) isFixed[i] = true;
  for (const std::vector<bool>& given : trace.inputs) {
    for (std::size_t i = 0; i < cone.inputs.size(); ++i) scan[cone.inputs[i]] = given[i];
    const auto tryScan = [&] {
      for (std::size_t i = 0; i < scan.size(); ++i) simulator.setInput(i, scan[i] ? ~0ULL : 0);
      simulator.evaluate();
      for (const Lit constraint : system.constraints) {
        if (simulator.value(constraint) == 0) return false;
      }
      return true;
    };
    if (!tryScan()) {
      std::vector<int> assumptions;
      for (std::size_t i = 0; i < system.latches.size(); ++i) {
        const int l = cnf.known(positive(system.latches[i].variable));
        if (l != 0) assumptions.push_back(simulator.latch(i) != 0 ? l : -l);
      }
      for (std::size_t i = 0; i < scan.size(); ++i) {
        const int l = cnf.known(positive(system.inputs[i]));
        if (l != 0 && isFixed[i]) assumptions.push_back(scan[i] ? l : -l);
      }
      if (sat.solve(assumptions, budget) != Sat::Outcome::Satisfiable) return std::nullopt;
      for (std::size_t i = 0; i < scan.size(); ++i) {
        if (!isFixed[i]) scan[i] = cnf.value(positive(system.inputs[i]));
      }
      if (!tryScan()) return std::nullopt;
    }
    result.inputs.push_back(scan);
    simulator.step();
  }
  return result;
}

std::vector<bool> constrainedVariables(const BitSystem& system) {
  std::vector<bool> isConstrained(system.variableCount(), false);
  for (const Lit l : system.constraints) isConstrained[variableOf(l)] = true;
  for (std::size_t i = system.gates.size(); i-- > 0;) {
    if (!isConstrained[system.gateVariables[i]]) continue;
    isConstrained[variableOf(system.gates[i].left)] = isConstrained[variableOf(system.gates[i].right)] = true;
  }
  return isConstrained;
}

}  // namespace rungproof
