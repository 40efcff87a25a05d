// A witness that needs the time bases or the clock bits somewhere in their periods says so in its CSV: `sim` repeats it
// (001:6592, 001:14054).
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "frontend/cli/cli.hpp"
#include "tests/temporary_folder.hpp"

namespace rungproof {
namespace {

struct CommandRun {
  int code;
  std::string out;
};

CommandRun command(std::vector<std::string> arguments) {
  std::istringstream in;
  std::ostringstream out, err;
  arguments.push_back("--isolated");
  const int code = runProgram(arguments, {in, out, err});
  return {code, out.str()};
}

std::string textOf(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

/// Proves a violated property named p, and runs the CSV of its witness as a stimulus: the column of Q0.0 is the same.
void expectRepeated(const std::string& program, const std::string& property, const std::string& clock) {
  SCOPED_TRACE(program);
  const test::TemporaryFolder folder;
  const std::string file = folder.file("p.awl", "//@ prove p: " + property + "\n" + program);
  EXPECT_EQ(command({"prove", file, "--scan-time", "10ms", "--traces", folder.path("t")}).code, 1);
  const std::string csv = folder.path("t/p.csv");
  EXPECT_NE(textOf(csv).find(clock), std::string::npos) << textOf(csv);
  EXPECT_EQ(command({"sim", file, "--stimulus", csv, "--expect", csv, "--scan-time", "10ms"}).code, 0) << textOf(csv);
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
  EXPECT_EQ(command({"sim", file, "--expect", expected, "--phase", "90ms"}).code, 0);
  EXPECT_EQ(command({"sim", file, "--expect", expected}).code, 1);
  EXPECT_EQ(command({"sim", file, "--phase", "soon"}).code, 2);
}

}  // namespace
}  // namespace rungproof
