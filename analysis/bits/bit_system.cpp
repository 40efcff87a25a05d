// Building of and-inverter graphs: structural hashing and the local identities that keep unrollings small.
// Tested by tests/solver/bit_system_test.cpp.
#include "analysis/bits/bit_system.hpp"

#include "ir/check.hpp"

namespace rungproof {

namespace {

std::size_t hashOfGate(Lit a, Lit b) {
  std::uint64_t h = (static_cast<std::uint64_t>(a) << 32U) ^ b;
  h *= 0x9E3779B97F4A7C15ULL;
  return static_cast<std::size_t>(h ^ (h >> 29U));
}

}  // namespace

std::uint32_t BitSystem::addVariable(Kind k, std::size_t index) {
  kind.push_back(k);
  position.push_back(static_cast<std::uint32_t>(index));
  return variableCount() - 1;
}

Lit BitSystem::addInput(std::string name) {
  const std::uint32_t v = addVariable(Kind::Input, inputs.size());
  inputs.push_back(v);
  inputNames.push_back(std::move(name));
  return positive(v);
}

Lit BitSystem::addLatch(std::string name, LatchInit init) {
  const std::uint32_t v = addVariable(Kind::Latch, latches.size());
  latches.push_back({v, positive(v), init, std::move(name)});
  return positive(v);
}

void BitSystem::setNext(Lit latch, Lit next) {
  CHECK(kind[variableOf(latch)] == Kind::Latch && !isNegative(latch), "next state of something else than a latch");
  latches[position[variableOf(latch)]].next = next;
}

void BitSystem::growTable() {
  gateTable_.assign(gateTable_.empty() ? 256 : gateTable_.size() * 2, 0);
  for (std::uint32_t i = 0; i < gates.size(); ++i) *slot(gates[i].left, gates[i].right) = i + 1;
}

std::uint32_t* BitSystem::slot(Lit a, Lit b) {
  const std::size_t mask = gateTable_.size() - 1;
  for (std::size_t i = hashOfGate(a, b) & mask;; i = (i + 1) & mask) {
    const std::uint32_t entry = gateTable_[i];
    if (entry == 0 || (gates[entry - 1].left == a && gates[entry - 1].right == b)) return &gateTable_[i];
  }
}

Lit BitSystem::addAnd(Lit a, Lit b) {
  for (;;) {
    if (a > b) std::swap(a, b);
    if (a == falseLit || a == negate(b)) return falseLit;
    if (a == trueLit || a == b) return b;
    bool again = false;
    for (int side = 0; side < 2 && !again; ++side) {
      const Lit gate = side == 0 ? b : a;
      const Lit other = side == 0 ? a : b;
      if (!isGate(gate)) continue;
      const auto [p, q] = gateOf(gate);
      if (!isNegative(gate)) {  // (p & q) & other
        if (other == p || other == q) return gate;
        if (other == negate(p) || other == negate(q)) return falseLit;
      } else {  // !(p & q) & other
        if (other == negate(p) || other == negate(q)) return other;
        if (other == p || other == q) {
          a = other;
          b = negate(other == p ? q : p);
          again = true;
        }
      }
    }
    if (again) continue;
    if (isGate(a) && isGate(b)) {
      const auto [p, q] = gateOf(a);
      const auto [r, s] = gateOf(b);
      const bool opposed = p == negate(r) || p == negate(s) || q == negate(r) || q == negate(s);
      if (!isNegative(a) && !isNegative(b) && opposed) return falseLit;
      if (!isNegative(a) && isNegative(b) && opposed) return a;
      if (isNegative(a) && !isNegative(b) && opposed) return b;
      if (isNegative(a) && isNegative(b)) {  // !(p & q) & !(p & !q) = !p
        if ((p == r && q == negate(s)) || (p == s && q == negate(r))) return negate(p);
        if ((q == r && p == negate(s)) || (q == s && p == negate(r))) return negate(q);
      }
    }
    break;
  }
  if ((gates.size() + 1) * 2 > gateTable_.size()) growTable();
  std::uint32_t* entry = slot(a, b);
  if (*entry == 0) {
    gates.push_back({a, b});
    *entry = static_cast<std::uint32_t>(gates.size());
    gateVariables.push_back(addVariable(Kind::Gate, gates.size() - 1));
  }
  return positive(gateVariables[*entry - 1]);
}

Lit BitSystem::addXor(Lit a, Lit b) {
  const Lit sign = (a ^ b) & 1U;
  a &= ~1U;
  b &= ~1U;
  return addAnd(negate(addAnd(a, b)), negate(addAnd(negate(a), negate(b)))) ^ sign;
}

Lit BitSystem::addIte(Lit c, Lit a, Lit b) {
  if (c == trueLit || a == b) return a;
  if (c == falseLit) return b;
  if (isNegative(c)) {
    c = negate(c);
    std::swap(a, b);
  }
  if (a == negate(b)) return negate(addXor(c, a));
  if (a == c) a = trueLit;
  if (a == negate(c)) a = falseLit;
  if (b == c) b = falseLit;
  if (b == negate(c)) b = trueLit;
  return negate(addAnd(negate(addAnd(c, a)), negate(addAnd(negate(c), b))));
}

bool recogniseChoice(const BitSystem& system, Lit l, BitChoice& choice) {
  if (!system.isGate(l)) return false;
  const auto [a, b] = system.gateOf(l);
  if (!isNegative(a) || !isNegative(b) || !system.isGate(a) || !system.isGate(b)) return false;
  const auto [p, q] = system.gateOf(a);
  const auto [r, s] = system.gateOf(b);
  // The gate is !(c & t) & !(!c & e): its value is c ? !t : !e.
  if (p == negate(r))
    choice = {p, negate(q), negate(s)};
  else if (p == negate(s))
    choice = {p, negate(q), negate(r)};
  else if (q == negate(r))
    choice = {q, negate(p), negate(s)};
  else if (q == negate(s))
    choice = {q, negate(p), negate(r)};
  else
    return false;
  return true;
}

}  // namespace rungproof
