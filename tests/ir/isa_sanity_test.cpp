// The joined table: opcodes are positions, look-ups find every mnemonic.
#include <gtest/gtest.h>

#include "ir/s7200/isa.hpp"

namespace rungproof {

TEST(InstructionTable, EveryMnemonicIsFoundAtItsOwnPosition) {
  for (std::size_t i = 0; i < s7200Instructions().all().size(); ++i) {
    const Desc& desc = s7200Instructions().all()[i];
    EXPECT_EQ(desc.opcode, i) << desc.stl;
    EXPECT_EQ(s7200Instructions().named(desc.stl), &desc) << desc.stl;
  }
}

}  // namespace rungproof
