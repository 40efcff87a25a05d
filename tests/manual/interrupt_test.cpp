// Interrupts (001:5327-5547): enabling, attaching, what is saved around a routine, what is forbidden in it.
#include "example.hpp"

namespace rungproof::manual {
namespace {

constexpr PouKind mainBlock = PouKind::Main, sub = PouKind::Subroutine, routine = PouKind::Interrupt;
using Signals = std::vector<std::pair<Signal, std::uint32_t>>;

}  // namespace

TEST(Interrupt, EnableAndDisableShowInSm44) {
  check({
      {"ENI", "", "interrupts[0]=1 SM4.4=1"},
      {"DISI", "interrupts[0]=1 SM4.4=1", "interrupts[0]=0 SM4.4=0"},
      {"LDN SM0.0; ENI", "", "ENO[0]=0"},
      {"LDN SM0.0; DISI", "interrupts[0]=1 SM4.4=1", "ENO[0]=0"},
  });
}

TEST(Interrupt, AttachAndDetach) {
  check({
      {"ATCH 0, 10", "", "event[10]=1"},
      {"ATCH 127, 33", "event[33]=5", "event[33]=128"},  // a new routine replaces the old one (001:5370)
      {"DTCH 10", "event[10]=1 event[11]=1", "event[10]=0"},
      {"CEVNT 10", "event[10]=1", ""},
      {"LDN SM0.0; ATCH 0, 10", "", "ENO[0]=0"},
      {"LDN SM0.0; DTCH 10", "event[10]=1", "ENO[0]=0"},
      {"LDN SM0.0; CEVNT 10", "event[10]=1", "ENO[0]=0"},
  });
}

TEST(Interrupt, TheQueuesHearOfIt) {
  Plant plant("LD I0.0; ATCH 3, 10; DTCH 11; CEVNT 12");
  plant.scan();
  EXPECT_TRUE(plant.outside.signals.empty());
  plant.set("I0.0=1").scan();
  EXPECT_EQ(plant.outside.signals,
            (Signals{{Signal::EventAttached, 10}, {Signal::EventDetached, 11}, {Signal::EventsCleared, 12}}));
}

TEST(Interrupt, AnInputOfACounterCannotBeAttached) {
  // Code 0002. HSC0 in mode 1 uses I0.0 and I0.2 and leaves I0.1 free (001:4211); mode + 1 stands in the register.
  check({
      {"ATCH 0, 0", "HC.mode[0]=2", "", "0002"},
      {"ATCH 0, 5", "HC.mode[0]=2", "", "0002"},
      {"ATCH 0, 2", "HC.mode[0]=2", "event[2]=1"},
      {"ATCH 0, 3", "HC.mode[0]=4", "", "0002"},  // mode 3: I0.1 is the direction
      {"ATCH 0, 4", "HC.mode[0]=4", "event[4]=1"},
      {"ATCH 0, 2", "HC.mode[3]=1", "", "0002"},  // HSC3 counts I0.1
      {"ATCH 0, 7", "HC.mode[4]=1", "", "0002"},  // HSC4 counts I0.3
      {"ATCH 0, 6", "HC.mode[1]=1 HC.mode[5]=1", "event[6]=1"},
      {"ATCH 0, 0", "HC.mode[0]=13", "event[0]=1"},   // mode 12 uses no input
      {"ATCH 0, 12", "HC.mode[0]=2", "event[12]=1"},  // CV = PV of HSC0 itself
  });
}

TEST(Interrupt, ForbiddenInARoutine) {
  // ENI and DISI are error 0004 there (001:5426), also in the subroutine it calls.
  Plant plant({{mainBlock, 0, "LD SM0.0"}, {routine, 0, "LD SM0.0; ENI; CALL 0"}, {sub, 0, "DISI"}});
  plant.interruptBefore[0] = 0;
  plant.set("interrupts[0]=0 SM4.4=1").scan();
  EXPECT_EQ(plant.value("interrupts[0]"), 0U);
  EXPECT_EQ(plant.value("SM4.4"), 1U);
  EXPECT_EQ(plant.outside.hazards(), (std::vector<Hazard>{Hazard::NotInInterrupt, Hazard::NotInInterrupt}));
}

TEST(Interrupt, SavesStackAccumulatorsStatusAndEno) {
  // 001:5430. The routine changes all of them; V is not saved.
  Plant plant({{mainBlock, 0, "LD I0.0; LD SM0.0; MOVD 5, AC1; = Q0.0; LPP; = Q0.1"},
               {routine, 0, "LDN SM0.0; LDN SM0.0; LD SM0.0; INCD AC1; ANDB 0, VB0; MOVB *AC2, VB1; MOVB 1, VB2"}});
  plant.interruptBefore[3] = 0;
  plant.set("I0.0=1 VB0=7 AC2=16#FF000000 SMB1=0").scan();
  EXPECT_EQ(plant.value("QB0"), 0b11U);
  EXPECT_EQ(plant.value("AC1"), 5U);
  EXPECT_EQ(plant.value("SM1.0"), 0U) << "ANDB set it in the routine";
  EXPECT_EQ(plant.value("ENO[0]"), 1U);
  EXPECT_EQ(plant.outside.hazards(), std::vector<Hazard>{Hazard::BadIndirectAddress}) << "clears ENO in the routine";
  EXPECT_EQ(plant.value("VB0"), 0U);
  EXPECT_EQ(plant.value("VB2"), 1U);
}

TEST(Interrupt, StackAtEntryAndConditionalReturn) {
  const std::vector<Block> blocks = {
      {mainBlock, 0, "LD SM0.0"}, {routine, 5, "= Q0.0; LPP; = Q0.1; LD I0.0; CRETI; LD SM0.0; = Q0.2; RETI; = Q0.3"}};
  Plant plant(blocks);
  plant.interruptBefore[0] = 5;
  plant.set("QB0=2").scan();
  EXPECT_EQ(plant.value("QB0"), 0b101U);
  plant.set("QB0=0 I0.0=1").scan();
  EXPECT_EQ(plant.value("QB0"), 0b001U);
  Plant zero(blocks);
  ASSERT_TRUE(zero.choices.set("interrupt-stack", "zero"));
  zero.interruptBefore[0] = 5;
  zero.scan();
  EXPECT_EQ(zero.value("QB0"), 0b100U);
}

TEST(Interrupt, CallInARoutineSavesOrSharesTheStack) {
  // 001:6765 against 001:5444. The routine's stack is 0 with 1 below; the subroutine pushes a 1.
  for (const bool shared : {false, true}) {
    Plant plant({{mainBlock, 0, "LD SM0.0"},
                 {routine, 0, "LDN SM0.0; LD SM0.0; CALL 0; = Q0.0"},
                 {sub, 0, "LPP; = Q0.1; LDN SM0.0"}});
    ASSERT_TRUE(plant.choices.set("interrupt-call-stack", shared ? "shared" : "saved"));
    plant.interruptBefore[0] = 0;
    plant.set("QB0=255").scan();
    EXPECT_EQ(plant.value("Q0.0"), shared ? 0U : 1U);
    EXPECT_EQ(plant.value("Q0.1"), 0U);
  }
}

TEST(Interrupt, SharedStackShowsTheRoutinesLevels) {
  Plant plant({{mainBlock, 0, "LD SM0.0"}, {routine, 0, "LD SM0.0; LD SM0.0; CALL 0"}, {sub, 0, "LPP; = Q0.1"}});
  ASSERT_TRUE(plant.choices.set("interrupt-call-stack", "shared"));
  plant.interruptBefore[0] = 0;
  EXPECT_EQ(plant.scan().value("Q0.1"), 1U);
}

TEST(Interrupt, HasItsOwnLocalMemory) {
  Plant plant({{mainBlock, 0, "LD SM0.0; MOVB 1, LB0; MOVB LB0, VB0"}, {routine, 0, "MOVB LB0, VB1; MOVB 9, LB0"}});
  plant.interruptBefore[2] = 0;
  plant.freshLocal = 0x33;
  plant.scan();
  EXPECT_EQ(plant.value("VW0"), 0x0133U);
}

TEST(Interrupt, ASegmentDoesNotReachIntoARoutine) {
  Plant plant({{mainBlock, 0, "LSCR S0.0; LD SM0.0; = Q0.0; SCRE"}, {routine, 0, "LD SM0.0; = Q0.1"}});
  plant.interruptBefore[2] = 0;
  plant.set("Q0.0=1").scan();
  EXPECT_EQ(plant.value("QB0"), 0b10U) << "inactive segment around, active routine inside";
}

}  // namespace rungproof::manual
