// What a CALL leaves in the registers of its caller (spec of the B stack, 002:222, and general knowledge).
#include <fmt/format.h>

#include "ir/s7300/block.hpp"
#include "ir/s7300/library_contract.hpp"
#include "proved_text.hpp"

namespace rungproof::test {
namespace {

/// `call`: behind OPN DB 1 in OB1; DB1.DBX0.0 is 0 and DB2.DBX0.0 is 1.
Outcome outcomeBehind(const std::string& call) {
  const std::string data = " STRUCT a : BOOL := %; w : WORD; END_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n";
  const auto block = [&](const std::string& number, const std::string& bit) {
    return "DATA_BLOCK DB " + number + data.substr(0, data.find('%')) + bit + data.substr(data.find('%') + 1);
  };
  const ProgramInput input =
      inputOfSource(block("1", "FALSE") + block("2", "TRUE") +
                    "FUNCTION FC 1 : VOID\nVAR_INPUT x : WORD; END_VAR\nBEGIN\nNETWORK\nNOP 0;\nEND_FUNCTION\n"
                    "FUNCTION_BLOCK FB 1\nVAR_OUTPUT y : WORD; END_VAR\nBEGIN\nNETWORK\nNOP 0;\nEND_FUNCTION_BLOCK\n"
                    "DATA_BLOCK DB 3 FB 1\nBEGIN\nEND_DATA_BLOCK\n"
                    "ORGANIZATION_BLOCK OB 1\n//@ prove first: not Q0.0\nBEGIN\nNETWORK\nOPN DB 1;\n" +
                    call + "\nA DBX 0.0;\n= Q 0.0;\nEND_ORGANIZATION_BLOCK\n");
  return outcomeOf(prove(input.program, input.properties, usualOptions()), "first");
}

// A full address as actual parameter may leave its block open: nothing is proved by the block that was open before.
TEST(Step7Call, FullAddressesMayOpenTheirBlockInTheCaller) {
  EXPECT_EQ(outcomeBehind("CALL FC 1 (x := MW 10);"), Outcome::Proved);
  EXPECT_EQ(outcomeBehind("CALL FC 1 (x := DB1.DBW 2);"), Outcome::Proved);
  EXPECT_EQ(outcomeBehind("CALL FC 1 (x := DB2.DBW 2);"), Outcome::Violated);
  EXPECT_EQ(outcomeBehind("CALL FB 1, DB 3 (y := MW 10);"), Outcome::Proved);
  EXPECT_EQ(outcomeBehind("CALL FB 1, DB 3 (y := DB2.DBW 2);"), Outcome::Violated);
}

// A call that some runs make and others do not: the registers of the others are what they were. FC1 leaves 7 in ACCU1,
// FC2 leaves 8, and both open DB1.
TEST(Step7Call, RunsThatDoNotCallKeepTheirRegisters) {
  const std::string blocks =
      "DATA_BLOCK DB 1\nSTRUCT w : WORD; END_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n"
      "FUNCTION FC 1 : VOID\nBEGIN\nNETWORK\nL 7;\nEND_FUNCTION\nFUNCTION FC 2 : VOID\nBEGIN\nNETWORK\nL 8;\n"
      "END_FUNCTION\n";
  const auto outcomes = [&](const std::string& properties, const std::string& statements) {
    const ProgramInput input = inputOfSource(blocks + "ORGANIZATION_BLOCK OB 1\n" + properties + "BEGIN\nNETWORK\n" +
                                             statements + "\nEND_ORGANIZATION_BLOCK\n");
    std::vector<Outcome> found;
    for (const ProofResult& result : prove(input.program, input.properties, usualOptions()).results)
      found.push_back(result.outcome);
    return found;
  };
  using enum Outcome;
  EXPECT_EQ(outcomes("//@ prove a: MW20 = 7\n//@ prove b: MW20 = 3\n//@ prove c: MW20 = 3 or MW20 = 7\n",
                     "L 3;\nA I 0.0;\nCC FC 1;\nT MW 20;"),
            (std::vector{Violated, Violated, Proved}));
  EXPECT_EQ(outcomes("//@ assume known: MW30 = 1 or MW30 = 2\n//@ external MW30..MW30\n//@ prove a: MW20 = 7\n"
                     "//@ prove b: MW20 = 8\n//@ prove c: MW20 = 7 or MW20 = 8\n",
                     "L 3;\nUC FC [MW 30];\nT MW 20;"),
            (std::vector{Violated, Violated, Proved}));
}

/// The verdicts of the properties a, b, c of an OB1 with these directives and statements.
std::vector<Outcome> outcomesOf(const std::string& directives, const std::string& statements) {
  const ProgramInput input = inputOfSource(
      "DATA_BLOCK DB 1\nSTRUCT\n  text : STRING [4];\nEND_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n"
      "ORGANIZATION_BLOCK OB 1\n" +
      directives +
      "VAR_TEMP\n  start : ARRAY [0 .. 19] OF BYTE;\n  date : DATE_AND_TIME;\nEND_VAR\n"
      "BEGIN\nNETWORK\n" +
      statements + "\nEND_ORGANIZATION_BLOCK\n");
  const ProofRun run = prove(input.program, input.properties, usualOptions());
  std::vector<Outcome> outcomes;
  for (const char* name : {"a", "b", "c"}) outcomes.push_back(outcomeOf(run, name));
  return outcomes;
}

// An IEC timer reads the time once in a call, whenever the time passes: ET never goes beyond PT, and in the call that
// starts it no time has passed.
TEST(Step7Call, IecTimersReadTheTimeOnce) {
  for (const int timer : {3, 4, 5}) {
    const ProgramInput input =
        inputOfSource(fmt::format("DATA_BLOCK DB 2\nSFB {}\nBEGIN\nEND_DATA_BLOCK\nORGANIZATION_BLOCK OB 1\n"
                                  "//@ prove a: MD4 <= 300\n//@ prove b: not prev(I0.0) and I0.0 implies MD4 = 0\n"
                                  "BEGIN\nNETWORK\nCALL SFB {}, DB 2 (IN := I 0.0, PT := T#300MS, Q := Q 0.0, "
                                  "ET := MD 4);\nEND_ORGANIZATION_BLOCK\n",
                                  timer, timer));
    const ProofRun run = prove(input.program, input.properties, usualOptions());
    EXPECT_EQ(outcomeOf(run, "a"), Outcome::Proved) << timer;
    // A pulse that runs is not started again: its time goes on when IN rises once more.
    EXPECT_EQ(outcomeOf(run, "b"), timer == 3 ? Outcome::Violated : Outcome::Proved) << timer;
  }
}

// An index from outside that two comparisons bound, and the places of an array in the instance behind it: no other word
// is written.
TEST(Step7Call, APointerIntoTheInstanceIsBoundedByComparisons) {
  const auto outcome = [](const std::string& bounds) {
    const ProgramInput input = inputOfSource(
        "FUNCTION_BLOCK FB 10\nVAR_INPUT n : INT; END_VAR\nVAR cnt : INT; arr : ARRAY [0..9] OF INT; last : INT; "
        "END_VAR\nBEGIN\nNETWORK\n" +
        bounds +
        "L #n; SLD 4; L P##arr; +D; LAR1; L 5; T DIW [AR1,P#0.0];\nerr: NOP 0;\nEND_FUNCTION_BLOCK\n"
        "DATA_BLOCK DB 10 FB 10\nBEGIN\nEND_DATA_BLOCK\nORGANIZATION_BLOCK OB 1\n"
        "//@ prove a: DB10.DBW2 = 0 and DB10.DBW24 = 0\nBEGIN\nNETWORK\nCALL FB 10, DB 10 (n := IW 4);\n"
        "END_ORGANIZATION_BLOCK\n");
    const ProofRun run = prove(input.program, input.properties, usualOptions(5));
    EXPECT_TRUE(run.disagreements.empty());
    return outcomeOf(run, "a");
  };
  EXPECT_EQ(outcome("L #n; L 0; <I; JC err; L #n; L 9; >I; JC err;\n"), Outcome::Proved);
  EXPECT_EQ(outcome("L #n; L 0; <I; JC err; L #n; L 10; >I; JC err;\n"), Outcome::Violated);  // arr[10] is `last`
  // Nothing bounds it: it may lie anywhere in the block, or beyond, where the CPU stops.
  EXPECT_EQ(outcome(""), Outcome::Violated);
}

// Blocks of which only the contract is known: every output may be anything, what was not handed over stays.
TEST(Step7Call, AContractGivesAnyOutputsAndNothingElse) {
  int contracts = 0;
  for (const s7300::LibraryBlock& block : s7300::libraryBlocks()) {
    if (!s7300::isContractOnly(block)) continue;
    ++contracts;
    std::string actuals, taken;  // what takes the result out where it is a text
    int byte = 40;
    const auto parameters = s7300::interfaceOf(block);
    for (const s7300::Field& field : parameters->fields) {
      const std::string type = s7300::toString(field.type);
      const bool isResult = field.name == "RET_VAL";
      const std::string place = type == "BOOL"                    ? fmt::format("M {}.0", byte)
                                : type == "BYTE"                  ? fmt::format("MB {}", byte)
                                : type == "INT" || type == "WORD" ? fmt::format("MW {}", isResult ? 10 : byte)
                                : type == "DATE_AND_TIME"         ? std::string("#date")
                                : type.starts_with("STRING")      ? std::string("DB1.text")
                                                                  : fmt::format("MD {}", isResult ? 10 : byte);
      if (isResult && type.starts_with("STRING")) taken = "L DB1.DBW 1; T MW 10;";
      actuals += fmt::format("{}{} := {}", actuals.empty() ? "" : ", ", field.name, place);
      byte += 4;
    }
    const std::string call = fmt::format("CALL {} ({});", blockName(blockNumber(block.type, block.number)), actuals);
    const std::vector<Outcome> expected = {Outcome::Proved, Outcome::Violated, Outcome::Reachable};
    EXPECT_EQ(outcomesOf("//@ prove a: Q0.0\n//@ prove b: not Q0.1\n//@ reach c: not Q0.1 and not first_scan\n",
                         "SET; = M 0.0; " + call + taken + " A M 0.0; = Q 0.0; L MW 10; L 5; ==I; = Q 0.1;"),
              expected)
        << call;
  }
  EXPECT_EQ(contracts, 26);
}

// The time of the system is no negative number (002:2494), and tells nothing else.
TEST(Step7Call, TheSystemTimeIsAnyNumberOfMilliseconds) {
  const std::vector<Outcome> expected = {Outcome::Proved, Outcome::Violated, Outcome::Reachable};
  EXPECT_EQ(outcomesOf("//@ prove a: not Q0.0\n//@ prove b: not Q0.1\n//@ reach c: not Q0.1\n",
                       "CALL SFC 64 (RET_VAL := MD 0); L MD 0; L L#0; <D; = Q 0.0; L MD 0; L L#77; ==D; = Q 0.1;"),
            expected);
}

}  // namespace
}  // namespace rungproof::test
