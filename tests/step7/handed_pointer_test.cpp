// POINTER and ANY as parameters: the bytes that the called block finds, and what it reaches through them. Layouts:
// 002:2181-2288 (ten bytes: 16#10, type, number, data block, pointer; area codes 002:1698-1707); the bit address of a
// byte n is 8 n.
#include <gtest/gtest.h>

#include "engine/simulator.hpp"
#include "frontend/step7/source_writer.hpp"
#include "tests/step7/read7.hpp"

namespace rungproof {
namespace {

/// DB10 "Motor": speed at 4, row at 6, text at 26, moment at 32, name at 40 (002:673-679).
constexpr const char* motor =
    "DATA_BLOCK DB 10\nSTRUCT\n  on : BOOL;\n  mode : WORD;\n  speed : INT;\n  row : ARRAY [1 .. 10] OF INT;\n"
    "  text : ARRAY [1 .. 5] OF CHAR;\n  moment : DATE_AND_TIME;\n  name : STRING [4];\nEND_STRUCT;\nBEGIN\n"
    "END_DATA_BLOCK\n";

/// FC 1 takes an ANY and leaves its bytes in MB 100 to 109; FC 2 does so with a POINTER, MB 100 to 105.
constexpr const char* takers =
    "FUNCTION FC 1 : VOID\nVAR_INPUT\n  p : ANY;\nEND_VAR\nBEGIN\nNETWORK\nL P##p; LAR1;\nL D [AR1,P#0.0]; T MD 100;\n"
    "L W [AR1,P#4.0]; T MW 104;\nL D [AR1,P#6.0]; T MD 106;\nEND_FUNCTION\n"
    "FUNCTION FC 2 : VOID\nVAR_INPUT\n  p : POINTER;\nEND_VAR\nBEGIN\nNETWORK\nL P##p; LAR1;\nL W [AR1,P#0.0]; T MW "
    "100;\n"
    "L D [AR1,P#2.0]; T MD 102;\nEND_FUNCTION\n";

std::string ob1Of(const std::string& statements) {
  return "ORGANIZATION_BLOCK OB 1\nVAR_TEMP\n  start : ARRAY [0 .. 19] OF BYTE;\n  own : INT;\n  many : ANY;\n"
         "  rec : STRUCT\n    a : INT;\n    b : INT;\n  END_STRUCT;\nEND_VAR\nBEGIN\nNETWORK\n" +
         statements + "\nEND_ORGANIZATION_BLOCK\n";
}

struct PointerRun {
  explicit PointerRun(const std::string& text) : program(read7(text)), simulator(program) {
    EXPECT_EQ(findings7(program), "");
    simulator.scan();
    EXPECT_TRUE(simulator.isRunning());
  }
  std::string bytes(std::uint32_t first, std::uint32_t count) const {
    std::string text;
    for (std::uint32_t i = 0; i < count; ++i)
      text += fmt::format("{}{:02X}", i == 0 ? "" : " ", simulator.read(direct(Area::M, Width::Byte, first + i)));
    return text;
  }
  std::uint64_t word(std::uint32_t byte) const { return simulator.read(direct(Area::M, Width::Word, byte)); }

