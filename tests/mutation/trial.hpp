// Trial: the manual's tests run on one mutant, in a process of their own, so that neither a broken invariant nor a loop
// without end reaches the campaign.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "tests/mutation/mutant.hpp"

namespace rungproof::mutation {

/// Runs every test once without a change and notes the sites that each reaches. Gives the names of the tests by number;
/// empty when one of them fails.
std::vector<std::string> recordTests();

/// What the tests say of a mutant. Noticed: one of them fails, aborts or does not end (2 s of processor time and 1/20 s
/// for each test). Unchecked: some run ends otherwise than without the change, but no test looks there. Silent: no run
/// ends otherwise. LeftOut: it was not tried.
enum class Verdict { Noticed, Unchecked, Silent, LeftOut };

struct Candidate {
  Mutant mutant;
  const std::set<int>* tests;  ///< those that reach its site
};
/// As many at a time as the machine has processors; the verdicts in the order of the candidates.
std::vector<Verdict> tryMutants(const std::vector<Candidate>& candidates, const std::vector<std::string>& names);

/// Whether every mutant is tried (RUNGPROOF_EVERY_MUTANT=1). The ordinary suite tries of each instruction the first
/// three and every eighth of the others, and the rest where none of these is noticed.
bool triesEveryMutant();
std::vector<Verdict> tryChosenMutants(const std::vector<Candidate>& candidates, const std::vector<std::string>& names);

}  // namespace rungproof::mutation
