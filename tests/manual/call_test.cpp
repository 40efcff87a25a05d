// Subroutines (001:6731-6838): stack, accumulators, local memory, parameters, nesting.
#include "plant.hpp"

namespace rungproof::manual {
namespace {

constexpr PouKind mainBlock = PouKind::Main, sub = PouKind::Subroutine, routine = PouKind::Interrupt;

}  // namespace

TEST(Call, CalleeStartsWithStack1000AndTheCallersComesBack) {
  // 001:6765. The main program leaves 0, 1, 1 on the stack; the subroutine sees 1, then 0s.
  Plant plant({{mainBlock, 0, "LD I0.0; LD I0.1; LD SM0.0; CALL 3; = Q0.0; LPP; = Q0.1; LPP; = Q0.2"},
               {sub, 3, "= Q1.0; LPP; = Q1.1; LPP; = Q1.2; LDN SM0.0; LDN SM0.0"}});
  plant.set("I0.0=1 I0.1=0 Q1.1=1 Q1.2=1").scan();
  EXPECT_EQ(plant.value("QB1"), 0b001U);
  EXPECT_EQ(plant.value("QB0"), 0b101U);
}

TEST(Call, NothingHappensWithoutPowerFlow) {
  Plant plant({{mainBlock, 0, "LD I0.0; CALL 1, VB0, VB1"},
               {sub, 1, "MOVB LB0, VB2; MOVB 9, LB1", {"IN BYTE LB0", "OUT BYTE LB1"}}});
  plant.set("VB0=5 VB1=6 ENO[0]=1").scan();
  EXPECT_EQ(plant.value("VB1"), 6U);
  EXPECT_EQ(plant.value("VB2"), 0U);
  EXPECT_EQ(plant.value("ENO[0]"), 0U);
  plant.set("I0.0=1").scan();
  EXPECT_EQ(plant.value("VB1"), 9U);
  EXPECT_EQ(plant.value("VB2"), 5U);
  EXPECT_EQ(plant.value("ENO[0]"), 1U);
}

TEST(Call, AccumulatorsAndStatusBitsAreShared) {
  Plant plant({{mainBlock, 0, "LD SM0.0; MOVD 5, AC0; CALL 1; MOVD AC0, VD0"}, {sub, 1, "INCD AC0; ANDB 0, VB9"}});
  plant.scan();
  EXPECT_EQ(plant.value("VD0"), 6U);
  EXPECT_EQ(plant.value("SM1.0"), 1U) << "the zero result of ANDB is seen after the return";
}

TEST(Call, LocalMemoryBelongsToTheLevel) {
  // Main writes LB10; the subroutine finds what its own frame holds, writes there, and main's byte stays.
  Plant plant({{mainBlock, 0, "LD SM0.0; MOVB 7, LB10; CALL 1; MOVB LB10, VB0; CALL 2; MOVB LB10, VB3"},
               {sub, 1, "MOVB LB10, VB1; MOVB 8, LB10; CALL 2; MOVB LB10, VB4"},
               {sub, 2, "MOVB LB10, VB2; MOVB 99, LB10"}});
  plant.freshLocal = 0x5A;
  plant.scan();
  EXPECT_EQ(plant.value("VB0"), 7U);
  EXPECT_EQ(plant.value("VB1"), 0x5AU);
  EXPECT_EQ(plant.value("VB2"), 0x5AU);
  EXPECT_EQ(plant.value("VB3"), 7U);
  EXPECT_EQ(plant.value("VB4"), 8U);
}

TEST(Call, MainFindsNothingOfTheLastScanInLocalMemory) {
  Plant plant("LD SM0.0; MOVB LB3, VB0; MOVB 44, LB3");
  plant.freshLocal = 0x21;
  EXPECT_EQ(plant.scan().value("VB0"), 0x21U);
  EXPECT_EQ(plant.scan().value("VB0"), 0x21U);
}

TEST(Call, ParametersLieInOrder) {
  // Figure 5-9 (001:2424-2431): BOOL L0.0, BYTE LB1, INT LW2, IN_OUT BYTE LB4, OUT BOOL L5.0, OUT WORD LW6.
  Plant plant({{mainBlock, 0, "LD SM0.0; CALL 0, I0.3, VB10, VW12, VB14, Q0.5, VW16"},
               {sub,
                0,
                "MOVB LB0, VB100; MOVB LB1, VB101; MOVW LW2, VW102; MOVB LB4, VB104; INCB LB4; = L5.0; MOVW LW2, LW6",
                {"IN BOOL L0.0", "IN BYTE LB1", "IN INT LW2", "IN_OUT BYTE LB4", "OUT BOOL L5.0", "OUT WORD LW6",
                 "TEMP BYTE LB8"}}});
  plant.set("I0.3=1 VB10=11 VW12=-1212 VB14=14").scan();
  EXPECT_EQ(plant.value("VB100"), 1U);
  EXPECT_EQ(plant.value("VB101"), 11U);
  EXPECT_EQ(plant.value("VW102"), 0x10000U - 1212U);
  EXPECT_EQ(plant.value("VB104"), 14U);
  EXPECT_EQ(plant.value("VB14"), 15U) << "IN_OUT comes back";
  EXPECT_EQ(plant.value("VB10"), 11U) << "IN does not";
  EXPECT_EQ(plant.value("Q0.5"), 1U);
  EXPECT_EQ(plant.value("VW16"), 0x10000U - 1212U);
}

TEST(Call, PointersConstantsAndAddresses) {
  // 001:6782: the value behind a pointer, a constant, an address as a number, and the address in a pointer for STRING.
  Plant plant({{mainBlock, 0, "LD SM0.0; MOVD &VB50, AC1; CALL 0, *AC1, 16#1234, &VB60, *AC1, VD80"},
               {sub,
                0,
                "MOVB LB0, VB100; MOVW LW1, VW102; MOVD LD3, VD104; MOVD LD7, VD108; MOVR 2.5, LD11",
                {"IN BYTE LB0", "IN WORD LW1", "IN DWORD LD3", "IN STRING LD7", "OUT REAL LD11"}}});
  plant.set("VB50=77").scan();
  EXPECT_EQ(plant.value("VB100"), 77U);
  EXPECT_EQ(plant.value("VW102"), 0x1234U);
  EXPECT_EQ(plant.value("VD104"), 0x0800003CU);
  EXPECT_EQ(plant.value("VD108"), 0x08000032U);
  EXPECT_FLOAT_EQ(plant.real("VD80"), 2.5F);
}

TEST(Call, StringConstantsAreReadThroughAPointer) {
  // 001:6804, 001:6836: the subroutine uses *LD0; the text itself cannot be written.
  Plant plant({{mainBlock, 0, "LD SM0.0; CALL 0, \"FIRST\"; CALL 0, \"2ND\"; CALL 1, \"2ND\""},
               {sub, 0, "SCPY *LD0, VB0; SLEN *LD0, AC0; MOVB AC0, VB20; INCB VB21", {"IN STRING LD0"}},
               {sub, 1, "SCPY VB0, *LD0", {"IN STRING LD0"}}});
  plant.scan();
  EXPECT_EQ(plant.value("VD0"), 0x03'32'4E'44U) << "3, 2, N, D";
  EXPECT_EQ(plant.value("VW4"), 0x5354U) << "what the longer text left";
  EXPECT_EQ(plant.value("VB20"), 3U);
  EXPECT_EQ(plant.value("VB21"), 2U);
  EXPECT_EQ(plant.outside.hazards(), std::vector<Hazard>{Hazard::BadIndirectAddress});
}

TEST(Call, OutputsGoThroughPointers) {
  Plant plant({{mainBlock, 0, "LD SM0.0; CALL 0, *VD0, *VD4"},
               {sub, 0, "INCW LW0; MOVB 3, LB2", {"IN_OUT INT LW0", "OUT BYTE LB2"}}});
  plant.set("VD0=16#08000014 VD4=16#04000002 VW20=41").scan();
  EXPECT_EQ(plant.value("VW20"), 42U);
  EXPECT_EQ(plant.value("MB2"), 3U);
}

TEST(Call, AnOutputThatIsNotAssignedReturnsWhatLayThere) {
  // 001:6784: S writes the output only with power flow.
  Plant plant({{mainBlock, 0, "LD SM0.0; CALL 0, Q0.0"}, {sub, 0, "LD I0.0; S L0.0, 1", {"OUT BOOL L0.0"}}});
  EXPECT_EQ(plant.scan().value("Q0.0"), 0U);
  plant.freshLocal = 1;
  EXPECT_EQ(plant.scan().value("Q0.0"), 1U);
}

TEST(Call, BadPointersAreErrors) {
  Plant plant({{mainBlock, 0, "LD SM0.0; CALL 0, *VD0"}, {sub, 0, "INCW LW0", {"IN_OUT INT LW0"}}});
  plant.set("VD0=16#FF000000").scan();
  ASSERT_FALSE(plant.outside.hazards().empty());
  EXPECT_EQ(plant.outside.hazards()[0], Hazard::BadIndirectAddress);
  EXPECT_EQ(plant.value("SM4.3"), 1U);
}

TEST(Call, ReturnsWithPowerFlowOnly) {
  Plant plant({{mainBlock, 0, "LD SM0.0; CALL 0; MOVB 1, VB2"},
               {sub, 0, "LD I0.0; CRET; LD SM0.0; MOVB 1, VB0; RET; MOVB 1, VB1"}});
  plant.scan();
  EXPECT_EQ(plant.value("VW0"), 0x0100U);
  plant.set("VB0=0 VB2=0 I0.0=1").scan();
  EXPECT_EQ(plant.value("VW0"), 0U);
  EXPECT_EQ(plant.value("VB2"), 1U) << "the caller goes on";
}

TEST(Call, EightLevelsFromMain) {
  // 001:6744: each call adds 1 to VB0; the ninth nested call is error 0008 and is not made.
  const std::string recursive = "LDB< VB0, VB1; CALL 0";
  Plant plant({{mainBlock, 0, "LD SM0.0; CALL 0"}, {sub, 0, "INCB VB0; LDB< VB0, VB1; CALL 0"}});
  plant.set("VB1=8").scan();
  EXPECT_EQ(plant.value("VB0"), 8U);
  EXPECT_TRUE(plant.outside.hazards().empty());
  plant.set("VB0=0 VB1=20").scan();
  EXPECT_EQ(plant.value("VB0"), 8U);
  ASSERT_EQ(plant.outside.hazards().size(), 1U);
  EXPECT_EQ(plant.outside.hazards()[0], Hazard::NestingTooDeep);
  EXPECT_EQ(plant.value("SM4.3"), 1U);
}

TEST(Call, OneLevelFromAnInterruptRoutine) {
  Plant plant({{mainBlock, 0, "LD SM0.0"},
               {routine, 0, "LD SM0.0; CALL 0"},
               {sub, 0, "INCB VB0; LD I0.0; CALL 1"},
               {sub, 1, "INCB VB1"}});
  plant.interruptBefore[0] = 0;
  plant.scan();
  EXPECT_EQ(plant.value("VB0"), 1U);
  EXPECT_TRUE(plant.outside.hazards().empty());
  plant.set("I0.0=1").scan();
  EXPECT_EQ(plant.value("VB0"), 2U);
  EXPECT_EQ(plant.value("VB1"), 0U);
  ASSERT_EQ(plant.outside.hazards().size(), 1U);
  EXPECT_EQ(plant.outside.hazards()[0], Hazard::NestingTooDeep);
}

TEST(Call, InterruptsInASubroutineReturnThere) {
  Plant plant({{mainBlock, 0, "LD SM0.0; CALL 0; MOVB LB0, VB2"},
               {sub, 0, "MOVB 5, LB0; = Q0.0; MOVB LB0, VB0"},
               {routine, 0, "MOVB 6, LB0; CALL 1; MOVB LB0, VB3"},
               {sub, 1, "MOVB 9, LB0"}});
  plant.interruptBefore[5] = 0;
  plant.scan();
  EXPECT_EQ(plant.value("VB0"), 5U);
  EXPECT_EQ(plant.value("VB2"), 0U);
  EXPECT_EQ(plant.value("VB3"), 6U);
  EXPECT_EQ(plant.value("Q0.0"), 1U);
}

}  // namespace rungproof::manual
