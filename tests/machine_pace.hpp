// How fast this machine is at the moment, against the quiet machine on which the limits of the tests were found. Other
// work on the same processor takes caches and memory from a test even where its processor time alone is counted (the
// same run varies by a factor of two to three), so a limit in seconds says something only beside a fixed piece of work
// that was done in the same moment. That piece is CaDiCaL on a fixed formula: not a line of it changes with this
// project, and it walks through memory as the project's own engines and tables do.
#pragma once

#include <algorithm>
#include <cadical.hpp>
#include <chrono>
#include <ctime>
#include <random>

namespace rungproof::test {

/// Processor seconds of this process so far, all threads.
inline double processorSeconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// Seconds of the wall clock.
inline double wallSeconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// How many times as long as on the quiet machine the fixed work takes now, by `clock`; 1 at least. Costs 0.04 s there.
inline double machinePace(double (*clock)() = processorSeconds) {
  constexpr int variables = 20000, clauses = 56000;
  constexpr double quiet = 0.038;  // s, the least of sixty runs
  const double begin = clock();
  CaDiCaL::Solver solver;
  std::minstd_rand random(7);
  for (int i = 0; i < 3 * clauses; ++i) {
    const int variable = 1 + static_cast<int>(random() % variables);
    solver.add(random() % 2 == 0 ? variable : -variable);
    if (i % 3 == 2) solver.add(0);
  }
  solver.solve();
  return std::max(1.0, (clock() - begin) / quiet);
}

/// Seconds that `work` would take on the quiet machine: the time of each run divided by the pace before and after it,
/// the least of at most `attempts` runs, the last of which is the first to stay below `enough`.
template <class Work>
double quietSeconds(Work&& work, double enough = 0, int attempts = 3, double (*clock)() = processorSeconds) {
  double least = 1e9, before = machinePace(clock);
  for (int i = 0; i < attempts && least > enough; ++i) {
    const double begin = clock();
    work();
    const double seconds = clock() - begin, after = machinePace(clock);
    least = std::min(least, seconds / ((before + after) / 2));
    before = after;
  }
  return least;
}

}  // namespace rungproof::test
