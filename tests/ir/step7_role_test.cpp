// Kinds of the statements of the S7-300/400: named ones, and that no instruction of another family has one.
#include <gtest/gtest.h>

#include "ir/s7200/isa.hpp"
#include "ir/s7300/isa.hpp"
#include "ir/s7300/statement_detail.hpp"

namespace rungproof {
namespace {

StatementRole roleNamed(std::string_view mnemonic) {
  Instruction instruction;
  instruction.desc = s7300Instructions().named(mnemonic);
  return statementRole(instruction);
}

TEST(StatementRole, TellsWhatSharesAnOperandOrALetterApart) {
  EXPECT_EQ(roleNamed("A"), StatementRole::AndScan);
  EXPECT_EQ(roleNamed("AW"), StatementRole::Other);  // a word operation
  EXPECT_EQ(roleNamed("S"), StatementRole::Latch);
  EXPECT_EQ(roleNamed("S C"), StatementRole::SetCounter);
  EXPECT_EQ(roleNamed("SE"), StatementRole::StartTimer);
  EXPECT_EQ(roleNamed("SET"), StatementRole::SetRlo);
  EXPECT_EQ(roleNamed("LAR1 AR2"), StatementRole::Ar2ToAr1);
  EXPECT_EQ(roleNamed("JNB"), StatementRole::JumpKeepingRlo);
  EXPECT_EQ(roleNamed("JNBI"), StatementRole::JumpByBr);
  EXPECT_EQ(roleNamed("L DBNO"), StatementRole::Other);
}

TEST(StatementRole, EveryJumpCallAndEndHasOne) {
  for (const Desc& desc : s7300Instructions().all()) {
    const bool moves = desc.control == Control::Branch || desc.control == Control::Distributor ||
                       desc.control == Control::BlockEnd || desc.control == Control::BlockCall;
    Instruction instruction;
    instruction.desc = &desc;
    EXPECT_TRUE(!moves || statementRole(instruction) != StatementRole::Other) << desc.stl;
  }
}

TEST(StatementRole, JumpsLatchesTimersAndComparisonsByTheirSpelling) {
  const auto with = [](std::string_view mnemonic) {
    Instruction instruction;
    instruction.desc = s7300Instructions().named(mnemonic);
    return instruction;
  };
  for (const char* name : {"JC", "JCB", "JBI"}) EXPECT_TRUE(jumpsOnOne(with(name))) << name;
  for (const char* name : {"JCN", "JNB", "JNBI", "JU"}) EXPECT_FALSE(jumpsOnOne(with(name))) << name;
  EXPECT_TRUE(setsBit(with("S")));
  for (const char* name : {"R", "=", "S C", "SD"}) EXPECT_FALSE(setsBit(with(name))) << name;
  EXPECT_TRUE(startsOnDelay(with("SD")));
  for (const char* name : {"SE", "SP", "SS", "SF"}) EXPECT_FALSE(startsOnDelay(with(name))) << name;
  for (const char* name : {"==R", "<>R", ">R", "<=R"}) EXPECT_TRUE(comparesReals(with(name))) << name;
  for (const char* name : {"==I", ">D", "+R"}) EXPECT_FALSE(comparesReals(with(name))) << name;
  for (const char* name : {"SQRT", "LN"}) EXPECT_TRUE(wantsNoNegative(with(name))) << name;
  for (const char* name : {"SQR", "EXP", "+R"}) EXPECT_FALSE(wantsNoNegative(with(name))) << name;
  for (const char* name : {"-R", "NEGR", "SIN"}) EXPECT_TRUE(givesEitherSign(with(name))) << name;
  for (const char* name : {"ABS", "SQR", "EXP", "-I"}) EXPECT_FALSE(givesEitherSign(with(name))) << name;
  EXPECT_TRUE(numberStep(with("DTR"))->givesReal && !numberStep(with("DTR"))->takesReal);
  EXPECT_TRUE(numberStep(with("RND-"))->takesReal && !numberStep(with("RND-"))->givesReal);
  EXPECT_TRUE(numberStep(with("ABS"))->takesReal && numberStep(with("ABS"))->givesReal);
  EXPECT_FALSE(numberStep(with("ITD"))->givesReal || numberStep(with("+R")));
  EXPECT_EQ(resultOf(with("-D"), 3, 5)->value, -2);
  EXPECT_FALSE(resultOf(with("*I"), 300, 300)->fits());
  EXPECT_TRUE(resultOf(with("*D"), 300, 300)->fits());
  for (const char* name : {"/I", "MOD", "+R", "INC"}) EXPECT_FALSE(resultOf(with(name), 1, 1)) << name;
}

TEST(StatementRole, NoneOfTheOtherFamily) {
  for (const Desc& desc : s7200Instructions().all()) {
    Instruction instruction;
    instruction.desc = &desc;
    EXPECT_EQ(statementRole(instruction), StatementRole::Other) << desc.stl;
  }
}

}  // namespace
}  // namespace rungproof
