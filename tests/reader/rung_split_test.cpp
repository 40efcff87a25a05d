// Where rungs begin in a text without Network lines.
#include "frontend/stl/rung_split.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "ir/s7200/isa.hpp"

namespace rungproof {
namespace {

/// Starts of a row of mnemonics separated by blanks.
std::vector<std::size_t> starts(const std::string& mnemonics) {
  std::vector<Instruction> instructions;
  std::istringstream stream(mnemonics);
  for (std::string name; stream >> name;) {
    Instruction instruction;
    instruction.desc = s7200Instructions().named(name);
    EXPECT_NE(instruction.desc, nullptr) << name;
    instructions.push_back(instruction);
  }
  return rungStarts(instructions);
}
using Starts = std::vector<std::size_t>;

TEST(RungSplit, LoadBehindAnOutput) {
  EXPECT_EQ(starts(""), Starts{});
  EXPECT_EQ(starts("LD ="), Starts{0});
  EXPECT_EQ(starts("LD = LD ="), (Starts{0, 2}));
  EXPECT_EQ(starts("LD LD ="), Starts{0});  // the first load is never used: no output between
  EXPECT_EQ(starts("LD = = TON LD"), (Starts{0, 4}));
  EXPECT_EQ(starts("S LD ="), (Starts{0, 1}));  // a block may begin without a load (001:6765)
}

TEST(RungSplit, StackThatIsUsedLater) {
  EXPECT_EQ(starts("LD = LD ALD ="), Starts{0});
  EXPECT_EQ(starts("LD = LD LD OLD ALD ="), Starts{0});
  EXPECT_EQ(starts("LD LPS A = LPP AN = LD ="), (Starts{0, 7}));
  EXPECT_EQ(starts("LD = LD LD CTU LD ="), (Starts{0, 2, 5}));  // CTU takes two levels
  EXPECT_EQ(starts("LD MOVB A = NOT = LD ="), (Starts{0, 6}));
}

TEST(RungSplit, ComparisonsAreLoads) { EXPECT_EQ(starts("LD = LDW>= R LDB= AW< ="), (Starts{0, 2, 4})); }

TEST(RungSplit, InstructionsAtTheLeftRail) {
  EXPECT_EQ(starts("LD = MEND"), (Starts{0, 2}));
  EXPECT_EQ(starts("LSCR LD = SCRE LD ="), (Starts{0, 1, 3, 4}));
  EXPECT_EQ(starts("LD FOR INCW NEXT LD ="), (Starts{0, 3, 4}));
  EXPECT_EQ(starts("LD JMP LBL LD = RET"), (Starts{0, 2, 3, 5}));
}

}  // namespace
}  // namespace rungproof
