// Reading takes time in proportion to the length of a text, damaged or not.
#include <gtest/gtest.h>

#include "frontend/input/project.hpp"
#include "tests/machine_pace.hpp"

namespace rungproof {
namespace {

std::string repeated(std::string_view piece, std::size_t count) {
  std::string result;
  result.reserve(piece.size() * count);
  for (std::size_t i = 0; i < count; ++i) result += piece;
  return result;
}

double milliseconds(const std::string& text) {
  return 1000 * test::quietSeconds([&] { EXPECT_GT(readText("long.awl", text).sources->size(), 0U); }, 0, 2);
}

TEST(Reading, TimeGrowsWithTheLengthOnly) {
  // Ten times the text may take forty times as long before this fails: a quadratic step would take a hundred.
  struct Case {
    const char* name;
    std::string head;
    std::string piece;
  };
  const std::vector<Case> cases = {{"operands on one line", "LD ", "I0.0,"},
                                   {"blank line", "NOT\n", "    "},
                                   {"open quotes", "LD ", "'$"},
                                   {"mixed quotes", "LD ", "\"'x "},
                                   {"semicolons", "", "NOT;"},
                                   {"commas over lines", "CALL 1,\n", "VB0,\n"},
                                   {"unknown instructions", "NOT\n", "FOOB I0.0\n"},
                                   {"networks", "", "Network 1\nNOT\n"},
                                   {"headings", "", "INT\n"},
                                   {"blocks", "", "SUBROUTINE_BLOCK A\nBEGIN\n"},
                                   {"rungs without networks", "", "LD I0.0\n= Q0.0\n"},
                                   {"pending loads", "", "LD I0.0\n"},
                                   {"lines outside", "ORGANIZATION_BLOCK M:OB1\nEND_ORGANIZATION_BLOCK\n", "LD I0.0\n"},
                                   {"comments", "NOT\n", "// x\n"},
                                   {"declarations", "SUBROUTINE_BLOCK A:SBR0\nVAR\n", "a:INT;\n"},
                                   {"names", "", "LD nobody\n"},
                                   {"data", "VB0 1\n", "1\n"}};
  for (const Case& c : cases) {
    const double small = milliseconds(c.head + repeated(c.piece, 3000));
    const double large = milliseconds(c.head + repeated(c.piece, 30000));
    EXPECT_LT(large, 40 * small + 50) << c.name;
  }
}

}  // namespace
}  // namespace rungproof
