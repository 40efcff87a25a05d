// Certificates over the original transition system: an inductive invariant in its own terms, written as SMT-LIB 2
// that any solver of QF_BV can check without knowing this program. The check in process reads the same text with
// Z3, so it is independent of bit-blasting and of the engines. Tested by tests/solver/certificate_test.cpp.
#pragma once

#include <string>
#include <vector>

#include "analysis/transition_system.hpp"

namespace rungproof {

/// With I the conjunction of `invariant` (width-1 nodes over states): I holds initially, I and the constraints keep
/// I, and: k = 0: I and the constraints exclude bad; k > 0: bad does not occur in the first k scans, and k scans
/// without bad that satisfy I are not followed by a bad one - with simplePath: if their states differ pairwise in
/// `pathBits`.
struct WordCertificate {
  std::vector<Node> invariant;
  int k = 0;
  bool simplePath = false;
  std::vector<Node> pathBits;
};

/// One obligation: assertions that must be unsatisfiable together.
struct Obligation {
  std::string name;  ///< "initiation", "consecution", "safety", "base"
  std::string text;  ///< SMT-LIB 2 declarations, definitions and assertions, without check-sat
};

std::vector<Obligation> obligationsOf(const TransitionSystem& system, const Question& question, const WordCertificate& certificate);

/// A self-contained file: the obligations between push and pop, each with the expected answer unsat.
std::string certificateText(const TransitionSystem& system, const Question& question, const WordCertificate& certificate);

enum class CheckResult : std::uint8_t { Valid, Invalid, Unknown };
/// Checks all obligations with Z3. Unknown: not within the time.
CheckResult checkCertificate(const TransitionSystem& system, const Question& question, const WordCertificate& certificate, double seconds);

}  // namespace rungproof
