// What is said where a program does not name its family and one is taken: SimaticML is read as for an S7-200, which TIA
// Portal does not have.
#include <gtest/gtest.h>

#include <string>

#include "program_run.hpp"

namespace rungproof::test {
namespace {

const std::string drawnMotor = std::string(RUNGPROOF_SOURCE_DIR) + "/corpus/simaticml/motor.xml";

TEST(FamilyNote, SaysHowSimaticMlIsRead) {
  const ProgramRun taken = run({"lint", "--isolated", drawnMotor});
  EXPECT_NE(taken.err.find("motor.xml is SimaticML, which names no family: it is read as for an S7-200"),
            std::string::npos)
      << taken.err;
  EXPECT_NE(taken.err.find("--dialect s7-300"), std::string::npos) << taken.err;
  EXPECT_EQ(taken.err.find('\n'), taken.err.size() - 1) << "one line: " << taken.err;
}

TEST(FamilyNote, IsSilentWhereTheFamilyIsGiven) {
  for (const std::vector<std::string>& given :
       {std::vector<std::string>{"--quiet"}, {"--cpu", "226"}, {"--dialect", "s7-200"}}) {
    std::vector<std::string> arguments = {"lint", "--isolated", drawnMotor};
    arguments.insert(arguments.end(), given.begin(), given.end());
    const ProgramRun silent = run(arguments);
    EXPECT_NE(silent.exit, 2) << given[0] << silent.err;
    EXPECT_EQ(silent.err.find("names no family"), std::string::npos) << given[0];
  }
  EXPECT_EQ(run({"lint", "--isolated", std::string(RUNGPROOF_SOURCE_DIR) + "/corpus/iec/batch.st"}).err, "");
}

}  // namespace
}  // namespace rungproof::test
