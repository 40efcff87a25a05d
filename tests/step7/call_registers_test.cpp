// What CALL leaves in the registers. It is compiled to `CDB; OPN DI m; TAR2; LAR2 P#DBX 0.0; UC FB n; LAR2; CDB`: the
// FB finds the DI of its caller in DB, its instance in DI and the place of its data in AR2; behind the call the
// instance is open in DB. That is general knowledge, so that proofs also cover a DB register that keeps its block.
#include "tests/step7/run7.hpp"

namespace rungproof {
namespace {

using test7::block, test7::lastRow, test7::Output, test7::proofOf;

std::string functionBlock(int number, const std::string& declarations, const std::string& statements) {
  std::string text = "FUNCTION_BLOCK FB " + std::to_string(number) + "\n" + declarations + "BEGIN\nNETWORK\n";
  std::istringstream in(statements);
  for (std::string one; std::getline(in, one, ';');) text += one + ";\n";
  return text + "END_FUNCTION_BLOCK\n";
}
std::string instanceOf(int fb, int db) {
  return "DATA_BLOCK DB " + std::to_string(db) + "\nFB " + std::to_string(fb) + "\nBEGIN\nEND_DATA_BLOCK\n";
}
std::string dataBlock(int number, int value) {
  return "DATA_BLOCK DB " + std::to_string(number) + "\nSTRUCT\n  X : INT := " + std::to_string(value) +
         ";\nEND_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n";
}

const std::string oneWord = "VAR\n  x : INT := 7;\nEND_VAR\n";
const std::string dataBlocks = dataBlock(5, 55) + dataBlock(6, 66);
const std::string looks = functionBlock(1, oneWord, "L DBNO;T MW 10;L DINO;T MW 12") + instanceOf(1, 1);
const std::string calls = "OPN DB 5;OPN DI 6;CALL FB 1, DB 1;L DBNO;T MW 14;L DINO;T MW 16";

// P#DBX 0.0 is 16#8400_0000. An instance within another one begins at its own place: byte 2 is P#DBX 2.0, bit 16.
TEST(CallRegisters, AddressRegister2HoldsThePlaceOfTheInstance) {
  const std::string inner = functionBlock(2, oneWord, "TAR2;T MD 20");
  const std::string outer =
      functionBlock(1, "VAR\n  a : INT;\n  part : FB 2;\nEND_VAR\n", "TAR2;T MD 24;CALL #part;TAR2;T MD 28");
  const std::string program = inner + outer + instanceOf(1, 1) + block(1, "CALL FB 1, DB 1");
  EXPECT_TRUE(lastRow(program, "MD20,MD24,MD28", {"--scans", "1"}).ends_with(",-2080374768,-2080374784,-2080374784"))
      << lastRow(program, "MD20,MD24,MD28", {"--scans", "1"});
  const Output output = proofOf("prove own: MD24 = 16#84000000\nprove part: MD20 = 16#84000010\n", program);
  EXPECT_TRUE(output.has("PROVED  own") && output.has("PROVED  part")) << output.text;
}

// The area in AR2 is that of DB: an access across areas in the FB goes to the block in DB, which is the DI of the
// caller.
TEST(CallRegisters, AccessAcrossAreasGoesToTheOtherBlock) {
  const std::string program = dataBlocks + functionBlock(1, oneWord, "L W [AR2,P#0.0];T MW 10") + instanceOf(1, 1) +
                              block(1, "OPN DB 5;OPN DI 6;CALL FB 1, DB 1");
  EXPECT_TRUE(lastRow(program, "MW10", {"--scans", "1"}).ends_with(",66"));
  EXPECT_TRUE(proofOf("prove never: MW10 <> 7\n", program).has("PROVED  never"));
}

// In the FB: DB = 6, DI = 1. Behind the call: DB = 1, DI = 6. A DB register that is kept holds 5 in both places.
TEST(CallRegisters, ExchangedAroundAFunctionBlock) {
  const std::string program = dataBlocks + looks + block(1, calls);
  EXPECT_TRUE(lastRow(program, "MW10,MW12,MW14,MW16", {"--scans", "1"}).ends_with(",6,1,1,6"));
  EXPECT_TRUE(lastRow(program, "MW10,MW12,MW14,MW16", {"--scans", "1", "--choice", "call-data-block=kept"})
                  .ends_with(",5,1,5,6"));
  const std::string inside = "prove inside: MW10 = 6\nprove behind: MW14 = 1\n";
  const std::string kept = "prove inside: MW10 = 5\nprove behind: MW14 = 5\n";
  const std::string sure = "prove instance: MW12 = 1\nprove caller: MW16 = 6\n";
  const Output open = proofOf(inside + sure, program);
  EXPECT_TRUE(open.has("VIOLATED  inside") && open.has("VIOLATED  behind")) << open.text;
  EXPECT_TRUE(open.has("under call-data-block = kept")) << open.text;
  EXPECT_TRUE(open.has("PROVED  instance") && open.has("PROVED  caller")) << open.text;
  EXPECT_TRUE(proofOf(kept, program).has("VIOLATED  inside"));
  const Output named = proofOf(inside, program, {"--choice", "call-data-block=exchanged"});
  EXPECT_TRUE(named.has("PROVED  inside") && named.has("PROVED  behind")) << named.text;
  const Output other = proofOf(kept, program, {"--choice", "call-data-block=kept"});
  EXPECT_TRUE(other.has("PROVED  inside") && other.has("PROVED  behind")) << other.text;
}

// DBW 0 behind the call is the word of DB5 or of the instance, 7. Opened again it is that of DB5.
TEST(CallRegisters, DataBehindACall) {
  const std::string asked = "prove word: MW20 = 55\n";
  const std::string before = dataBlocks + looks;
  const Output open = proofOf(asked, before + block(1, "OPN DB 5;CALL FB 1, DB 1;L DBW 0;T MW 20"));
  EXPECT_TRUE(open.has("VIOLATED  word") && open.has("call-data-block = exchanged")) << open.text;
  EXPECT_TRUE(
      proofOf(asked, before + block(1, "OPN DB 5;CALL FB 1, DB 1;OPN DB 5;L DBW 0;T MW 20")).has("PROVED  word"));
}

// An FC that uses AR2 is called from an FB, whose own data are found by it: x = 7 lies at byte 0, y = 9 at byte 2. UC
// gives nothing back.
TEST(CallRegisters, AddressRegister2BehindAFunction) {
  const std::string function = "FUNCTION FC 1 : VOID\nBEGIN\nNETWORK\nLAR2 P#2.0;\nEND_FUNCTION\n";
  const std::string own = "VAR\n  x : INT := 7;\n  y : INT := 9;\nEND_VAR\n";
  const auto program = [&](const std::string& call) {
    return function + functionBlock(1, own, call + ";L #x;T MW 10") + instanceOf(1, 1) + block(1, "CALL FB 1, DB 1");
  };
  const std::string asked = "prove seven: MW10 = 7\nprove nine: MW10 = 9\n";
  EXPECT_TRUE(lastRow(program("CALL FC 1"), "MW10", {"--scans", "1"}).ends_with(",7"));
  const Output open = proofOf(asked, program("CALL FC 1"));
  EXPECT_TRUE(open.has("VIOLATED  seven") && open.has("under call-address-register = left")) << open.text;
  EXPECT_TRUE(open.has("VIOLATED  nine")) << open.text;
  const Output back = proofOf(asked, program("CALL FC 1"), {"--choice", "call-address-register=given-back"});
  EXPECT_TRUE(back.has("PROVED  seven")) << back.text;
  const Output left = proofOf(asked, program("CALL FC 1"), {"--choice", "call-address-register=left"});
  EXPECT_TRUE(left.has("PROVED  nine")) << left.text;
  EXPECT_TRUE(proofOf(asked, program("UC FC 1")).has("PROVED  nine"));
  // An FC that leaves AR2 alone opens no point.
  const std::string quiet = "FUNCTION FC 1 : VOID\nBEGIN\nNETWORK\nL 1;\nT MW 20;\nEND_FUNCTION\n";
  const Output same = proofOf("prove seven: MW10 = 7\n", quiet + functionBlock(1, own, "CALL FC 1;L #x;T MW 10") +
                                                             instanceOf(1, 1) + block(1, "CALL FB 1, DB 1"));
  EXPECT_TRUE(same.has("PROVED  seven") && !same.has("call-address-register")) << same.text;
}

// SFB4 (TON) is called in the same way; UC, and CALL of an FC, give both registers back.
TEST(CallRegisters, OtherCalls) {
  const std::string timer = "DATA_BLOCK DB 1\nSFB 4\nBEGIN\nEND_DATA_BLOCK\n";
  const std::string ton = "OPN DB 5;CALL SFB 4, DB 1 (IN := I 0.0, PT := T#1S);L DBNO;T MW 14";
  EXPECT_TRUE(lastRow(dataBlocks + timer + block(1, ton), "MW14", {"--scans", "1"}).ends_with(",1"));
  const std::string reads = functionBlock(1, "", "L DBNO;T MW 10");
  const std::string function = "FUNCTION FC 1 : VOID\nBEGIN\nNETWORK\nL DBNO;\nT MW 10;\nEND_FUNCTION\n";
  for (const std::string& program : {reads + block(1, "OPN DB 5;OPN DI 6;UC FB 1;L DBNO;T MW 14"),
                                     function + block(1, "OPN DB 5;OPN DI 6;CALL FC 1;L DBNO;T MW 14")}) {
    const Output output = proofOf("prove inside: MW10 = 5\nprove behind: MW14 = 5\n", dataBlocks + program);
    EXPECT_TRUE(output.has("PROVED  inside") && output.has("PROVED  behind")) << output.text;
  }
}

// A full address as parameter is copied in with OPN: the FC may find that block open, and its caller too.
TEST(CallRegisters, FullAddressesAsParameters) {
  const std::string function =
      "FUNCTION FC 1 : VOID\nVAR_INPUT\n  a : INT;\nEND_VAR\nBEGIN\nNETWORK\nL DBNO;\nT MW 10;\nEND_FUNCTION\n";
  const std::string program = dataBlocks + function + block(1, "OPN DB 5;CALL FC 1 (a := DB6.DBW 0);L DBNO;T MW 14");
  const Output output = proofOf(
      "prove five: MW10 = 5\nprove six: MW10 = 6\nprove behind: MW14 = 5\nprove either: MW10 >= 5 and MW10 <= 6\n",
      program);
  EXPECT_TRUE(output.has("VIOLATED  five") && output.has("VIOLATED  six") && output.has("VIOLATED  behind"))
      << output.text;
  EXPECT_TRUE(output.has("PROVED  either")) << output.text;
}

// A block with a timer in its data that is called under a condition: where its statements stand behind a jump, the
// place of its data is still the one of this call. Without I0.2 nothing of it runs, so the output stays.
TEST(CallRegisters, ATimerWithinAConditionalCallFindsItsData) {
  const std::string timed = functionBlock(
      7, "VAR_INPUT\n  x : BOOL;\nEND_VAR\nVAR_OUTPUT\n  y : BOOL;\nEND_VAR\nVAR\n  tm : SFB 4;\n  n : INT;\nEND_VAR\n",
      "CALL #tm (IN := #x, PT := T#50MS, Q := #y);L 5;T #n");
  const std::string program =
      timed + instanceOf(7, 11) + block(1, "A I 0.2;JCN m1;CALL FB 7, DB 11 (x := I 0.0, y := Q 0.0);m1: NOP 0");
  const Output output = proofOf("prove stays: not I0.2 and not first_scan implies Q0.0 = prev(Q0.0)\n", program);
  EXPECT_TRUE(output.has("PROVED  stays")) << output.text;
  EXPECT_FALSE(output.has("pointer whose targets")) << output.text;
}

}  // namespace
}  // namespace rungproof