  Program program;
  Simulator simulator;
};

std::string anyOf(const std::string& actual) {
  const PointerRun run(std::string(motor) + takers + ob1Of("CALL FC 1 (p := " + actual + ");"));
  return run.bytes(100, 10);
}

TEST(HandedPointer, AnyHasTenBytes) {
  EXPECT_EQ(anyOf("P#DB60.DBX 0.0 BYTE 26"), "10 02 00 1A 00 3C 84 00 00 00");  // 002:2275-2288
  EXPECT_EQ(anyOf("P#DB10.DBX 30.0 INT 22"), "10 05 00 16 00 0A 84 00 00 F0");
  EXPECT_EQ(anyOf("P#I20.0 WORD 1"), "10 04 00 01 00 00 81 00 00 A0");
  EXPECT_EQ(anyOf("P#Q 2.0 BOOL 8"), "10 01 00 08 00 00 82 00 00 10");
  EXPECT_EQ(anyOf("P#P 0.0 VOID 0"), "10 00 00 00 00 00 80 00 00 00");
  EXPECT_EQ(anyOf("MW 40"), "10 04 00 01 00 00 83 00 01 40");
  EXPECT_EQ(anyOf("M 40.3"), "10 01 00 01 00 00 83 00 01 43");
  EXPECT_EQ(anyOf("DB10.DBD 2"), "10 06 00 01 00 0A 84 00 00 10");
}

// Arrays and structures count their bytes, an array of CHAR its characters (002:2249).
TEST(HandedPointer, NamesGiveTheTypeOfWhatTheyStandFor) {
  EXPECT_EQ(anyOf("DB10.speed"), "10 05 00 01 00 0A 84 00 00 20");
  EXPECT_EQ(anyOf("DB10.on"), "10 01 00 01 00 0A 84 00 00 00");
  EXPECT_EQ(anyOf("DB10.row"), "10 02 00 14 00 0A 84 00 00 30");
  EXPECT_EQ(anyOf("DB10.row[3]"), "10 05 00 01 00 0A 84 00 00 50");
  EXPECT_EQ(anyOf("DB10.text"), "10 03 00 05 00 0A 84 00 00 D0");
  EXPECT_EQ(anyOf("DB10.moment"), "10 0E 00 01 00 0A 84 00 01 00");
}

// Local data of the caller is area V for the block that is called: 16#87 (002:1707).
TEST(HandedPointer, LocalDataOfTheCallerIsAreaV) {
  EXPECT_EQ(anyOf("#own"), "10 05 00 01 00 00 87 00 00 A0");  // L 20
  EXPECT_EQ(anyOf("#rec"), "10 02 00 04 00 00 87 00 01 00");  // behind the ten bytes of the ANY: L 32
  EXPECT_EQ(anyOf("P#L 20.0 INT 1"), "10 05 00 01 00 00 87 00 00 A0");
}

TEST(HandedPointer, APointerHasSixBytes) {
  const auto pointerOf = [](const std::string& actual) {
    const PointerRun run(std::string(motor) + takers + ob1Of("CALL FC 2 (p := " + actual + ");"));
    return run.bytes(100, 6);
  };
  EXPECT_EQ(pointerOf("P#M40.0"), "00 00 83 00 01 40");
  EXPECT_EQ(pointerOf("MW 40"), "00 00 83 00 01 40");
  EXPECT_EQ(pointerOf("M 40.1"), "00 00 83 00 01 41");
  EXPECT_EQ(pointerOf("P#DB1.DBX20.0"), "00 01 84 00 00 A0");
  EXPECT_EQ(pointerOf("DB10.speed"), "00 0A 84 00 00 20");
  EXPECT_EQ(pointerOf("DB10.row"), "00 0A 84 00 00 30");
  EXPECT_EQ(pointerOf("#own"), "00 00 87 00 00 A0");
}

// An ANY in local data is handed on as it is (002:2271-2273).
TEST(HandedPointer, ATemporaryAnyIsHandedOn) {
  const PointerRun run(
      std::string(takers) +
      ob1Of("L P##many; LAR1; L W#16#1005; T W [AR1,P#0.0]; L 7; T W [AR1,P#2.0]; L 12; T W [AR1,P#4.0];"
            "L P#DBX 3.0; T D [AR1,P#6.0]; CALL FC 1 (p := #many);"));
  EXPECT_EQ(run.bytes(100, 10), "10 05 00 07 00 0C 84 00 00 18");
}

// A variable of the instance: the instance data block and the place in it; the inner instance begins at byte 2.
TEST(HandedPointer, StaticDataStandsInTheInstance) {
  const PointerRun run(
      std::string(takers) +
      "FUNCTION_BLOCK FB 5\nVAR\n  x : INT;\n  list : ARRAY [0 .. 3] OF BYTE;\nEND_VAR\nBEGIN\nNETWORK\n"
      "CALL FC 1 (p := #list);\nEND_FUNCTION_BLOCK\n"
      "FUNCTION_BLOCK FB 6\nVAR\n  y : INT;\n  inner : FB 5;\nEND_VAR\nBEGIN\nNETWORK\nCALL #inner;\n"
      "END_FUNCTION_BLOCK\nDATA_BLOCK DB 7\nFB 6\nBEGIN\nEND_DATA_BLOCK\n" +
      ob1Of("CALL FB 6, DB 7;"));
  EXPECT_EQ(run.bytes(100, 10), "10 02 00 04 00 07 84 00 00 20");
}

// The ANY of an FB stands in its instance, and P## gives its place there: area DI (002:2212).
TEST(HandedPointer, AnyOfAFunctionBlockStandsInItsInstance) {
  PointerRun run(
      "FUNCTION_BLOCK FB 5\nVAR_INPUT\n  n : INT;\n  p : ANY;\nEND_VAR\nBEGIN\nNETWORK\n"
      "L P##p; T MD 96; LAR1; L W [AR1,P#2.0]; T MW 100; L W [AR1,P#4.0]; T MW 102; L D [AR1,P#6.0]; T MD 104;\n"
      "END_FUNCTION_BLOCK\nDATA_BLOCK DB 7\nFB 5\nBEGIN\nEND_DATA_BLOCK\n" +
      ob1Of("A M 0.0; JC old; CALL FB 5, DB 7 (n := 1, p := P#M 10.0 BYTE 4); JU end;\n"
            "old: CALL FB 5, DB 7; end: NOP 0; SET; = M 0.0; L DB7.DBW 2; T MW 110;"));
  for (int scan = 0; scan < 2; ++scan) {  // what is not given stays in the instance (002:255)
    EXPECT_EQ(run.bytes(96, 12), "85 00 00 10 00 04 00 00 83 00 00 50");
    EXPECT_EQ(run.bytes(110, 2), "10 02");
    run.simulator.scan();
  }
}

// P## counts from where the data of the FB begin; where they begin in the instance AR2 says, which a multi-instance
// adds itself. The inner FB's list lies 2 bytes behind its beginning, which lies at byte 2 of DB7: bytes 4 to 7.
TEST(HandedPointer, AMultiInstanceAddsAr2ToAPointerToItsData) {
  const PointerRun run(
      "FUNCTION_BLOCK FB 5\nVAR\n  x : INT;\n  list : ARRAY [0 .. 3] OF BYTE;\nEND_VAR\nBEGIN\nNETWORK\n"
      "L P##list; T MD 96; LAR1; TAR2; +AR1; L 77; T DIB [AR1,P#1.0]; L B [AR1,P#1.0]; T MB 100;\nEND_FUNCTION_BLOCK\n"
      "FUNCTION_BLOCK FB 6\nVAR\n  y : INT;\n  inner : FB 5;\nEND_VAR\nBEGIN\nNETWORK\nCALL #inner;\n"
      "END_FUNCTION_BLOCK\nDATA_BLOCK DB 7\nFB 6\nBEGIN\nEND_DATA_BLOCK\n" +
      ob1Of("CALL FB 6, DB 7; L DB7.DBB 5; T MB 101;"));
  EXPECT_EQ(run.bytes(96, 6), "85 00 00 10 4D 4D");
}

// What a block was given it may hand on: the same bytes.
TEST(HandedPointer, FormalPointersAreHandedOn) {
  const std::string handing = "VAR_INPUT\n  q : ANY;\nEND_VAR\nBEGIN\nNETWORK\nCALL FC 1 (p := #q);\n";
  const std::string blocks = std::string(takers) + "FUNCTION FC 3 : VOID\n" + handing +
                             "END_FUNCTION\nFUNCTION_BLOCK FB 5\n" + handing +
                             "END_FUNCTION_BLOCK\nDATA_BLOCK DB 7\nFB 5\nBEGIN\nEND_DATA_BLOCK\n";
  for (const char* call : {"CALL FC 3 (q := P#M 10.0 BYTE 4);", "CALL FB 5, DB 7 (q := P#M 10.0 BYTE 4);"}) {
    const PointerRun run(blocks + ob1Of(call));
    EXPECT_EQ(run.bytes(100, 10), "10 02 00 04 00 00 83 00 00 50") << call;
  }
}

// Complex types come by a POINTER: that of an FC in area V, that of an IN_OUT of an FB in its instance.
TEST(HandedPointer, ComplexParametersHaveAPointerToo) {
  const std::string body = "L P##s; LAR1; L W [AR1,P#0.0]; T MW 100; L D [AR1,P#2.0]; T MD 102;\n";
  const std::string declaration = "  s : ARRAY [1 .. 10] OF INT;\nEND_VAR\nBEGIN\nNETWORK\n";
  const PointerRun function(std::string(motor) + "FUNCTION FC 3 : VOID\nVAR_INPUT\n" + declaration + body +
                            "END_FUNCTION\n" + ob1Of("CALL FC 3 (s := DB10.row);"));
  EXPECT_EQ(function.bytes(100, 6), "00 0A 84 00 00 30");
  const PointerRun block(std::string(motor) + "FUNCTION_BLOCK FB 3\nVAR_INPUT\n  n : INT;\nEND_VAR\nVAR_IN_OUT\n" +
                         declaration + body + "END_FUNCTION_BLOCK\nDATA_BLOCK DB 7\nFB 3\nBEGIN\nEND_DATA_BLOCK\n" +
                         ob1Of("CALL FB 3, DB 7 (n := 5, s := DB10.row); L DB7.DBW 2; T MW 110;"));
  EXPECT_EQ(block.bytes(100, 6), "00 0A 84 00 00 30");
  EXPECT_EQ(block.word(110), 10U);
}

// The checksum of the course book (002:2290-2326), over an ANY of each area: the sum of the bytes, 0 for other types.
TEST(HandedPointer, ChecksumOverAnAny) {
  const std::string checksum =
      "FUNCTION FC 5 : INT\nVAR_INPUT\n  Area : ANY;\nEND_VAR\nVAR_TEMP\n  n : INT;\n  block : WORD;\n  sum : INT;\n"
      "END_VAR\nBEGIN\nNETWORK\nL 0; T #sum; L P##Area; LAR1; L B [AR1,P#1.0]; L 2; ==I; JCN end;\n"
      "L W [AR1,P#4.0]; T #block; OPN DB [#block]; L W [AR1,P#2.0]; L D [AR1,P#6.0]; LAR1; TAK;\n"
      "more: T #n; L B [AR1,P#0.0]; L #sum; +I; T #sum; +AR1 P#1.0; L #n; LOOP more;\n"
      "end: L #sum; T #RET_VAL;\nEND_FUNCTION\n";
  const std::string data =
      "DATA_BLOCK DB 60\nSTRUCT\n  b : ARRAY [0 .. 25] OF BYTE := B#16#FF, B#16#1, B#16#80, 22 (B#16#0), B#16#7F;\n"
      "END_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n";
  const PointerRun run(data + checksum +
                       ob1Of("L 1; T MB 10; L 2; T MB 11; L 3; T MB 12; L 4; T #rec.a; L 5; T #rec.b;\n"
                             "CALL FC 5 (Area := DB60.b, RET_VAL := MW 20);\n"
                             "CALL FC 5 (Area := P#M 10.0 BYTE 3, RET_VAL := MW 22);\n"
                             "CALL FC 5 (Area := P#M 10.0 WORD 3, RET_VAL := MW 24);\n"
                             "CALL FC 5 (Area := #rec, RET_VAL := MW 26);"));
  EXPECT_EQ(run.word(20), 255U + 1U + 128U + 127U);
  EXPECT_EQ(run.word(22), 6U);
  EXPECT_EQ(run.word(24), 0U);
  EXPECT_EQ(run.word(26), 9U);
}

// Data of the block that is open: its number (reading `number`), or 0 (reading `zero`).
TEST(HandedPointer, DataOfTheOpenBlock) {
  const auto bytesOf = [](const std::string& actual, const char* reading) {
    const Program program = read7(std::string(motor) + takers + ob1Of("OPN DB 10; CALL FC 1 (p := " + actual + ");"));
    EXPECT_EQ(findings7(program), "");
    SimulatorOptions options;
    EXPECT_TRUE(options.choices.set("open-block-pointer", reading));
    Simulator simulator(program, options);
    simulator.scan();
    std::string text;
    for (std::uint32_t i = 100; i < 110; ++i)
      text += fmt::format("{:02X}", simulator.read(direct(Area::M, Width::Byte, i)));
    return text;
  };
  EXPECT_EQ(bytesOf("DBW 4", "number"), "10040001000A84000020");
  EXPECT_EQ(bytesOf("DBX 1.3", "number"), "10010001000A8400000B");
  EXPECT_EQ(bytesOf("P#DBX 2.0 BYTE 4", "number"), "10020004000A84000010");
  EXPECT_EQ(bytesOf("DBW 4", "zero"), "10040001000084000020");
}

// What was written is what is printed.
TEST(HandedPointer, APointerOfTheOpenBlockIsPrintedAsItWasWritten) {
  for (const char* actual : {"P#DBX 2.0 BYTE 4", "DBW4", "DIX1.3", "T5", "C2"}) {
    const Program program = read7(std::string(motor) + takers + ob1Of("CALL FC 1 (p := " + std::string(actual) + ");"));
    EXPECT_NE(step7::writeSource(program, step7::MnemonicSet::International).find(actual), std::string::npos) << actual;
  }
}

// Timers and counters (general knowledge): the type 16#1D or 16#1C, one element, no data block, the number at the end;
// whether byte 6 repeats the type is open, here 0. A formal timer is the one that its block was given.
TEST(HandedPointer, AnyOfATimerOrACounter) {
  EXPECT_EQ(anyOf("T 5"), "10 1D 00 01 00 00 00 00 00 05");
  EXPECT_EQ(anyOf("C 2"), "10 1C 00 01 00 00 00 00 00 02");
  const PointerRun run(std::string(takers) +
                       "FUNCTION FC 3 : VOID\nVAR_INPUT\n  t : TIMER;\nEND_VAR\nBEGIN\nNETWORK\nCALL FC 1 (p := #t);\n"
                       "END_FUNCTION\n" +
                       ob1Of("CALL FC 3 (t := T 7);"));
  EXPECT_EQ(run.bytes(100, 10), "10 1D 00 01 00 00 00 00 00 07");
}

// An elementary parameter of an FC leads to what its caller gave, through a second FC too; a bit of a structure to that
// bit. Local data of the caller's caller has no pointer: any value, here 0.
TEST(HandedPointer, ElementaryParametersOfAnFc) {
  const auto bytesOf = [](const std::string& actual) {
    const PointerRun run(std::string(motor) + takers +
                         "FUNCTION FC 3 : VOID\nVAR_INPUT\n  x : INT;\nEND_VAR\nBEGIN\nNETWORK\nCALL FC 1 (p := #x);\n"
                         "END_FUNCTION\nFUNCTION FC 4 : VOID\nVAR_INPUT\n  y : INT;\nEND_VAR\nBEGIN\nNETWORK\n"
                         "CALL FC 3 (x := #y);\nEND_FUNCTION\n" +
                         ob1Of("OPN DB 10; CALL FC 4 (y := " + actual + ");"));
    return run.bytes(100, 10);
  };
  EXPECT_EQ(bytesOf("MW 40"), "10 05 00 01 00 00 83 00 01 40");
  EXPECT_EQ(bytesOf("DB10.speed"), "10 05 00 01 00 0A 84 00 00 20");
  EXPECT_EQ(bytesOf("DBW 6"), "10 05 00 01 00 0A 84 00 00 30");
  EXPECT_EQ(bytesOf("#own"), "10 05 00 01 00 00 00 00 00 00");
  EXPECT_EQ(bytesOf("7"), "10 05 00 01 00 00 00 00 00 00");
  const PointerRun run(
      "DATA_BLOCK DB 11\nSTRUCT\n  s : STRUCT\n    a : INT;\n    b : BOOL;\n    c : BOOL;\n  END_STRUCT;\n"
      "END_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n" +
      std::string(takers) +
      "FUNCTION FC 3 : VOID\nVAR_INPUT\n  s : STRUCT\n    a : INT;\n    b : BOOL;\n    c : BOOL;\n"
      "  END_STRUCT;\nEND_VAR\nBEGIN\nNETWORK\nCALL FC 1 (p := #s.c);\nEND_FUNCTION\n" +
      ob1Of("CALL FC 3 (s := DB11.s);"));
  EXPECT_EQ(run.bytes(100, 10), "10 01 00 01 00 0B 84 00 00 11");
}

// P## of an elementary parameter is the pointer to what the caller gives: P#M 40.0 is 16#83000140 (002:1698-1707),
// local data of the caller lie in area V. Of data blocks and constants it is any value, here 0.
TEST(HandedPointer, AddressOfAnElementaryParameter) {
  const auto addressOf = [](const std::string& actual) {
    const PointerRun run(
        std::string(motor) +
        "FUNCTION FC 3 : VOID\nVAR_INPUT\n  x : INT;\nEND_VAR\nBEGIN\nNETWORK\nL P##x; T MD 100;\nEND_FUNCTION\n"
        "FUNCTION FC 4 : VOID\nVAR_INPUT\n  y : INT;\nEND_VAR\nBEGIN\nNETWORK\nCALL FC 3 (x := #y);\nEND_FUNCTION\n" +
        ob1Of("CALL FC 3 (x := " + actual + ");"));
    return run.bytes(100, 4);
  };
  EXPECT_EQ(addressOf("MW 40"), "83 00 01 40");
  EXPECT_EQ(addressOf("IW 2"), "81 00 00 10");
  EXPECT_EQ(addressOf("QW 4"), "82 00 00 20");
  EXPECT_EQ(addressOf("PIW 256"), "80 00 08 00");
  EXPECT_EQ(addressOf("#own"), "87 00 00 A0");
  EXPECT_EQ(addressOf("DB10.speed"), "00 00 00 00");
  EXPECT_EQ(addressOf("7"), "00 00 00 00");
}

TEST(HandedPointer, WhatHasNoPointerIsRefused) {
  const auto findingOf = [](const std::string& statement) {
    return findings7(read7(std::string(takers) + "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n" + statement +
                           "\nEND_ORGANIZATION_BLOCK\n"));
  };
  EXPECT_NE(findingOf("CALL FC 2 (p := T 5);").find("only an ANY can name a timer or a counter"), std::string::npos)
      << findingOf("CALL FC 2 (p := T 5);");
  EXPECT_NE(findingOf("CALL FC 1 (p := MW [MD 4]);").find("as ANY"), std::string::npos);
  EXPECT_NE(findingOf("CALL FC 1 (p := P#M 2.0);"), "");
  EXPECT_NE(findingOf("CALL FC 1 (p := 5);").find("takes a pointer such as P#M 10.0 BYTE 4"), std::string::npos);
  EXPECT_NE(findingOf("CALL FC 2 (p := P#M 2.0 BYTE 4);").find("takes a pointer such as P#M 10.0"), std::string::npos);
}

}  // namespace
}  // namespace rungproof
