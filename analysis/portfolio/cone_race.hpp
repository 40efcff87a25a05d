// ConeRace: the open questions of a stage as contests of a race, each on its cone of influence under the invariants
// that are known. The engine on words takes part where the cone is not too large for it. Tested by
// tests/solver/portfolio_test.cpp.
#pragma once

#include <deque>
#include <memory>
#include <vector>

#include "analysis/bits/bit_cone.hpp"
#include "analysis/portfolio/invariants.hpp"
#include "analysis/portfolio/portfolio.hpp"
#include "analysis/portfolio/race.hpp"
#include "analysis/words/word_engine.hpp"

namespace rungproof {

/// A question in the race.
struct Contestant {
  std::size_t question;
  BitCone cone;
  std::unique_ptr<WordEngine> words{};  ///< once it has taken part
  // Result of a run:
  Verdict verdict{};
  double seconds = 0;  ///< engine time spent in it
};

class ConeRace {
 public:
  /// `answers`: by question, what is known of them.
  ConeRace(const TransitionSystem& system, BitBlast& blast, const Invariants& invariants, const Questions& questions,
           const std::vector<QuestionAnswer>& answers, const PortfolioOptions& options);

  /// What is open: engines that have been at work go on where they stopped.
  void run(const RaceRun& run);
  std::deque<Contestant>& contestants() { return contestants_; }

 private:
  const TransitionSystem& system_;
  const bool mayUseWords_;
  const std::uint64_t seed_;
  std::deque<Contestant> contestants_;
  std::unique_ptr<Race> race_;
};

}  // namespace rungproof
