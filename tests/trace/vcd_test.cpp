// Value change dumps that are read: what other tools write, by hand, with their mistakes; and what rungproof writes,
// which must come back as the same trace, over every program of the corpus.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>

#include "engine/simulator.hpp"
#include "frontend/input/project.hpp"
#include "frontend/simulation/expected_lanes.hpp"
#include "frontend/simulation/stimulus_reader.hpp"
#include "tests/trace/traces.hpp"

namespace rungproof {
namespace {

std::string shownDump(const std::string& text, const TraceImport& import = {}) {
  std::vector<Failure> failures;
  const Trace trace = readTrace("a.vcd", text, failures, import);
  if (!failures.empty()) return failures[0].place + ": " + failures[0].message + "; " + failures[0].help;
  std::string result;
  for (const TraceSignal& signal : trace.signals) result += signal.name + " ";
  for (const TraceRow& row : trace.rows) {
    result += fmt::format("| {:g}:", static_cast<double>(row.timeUs) / 1000);
    for (const std::optional<TraceNumber>& value : row.values) result += value ? fmt::format(" {:g} ", *value) : " x ";
  }
  return result;
}

const std::string head =
    "$date today $end\n$timescale\n  10 us\n$end\n$scope module top $end\n$var wire 1 ! Q0.0 $end\n"
    "$scope module pump $end\n$var reg 16 \" speed [15:0] $end\n$var real 64 # level $end\n$upscope $end\n$upscope "
    "$end\n"
    "$enddefinitions $end\n";

TEST(VcdReader, ScopesVectorsRealsAndUnknownValues) {
  EXPECT_EQ(
      shownDump(head + "#0\n$dumpvars\nx!\nbx \"\nr0.5 #\n$end\n#100\n1!\nb101 \"\n#150\n0!\nb1111111111111110 \"\n"
                       "r-2.5e1 #\nz!\n#200\n"),
      "Q0.0 speed level | 0: x  x  0.5 | 1: 1  5  0.5 | 1.5: x  -2  -25 | 2: x  -2  -25 ");
}

TEST(VcdReader, NamesOfSeveralScopesAndRenamedOnes) {
  const std::string two =
      "$timescale 1ms $end $scope module a $end $var wire 1 ! run $end $upscope $end $scope module b $end "
      "$var wire 1 % run $end $var wire 1 & %QX0.3 $end $upscope $end $enddefinitions $end\n#0\n0! 1% 1&\n";
  EXPECT_EQ(shownDump(two), "a.run b.run Q0.3 | 0: 0  1  1 ");
  TraceImport import;
  import.renames = {{"b.run", "Q0.0"}, { "a.run", "-" }};
  EXPECT_EQ(shownDump(two, import), "Q0.0 Q0.3 | 0: 1  1 ");
}

TEST(VcdReader, MistakesHaveTheirPlace) {
  EXPECT_EQ(shownDump(head + "#0\n1%\n"), "a.vcd:14:1: no variable has the code '%'; declare it with $var");
  EXPECT_EQ(shownDump(head + "#5\n1!\n#3\n"),
            "a.vcd:15:1: the time '#3' is earlier than the one before; times must stand in ascending order");
  EXPECT_EQ(
      shownDump(head + "#0\n2!\n"),
      "a.vcd:14:1: '2!' is no change of a value; a change is 0, 1, x or z and the code of a variable, or b1010 and "
      "r1.5 with the code behind a blank");
  EXPECT_EQ(shownDump(head + "#0\nb12 \"\n"),
            "a.vcd:14:1: 'b12' holds something else than 0, 1, x and z; export the dump again");
  EXPECT_EQ(shownDump(head + "#0\nb11111111111111111 \"\n"),
            "a.vcd:14:1: the value has more bits than speed, which has 16; export the dump again");
  EXPECT_EQ(shownDump(head + "#0\nrfast #\n"),
            "a.vcd:14:1: 'rfast' is no number; write r and a decimal number, such as r1.5");
  EXPECT_EQ(shownDump(head + "#0\nb1"), "a.vcd:14:1: the dump ends within a change; export it again");
  EXPECT_EQ(shownDump(head + "#x\n"), "a.vcd:13:1: '#x' is no time; a time is # and a whole number");
  EXPECT_EQ(shownDump("$timescale 1 fortnight $end\n"),
            "a.vcd:1:1: '1fortnight' is no time scale; write for example $timescale 1 us $end");
  EXPECT_EQ(shownDump("$var wire ! a $end\n"),
            "a.vcd:1:1: this $var does not name type, width, code and name; write $var wire 1 ! start $end");
  EXPECT_EQ(shownDump("$scope module a"), "a.vcd:1:1: $scope has no $end; the dump may be cut off; export it again");
  const std::string unscaled = "$var wire 1 ! a $end $enddefinitions $end\n#4\n1!\n";
  EXPECT_EQ(shownDump(unscaled), "a.vcd:2:1: the dump has no $timescale; give --time-unit, such as --time-unit us");
  TraceImport import;
  import.timeUnit = "s";
  EXPECT_EQ(shownDump(unscaled, import), "a | 4000: 1 ");
}

void expectSame(const Trace& wanted, const Trace& found, const std::string& what) {
  ASSERT_EQ(wanted.signals.size(), found.signals.size()) << what;
  ASSERT_EQ(wanted.rows.size(), found.rows.size()) << what;
  for (std::size_t r = 0; r < wanted.rows.size(); ++r) {
    EXPECT_EQ(wanted.rows[r].scan, found.rows[r].scan) << what;
    EXPECT_EQ(wanted.rows[r].timeUs, found.rows[r].timeUs) << what << " row " << r;
    EXPECT_EQ(wanted.rows[r].scanUs, found.rows[r].scanUs) << what << " row " << r;
    for (std::size_t i = 0; i < wanted.signals.size(); ++i) {
      const auto &a = wanted.rows[r].values[i], &b = found.rows[r].values[i];
      const bool isNan = a && std::isnan(*a) && (!b || std::isnan(*b));
      const bool isSameReal = a && b && wanted.signals[i].isReal() && static_cast<float>(*a) == static_cast<float>(*b);
      EXPECT_TRUE(a == b || isNan || isSameReal) << what << " " << wanted.signals[i].name << " row " << r;
    }
  }
}

TEST(WrittenTrace, ComesBackFromVcdAndCsv) {
  std::vector<Failure> failures;
  for (const char* ending : {".csv", ".vcd"}) {
    const Trace trace = sampleTrace();
    const Trace back = readTrace("t", written(trace, ending), failures);
    ASSERT_TRUE(failures.empty()) << failures[0].message;
    ASSERT_EQ(back.signals.size(), 5U);
    for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(trace.indexOf(back.signals[i]), static_cast<int>(i)) << ending;
    expectSame(trace, back, ending);
  }
}

/// Forty scans of uneven length with inputs that change: every program of the corpus that runs.
TEST(WrittenTrace, OfTheCorpusComesBack) {
  int programs = 0;
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(std::string(RUNGPROOF_SOURCE_DIR) + "/corpus")) {
    if (entry.path().extension() != ".awl") continue;
    const Program program = readProgram({entry.path().string()});
    const bool isRead = std::ranges::none_of(
        program.findings, [](const Finding& finding) { return finding.severity == Severity::Error; });
    if (!isRead || program.main() == nullptr) continue;
    Simulator simulator(program, {});
    Trace trace;
    trace.signals = touchedSignals(program);
    for (std::uint32_t scan = 0; scan < 40; ++scan) {
      ScanRequest request;
      request.lengthUs = scan % 3 == 0 ? 10000U : 12500U + scan;
      simulator.scan(request);
      trace.rows.push_back(sampleRow(simulator, trace.signals));
    }
    for (const SignalNames names : {SignalNames::Address, SignalNames::Symbol, SignalNames::Both}) {
      for (const char* ending : {".csv", ".vcd"}) {
        std::vector<Failure> failures;
        const Trace back = readTrace("t", written(named(trace, names), ending), program, failures);
        ASSERT_TRUE(failures.empty()) << entry.path() << ending << ": " << failures[0].place << failures[0].message;
        expectSame(trace, back, entry.path().string() + ending);
      }
    }
    ++programs;
  }
  EXPECT_GE(programs, 80);
}

}  // namespace
}  // namespace rungproof
