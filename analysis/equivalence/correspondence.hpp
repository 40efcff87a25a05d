// Which memory of NEW always holds what OLD's holds: pairs of states are assumed equal at the start of a scan, and
// those that the scan does not keep equal are dropped until nothing changes (van Eijk's correspondence). Tested by
// tests/equivalence.
#pragma once

#include <functional>
#include <vector>

#include "analysis/equivalence/product.hpp"
#include "analysis/portfolio/portfolio.hpp"

namespace rungproof {

/// Answers the questions of a system; seconds for each.
using Ask = std::function<std::vector<QuestionAnswer>(const TransitionSystem&, double each, Effort)>;

struct Correspondence {
  std::vector<bool> isMerged;             ///< by state of NEW: it equals its partner in every scan
  std::vector<PairCondition> conditions;  ///< under which others do
};

/// Whatever NEW's other states are. `withConditions`: states that do not equal their partners may do so wherever some
/// bit of OLD has a value. `left`: seconds; where they do not suffice nothing is known to correspond.
Correspondence findCorrespondence(ProgramProduct& product, bool withConditions, const Ask& ask,
                                  const std::function<double()>& left);

}  // namespace rungproof
