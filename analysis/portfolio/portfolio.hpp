// The portfolio: answers the questions of a transition system with all engines, easy questions first. Shares what
// can be shared (blasting, simulation, short inductions, invariants), then lets the engines race for each open
// question on its own cone. Proved comes with a certificate, violated with a run; two engines that disagree stop the
// program. Tested by tests/solver/portfolio_test.cpp.
#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "analysis/bits/bit_blast.hpp"
#include "analysis/portfolio/certificate.hpp"
#include "analysis/schedule/technique.hpp"

namespace rungproof {

/// Surface: only what needs no earlier scan. Together: what treats all questions at once, within milliseconds. Mined:
/// groups of questions under invariants and bounds that are soon found. Apart: the same under all of them, then each
/// question, after the others have been tried. Full: all.
enum class Effort : std::uint8_t { Surface, Together, Mined, Apart, Full };

struct PortfolioOptions {
  Effort effort = Effort::Full;
  double seconds = 30;  ///< wall time for each question
  int jobs = 2;         ///< threads
  std::uint64_t seed = 1;
  int bound = 0;             ///< BMC and k-induction look at that many scans at most; 0: no limit
  std::uint64_t memory = 0;  ///< bytes that a check of certificates may use; 0: no limit
  /// Questions from this one on are some of hundreds. Each has runs of held inputs of its own behind it, so that the
  /// race of Effort::Apart is without these, and shorter.
  std::size_t ofMany = ~std::size_t{0};
  bool check = true;  ///< check certificates with Z3; without, proofs are reported as they are
  /// Checks certificates against something better than the given system; what it leaves Unknown or calls Invalid is
  /// checked against that. In the order of the claims.
  std::function<std::vector<CheckResult>(const std::vector<Claim>&, const CheckLimits&)> judge{};
  Techniques techniques{};                    ///< what may be used
  TechniqueLog* log = nullptr;                ///< told of what was used
  const std::atomic<bool>* cancel = nullptr;  ///< ends the search from outside; what is open stays unknown
  /// When the whole call has to be back, checks of certificates included (they may take half a second more).
  std::optional<Budget::Clock::time_point> deadline;

  /// Until the deadline or the interruption.
  Budget budget() const { return Budget(deadline.value_or(Budget::Clock::time_point::max()), cancel); }
  /// Seconds until the deadline, 0 at least; 1e9 without one.
  double left() const {
    return deadline ? std::max(std::chrono::duration<double>(*deadline - Budget::Clock::now()).count(), 0.0) : 1e9;
  }
};

struct QuestionAnswer {
  Answer answer = Answer::Unknown;
  int depth = 0;       ///< Violated: index of the bad scan; Unknown: bad is unreachable in the first `depth` scans
  std::string method;  ///< "2-induction", "IC3", "simulation" ...; Unknown: what was tried
  double seconds = 0;
  std::optional<WordTrace> trace;
  std::optional<WordCertificate> certificate;
  bool isJudged = false;       ///< PortfolioOptions::judge found the certificate valid
  bool usesFreeReals = false;  ///< Violated: the run may rest on values of REAL operations that the CPU does not give
};

/// Bounded search alone for the first question: a run of at most `depth` scans, if there is one and it is found in
/// time.
std::optional<WordTrace> shallowSearch(const TransitionSystem& system, int depth, double seconds);

/// By question of the system; others than `questions` are not looked at. Adds nodes (of invariants) to its graph.
std::vector<QuestionAnswer> answerQuestions(const TransitionSystem& system, const Questions& questions,
                                            const PortfolioOptions& options);
inline std::vector<QuestionAnswer> answerQuestions(const TransitionSystem& system, const PortfolioOptions& options) {
  return answerQuestions(system, allQuestions(system), options);
}

}  // namespace rungproof
