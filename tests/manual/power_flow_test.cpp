// The class of every instruction: what needs power flow changes nothing without it (001:2274), whatever it is; the
// operands are made from the descriptors, so that no instruction can be forgotten.
#include "ir/s7200/isa.hpp"
#include "plant.hpp"

namespace rungproof::manual {
namespace {

/// An operand that the descriptor permits, in a place of its own.
std::string sampleOperand(const OperandDesc& desc, std::size_t i) {
  const std::string at = std::to_string(100 + 40 * i);
  const bool inV = (desc.forms & form::V) != 0;
  if (desc.hasRanges() && (desc.forms & form::Const) != 0)
    return std::to_string(std::max<std::int64_t>(desc.ranges[0].low, 0));
  if (desc.type == Type::Bool) return inV ? "V" + at + ".0" : "Q1.0";
  if (!inV) return (desc.forms & form::Q) != 0 ? "QB1" : (desc.forms & form::I) != 0 ? "IB1" : "1";
  const Width width = widthOf(desc.type);
  return (width == Width::Byte ? "VB" : width == Width::Word ? "VW" : "VD") + at;
}
std::string sampleStatement(const Desc& desc) {
  std::string text(desc.stl);
  for (std::size_t i = 0; i < desc.operandCount; ++i)
    text += (i == 0 ? " " : ", ") + sampleOperand(desc.operands[i], i);
  return text;
}
/// Values in V that make most instructions write something.
void fill(Plant& plant) {
  for (std::uint32_t byte = 100; byte < 300; ++byte)
    plant.store.area(Area::V)[byte] = static_cast<std::uint8_t>(byte % 7 + 1);
  plant.set("SMB67=133 SMB77=133 event[10]=1 SMB1=255 ENO[0]=1");
}

}  // namespace

TEST(PowerFlow, ConditionalInstructionsNeedIt) {
  int count = 0, effective = 0;
  for (const Desc& desc : s7200Instructions().all()) {
    if (desc.execution != Execution::Conditional) continue;
    ++count;
    const std::string statement = sampleStatement(desc);
    SCOPED_TRACE(statement);
    for (const char* around : {"LDN SM0.0; ", "LSCR S0.0; LD SM0.0; "}) {
      Plant plant(around + statement);
      fill(plant);
      Concrete::Store before = plant.store;
      plant.scan();
      if (desc.eno) before.set(Reg::Eno, 0, 0, true);
      EXPECT_TRUE(plant.store == before) << around;
      EXPECT_TRUE(plant.outside.hazards().empty());
      EXPECT_TRUE(plant.outside.signals.empty());
    }
    Plant plant("LD SM0.0; " + statement);
    fill(plant);
    const Concrete::Store before = plant.store;
    plant.scan();
    const bool hasErrors = !plant.outside.hazards().empty();
    const bool acts = !(plant.store == before) || hasErrors || !plant.outside.signals.empty();
    effective += acts ? 1 : 0;
  }
  EXPECT_GT(count, 100);
  EXPECT_GT(effective, count * 9 / 10) << "the samples say little if most of them do nothing anyway";
}

TEST(PowerFlow, SkippedBoxesLeaveEnoByChoice) {
  Plant plant("LDN SM0.0; INCB VB0; LD SM0.0; AENO; = Q0.0");
  plant.set("ENO[0]=1 Q0.0=1");
  EXPECT_EQ(plant.scan().value("Q0.0"), 0U);
  ASSERT_TRUE(plant.choices.set("skipped-eno", "kept"));
  plant.set("ENO[0]=1");
  EXPECT_EQ(plant.scan().value("Q0.0"), 1U);
}

TEST(PowerFlow, SkippedBoxesOfEveryKindKeepEnoByChoice) {
  int count = 0;
  for (const Desc& desc : s7200Instructions().all()) {
    if (desc.execution != Execution::Conditional || !desc.eno) continue;
    ++count;
    for (const std::uint64_t eno : {0U, 1U}) {
      Plant plant("LDN SM0.0; " + sampleStatement(desc));
      ASSERT_TRUE(plant.choices.set("skipped-eno", "kept"));
      plant.set("ENO[0]", eno);
      EXPECT_EQ(plant.scan().value("ENO[0]"), eno) << desc.stl;
    }
  }
  EXPECT_GT(count, 100);
}

TEST(PowerFlow, EnoFollowsTheLastBox) {
  // 001:2276-2278: a box without error sets ENO, one with an error clears it; AENO ANDs it into the top.
  Plant plant("LD SM0.0; MOVB 1, VB0; AENO; = Q0.0; LD SM0.0; /I VW2, VW4; AENO; = Q0.1");
  plant.scan();
  EXPECT_EQ(plant.value("QB0"), 0b01U);
  EXPECT_EQ(plant.outside.hazards(), std::vector<Hazard>{Hazard::DivideByZero});
  plant.set("VW2=3").scan();
  EXPECT_EQ(plant.value("QB0"), 0b11U);
}

}  // namespace rungproof::manual
