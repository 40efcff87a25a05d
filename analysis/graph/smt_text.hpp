// Graph nodes as SMT-LIB 2 text of the logic QF_BV: declarations and definitions for several scans, truth values as
// Bool. REAL operations become declared constants, any value: what is unsatisfiable so, is so with their meaning.
// Tested by tests/certificate and tests/export.
#pragma once

#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "analysis/graph/transition_system.hpp"

namespace rungproof {

class SmtText {
 public:
  explicit SmtText(const TransitionSystem& system) : SmtText(system, {}, {}) {}
  /// `open` nodes (indices) are declared only: any value, so that what is below them is not written. `tag` keeps the
  /// names apart from those of other texts.
  SmtText(const TransitionSystem& system, std::string tag, std::unordered_set<std::uint32_t> open);

  /// The term of a node in scan `frame`, sort Bool if its width is 1; declares and defines what is missing. The state
  /// of scan 0 is declared, that of later scans is defined by the next-state functions.
  std::string term(Node n, int frame);
  /// Equations of the initial values of those variables at scan 0.
  std::vector<std::string> initialEquations(const std::unordered_set<std::uint32_t>& variables);
  struct Definition {
    std::string name, sort, expression;
  };
  /// What has any value, and what is defined by it, each after all that it is made of.
  const std::string& declarations() const { return declarations_; }
  const std::vector<Definition>& definitions() const { return definitions_; }
  /// Declarations, then one define-fun for each definition.
  std::string text() const;

  /// "|name@frame|", unique.
  std::string symbol(Node variable, int frame) const;
  /// "Bool" or "(_ BitVec w)".
  static std::string sort(int width);
  static std::string constant(std::uint64_t value, int width);

 private:
  void define(Node n, int frame);
  std::string expression(Node n, int frame);
  std::string named(Node n, int frame);
  std::string word(Node n, int frame);
  static std::uint64_t key(Node n, int frame) { return static_cast<std::uint64_t>(frame) << 32U | indexOf(n); }

  const TransitionSystem& system_;
  const Graph& graph_;
  std::unordered_map<std::uint32_t, std::size_t> states_;  ///< variable node index -> index in system_.states
  std::unordered_map<std::uint32_t, std::string> names_;   ///< variable node index -> unique name
  const std::string tag_;
  const std::unordered_set<std::uint32_t> open_;
  std::unordered_set<std::uint64_t> defined_;
  std::string declarations_;
  std::vector<Definition> definitions_;
};

/// A formula with those of the definitions that it rests on as local ones. Z3 4.8.12 takes time out of all proportion
/// to read define-fun where definitions share much, which REAL arithmetic does; it reads let at once.
std::string withDefinitions(const std::vector<SmtText::Definition>& definitions, const std::string& formula);

}  // namespace rungproof
