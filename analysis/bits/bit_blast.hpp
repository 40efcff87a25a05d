// From words to bits: the questions of a TransitionSystem as one BitSystem over the variables they depend on, with
// the way back for runs and invariants. Every operation is exact except those on REAL numbers, which become free
// inputs and are reported: proofs stay valid, runs must be replayed.
// Tested by tests/solver/bit_blast_test.cpp.
#pragma once

#include <optional>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "analysis/bits/bit_arithmetic.hpp"
#include "analysis/bits/engine_contract.hpp"
#include "analysis/graph/transition_system.hpp"

namespace rungproof {

/// A run in words: the values of all state variables before the first scan (by index in TransitionSystem::states)
/// and of all inputs in each scan (by index in TransitionSystem::inputs). The last scan is the bad one.
struct WordTrace {
  std::vector<std::uint64_t> initial;
  std::vector<std::vector<std::uint64_t>> inputs;
};

/// Thrown where the time is over and half a result is of no use.
struct OutOfBudget {};

class BitBlast {
 public:
  /// Covers the cone of `questions`, of all constraints, and of `extra` nodes over states and inputs. Throws
  /// OutOfBudget: long arithmetic can be millions of gates.
  BitBlast(const TransitionSystem& system, const Questions& questions, const std::vector<Node>& extra = {},
           const Budget* budget = nullptr);
  /// One node within one scan; `open` nodes (indices) and variables of any kind become free inputs.
  BitBlast(const TransitionSystem& system, Node root, const std::unordered_set<std::uint32_t>& open);

  const BitSystem& bits() const { return bits_; }
  BitSystem& bits() { return bits_; }
  /// The questions that bits().bads stand for, in their order.
  const Questions& questions() const { return questions_; }
  Lit badOf(std::size_t question) const { return of(system_.questions[question].bad)[0]; }
  /// bits().bads are those of these questions from now on, all of the cone.
  void ask(const Questions& questions);
  /// By index in bits().constraints: left out of a cone that shares no variables with it.
  const std::vector<bool>& isTotal() const { return total_; }
  /// Literals of a node of the cone, lowest bit first.
  const LitVector& of(Node n) const;
  bool contains(Node n) const { return literals_.contains(indexOf(n)); }
  /// Adds nodes over variables of the cone; they count as `extra`.
  void add(const std::vector<Node>& nodes);
  /// The node, which was added, is 1 in every scan whatever the variables are: told to all who work on the bits.
  void tell(Node valid);
  /// The node, which was added, is the next of bits().guide.
  void guide(Node n, bool isAfter) { bits_.guide.push_back({of(n)[0], isAfter}); }
  /// REAL operations that were replaced by free inputs.
  const std::vector<Node>& unmodelled() const { return unmodelled_; }
  /// Input indices of bits() that stand for REAL operations.
  const std::vector<std::uint32_t>& unmodelledInputs() const { return unmodelledInputs_; }
  /// Which bit of which state variable a latch is.
  struct StateBit {
    std::uint32_t state;  ///< index in TransitionSystem::states
    std::uint32_t bit;
  };
  const StateBit& stateBit(std::uint32_t latch) const { return stateBits_[latch]; }
  /// The node of a literal that depends on latches only: one of `extra`, or extracts of state variables joined by And
  /// and Not.
  Node nodeOf(Lit l);
  /// State variables without bits here keep their initial value or 0, inputs without bits are 0.
  WordTrace wordTrace(const BitTrace& trace) const;
  /// The same run in bits; inputs that stand for REAL operations are 0.
  BitTrace bitTrace(const WordTrace& trace) const;

 private:
  void collectCone(const std::vector<Node>& roots, const std::unordered_set<std::uint32_t>& open = {},
                   const Budget* budget = nullptr);
  void blast(Node n);
  void remember(Node n);
  void blastDivision(const NodeData& node, const LitVector& a, const LitVector& b, LitVector& out);
  LitVector freshInputs(const std::string& name, int width);

  const TransitionSystem& system_;
  Graph& graph_;
  BitSystem bits_;
  Questions questions_;
  std::unordered_map<std::uint32_t, LitVector> literals_;    ///< by node index
  std::unordered_map<std::uint32_t, std::uint32_t> states_;  ///< variable node index -> index in system_.states
  std::unordered_map<std::uint32_t, std::uint32_t> inputs_;  ///< variable node index -> index in system_.inputs
  std::vector<StateBit> stateBits_;                          ///< by latch
  struct InputBit {
    std::uint32_t input, bit;
  };
  static constexpr std::uint32_t noInput = 0xFFFFFFFF;
  std::vector<InputBit> inputBits_;  ///< by input of bits_
  std::vector<bool> total_;
  std::vector<Node> unmodelled_;
  std::vector<std::uint32_t> unmodelledInputs_;
  std::unordered_map<std::uint32_t, Node> nodes_;  ///< by variable of bits_
};

}  // namespace rungproof
