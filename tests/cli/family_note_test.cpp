// Which family SimaticML is read for: TIA Portal has no S7-200.
#include <gtest/gtest.h>

#include <string>

#include "tests/program_run.hpp"

namespace rungproof::test {
namespace {

const std::string drawnMotor = std::string(RUNGPROOF_SOURCE_DIR) + "/corpus/simaticml/motor.xml";

TEST(FamilyNote, SimaticMlIsOfAnS7300) {
  const ProgramRun taken = run({"prove", "--isolated", drawnMotor});
  EXPECT_EQ(taken.exit, 0) << taken.out;
  EXPECT_NE(taken.out.find("assumes: CPU 319-3"), std::string::npos) << taken.out;
  EXPECT_EQ(taken.err, "");
}

TEST(FamilyNote, SimaticMlIsNoProgramOfAnotherFamily) {
  for (const std::string dialect : {"s7-200", "iec"}) {
    const ProgramRun refused = run({"prove", "--isolated", drawnMotor, "--dialect", dialect});
    EXPECT_EQ(refused.exit, 2) << dialect << refused.out;
    EXPECT_NE(refused.out.find("error[SYN050]: SimaticML is an export of TIA Portal, which has no programs of that "
                               "dialect"),
              std::string::npos)
        << dialect << refused.out;
  }
}

}  // namespace
}  // namespace rungproof::test
