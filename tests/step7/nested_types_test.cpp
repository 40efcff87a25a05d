// Types that stand in each other: more levels than anybody writes are refused, and doubling types cost no more than
// they have bytes.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/step7/read7.hpp"

namespace rungproof {
namespace {

/// Types one in the other: each has `fields` of the next one, the last one an INT.
std::string chainOf(int levels, std::string_view first, std::string_view last, std::string_view fields) {
  std::string text;
  for (int i = 1; i <= levels; ++i) {
    text += fmt::format(fmt::runtime(first), i);
    text += i == levels ? std::string("    a : INT;\n") : fmt::format(fmt::runtime(fields), i + 1);
    text += last;
  }
  return text;
}

std::size_t countOf(const Program& program, std::string_view part) {
  return static_cast<std::size_t>(std::ranges::count_if(
      program.findings, [&](const Finding& f) { return f.message.view().find(part) != std::string_view::npos; }));
}

TEST(NestedTypes, AChainOfThousandsIsRefused) {
  const std::string types = chainOf(5000, "TYPE UDT {}\n  STRUCT\n", "  END_STRUCT;\nEND_TYPE\n", "    a : UDT {};\n");
  const Program program = readText("a.awl", types + "DATA_BLOCK DB 1\n  UDT 1\nBEGIN\nEND_DATA_BLOCK\n");
  EXPECT_GE(countOf(program, "types that contain each other, more than are read"), 1U);
}

TEST(NestedTypes, AChainOfInstancesIsRefused) {
  const std::string blocks =
      chainOf(5000, "FUNCTION_BLOCK FB {}\nVAR\n", "END_VAR\nBEGIN\nEND_FUNCTION_BLOCK\n", "    a : FB {};\n");
  const Program program = readText("a.awl", blocks + "DATA_BLOCK DB 1\n  FB 1\nBEGIN\nEND_DATA_BLOCK\n");
  EXPECT_GE(countOf(program, "types that contain each other, more than are read"), 1U);
}

TEST(NestedTypes, FiftyLevelsAreRead) {
  const std::string types = chainOf(50, "TYPE UDT {}\n  STRUCT\n", "  END_STRUCT;\nEND_TYPE\n", "    a : UDT {};\n");
  const Program program = readText("a.awl", types + "DATA_BLOCK DB 1\n  UDT 1\nBEGIN\nEND_DATA_BLOCK\n");
  EXPECT_TRUE(program.findings.empty());
}

TEST(NestedTypes, DoublingTypesEndAtTheLargestStructure) {
  // 2 bytes double in each level: 65,536 in the sixteenth from the end, one more than a structure may have. Without
  // that the sixty levels would have 10^18 fields.
  const std::string types =
      chainOf(60, "TYPE UDT {}\n  STRUCT\n", "  END_STRUCT;\nEND_TYPE\n", "    a : UDT {0};\n    b : UDT {0};\n");
  const Program program = readText("a.awl", types + "DATA_BLOCK DB 1\n  UDT 1\nBEGIN\nEND_DATA_BLOCK\n");
  EXPECT_GE(countOf(program, "more than 65535 bytes"), 1U);
}

TEST(NestedTypes, DoublingInstancesEndAtTheLargestStructure) {
  const std::string blocks = chainOf(60, "FUNCTION_BLOCK FB {}\nVAR\n", "END_VAR\nBEGIN\nEND_FUNCTION_BLOCK\n",
                                     "    a : FB {0};\n    b : FB {0};\n");
  const Program program = readText("a.awl", blocks + "DATA_BLOCK DB 1\n  FB 1\nBEGIN\nEND_DATA_BLOCK\n");
  EXPECT_GE(countOf(program, "65535"), 1U);
}

}  // namespace
}  // namespace rungproof
