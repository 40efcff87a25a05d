// The joined table: opcodes are positions, look-ups find every mnemonic.
#include <gtest/gtest.h>

#include "ir/isa.hpp"

namespace rungproof {

TEST(InstructionTable, EveryMnemonicIsFoundAtItsOwnPosition) {
  for (std::size_t i = 0; i < instructionTable().size(); ++i) {
    const Desc& desc = instructionTable()[i];
    EXPECT_EQ(desc.opcode, i) << desc.stl;
    EXPECT_EQ(instructionNamed(desc.stl), &desc) << desc.stl;
  }
}

}  // namespace rungproof
