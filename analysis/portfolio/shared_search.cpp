// One query for each question and k; a query that takes long is left to the engines.
#include "analysis/portfolio/shared_search.hpp"

#include <algorithm>
#include <bit>

#include "analysis/bits/simulation_runs.hpp"
#include "analysis/schedule/schedule.hpp"
#include "ir/check.hpp"

namespace rungproof {

namespace {

/// Do the questions depend on different parts of the system within two scans? A solver of one part is much quicker
/// than one that decides variables of the others too.
bool areApart(const BitSystem& system) {
  const std::size_t variables = system.variableCount();
  std::vector<std::uint32_t> mark(2 * variables, 0);  // by scan, by variable: the last question that reached it
  std::size_t single = 0, together = 0;
  std::vector<std::size_t> open;
  std::uint32_t question = 0;
  const auto reach = [&](std::size_t scan, Lit l) {
    const std::size_t at = scan * variables + variableOf(l);
    if (mark[at] == question) return;
    single += mark[at] == 0 ? 1 : 0;
    ++together;
    mark[at] = question;
    open.push_back(at);
  };
  for (const Lit bad : system.bads) {
    ++question;
    reach(1, bad);
    for (std::size_t scan = 0; scan < 2; ++scan) {
      for (const Lit constraint : system.constraints) reach(scan, constraint);
    }
    while (!open.empty()) {
      const std::size_t scan = open.back() / variables, v = open.back() % variables;
      open.pop_back();
      if (system.kind[v] == BitSystem::Kind::Gate) {
        reach(scan, system.gates[system.position[v]].left);
        reach(scan, system.gates[system.position[v]].right);
      } else if (system.kind[v] == BitSystem::Kind::Latch && scan > 0) {
        reach(scan - 1, system.latches[system.position[v]].next);
      }
    }
    if (together > schedule::mostShared * single + variables) return false;
  }
  return question > 1 && together <= schedule::mostShared * single;
}
}  // namespace

SharedSearch::SharedSearch(const BitSystem& system, std::uint64_t seed, std::vector<int> cleanScans)
    : system_(system),
      seed_(seed),
      answers_(system.bads.size()),
      base_(system, Unrolling::Start::Initial),
      baseSat_(Sat::Use::Many),
      baseCnf_(base_.graph(), baseSat_),
      cleanScans_(std::move(cleanScans)) {}

std::size_t SharedSearch::openCount() const {
  return static_cast<std::size_t>(
      std::count_if(answers_.begin(), answers_.end(), [](const SharedAnswer& a) { return a.open(); }));
}

void SharedSearch::simulate(int scans, const Budget& budget) {
  SimulationRuns runs(system_, seed_);
  std::vector<std::uint64_t> start, record;
  for (std::size_t i = 0; i < system_.latches.size(); ++i) start.push_back(runs.simulator().latch(i));
  for (int scan = 0; scan < scans && !budget.isExhausted() && runs.choose(); ++scan) {
    for (std::size_t i = 0; i < system_.inputs.size(); ++i) record.push_back(runs.simulator().input(i));
    for (std::size_t q = 0; q < answers_.size(); ++q) {
      const std::uint64_t bad = runs.simulator().value(system_.bads[q]) & runs.live();
      if (bad == 0 || !answers_[q].open()) continue;
      const int lane = std::countr_zero(bad);
      BitTrace trace;
      for (const std::uint64_t lanes : start) trace.initial.push_back((lanes >> lane & 1U) != 0);
      for (int earlier = 0; earlier <= scan; ++earlier) {
        std::vector<bool>& values = trace.inputs.emplace_back();
        for (std::size_t i = 0; i < system_.inputs.size(); ++i)
          values.push_back((record[static_cast<std::size_t>(earlier) * system_.inputs.size() + i] >> lane & 1U) != 0);
      }
      Verdict& verdict = answers_[q].verdict;
      verdict.answer = Answer::Violated;
      verdict.depth = scan;
      verdict.method = "simulation";
      verdict.trace = std::move(trace);
    }
    runs.step();
  }
}

void SharedSearch::extendBase(int depth, const Budget& budget) {
  if (std::find(cleanScans_.begin(), cleanScans_.end(), depth) == cleanScans_.end()) return;
  for (; baseFrames_ <= depth; ++baseFrames_) {
    for (const Lit constraint : system_.constraints) {
      const Lit l = base_.at(baseFrames_, constraint);
      if (l != trueLit) baseSat_.add({baseCnf_.literal(l)});
    }
  }
  for (std::size_t q = 0; q < answers_.size(); ++q) {
    Verdict& verdict = answers_[q].verdict;
    // A simulated violation is replaced by a shorter one if there is one.
    const bool longer = verdict.answer == Answer::Violated && verdict.depth > depth;
    if ((!answers_[q].open() && !longer) || cleanScans_[q] != depth || budget.isExhausted()) continue;
    const Lit bad = base_.at(depth, system_.bads[q]);
    const Sat::Outcome outcome =
        bad == falseLit ? Sat::Outcome::Unsatisfiable
                        : baseSat_.solve({baseCnf_.literal(bad)}, budget.slice(schedule::inductionQuerySeconds));
    if (outcome == Sat::Outcome::Unsatisfiable) cleanScans_[q] = depth + 1;
    if (outcome != Sat::Outcome::Satisfiable) continue;
    verdict.answer = Answer::Violated;
    verdict.depth = depth;
    verdict.method = "BMC";
    verdict.trace = base_.trace(depth, baseCnf_);
  }
}

void SharedSearch::induce(int most, const std::vector<std::vector<Lit>>& invariants, const Budget& budget) {
  Unrolling steps(system_, Unrolling::Start::Any);
  struct Solver {
    Sat sat{Sat::Use::Many};
    BitCnf cnf;
    int scans = 0;  ///< that constraints and invariants have been added for
    explicit Solver(const BitSystem& graph) : cnf(graph, sat) {}
  };
  std::vector<std::unique_ptr<Solver>> solvers(invariants.empty() && areApart(system_) ? answers_.size() : 1);
  const auto solverFor = [&](std::size_t q, int k) -> Solver& {
    std::unique_ptr<Solver>& solver = solvers[solvers.size() == 1 ? 0 : q];
    if (!solver) solver = std::make_unique<Solver>(steps.graph());
    for (; solver->scans <= k; ++solver->scans) {
      for (const Lit constraint : system_.constraints)
        solver->sat.add({solver->cnf.literal(steps.at(solver->scans, constraint))});
      for (const std::vector<Lit>& clause : invariants) {
        std::vector<int> literals;
        for (const Lit l : clause) literals.push_back(solver->cnf.literal(steps.at(solver->scans, l)));
        solver->sat.add(literals);
      }
      followGuide(system_, steps, solver->scans, solver->sat, solver->cnf, {}, budget);
    }
    return *solver;
  };
  for (int k = 0; k <= most && !budget.isExhausted(); ++k) {
    for (std::size_t q = 0; q < answers_.size(); ++q) {
      if (!answers_[q].open() || cleanScans_[q] < k || budget.isExhausted()) continue;
      const Lit bad = steps.at(k, system_.bads[q]);
      Sat::Outcome outcome = Sat::Outcome::Unsatisfiable;
      if (bad != falseLit) {
        Solver& solver = solverFor(q, k);
        std::vector<int> assumptions;
        for (int earlier = 0; earlier < k; ++earlier)
          assumptions.push_back(-solver.cnf.literal(steps.at(earlier, system_.bads[q])));
        assumptions.push_back(solver.cnf.literal(bad));
        outcome = solver.sat.solve(assumptions, budget.slice(schedule::inductionQuerySeconds));
      }
      if (outcome != Sat::Outcome::Unsatisfiable) continue;
      Verdict& verdict = answers_[q].verdict;
      verdict.answer = Answer::Proved;
      verdict.method = k == 0 ? "invariant" : std::to_string(k) + "-induction";
      verdict.certificate = Certificate{};
      verdict.certificate->k = k;
    }
    extendBase(k, budget);
    if (openCount() == 0) return;
  }
  for (std::size_t q = 0; q < answers_.size(); ++q) {
    if (answers_[q].open()) answers_[q].verdict.depth = cleanScans_[q];
  }
}

}  // namespace rungproof
