// Nodes of a transition system in several scans as clauses, word operations bit by bit. The meaning is that of the
// SMT-LIB 2 text (analysis/graph/smt_text.hpp): REAL operations have any value. Tested by tests/recheck.
#pragma once

#include <unordered_map>
#include <unordered_set>

#include "analysis/recheck/gate_clauses.hpp"
#include "analysis/recheck/obligation.hpp"

namespace rungproof {

class ScanClauses {
 public:
  /// `open` nodes (indices) have any value.
  explicit ScanClauses(const TransitionSystem& system, std::unordered_set<std::uint32_t> open = {});

  /// The literal that is true where the formula is.
  int literalOf(const Formula& formula);
  const GateClauses& gates() const { return gates_; }

 private:
  using Word = GateClauses::Word;
  static std::uint64_t key(ScanNode n) { return static_cast<std::uint64_t>(n.scan) << 32U | indexOf(n.node); }
  const Word& wordOf(ScanNode wanted);
  Word made(ScanNode n);
  bool hasAnyValue(Node n) const;

  const TransitionSystem& system_;
  const Graph& graph_;
  const std::unordered_set<std::uint32_t> open_;
  std::unordered_map<std::uint32_t, Node> next_;  ///< of state variables
  std::unordered_map<std::uint64_t, Word> words_;
  GateClauses gates_;
};

}  // namespace rungproof
