// Coils, boxes and actual parameters write; contacts do not.
#include "ir/written_operand.hpp"

#include <gtest/gtest.h>

#include "frontend/input/project.hpp"

namespace rungproof {
namespace {

// = writes Q0.0; MOVW writes VB10 and VB11; I0.1 and Q0.1 are given to a subroutine, which may write either.
TEST(WrittenOperand, CountsCoilsBoxesAndActuals) {
  const Program program = readText("p.awl",
                                   "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1\nLD I0.0\n= Q0.0\nMOVW 1, VW10\n"
                                   "CALL SBR_0, I0.1, Q0.1\nEND_ORGANIZATION_BLOCK\nSUBROUTINE_BLOCK SBR_0:SBR0\n"
                                   "VAR_INPUT\nin:BOOL;\nEND_VAR\nVAR_OUTPUT\nout:BOOL;\nEND_VAR\nBEGIN\nNetwork 1\n"
                                   "LD L0.0\n= L0.1\nEND_SUBROUTINE_BLOCK\n");
  const auto written = [&](const Operand& operand, Actuals actuals) { return isWritten(program, operand, actuals); };
  EXPECT_FALSE(written(direct(Area::I, Width::Bit, 0, 0), Actuals::Written));
  EXPECT_TRUE(written(direct(Area::Q, Width::Bit, 0, 0), Actuals::Read));
  EXPECT_TRUE(written(direct(Area::V, Width::Byte, 11, 0), Actuals::Read));
  EXPECT_FALSE(written(direct(Area::V, Width::Byte, 12, 0), Actuals::Written));
  for (const Operand& actual : {direct(Area::I, Width::Bit, 0, 1), direct(Area::Q, Width::Bit, 0, 1)}) {
    EXPECT_TRUE(written(actual, Actuals::Written));
    EXPECT_FALSE(written(actual, Actuals::Read));
  }
}

}  // namespace
}  // namespace rungproof
