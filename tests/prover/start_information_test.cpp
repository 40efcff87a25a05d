// What an organization block of the S7-300/400 finds in its first 20 bytes (002:2000-2015).
#include "proved_text.hpp"

namespace rungproof::test {
namespace {

/// OB1 and OB100 meet a BCD error, OB1 not with every input; all three blocks keep bytes of their start information.
ProofRun runOf(const std::string& properties) {
  const std::string error = "BTI;\nT MW 22;\nEND_ORGANIZATION_BLOCK\n";
  const ProgramInput input = inputOfSource(
      "ORGANIZATION_BLOCK OB 121\nBEGIN\nNETWORK\nL LB 0;\nT MB 10;\nL LB 2;\nT MB 11;\nL LB 3;\nT MB 12;\n"
      "END_ORGANIZATION_BLOCK\n"
      "ORGANIZATION_BLOCK OB 100\nBEGIN\nNETWORK\nL LB 0;\nT MB 14;\nL LB 3;\nT MB 15;\nL W#16#ABCD;\n" +
      error + "ORGANIZATION_BLOCK OB 1\n" + properties +
      "BEGIN\nNETWORK\nL LB 0;\nT MB 16;\nL LB 1;\nT MB 17;\nL LB 2;\nT MB 18;\nL LB 3;\nT MB 19;\nL LB 19;\n"
      "T MB 20;\nL IW 0;\n" +
      error);
  return prove(input.program, input.properties, usualOptions());
}

// OB1_EV_CLASS 16#11, OB1_SCAN_1 1 or 3 behind a warm restart, OB1_PRIORITY 1 (002:817), and the numbers.
TEST(StartInformation, WhatIsKnownIsProved) {
  const ProofRun run = runOf(
      "//@ prove class: MB16 = 17\n//@ prove scan: MB17 = 1 or MB17 = 3\n//@ prove priority: MB18 = 1\n"
      "//@ prove main: MB19 = 1\n//@ prove start: MB15 = 100\n//@ prove error: MB12 = 0 or MB12 = 121\n");
  for (const char* name : {"class", "scan", "priority", "main", "start", "error"})
    EXPECT_EQ(outcomeOf(run, name), Outcome::Proved) << name;
}

// The class of an error or a restart is not that of OB1; OB121 has the priority of the block that it interrupts
// (002:1282), which is not 1 in OB100; the date and time of a call may be any.
TEST(StartInformation, WhatIsNotKnownMayBeAnything) {
  const ProofRun run = runOf(
      "//@ prove errorClass: MB10 = 17 or MB10 = 0\n//@ prove errorPriority: MB11 = 1 or MB11 = 0\n"
      "//@ prove startClass: MB14 = 17\n//@ prove date: MB20 = 0\n");
  for (const char* name : {"errorClass", "errorPriority", "startClass", "date"})
    EXPECT_EQ(outcomeOf(run, name), Outcome::Violated) << name;
}

}  // namespace
}  // namespace rungproof::test
