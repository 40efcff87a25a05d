// Access lists and their indices: what each instruction reads and writes, by the manual's description of it.
#include <gtest/gtest.h>

#include "tests/rules/lint.hpp"

namespace rungproof::testing {
namespace {

/// Accesses of the second instruction of "LD SM0.0 / <text>": "r VW0 w VW2", with "*3" for a row of elements.
std::string accessesOf(const std::string& text) {
  const Linted linted("Network 1\nLD SM0.0\n" + text + "\n");
  std::string result;
  for (const Access& access : linted.facts->accesses().of(1)) {
    result += std::string(result.empty() ? "" : " ") + (access.write ? "w " : "r ") + accessName(access);
    if (access.count > 1) result += "*" + std::to_string(access.count);
    if (access.most > access.count) result += ".." + std::to_string(access.most);
  }
  return result;
}

TEST(Access, FollowsTheOperandsOfEachInstruction) {
  EXPECT_EQ(accessesOf("MOVW VW0, VW2"), "r VW0 w VW2");
  EXPECT_EQ(accessesOf("+I VW0, VW2"), "r VW0 r VW2 w VW2");
  EXPECT_EQ(accessesOf("S Q0.3, 8"), "w Q0.3*8");
  EXPECT_EQ(accessesOf("R T37, 2"), "w T37*2 w T37*2");           // bit and current value (001:2791)
  EXPECT_EQ(accessesOf("S Q0.0, VB10"), "w Q0.0..255 r VB10");    // N from memory
  EXPECT_EQ(accessesOf("MUL VW0, VD10"), "r VW0 r VW12 w VD10");  // low word in, double word out (001:4881)
  EXPECT_EQ(accessesOf("BMW VW0, VW100, 5"), "r VW0*5 w VW100*5");
  EXPECT_EQ(accessesOf("FILL +0, VW100, 3"), "w VW100*3");
  EXPECT_EQ(accessesOf("MOVW *VD4, AC0"), "r VD4 r *VD4 w AC0");
  EXPECT_EQ(accessesOf("SHRB I0.0, V10.5, -4"), "r I0.0 r V10.5*4 w V10.5*4");
  EXPECT_EQ(accessesOf("TON T37, VW0"), "w T37 w T37 r VW0");     // the box owns bit and value
  EXPECT_EQ(accessesOf("HTA VB0, VB10, 3"), "r VB0*2 w VB10*3");  // two digits in a byte
}

TEST(Access, CallTakesDirectionsFromTheTableOfTheBlock) {
  const Linted linted(
      "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1\nLD SM0.0\nCALL SBR0, VB0, VW2\nEND_ORGANIZATION_BLOCK\n"
      "SUBROUTINE_BLOCK SBR_0:SBR0\nVAR_INPUT\nA:BYTE;\nEND_VAR\nVAR_OUTPUT\nB:WORD;\nEND_VAR\nBEGIN\nNetwork 1\nLD "
      "SM0.0\nBTI LB0, LW1\nEND_SUBROUTINE_BLOCK\n");
  const std::span<const Access> call = linted.facts->accesses().of(1);
  ASSERT_EQ(call.size(), 2U);
  EXPECT_FALSE(call[0].write);
  EXPECT_EQ(call[0].width, Width::Byte);
  EXPECT_TRUE(call[1].write);
  EXPECT_EQ(call[1].width, Width::Word);
}

TEST(AccessIndex, FindsEveryAccessOfAByte) {
  const Linted linted("Network 1\nLD V10.3\nMOVW VW9, VW20\nMOVD VD7, VD30\nFILL +0, VW0, 100\n");
  const AccessIndex& index = linted.facts->index();
  const std::uint32_t cell = index.cells().cell(Area::V, 10, 0);
  EXPECT_EQ(index.at(cell).size(), 3U);  // the bit, the word and the double word; the block of 200 bytes is wide
  EXPECT_EQ(index.wide().size(), 1U);
  EXPECT_TRUE(index.isWrittenAtLarge(cell));
  EXPECT_FALSE(index.isReadAtLarge(cell));
  EXPECT_FALSE(index.mayBeWritten(index.cells().cell(Area::V, 200, 0)));
}

TEST(AccessIndex, PointersReachFromTheirAddressUpwards) {
  const Linted linted("Network 1\nLD SM0.0\nMOVD &VB100, AC1\nMOVB 1, *AC1\n");
  const AccessIndex& index = linted.facts->index();
  EXPECT_TRUE(index.mayBeWritten(index.cells().cell(Area::V, 150, 0)));
  EXPECT_FALSE(index.mayBeWritten(index.cells().cell(Area::V, 99, 0)));
}

TEST(BitWrites, ListsEveryBitOfALatch) {
  const Linted linted("Network 1\nLD I0.0\nS Q0.6, 4\n= Q1.1\n");
  const std::uint32_t cell = linted.facts->index().cells().cell(Area::Q, 1, 0);
  EXPECT_EQ(linted.facts->bits().at(cell * 8 + 1).size(), 2U);  // Q0.6, 4 reaches Q1.1
  EXPECT_EQ(linted.facts->bits().at(cell * 8 + 2).size(), 0U);
  EXPECT_EQ(linted.facts->bitName(cell * 8 + 1), "Q1.1");
}

}  // namespace
}  // namespace rungproof::testing
