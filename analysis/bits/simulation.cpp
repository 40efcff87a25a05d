// The engine that only looks for violations: random runs, longer from episode to episode. Finds what is shallow or
// needs nothing but patience (a timer of 30000 ticks), at the cost of one word operation per gate for 64 scans.
// Tested by tests/solver/simulation_test.cpp.
#include <algorithm>
#include <bit>

#include "analysis/bits/bit_unrolling.hpp"
#include "analysis/bits/simulation_runs.hpp"
#include "analysis/schedule/schedule.hpp"
#include "ir/check.hpp"

namespace rungproof {

namespace {

class Simulation final : public Engine {
 public:
  Simulation(const BitSystem& system, const EngineOptions& options) : system_(system), runs_(system, options.seed) {}

  Verdict advance(const Budget& budget) override {
    Verdict verdict;
    verdict.method = "simulation";
    const std::size_t inputs = std::max<std::size_t>(system_.inputs.size(), 1);
    while (!budget.isExhausted()) {
      if (scan_ == 0) {
        runs_.restart();
        start_.clear();
        for (std::size_t i = 0; i < system_.latches.size(); ++i) start_.push_back(runs_.simulator().latch(i));
        record_.clear();
      }
      if (!runs_.choose()) {
        endEpisode();
        continue;
      }
      for (std::size_t i = 0; i < system_.inputs.size(); ++i) record_.push_back(runs_.simulator().input(i));
      std::uint64_t bad = 0;
      for (const Lit l : system_.bads) bad |= runs_.simulator().value(l);
      ++scan_;
      if ((bad & runs_.live()) != 0) {
        verdict.answer = Answer::Violated;
        verdict.depth = scan_ - 1;
        verdict.trace = traceOf(std::countr_zero(bad & runs_.live()));
        CHECK(isViolation(system_, *verdict.trace), "a simulated run does not violate the property");
        return verdict;
      }
      if (scan_ >= length_ || record_.size() + inputs > schedule::episodeWords)
        endEpisode();
      else
        runs_.step();
    }
    return verdict;
  }

 private:
  void endEpisode() {
    scan_ = 0;
    if (++episodes_ % 2 == 0) length_ = std::min(length_ * 2, schedule::longestEpisode);
  }

  BitTrace traceOf(int lane) const {
    BitTrace trace;
    for (const std::uint64_t lanes : start_) trace.initial.push_back((lanes >> lane & 1U) != 0);
    const std::size_t inputs = system_.inputs.size();
    for (int scan = 0; scan < scan_; ++scan) {
      std::vector<bool>& values = trace.inputs.emplace_back();
      for (std::size_t i = 0; i < inputs; ++i) values.push_back((record_[scan * inputs + i] >> lane & 1U) != 0);
    }
    return trace;
  }

  const BitSystem& system_;
  SimulationRuns runs_;
  std::vector<std::uint64_t> start_;   ///< initial latches, by latch index
  std::vector<std::uint64_t> record_;  ///< inputs, by scan and input index
  int scan_ = 0;
  int length_ = 64;  ///< scans of this episode
  int episodes_ = 0;
};

}  // namespace

std::unique_ptr<Engine> makeSimulation(const BitSystem& system, const EngineOptions& options) {
  return std::make_unique<Simulation>(system, options);
}

}  // namespace rungproof
