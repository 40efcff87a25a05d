// BitSystem: a transition system of bits, an and-inverter graph with latches, as the AIGER format has it. The
// bit-level engines (BMC, k-induction, IC3) work on it alone, so they can be tested on hand-made systems.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace rungproof {

/// A literal: 2 * variable + sign. Variable 0 is the constant false, so literal 0 is false and 1 is true.
using Lit = std::uint32_t;
constexpr Lit negate(Lit l) { return l ^ 1U; }
constexpr std::uint32_t variableOf(Lit l) { return l >> 1U; }
constexpr bool isNegative(Lit l) { return (l & 1U) != 0; }

enum class LatchInit : std::uint8_t { Zero, One, Free };

struct Latch {
  std::uint32_t variable = 0;
  Lit next = 0;
  LatchInit init = LatchInit::Zero;
  std::string name;  ///< "T37.value[3]"
};

struct AndGate {
  Lit left = 0, right = 0;  ///< both smaller than the gate's own literal
};

/// Variables are numbered 0 constant, then inputs, latches and gates in any topological order.
struct BitSystem {
  enum class Kind : std::uint8_t { Constant, Input, Latch, Gate };
  std::vector<Kind> kind{Kind::Constant};
  std::vector<std::uint32_t> position{0};  ///< by variable: index in inputs, latches or gates
  std::vector<std::uint32_t> inputs;       ///< variables
  std::vector<std::string> inputNames;
  std::vector<Latch> latches;
  std::vector<AndGate> gates;
  std::vector<std::uint32_t> gateVariables;
  std::vector<Lit> constraints;
  std::vector<Lit> bads;

  Lit addInput(std::string name);
  Lit addLatch(std::string name, LatchInit init);
  void setNext(Lit latch, Lit next);
  /// Hash-consed, with constant and identity simplification.
  Lit addAnd(Lit a, Lit b);
  Lit addOr(Lit a, Lit b) { return negate(addAnd(negate(a), negate(b))); }
  Lit addXor(Lit a, Lit b);
  Lit addIte(Lit c, Lit a, Lit b);
  std::uint32_t variableCount() const { return static_cast<std::uint32_t>(kind.size()); }

 private:
  struct Hash;
  std::vector<std::uint32_t> gateTable_;  ///< open addressing: gate index + 1 by (left, right)
};

}  // namespace rungproof
