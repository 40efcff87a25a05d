// Random inputs under constraints: rejected inputs are drawn again, then those of the scan before are kept, then
// samples found by the SAT solver are tried.
#include "analysis/bits/simulation_runs.hpp"

#include "analysis/bits/bit_cone.hpp"
#include "analysis/bits/bit_unrolling.hpp"
#include "analysis/schedule/schedule.hpp"

namespace rungproof {

namespace {
constexpr std::uint64_t everyScan = 0x1111111111111111ULL;  ///< lanes that change inputs in every scan
}  // namespace

SimulationRuns::SimulationRuns(const BitSystem& system, std::uint64_t seed)
    : system_(system), simulator_(system), random_(seed) {
  if (!system.constraints.empty()) collectSamples();
  const std::vector<bool> isConstrained = constrainedVariables(system);
  for (std::uint32_t gate = 0; gate < system.gates.size(); ++gate)
    (isConstrained[system.gateVariables[gate]] ? ofConstraints_ : others_).push_back(simulator_.stepOf(gate));
  restart();
}

/// Each bit is set with probability 2^-halvings.
std::uint64_t SimulationRuns::sparse(int halvings) {
  std::uint64_t mask = random_();
  for (int i = 1; i < halvings && mask != 0; ++i) mask &= random_();
  return mask;
}

void SimulationRuns::restart() {
  for (std::size_t i = 0; i < system_.latches.size(); ++i) {
    const LatchInit init = system_.latches[i].init;
    simulator_.setLatch(i, init == LatchInit::Free ? random_() : init == LatchInit::One ? ~0ULL : 0);
  }
  live_ = ~0ULL;
  fresh_ = true;
}

std::uint64_t SimulationRuns::violating() {
  std::uint64_t ok = ~0ULL;
  for (const Lit constraint : system_.constraints) ok &= simulator_.value(constraint);
  return ~ok & live_;
}

bool SimulationRuns::choose() {
  std::vector<std::uint64_t> before(system_.inputs.size());
  for (std::size_t i = 0; i < before.size(); ++i) {
    before[i] = simulator_.input(i);
    const std::uint64_t change = fresh_ ? ~0ULL
                                        : everyScan | (everyScan << 1U & sparse(3)) | (everyScan << 2U & sparse(6)) |
                                              (everyScan << 3U & sparse(10));
    simulator_.setInput(i, (before[i] & ~change) | (random_() & change));
  }
  const auto judge = [&] {
    simulator_.evaluate(ofConstraints_);
    return violating();
  };
  std::uint64_t wrong = judge();
  for (int attempt = 0; wrong != 0 && attempt < schedule::redraws + 1; ++attempt) {
    redraw(wrong, before, attempt == schedule::redraws);
    wrong = judge();
  }
  for (std::size_t attempt = 0; wrong != 0 && attempt < samples_.size(); ++attempt) {
    takeSamples(wrong, attempt);
    wrong = judge();
  }
  simulator_.evaluate(others_);
  live_ &= ~wrong;
  fresh_ = false;
  return live_ != 0;
}

void SimulationRuns::redraw(std::uint64_t wrong, const std::vector<std::uint64_t>& before, bool keep) {
  for (std::size_t i = 0; i < before.size(); ++i)
    simulator_.setInput(i, (simulator_.input(i) & ~wrong) | ((keep ? before[i] : random_()) & wrong));
}

void SimulationRuns::takeSamples(std::uint64_t wrong, std::size_t attempt) {
  for (std::size_t lane = 0; lane < 64; ++lane) {
    if ((wrong >> lane & 1U) == 0) continue;
    const std::vector<bool>& sample = samples_[(lane + attempt) % samples_.size()];
    const std::uint64_t bit = 1ULL << lane;
    for (std::size_t i = 0; i < sample.size(); ++i)
      simulator_.setInput(i, (simulator_.input(i) & ~bit) | (sample[i] ? bit : 0));
  }
}

void SimulationRuns::collectSamples() {
  Unrolling unrolling(system_, Unrolling::Start::Initial);
  Sat sat(Sat::Use::Many);
  BitCnf cnf(unrolling.graph(), sat);
  for (const Lit constraint : system_.constraints) sat.add({cnf.literal(unrolling.at(0, constraint))});
  const Budget budget = Budget::seconds(schedule::inputSampleSeconds);
  for (int round = 0; round < schedule::inputSamples; ++round) {
    for (const std::uint32_t v : system_.inputs) {
      const int l = cnf.known(unrolling.at(0, positive(v)));
      const bool value = round == 0 || (round > 1 && (random_() & 1U) != 0);
      if (l != 0) sat.prefer(value ? l : -l);
    }
    if (sat.solve({}, budget) != Sat::Outcome::Satisfiable) return;
    samples_.push_back(unrolling.trace(0, cnf).inputs[0]);
  }
}

}  // namespace rungproof
