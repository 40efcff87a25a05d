// A witness that needs the time bases or the clock bits somewhere in their periods says so in its CSV: `sim` repeats it
// (001:6592, 001:14054).
#include <gtest/gtest.h>

#include "tests/program_run.hpp"

namespace rungproof {
namespace {

test::ProgramRun command(std::vector<std::string> arguments) {
  arguments.push_back("--isolated");
  return test::run(arguments);
}

/// Proves a violated property named p, and runs the CSV of its witness as a stimulus: the column of Q0.0 is the same.
void expectRepeated(const std::string& program, const std::string& property, const std::string& clock) {
  SCOPED_TRACE(program);
  const test::TemporaryFolder folder;
  const std::string file = folder.file("p.awl", "//@ prove p: " + property + "\n" + program);
  EXPECT_EQ(command({"prove", file, "--scan-time", "10ms", "--traces", folder.path("t")}).exit, 1);
  const std::string csv = folder.path("t/p.csv");
  EXPECT_NE(test::contentOf(csv).find(clock), std::string::npos) << test::contentOf(csv);
  EXPECT_EQ(command({"sim", file, "--stimulus", csv, "--expect", csv, "--scan-time", "10ms"}).exit, 0)
      << test::contentOf(csv);
}

TEST(WitnessFile, CarriesThePhaseOfTheTimeBases) {
  expectRepeated("LD SM0.0\nTON T37, 1\nAW< VW0, 50\nINCW VW0\nLD T37\n= Q0.0\n", "VW0 < 9 implies not Q0.0",
                 "CLOCK.tick");
  expectRepeated("LD SM0.0\nTON T33, 3\nAW< VW0, 50\nINCW VW0\nLD T33\n= Q0.0\nLD T37\n= Q0.1\nLD SM0.0\nTON T37, 1\n",
                 "VW0 < 9 implies not Q0.1", "CLOCK.tick");
}

TEST(WitnessFile, CarriesThePhaseOfTheClockBits) {
  expectRepeated("LD SM0.0\nAW< VW2, 50\nINCW VW2\nLD SM0.5\n= Q0.0\n", "VW2 < 9 implies not Q0.0", "CLOCK.second");
  expectRepeated("LD SM0.0\nAW< VW2, 50\nINCW VW2\nLD SM0.4\n= Q0.0\n", "VW2 < 9 implies not Q0.0", "CLOCK.minute");
}

TEST(WitnessFile, PhaseIsAnOptionOfSim) {
  const test::TemporaryFolder folder;
  const std::string file = folder.file("p.awl", "LD SM0.0\nTON T37, 1\nLD T37\n= Q0.0\n");
  const std::string expected = folder.file("e.csv", "scan,Q0.0\n1,0\n2,1\n");
  EXPECT_EQ(command({"sim", file, "--expect", expected, "--phase", "90ms"}).exit, 0);
  EXPECT_EQ(command({"sim", file, "--expect", expected}).exit, 1);
  EXPECT_EQ(command({"sim", file, "--phase", "soon"}).exit, 2);
}

}  // namespace
}  // namespace rungproof
