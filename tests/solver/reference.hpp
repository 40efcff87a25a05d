// A slow and plain reading of BitSystem for small systems: evaluates literals recursively, searches all states,
// and checks certificates by trying every state and input. Shares no code with the engines.
#pragma once

#include <optional>
#include <random>

#include "analysis/bits/engine_contract.hpp"

namespace rungproof::reference {

/// Value of `l` when latch i has bit i of `state` and input i bit i of `inputs`; `extra` are a certificate's gates.
inline bool evaluate(const BitSystem& system, Lit l, std::uint32_t state, std::uint32_t inputs,
                     const std::vector<AndGate>& extra = {}) {
  const std::uint32_t v = variableOf(l);
  bool value = false;
  if (v >= system.variableCount()) {
    const AndGate& gate = extra.at(v - system.variableCount());
    value = evaluate(system, gate.left, state, inputs, extra) && evaluate(system, gate.right, state, inputs, extra);
  } else if (system.kind[v] == BitSystem::Kind::Input) {
    value = (inputs >> system.position[v] & 1U) != 0;
  } else if (system.kind[v] == BitSystem::Kind::Latch) {
    value = (state >> system.position[v] & 1U) != 0;
  } else if (system.kind[v] == BitSystem::Kind::Gate) {
    const AndGate& gate = system.gates[system.position[v]];
    value = evaluate(system, gate.left, state, inputs) && evaluate(system, gate.right, state, inputs);
  }
  return value != isNegative(l);
}

inline bool isLegal(const BitSystem& system, std::uint32_t state, std::uint32_t inputs) {
  for (const Lit l : system.constraints) {
    if (!evaluate(system, l, state, inputs)) return false;
  }
  return true;
}

inline bool isBad(const BitSystem& system, std::uint32_t state, std::uint32_t inputs) {
  for (const Lit l : system.bads) {
    if (evaluate(system, l, state, inputs)) return true;
  }
  return false;
}

inline bool isInitial(const BitSystem& system, std::uint32_t state) {
  for (std::size_t i = 0; i < system.latches.size(); ++i) {
    const LatchInit init = system.latches[i].init;
    if (init != LatchInit::Free && (init == LatchInit::One) != ((state >> i & 1U) != 0)) return false;
  }
  return true;
}

inline std::uint32_t nextState(const BitSystem& system, std::uint32_t state, std::uint32_t inputs) {
  std::uint32_t result = 0;
  for (std::size_t i = 0; i < system.latches.size(); ++i) {
    result |= static_cast<std::uint32_t>(evaluate(system, system.latches[i].next, state, inputs)) << i;
  }
  return result;
}

/// Length - 1 of the shortest violating run; nothing if bad is unreachable.
inline std::optional<int> shortestViolation(const BitSystem& system) {
  const std::uint32_t states = 1U << system.latches.size(), choices = 1U << system.inputs.size();
  std::vector<bool> reached(states);
  std::vector<std::uint32_t> layer;
  for (std::uint32_t s = 0; s < states; ++s) {
    if (isInitial(system, s)) {
      reached[s] = true;
      layer.push_back(s);
    }
  }
  for (int depth = 0; !layer.empty(); ++depth) {
    std::vector<std::uint32_t> following;
    for (const std::uint32_t s : layer) {
      for (std::uint32_t i = 0; i < choices; ++i) {
        if (!isLegal(system, s, i)) continue;
        if (isBad(system, s, i)) return depth;
        const std::uint32_t t = nextState(system, s, i);
        if (reached[t]) continue;
        reached[t] = true;
        following.push_back(t);
      }
    }
    layer = std::move(following);
  }
  return std::nullopt;
}

/// Checks a certificate without k (an inductive invariant) on every state and input.
inline bool isInductive(const BitSystem& system, const Certificate& certificate) {
  const std::uint32_t states = 1U << system.latches.size(), choices = 1U << system.inputs.size();
  const auto holds = [&](std::uint32_t s) {
    for (const std::vector<Lit>& clause : certificate.clauses) {
      bool some = false;
      for (const Lit l : clause) some = some || evaluate(system, l, s, 0, certificate.gates);
      if (!some) return false;
    }
    return true;
  };
  for (std::uint32_t s = 0; s < states; ++s) {
    const bool inside = holds(s);
    if (isInitial(system, s) && !inside) return false;
    if (!inside) continue;
    for (std::uint32_t i = 0; i < choices; ++i) {
      if (!isLegal(system, s, i)) continue;
      if (isBad(system, s, i) || !holds(nextState(system, s, i))) return false;
    }
  }
  return true;
}

/// A random system: up to 7 latches and 3 inputs, gates over them, sometimes a constraint, rare bad states.
inline BitSystem randomSystem(std::mt19937& random) {
  const auto below = [&](std::uint32_t n) { return static_cast<std::uint32_t>(random() % n); };
  BitSystem system;
  std::vector<Lit> pool;
  for (std::uint32_t i = below(4); i > 0; --i) pool.push_back(system.addInput("i" + std::to_string(i)));
  std::vector<Lit> latches;
  for (std::uint32_t i = 1 + below(7); i > 0; --i) {
    const std::uint32_t kind = below(8);
    latches.push_back(system.addLatch("l" + std::to_string(i), kind == 0  ? LatchInit::Free
                                                               : kind < 3 ? LatchInit::One
                                                                          : LatchInit::Zero));
    pool.push_back(latches.back());
  }
  const auto pick = [&] { return pool[below(static_cast<std::uint32_t>(pool.size()))] ^ below(2); };
  for (std::uint32_t i = below(30) + 2; i > 0; --i) {
    const std::uint32_t kind = below(6);
    pool.push_back(kind == 0   ? system.addXor(pick(), pick())
                   : kind == 1 ? system.addIte(pick(), pick(), pick())
                               : system.addAnd(pick(), pick()));
  }
  for (const Lit l : latches) system.setNext(l, below(3) == 0 ? system.addXor(l, pick()) : pick());
  if (below(3) == 0) system.constraints.push_back(system.addOr(pick(), system.addOr(pick(), pick())));
  Lit bad = pick();
  for (std::uint32_t i = 1 + below(4); i > 0; --i) bad = system.addAnd(bad, pick());
  system.bads.push_back(bad);
  return system;
}

}  // namespace rungproof::reference
