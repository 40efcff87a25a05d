// Plays one test of a table on the reference engine and compares what it expects. With skews, what a step sets acts
// some scans early or late, in the order of the steps; a step is compared at its end, but not before its own inputs
// have acted and before those of the next step act. Covered by tests/tables/player_test.cpp.
#pragma once

#include <functional>
#include <vector>

#include "engine/simulator.hpp"
#include "engine/testing/scan_length.hpp"
#include "engine/testing/test_table.hpp"

namespace rungproof {

/// When the inputs of each step act and when it is compared, in scans from 1.
struct StepTimes {
  std::uint64_t acts = 1;      ///< in front of this scan
  std::uint64_t compares = 1;  ///< at the end of this scan
};

/// `skews`: by step, scans by which its inputs act late (or early, below 0); empty: none.
std::vector<StepTimes> stepTimesOf(const TestCase& test, const ScanLength& length, const std::vector<int>& skews = {});

struct TestFailure {
  std::size_t step = 0;                 ///< index of the row
  std::optional<std::size_t> signal{};  ///< of TestTable::expects; nothing: the CPU stopped
  TraceNumber actual = 0;
  std::uint64_t scan = 0;
  std::uint64_t timeUs = 0;
};

struct TestPlayOptions {
  SimulatorOptions engine;
  ScanLength length = [](std::uint64_t) { return std::uint32_t{10000}; };
  std::vector<int> skews{};
  bool stopsAtFailure = true;
  InstructionObserver* observer = nullptr;
  /// In front of and behind each scan; both may be missing.
  std::function<void(std::uint64_t scan)> beforeScan{};
  std::function<void(const Simulator& simulator, std::size_t step)> afterScan{};
};

struct TestPlay {
  std::vector<TestFailure> failures;  ///< in the order of the steps; the first one alone if the play stops there
  std::uint64_t scans = 0;
  std::uint64_t timeUs = 0;
};

/// Sets what a row sets, in front of the scan in which it acts.
void applyRow(Simulator& simulator, const TestTable& table, const TestRow& row);

/// `simulator`: powered up, not yet run.
TestPlay playTest(Simulator& simulator, const TestTable& table, const TestCase& test, const TestPlayOptions& options);

}  // namespace rungproof
