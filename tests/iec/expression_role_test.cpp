// What instructions of IEC 61131-3 are for, and how many values they take and leave (ir/iec/isa).
#include "ir/iec/expression_role.hpp"

#include <gtest/gtest.h>

#include "ir/iec/isa.hpp"
#include "ir/s7200/isa.hpp"

namespace rungproof {
namespace {

Instruction withDesc(const Desc& desc) {
  Instruction instruction;
  instruction.desc = &desc;
  return instruction;
}
Instruction namedIec(std::string_view mnemonic) { return withDesc(*iecInstructions().named(mnemonic)); }

TEST(ExpressionRole, ByInstruction) {
  EXPECT_EQ(expressionRole(namedIec("LOAD.BIT")), ExpressionRole::LoadBit);
  EXPECT_EQ(expressionRole(namedIec("STORE")), ExpressionRole::Store);
  EXPECT_EQ(expressionRole(namedIec("XOR")), ExpressionRole::Xor);
  EXPECT_EQ(expressionRole(namedIec("ADD")), ExpressionRole::Other);
  for (const Desc& desc : s7200Instructions().all())
    EXPECT_EQ(expressionRole(withDesc(desc)), ExpressionRole::Other) << desc.stl;
}

TEST(ExpressionRole, WhatTheStackGivesAndGets) {
  const auto uses = [](std::string_view mnemonic, std::size_t pops, std::size_t pushes) {
    const StackUse use = stackUse(namedIec(mnemonic));
    EXPECT_EQ(use.pops, pops) << mnemonic;
    EXPECT_EQ(use.pushes, pushes) << mnemonic;
  };
  uses("LOAD", 0, 1);
  uses("NOT", 1, 1);
  uses("ADD", 2, 1);
  uses("SEL", 3, 1);
  uses("STORE", 1, 0);
  uses("STORE.ELEMENT", 2, 0);
  uses("JMP", 0, 0);
  uses("JMPCN", 1, 0);
}

TEST(ExpressionRole, WidthOfTruth) {
  Instruction bit = namedIec("AND"), word = namedIec("AND"), constant = namedIec("CONST");
  bit.operands = {rungproof::constant(1)};
  word.operands = {rungproof::constant(16)};
  constant.operands = {rungproof::constant(7), rungproof::constant(1)};
  EXPECT_TRUE(isOfTruth(bit));
  EXPECT_FALSE(isOfTruth(word));
  EXPECT_TRUE(isOfTruth(constant));
}

}  // namespace
}  // namespace rungproof
