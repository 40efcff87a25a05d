// Library blocks: names, output parameters, values from outside (chapters 7 to 15 of the manual).
#include "ir/s7200/library_block.hpp"
#include "tests/engine/rig.hpp"

namespace rungproof {
namespace {

TEST(LibraryBlock, NamesWithANumberMatchAnyDigit) {
  ASSERT_NE(libraryBlockNamed("PTO0_RUN"), nullptr);
  EXPECT_EQ(libraryBlockNamed("PTO1_RUN"), libraryBlockNamed("pto0_run"));
  EXPECT_EQ(libraryBlockNamed("PTOx_RUN"), nullptr);
  EXPECT_EQ(libraryBlockNamed("SBR_0"), nullptr);
  EXPECT_EQ(libraryOutputNamed(*libraryBlockNamed("USS_CTRL"), "Speed"), 12U);  // 001:10221
  EXPECT_EQ(libraryOutputNamed(*libraryBlockNamed("USS_CTRL"), "Zspeed"), 0U);
}

TEST(LibraryBlock, OutputsTakeTheirValuesFromOutside) {
  Rig rig("LD I0.0\nCALL MBUS_SLAVE, Q0.1, VB10\n");
  rig.simulator->devices().setLibraryOutput("MBUS_SLAVE", 1, 1);
  rig.simulator->devices().setLibraryOutput("MBUS_SLAVE", 2, 7);
  rig.scans(1);
  EXPECT_EQ(rig.get("Q0.1"), 0);  // without power flow the call is not made
  rig.set("I0.0", 1);
  rig.scans(1);
  EXPECT_EQ(rig.get("Q0.1"), 1);
  EXPECT_EQ(rig.get("VB10"), 7);
}

}  // namespace
}  // namespace rungproof
