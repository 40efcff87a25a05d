// Facts of instructions that their readers ask for, each against the manual, and the forms that belong together.
#include <gtest/gtest.h>

#include "ir/s7200/isa.hpp"

namespace rungproof {
namespace {

const Desc& named(std::string_view mnemonic) { return *s7200Instructions().named(mnemonic); }
std::string_view nameOf(const Desc* desc) { return desc == nullptr ? "" : desc->stl; }

TEST(Role, TellsContactsFromWordOperationsAndStackOperations) {
  EXPECT_EQ(named("LD").role, Role::Load);
  EXPECT_EQ(named("LDW>=").role, Role::Load);
  EXPECT_EQ(named("AN").role, Role::And);
  EXPECT_EQ(named("OR=").role, Role::Or);     // a comparison of reals
  EXPECT_EQ(named("ORB").role, Role::Other);  // a word operation
  EXPECT_EQ(named("ALD").role, Role::Ald);
  EXPECT_EQ(named("LDS").role, Role::Lds);
  EXPECT_EQ(named("STR").role, Role::StringConvert);  // a string to a real, no set coil
  EXPECT_EQ(named("SIN").role, Role::Other);
  EXPECT_EQ(named("DIV").role, Role::DivWide);
  EXPECT_EQ(named("/R").role, Role::Div);
}

TEST(Role, NegatedAndImmediateAreFactsNotLetters) {
  for (const Desc& desc : s7200Instructions().all()) {
    EXPECT_TRUE(!desc.negated || isContact(desc.role)) << desc.stl;
  }
  EXPECT_TRUE(named("ONI").negated && named("ONI").immediate);
  EXPECT_FALSE(named("SIN").negated);  // ends with N and negates nothing
  EXPECT_FALSE(named("+I").immediate);
  EXPECT_TRUE(named("SI").immediate && named("=I").immediate && named("BIW").immediate);  // 001:2781, 001:5595
}

TEST(Role, ComparisonsCarryTheirRelation) {
  EXPECT_EQ(named("AR<>").relation, Relation::NotEqual);
  EXPECT_EQ(named("LDD<=").relation, Relation::LessEqual);
  EXPECT_EQ(named("FND>").relation, Relation::Greater);
  EXPECT_EQ(named("=").relation, Relation::None);
}

/// The names of the power inputs are those of the stack levels that the box takes (001:3984-4008, 001:2880).
TEST(Role, BoxesHaveAPinForEachLevelTheyTake) {
  for (const Desc& desc : s7200Instructions().all()) {
    if (desc.execution != Execution::Sampled) continue;
    std::size_t pins = 0;
    for (const std::string_view pin : desc.flowPins) pins += pin.empty() ? 0 : 1;
    EXPECT_EQ(pins, desc.stack.needs) << desc.stl;
  }
}

TEST(InstructionForms, ContactsHaveThreeJointsAndAContrary) {
  EXPECT_EQ(nameOf(s7200Instructions().joinedForm(named("AW>="), Role::Load)), "LDW>=");
  EXPECT_EQ(nameOf(s7200Instructions().joinedForm(named("LDNI"), Role::Or)), "ONI");
  EXPECT_EQ(nameOf(s7200Instructions().joinedForm(named("LDS="), Role::And)), "AS=");
  EXPECT_EQ(nameOf(s7200Instructions().joinedForm(named("LDB="), Role::And)), "AB=");
  EXPECT_EQ(s7200Instructions().joinedForm(named("LDS"), Role::And), nullptr);
  EXPECT_EQ(nameOf(s7200Instructions().negatedForm(named("LD"))), "LDN");
  EXPECT_EQ(nameOf(s7200Instructions().negatedForm(named("ONI"))), "OI");
  EXPECT_EQ(s7200Instructions().negatedForm(named("LDW=")), nullptr);
  EXPECT_EQ(nameOf(&s7200Instructions().bitContact(Role::And, true)), "AN");
  EXPECT_EQ(nameOf(&s7200Instructions().bitContact(Role::Or, false, true)), "OI");
}

TEST(InstructionForms, OppositesComeInPairs) {
  EXPECT_EQ(nameOf(s7200Instructions().oppositeForm(named("S"))), "R");
  EXPECT_EQ(nameOf(s7200Instructions().oppositeForm(named("RI"))), "SI");
  EXPECT_EQ(nameOf(s7200Instructions().oppositeForm(named("SR"))), "RS");
  EXPECT_EQ(nameOf(s7200Instructions().oppositeForm(named("ED"))), "EU");
  EXPECT_EQ(nameOf(s7200Instructions().oppositeForm(named("TON"))), "TOF");
  EXPECT_EQ(s7200Instructions().oppositeForm(named("TONR")), nullptr);
  EXPECT_EQ(s7200Instructions().oppositeForm(named("TON.IEC")), nullptr);
  for (const Desc& desc : s7200Instructions().all()) {
    const Desc* opposite = s7200Instructions().oppositeForm(desc);
    const Desc* negated = s7200Instructions().negatedForm(desc);
    EXPECT_TRUE(opposite == nullptr || s7200Instructions().oppositeForm(*opposite) == &desc) << desc.stl;
    EXPECT_TRUE(negated == nullptr || s7200Instructions().negatedForm(*negated) == &desc) << desc.stl;
  }
}

TEST(InstructionForms, SingleInstructionsAreFoundByWhatTheyDo) {
  EXPECT_EQ(s7200Instructions().only(Role::Aeno).stl, "AENO");
  EXPECT_EQ(s7200Instructions().only(Control::Call).stl, "CALL");
  EXPECT_EQ(s7200Instructions().plainAssign().stl, "=");
}

}  // namespace
}  // namespace rungproof
