// BitSystem: a transition system of bits, an and-inverter graph with latches, as the AIGER format has it. The
// bit-level engines (BMC, k-induction, IC3) work on it alone, so they can be tested on hand-made systems. It also
// serves as plain and-inverter graph for unrollings. Tested by tests/solver/bit_system_test.cpp.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace rungproof {

/// A literal: 2 * variable + sign. Variable 0 is the constant false, so literal 0 is false and 1 is true.
using Lit = std::uint32_t;
constexpr Lit falseLit = 0;
constexpr Lit trueLit = 1;
constexpr Lit negate(Lit l) { return l ^ 1U; }
constexpr Lit positive(std::uint32_t variable) { return 2 * variable; }
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
  Lit left = 0, right = 0;  ///< left < right, both smaller than the gate's own literal
};

/// Every variable's children have smaller numbers: variables are in topological order. A run chooses inputs for
/// each scan such that all constraints are true in it; it is bad when some `bads` literal is true in a scan.
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
  /// Gates that presumably are true in every scan from a state that satisfies the invariants at hand, or after it, each
  /// easy to see after those before it: who asks what follows from invariants first asks for them.
  struct Guiding {
    Lit gate = 0;
    bool isAfter = false;  ///< of the state after the scan
  };
  std::vector<Guiding> guide;

  Lit addInput(std::string name = {});
  Lit addLatch(std::string name, LatchInit init);
  void setNext(Lit latch, Lit next);
  /// Hash-consed, with constant and identity simplification over two levels.
  Lit addAnd(Lit a, Lit b);
  Lit addOr(Lit a, Lit b) { return negate(addAnd(negate(a), negate(b))); }
  Lit addXor(Lit a, Lit b);
  Lit addIte(Lit c, Lit a, Lit b);
  std::uint32_t variableCount() const { return static_cast<std::uint32_t>(kind.size()); }
  bool isGate(Lit l) const { return kind[variableOf(l)] == Kind::Gate; }
  const AndGate& gateOf(Lit l) const { return gates[position[variableOf(l)]]; }

 private:
  std::uint32_t addVariable(Kind k, std::size_t index);
  std::uint32_t* slot(Lit a, Lit b);
  void growTable();
  std::vector<std::uint32_t> gateTable_;  ///< open addressing: gate index + 1 by (left, right)
};

/// If the gate of `l` is an exclusive or or a choice in disguise: condition, then, else of the *positive* gate's
/// value; recognised as !(c & !t) & !(!c & !e). An exclusive or has `otherwise` = !`then`.
struct BitChoice {
  Lit condition = 0, then = 0, otherwise = 0;
};
bool recogniseChoice(const BitSystem& system, Lit l, BitChoice& choice);

}  // namespace rungproof
