// The techniques of the prover: what can be switched off (--without), and what each was asked, settled and took
// (--verbose). An answer never depends on a technique that is off; only whether there is one does.
// Tested by tests/prover/technique_test.cpp.
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <initializer_list>
#include <mutex>
#include <span>
#include <string_view>

namespace rungproof {

enum class Technique : std::uint8_t {
  OneScan,
  FirstScan,
  Absorption,
  Merging,
  Simulation,
  ShortInduction,
  StatePairs,
  Groups,
  Sums,
  EqualGates,
  Invariants,
  Covers,
  TimerStates,
  WordGuesses,
  WordValues,
  Bounds,
  WordCaps,
  Ic3,
  WordIc3,
  Bmc,
  LongSimulation,
  Explicit,
  HeldInputs,
  KInduction,
  Accelerated,
  QuickAccelerated,
  EngineRuns,
  EarlyRuns,
  Exploration,
  ExactReals,
  count
};
inline constexpr std::size_t techniqueCount = static_cast<std::size_t>(Technique::count);

struct TechniqueInfo {
  Technique id;
  std::string_view name;  ///< as --without takes it
  std::string_view summary;
  bool settles = true;  ///< false: prepares only, and nobody can tell which answers rest on it
};
/// All, in the order of Technique.
std::span<const TechniqueInfo> techniqueTable();
const TechniqueInfo* techniqueNamed(std::string_view name);

/// Those that are on; all, at first.
class Techniques {
 public:
  bool has(Technique technique) const { return (off_ >> static_cast<unsigned>(technique) & 1U) == 0; }
  void leaveOut(Technique technique) { off_ |= 1U << static_cast<unsigned>(technique); }
  /// Leaves out all but these; those that are off stay so.
  void keepOnly(std::initializer_list<Technique> kept) {
    std::uint32_t others = ~0U;
    for (const Technique technique : kept) others &= ~(1U << static_cast<unsigned>(technique));
    off_ |= others;
  }

 private:
  static_assert(techniqueCount <= 32);
  std::uint32_t off_ = 0;
};

struct TechniqueUse {
  std::size_t asked = 0;    ///< questions that it worked on, once for each time
  std::size_t settled = 0;  ///< answers that it gave, or that rest on what it found
  double seconds = 0;       ///< of all threads together
};
using TechniqueUses = std::array<TechniqueUse, techniqueCount>;
void add(TechniqueUses& sum, const TechniqueUses& part);

/// Counts; several threads may use it.
class TechniqueLog {
 public:
  void add(Technique technique, const TechniqueUse& use);
  TechniqueUses uses() const;

 private:
  mutable std::mutex mutex_;
  TechniqueUses uses_{};
};

/// One use of a technique, until the end of a scope. Without a log nothing is counted.
class TechniqueTurn {
 public:
  TechniqueTurn(TechniqueLog* log, Technique technique, std::size_t asked)
      : log_(log), technique_(technique), asked_(asked) {}
  ~TechniqueTurn();
  TechniqueTurn(const TechniqueTurn&) = delete;
  TechniqueTurn& operator=(const TechniqueTurn&) = delete;
  void settled(std::size_t count = 1) { settled_ += count; }

 private:
  TechniqueLog* log_;
  Technique technique_;
  std::size_t asked_, settled_ = 0;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

}  // namespace rungproof
