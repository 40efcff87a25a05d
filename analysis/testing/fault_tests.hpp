// FaultTests: which of the tests that are offered are worth being done because they notice planted faults that no other
// test notices. What a fault changes must show in a value that comes at every scan time and with every skew; where a
// fault shows only in values that depend on the length of scans, a few of these are expected too, and their step says
// `timing`. Covered by tests/tables/generate_command_test.cpp.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "analysis/testing/bench_rows.hpp"
#include "analysis/testing/kill.hpp"
#include "analysis/testing/robust_check.hpp"

namespace rungproof {

class FaultTests {
 public:
  /// Program, rows and check must outlive it.
  FaultTests(const Program& program, const BenchRows& rows, RobustCheck& check, const SimulatorOptions& engine);

  /// Faults that these tests notice need no other test.
  void forget(const std::vector<TestCase>& tests);
  /// Takes a test, whose values are expected already, if it notices something; its steps end where it does.
  void offer(TestCase test);
  bool isDone() const { return open_.empty(); }

  struct OpenFault {
    Mutant mutant;
    Program program;
  };
  /// Those that no test notices so far. One that changes nothing is taken out by remove().
  const std::vector<std::unique_ptr<OpenFault>>& open() const { return open_; }
  void remove(std::size_t index);

  /// The tests that were taken, whose values come everywhere.
  std::vector<TestCase> takeRobust() { return std::move(robust_); }
  /// Tests with values that depend on the length of scans, for what is open still: those that notice the most, as long
  /// as such steps stay below `share` of all; `others`: steps of the tests so far. `scanText`: "10 ms".
  std::vector<TestCase> takeTimed(std::size_t others, double share, const std::string& scanText);

 private:
  struct Notice {
    const OpenFault* fault;
    std::size_t row, output;
  };
  struct Offer {
    TestCase test;
    std::vector<std::set<std::size_t>> failing;
    std::vector<Notice> notices;
  };
  std::vector<Notice> noticesOf(const OpenFault& fault, const TestCase& test) const;

  const BenchRows& rows_;
  RobustCheck& check_;
  const SimulatorOptions engine_;
  std::vector<std::unique_ptr<OpenFault>> open_;
  std::vector<TestCase> robust_;
  std::vector<Offer> timed_;
};

}  // namespace rungproof
