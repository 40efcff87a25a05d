// Comments that speak to the tool.
#include "frontend/stl/directive.hpp"

#include <gtest/gtest.h>

#include "tests/reader/read.hpp"

namespace rungproof {
namespace {

TEST(DirectiveTest, Text) {
  EXPECT_EQ(directiveText("//@ prove a: Q0.0 "), "prove a: Q0.0");
  EXPECT_EQ(directiveText("//@"), "");
  EXPECT_FALSE(directiveText("// @ prove").has_value());
  EXPECT_TRUE(speaksToTool("// rungproof: allow ADR001 wiring is fixed"));
  EXPECT_FALSE(speaksToTool("// start of rungproof"));
}

TEST(DirectiveTest, CollectedWithBlockAndNetwork) {
  const Program program =
      readText("a.awl",
               "//@ initial retentive\nORGANIZATION_BLOCK MAIN:OB1\n//@ assume x: I0.0\nBEGIN\nNetwork 3 //@ prove a: "
               "never Q0.0\nLD I0.0\n= Q0.0 //@ reach b: Q0.0; c\nEND_ORGANIZATION_BLOCK\n");
  ASSERT_EQ(program.directives.size(), 4U);
  EXPECT_EQ(program.directives[0].pou, -1);
  EXPECT_EQ(program.directives[1].pou, 0);
  EXPECT_EQ(program.directives[1].network, 0);
  EXPECT_EQ(program.directives[2].network, 3);
  EXPECT_EQ(program.directives[2].text, "prove a: never Q0.0");
  EXPECT_EQ(program.directives[3].text, "reach b: Q0.0; c");
  EXPECT_EQ(program.sources->text(program.directives[3].span), "//@ reach b: Q0.0; c");
  EXPECT_EQ(program.pous[0].networks[0].title, "");
}

TEST(DirectiveTest, RungsOfOlderTextsAreCounted) {
  const Program program = readText("a.txt", "LD I0.0\n= Q0.0\n//@ prove a: Q0.1\nLD I0.1\n= Q0.1\nMEND\n");
  ASSERT_EQ(program.directives.size(), 1U);
  EXPECT_EQ(program.directives[0].network, 2);
}

TEST(DirectiveTest, AllowCommentOnANetworkLineIsAComment) {
  const Program program = readText("a.awl", "Network 1 // rungproof: allow ADR001 reason\nLD I0.0\n");
  ASSERT_EQ(program.pous[0].networks[0].comments.size(), 1U);
  EXPECT_EQ(program.sources->text(program.pous[0].networks[0].comments[0].span), "// rungproof: allow ADR001 reason");
  EXPECT_EQ(program.pous[0].networks[0].title, "");
}

}  // namespace
}  // namespace rungproof
