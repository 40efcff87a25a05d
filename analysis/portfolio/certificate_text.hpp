// Obligations of certificates as SMT-LIB 2, for any solver and for Z3 in a process of its own.
// Tested by tests/certificate.
#pragma once

#include <optional>
#include <string>
#include <unordered_map>
#include <variant>
#include <vector>

#include "analysis/graph/smt_text.hpp"
#include "analysis/recheck/kept_difference.hpp"
#include "analysis/recheck/obligation.hpp"
#include "analysis/recheck/z3_check.hpp"

namespace rungproof {

/// What must be unsatisfiable for a certificate to hold.
struct Obligation {
  std::size_t certificate;  ///< by the order in which they were added
  std::string name;         ///< "initiation", "consecution", "base", "safety", "arithmetic"
  Formula formula;
  std::optional<std::variant<KeptDifference, KeptSum>> theorem{};  ///< instead of the formula
  std::optional<std::size_t> surface{};                            ///< in which open nodes have any value
  std::vector<Formula> guide{};  ///< what follows on the way to the contradiction, one after the other
};

class CertificateText {
 public:
  using OpenNodes = std::unordered_set<std::uint32_t>;
  /// `surfaces`: the open nodes of each.
  CertificateText(const TransitionSystem& system, const std::vector<OpenNodes>& surfaces)
      : system_(system), surfaces_(surfaces), smt_(system) {}

  void add(const Obligation& obligation, const std::string& question);
  /// A self-contained file: each obligation between push and pop, with the expected answer unsat.
  std::string file() const;
  /// By Z3, in the order in which they were added.
  std::vector<CheckResult> check(const CheckLimits& limits) const;

 private:
  struct Entry {
    std::string title, formula;
  };
  std::vector<SmtText::Definition> definitions() const;
  std::string declarations() const { return theorems_ + smt_.declarations() + surfaceDeclarations_; }
  std::string theorem(const KeptDifference& d);
  std::string theorem(const KeptSum& sum);

  const TransitionSystem& system_;
  const std::vector<OpenNodes>& surfaces_;
  SmtText smt_;
  std::string surfaceDeclarations_;
  std::vector<SmtText::Definition> surfaceDefinitions_;
  std::vector<Entry> entries_;
  std::string theorems_;                         ///< declarations of their variables
  std::unordered_map<std::string, int> proved_;  ///< theorems that are obligations already, by their form
};

}  // namespace rungproof
