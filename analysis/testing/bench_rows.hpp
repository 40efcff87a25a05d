// From steps of the search to rows of a test table, with what the reference engine shows as expected values.
// Covered by tests/tables/generate_command_test.cpp.
#pragma once

#include "analysis/testing/bench_search.hpp"
#include "analysis/testing/test_plan.hpp"
#include "engine/testing/test_player.hpp"

namespace rungproof {

/// How a wait is looked at. Middle: once before its end, when nothing has come yet. Often: at each fifth of it.
enum class Looks : std::uint8_t { Middle, Often };

class BenchRows {
 public:
  /// Program and signals must outlive the rows. `shownUs`: scans at which values are expected.
  BenchRows(const Program& program, const TestSignals& signals, const SimulatorOptions& engine, std::uint32_t shownUs);

  /// The columns of every table, without tests.
  const TestTable& columns() const { return columns_; }
  /// A test without expected values. All inputs are set in its first row.
  TestCase caseOf(const BenchTest& steps, Looks looks = Looks::Middle) const;
  /// Expects all outputs as the engine shows them.
  void expectValues(TestCase& test) const;
  /// With the shown scans and no skew; does not stop at failures.
  TestPlayOptions atShown() const;

  /// A look before the end of a wait that does not hold everywhere is given up. Whether there was one.
  static bool giveUpEarlyLooks(TestCase& test, const std::vector<std::set<std::size_t>>& failing);

 private:
  static std::string stepText(const TraceSignal& signal, TraceNumber from, TraceNumber to, bool isAtPowerOn);

  const Program& program_;
  const TestSignals& signals_;
  const SimulatorOptions engine_;
  const std::uint32_t shownUs_;
  TestTable columns_;
};

}  // namespace rungproof
