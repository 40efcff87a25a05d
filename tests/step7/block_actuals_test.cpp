// An FC may work on a copy of an actual that has a full address in a data block (general knowledge; 002:154 states the
// reference). That differs only where something else reaches the place meanwhile; then the verdict names the reading.
#include "tests/step7/run7.hpp"

namespace rungproof {
namespace {

using test7::block, test7::Output, test7::proofOf;

const std::string actualsData =
    "DATA_BLOCK DB 10\nSTRUCT\n  a : INT;\n  b : INT;\n  c : INT;\nEND_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n";

std::string actualsFunction(const std::string& statements) {
  std::string text =
      "FUNCTION FC 1 : VOID\nVAR_INPUT\n  x : INT;\nEND_VAR\nVAR_OUTPUT\n  y : INT;\nEND_VAR\nBEGIN\nNETWORK\n";
  std::istringstream in(statements);
  for (std::string one; std::getline(in, one, ';');) text += one + ";\n";
  return text + "END_FUNCTION\n";
}

/// FC 1 with b of DB 10 as output, `input` as input.
Output actualsAsked(const std::string& statements, const std::string& input = "MW 4", const std::string& others = "") {
  return proofOf("prove p: DB10.DBW4 = 0\n", actualsData + actualsFunction(statements) + others +
                                                 block(1, "CALL FC 1 (x := " + input + ", y := DB10.DBW 2)"));
}

const std::string actualsAssumption = "FC1 works on DB10.DBW2 in place and not on a copy";

// By full address, through the open block, through AR1, by both parameters, by a block below, by an interrupt.
TEST(BlockActuals, SecondWayIsNamed) {
  EXPECT_TRUE(actualsAsked("L #x;T #y;L DB10.DBW 2;T MW 20").has(actualsAssumption));
  EXPECT_TRUE(actualsAsked("L #x;T #y;OPN DB 10;L DBW 2;T MW 20").has(actualsAssumption));
  EXPECT_TRUE(actualsAsked("L #x;T #y;L P#M 30.0;LAR1;L W [AR1,P#0.0];T MW 20").has(actualsAssumption));
  EXPECT_TRUE(actualsAsked("L 5;T #y;L #x;T MW 20", "DB10.DBW 2").has(actualsAssumption));
  EXPECT_TRUE(actualsAsked("L #x;T #y;CALL FC 2", "MW 4",
                           "FUNCTION FC 2 : VOID\nBEGIN\nNETWORK\nL DB10.DBW 2;\nT MW 20;\nEND_FUNCTION\n")
                  .has(actualsAssumption));
  EXPECT_TRUE(actualsAsked("L #x;T #y", "MW 4", block(35, "L DB10.DBW 2;T MW 20")).has(actualsAssumption));
}

// Another word of the block, the actual of an input that is only read, and places in M, Q and T say nothing.
TEST(BlockActuals, OneWayIsNot) {
  for (const Output& output :
       {actualsAsked("L #x;T #y"), actualsAsked("L #x;T #y;L DB10.DBW 4;T MW 20"),
        actualsAsked("L #x;T #y", "DB10.DBW 0"), actualsAsked("L #x;T #y;L DB10.DBW 0;T MW 20", "DB10.DBW 0"),
        proofOf("prove p: DB10.DBW4 = 0\n", actualsData + actualsFunction("L #x;T #y;L MW 6;T MW 20") +
                                                block(1, "CALL FC 1 (x := MW 4, y := MW 6)"))}) {
    EXPECT_NE(output.exit, 2) << output.text;
    EXPECT_FALSE(output.has("in place and not on a copy")) << output.text;
  }
}

}  // namespace
}  // namespace rungproof
