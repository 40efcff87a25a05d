// RobustCheck: which expected values of a test come whatever the length of scans and however inputs are early or late.
//
// For one length of scans all skews are enumerated: at each border of two steps up to five scans are possible at which
// inputs act, and from each state that any of these ways can leave the next step is run once more. States that are
// equal at the same scan go on as one, so that the work stays a few plays of the test. With every whole millisecond of
// the range this is a proof for scans of equal length and time bases that begin with power-on; fractions, lengths that
// change from scan to scan and other phases are tried.
// Nothing goes on from a state in which an interrupt waits, and a program with devices goes on from none: there all
// inputs early, all late, and the turns between are tried, and nothing is proved.
// Covered by tests/tables/robust_check_test.cpp.
#pragma once

#include <random>
#include <set>
#include <vector>

#include "analysis/testing/processor_clock.hpp"
#include "engine/testing/test_player.hpp"

namespace rungproof {

struct RobustOptions {
  SimulatorOptions engine;
  std::uint32_t lowUs = 1000, highUs = 100000;  ///< scans
  std::uint64_t seed = 1;
};

struct RobustCells {
  std::vector<std::set<std::size_t>> failing;  ///< outputs by row that differ in some run
  std::set<std::size_t> stops;                 ///< rows in which the CPU stops in some run
  bool isProved = false;                       ///< all skews at every whole millisecond
};

class RobustCheck {
 public:
  using Clock = ProcessorClock;
  static constexpr int mostSkew = 2;

  /// The program must outlive the check. `columns`: what rows set and expect; its tests do not count.
  RobustCheck(const Program& program, TestTable columns, const RobustOptions& options);

  /// At the ends of the range and some lengths between.
  RobustCells quick(const TestCase& test);
  /// At every whole millisecond as long as there is time, at fractions, and at lengths that change.
  RobustCells full(const TestCase& test, Clock::time_point end);
  /// Values can be tried only.
  bool onlyTries() const { return replays_; }
  /// Runs from power-on so far, or what stands for one.
  std::size_t runs() const { return runs_; }

 private:
  bool enumerate(const TestCase& test, std::uint32_t us, RobustCells& cells);
  void play(const TestCase& test, ScanLength length, std::vector<int> skews, RobustCells& cells,
            std::uint32_t phaseMs = 0);
  void playSkews(const TestCase& test, std::uint32_t us, RobustCells& cells);
  void playTurns(const TestCase& test, std::uint32_t us, RobustCells& cells, Clock::time_point end);
  void tryLength(const TestCase& test, std::uint32_t us, RobustCells& cells, bool& isWhole);
  void compare(const TestRow& row, const Concrete::Store& state, std::set<std::size_t>& failing) const;

  const Program& program_;
  const TestTable columns_;
  const RobustOptions options_;
  const bool replays_;
  std::mt19937_64 random_;
  std::size_t runs_ = 0;
};

}  // namespace rungproof
