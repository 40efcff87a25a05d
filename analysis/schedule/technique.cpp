// The table of techniques, and the counting.
#include "analysis/schedule/technique.hpp"

#include <algorithm>

namespace rungproof {

namespace {

// clang-format off
constexpr std::array techniques = {
    TechniqueInfo{Technique::OneScan, "one-scan", "proofs that need no more than the surface of one scan"},
    TechniqueInfo{Technique::FirstScan, "first-scan", "questions that can be bad in the first scan only, of that scan"},
    TechniqueInfo{Technique::Absorption, "absorption", "runs end where the question can no longer be bad: \"A only after B\" without B"},
    TechniqueInfo{Technique::Merging, "merging", "states that are always equal or constant become one"},
    TechniqueInfo{Technique::Simulation, "simulation", "random runs for all questions together"},
    TechniqueInfo{Technique::ShortInduction, "short-induction", "k-induction of a few steps and its base cases, for all questions together"},
    TechniqueInfo{Technique::StatePairs, "state-pairs", "what two truth values of the state say about each other"},
    TechniqueInfo{Technique::Groups, "groups", "groups of truth values of which at most one holds"},
    TechniqueInfo{Technique::Sums, "sums", "sums of words, which what a scan adds to the words leaves as they are"},
    TechniqueInfo{Technique::EqualGates, "equal-gates", "gates over the state that are always equal (signal correspondence)"},
    TechniqueInfo{Technique::Invariants, "invariants", "clauses over truth values of the state, for a group of questions"},
    TechniqueInfo{Technique::Covers, "covers", "sets of truth values of which one always holds", false},
    TechniqueInfo{Technique::TimerStates, "timer-states", "guesses about timers and the bits that start them", false},
    TechniqueInfo{Technique::WordGuesses, "word-guesses", "guesses about words that count together", false},
    TechniqueInfo{Technique::WordValues, "word-values", "words that take few values, which are listed"},
    TechniqueInfo{Technique::Bounds, "bounds", "bounds on differences of words that count together, and of words that count scans from time"},
    TechniqueInfo{Technique::WordCaps, "word-caps", "words that stop counting at the largest constant they meet"},
    TechniqueInfo{Technique::Ic3, "ic3", "IC3 on bits"},
    TechniqueInfo{Technique::WordIc3, "word-ic3", "IC3 on words"},
    TechniqueInfo{Technique::Bmc, "bmc", "bounded model checking"},
    TechniqueInfo{Technique::LongSimulation, "long-simulation", "random runs for one question"},
    TechniqueInfo{Technique::Explicit, "explicit", "explicit search of small systems"},
    TechniqueInfo{Technique::HeldInputs, "held-inputs", "runs whose inputs stay as they are"},
    TechniqueInfo{Technique::KInduction, "k-induction", "k-induction for one question"},
    TechniqueInfo{Technique::Accelerated, "accelerated", "a search in which time passes in long scans"},
    TechniqueInfo{Technique::QuickAccelerated, "quick-accelerated", "the same for a moment, before each question has its time"},
    TechniqueInfo{Technique::EngineRuns, "engine-runs", "runs of the reference engine, inputs held and random"},
    TechniqueInfo{Technique::EarlyRuns, "early-runs", "exploration while the program is being encoded"},
    TechniqueInfo{Technique::Exploration, "exploration", "runs of the engine that go on where others came to something new"},
    TechniqueInfo{Technique::ExactReals, "exact-reals", "REAL operations written out as bits where any value is not enough"},
};
// clang-format on

constexpr bool techniquesAreInOrder() {
  for (std::size_t i = 0; i < techniques.size(); ++i) {
    if (static_cast<std::size_t>(techniques[i].id) != i) return false;
  }
  return techniques.size() == techniqueCount;
}
static_assert(techniquesAreInOrder(), "the table must follow the enumeration");

}  // namespace

std::span<const TechniqueInfo> techniqueTable() { return techniques; }

const TechniqueInfo* techniqueNamed(std::string_view name) {
  const auto found = std::ranges::find(techniques, name, &TechniqueInfo::name);
  return found == techniques.end() ? nullptr : &*found;
}

void add(TechniqueUses& sum, const TechniqueUses& part) {
  for (std::size_t i = 0; i < techniqueCount; ++i) {
    sum[i].asked += part[i].asked;
    sum[i].settled += part[i].settled;
    sum[i].seconds += part[i].seconds;
  }
}

void TechniqueLog::add(Technique technique, const TechniqueUse& use) {
  const std::lock_guard lock(mutex_);
  TechniqueUse& known = uses_[static_cast<std::size_t>(technique)];
  known.asked += use.asked;
  known.settled += use.settled;
  known.seconds += use.seconds;
}

TechniqueUses TechniqueLog::uses() const {
  const std::lock_guard lock(mutex_);
  return uses_;
}

TechniqueTurn::~TechniqueTurn() {
  if (log_ == nullptr) return;
  const std::chrono::duration<double> used = std::chrono::steady_clock::now() - begin_;
  log_->add(technique_, {asked_, settled_, used.count()});
}

}  // namespace rungproof
