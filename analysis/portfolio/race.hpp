// The race: for each open question IC3, BMC, k-induction, simulation, held inputs, explicit search and IC3 on words run
// in slices of time, on as many threads as wanted; the first conclusive answer of a question ends its other engines. A
// race that is stopped can go on. A proof and a violation of the same question stop the program. Tested by
// tests/solver/portfolio_test.cpp.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "analysis/bits/engine_contract.hpp"
#include "analysis/schedule/technique.hpp"

namespace rungproof {

struct RaceQuestion {
  const BitSystem* system = nullptr;
  Engine* words = nullptr;  ///< takes part beside the engines on bits, if given; its evidence stays with it
  std::vector<std::vector<Lit>> invariants{};
  Techniques techniques{};  ///< engines that take part, of those of a run
  double share = 1;         ///< of the time of a run
  // Result:
  Verdict verdict{};
  double seconds = 0;  ///< engine time spent, of all runs
};

struct RaceOptions {
  int jobs = 2;
  std::uint64_t seed = 1;
  int bound = 0;  ///< 0: no limit
  const std::atomic<bool>* cancel = nullptr;
  TechniqueLog* log = nullptr;
};

/// "BMC, k-induction, IC3 ...": the engines that take part.
std::string enginesOf(const Techniques& techniques);

/// What one call of a race may take.
struct RaceRun {
  Techniques techniques{};  ///< engines that take part
  double seconds = 30;      ///< for each question and thread, of the processor, earlier runs included
  Budget::Clock::time_point deadline = Budget::Clock::time_point::max();  ///< of all questions
};

class Race {
 public:
  Race(std::vector<RaceQuestion> questions, const RaceOptions& options);
  ~Race();
  Race(const Race&) = delete;
  Race& operator=(const Race&) = delete;

  /// What is open: engines that have been at work go on where they stopped.
  void run(const RaceRun& run);
  std::vector<RaceQuestion>& questions();

 private:
  class Workers;
  std::unique_ptr<Workers> workers_;
};

}  // namespace rungproof
