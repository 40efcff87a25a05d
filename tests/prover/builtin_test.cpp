// The built-in checks on programs made so that each answer is known beforehand.
#include <algorithm>
#include <set>

#include "analysis/proof/question_system.hpp"
#include "proved_text.hpp"
#include "tests/corpus/corpus_program.hpp"

namespace rungproof::test {
namespace {

ProofRun builtins(const ProgramInput& input) {
  ProverOptions options = usualOptions(10);
  options.checks.builtin = true;
  return prove(input.program, input.properties, options);
}

using Rules = std::set<std::string_view>;
const Rules setAndReset{"OUT003"}, stackLevels{"STK001"}, nesting{"SUB002"}, division{"ARI001"}, firing{"TIM008"},
    oncePerScan{"TIM004"}, presets{"TIM007"}, operandRange{"PTR001", "PTR004", "PTR005"};

/// Outcomes of those rules' questions whose name contains `part`.
std::vector<Outcome> outcomes(const ProofRun& run, const Rules& rules, const std::string& part = "") {
  std::vector<Outcome> found;
  for (const ProofResult& result : run.results) {
    if (result.builtin && rules.contains(result.builtin->rule->id) &&
        result.builtin->name.find(part) != std::string::npos)
      found.push_back(result.outcome);
  }
  return found;
}
using Outcomes = std::vector<Outcome>;

const char* const subroutine =
    "SUBROUTINE_BLOCK SBR_0:SBR0\nBEGIN\nNetwork 1\nLD I0.1\nR Q0.0, 1\nEND_SUBROUTINE_BLOCK\n";

TEST(Builtin, SetAndResetInMainAndSubroutine) {
  const ProofRun run =
      builtins(inputOf("", "Network 1\nLD I0.0\nS Q0.0, 1\nNetwork 2\nLD SM0.0\nCALL SBR_0\n", subroutine));
  EXPECT_EQ(outcomes(run, setAndReset, "Q0.0"), Outcomes{Outcome::Violated});
}

TEST(Builtin, WitnessesShowOnlyInputsThatMatter) {
  // The conflict needs I0.0 and I0.1 in one scan; I0.2 to I0.4 are read but have nothing to do with it.
  const ProofRun run = builtins(inputOf(
      "",
      "Network 1\nLD I0.0\nS Q0.0, 1\nNetwork 2\nLD I0.1\nR Q0.0, 1\nNetwork 3\nLD I0.2\nA I0.3\nO I0.4\n= Q0.1\n"));
  for (const ProofResult& result : run.results) {
    if (!result.builtin || result.builtin->rule->id != "OUT003") continue;
    ASSERT_TRUE(result.witness);
    ASSERT_EQ(result.witness->matters.size(), result.witness->scans.size());
    const ReplayScan& last = result.witness->scans.back();
    ASSERT_EQ(result.witness->matters.back().size(), last.inputs.size());
    std::set<std::string> thatMatter;
    for (std::size_t i = 0; i < last.inputs.size(); ++i) {
      if (result.witness->matters.back()[i]) thatMatter.insert(toString(last.inputs[i].operand));
    }
    EXPECT_EQ(thatMatter, (std::set<std::string>{"I0.0", "I0.1"}));
    return;
  }
  FAIL() << "no conflict was found";
}

TEST(Builtin, SetAndResetUnderOppositeConditionsIsNoConflict) {
  const ProofRun run =
      builtins(inputOf("", "Network 1\nLD I0.0\nS Q0.0, 1\nNetwork 2\nLDN I0.0\nCALL SBR_0\n",
                       "SUBROUTINE_BLOCK SBR_0:SBR0\nBEGIN\nNetwork 1\nLD SM0.0\nR Q0.0, 1\nEND_SUBROUTINE_BLOCK\n"));
  for (const Outcome outcome : outcomes(run, setAndReset, "Q0.0")) EXPECT_EQ(outcome, Outcome::Proved);
}

TEST(Builtin, SetInMainAndResetInInterrupt) {
  // Event 0: rising edge of I0.0. The routine may come in the scan in which the main program sets the bit.
  const ProofRun run =
      builtins(inputOf("", "Network 1\nLD SM0.1\nATCH INT_0, 0\nENI\nNetwork 2\nLD I0.5\nS M0.0, 1\n",
                       "INTERRUPT_BLOCK INT_0:INT0\nBEGIN\nNetwork 1\nLD SM0.0\nR M0.0, 1\nEND_INTERRUPT_BLOCK\n"));
  const Outcomes found = outcomes(run, setAndReset, "M0.0");
  ASSERT_FALSE(found.empty());
  for (const Outcome outcome : found) EXPECT_EQ(outcome, Outcome::Violated);
}

TEST(Builtin, SlowTimerSkippedByAJump) {
  // T37 has a resolution of 100 ms; with I0.0 its box is jumped over.
  const ProofRun run = builtins(inputOf(
      "", "Network 1\nLD I0.0\nJMP 1\nNetwork 2\nLD I0.1\nTON T37, 10\nNetwork 3\nLBL 1\nNetwork 4\nLD T37\n= Q0.0\n"));
  EXPECT_EQ(outcomes(run, oncePerScan, "T37"), Outcomes{Outcome::Violated});
}

TEST(Builtin, SlowTimerCalledTwice) {
  const ProofRun run = builtins(inputOf(
      "", "Network 1\nLD SM0.0\nCALL SBR_0\nNetwork 2\nLD I0.7\nCALL SBR_0\n",
      "SUBROUTINE_BLOCK SBR_0:SBR0\nBEGIN\nNetwork 1\nLD I0.1\nTON T37, 10\nLD T37\n= Q0.0\nEND_SUBROUTINE_BLOCK\n"));
  EXPECT_EQ(outcomes(run, oncePerScan, "T37"), Outcomes{Outcome::Violated});
}

TEST(Builtin, SlowTimerInEveryScanAndFastTimersAreNoQuestion) {
  const ProofRun run = builtins(inputOf("",
                                        "Network 1\nLD I0.1\nTON T37, 10\nNetwork 2\nLD I0.0\nJMP 1\nNetwork 3\nLD "
                                        "I0.1\nTON T33, 10\nNetwork 4\nLBL 1\n"));
  EXPECT_EQ(outcomes(run, oncePerScan), Outcomes{});
}

TEST(Builtin, NestingAtTheLimitAndBeyond) {
  // Eight levels are allowed (001:6723); SBR n calls SBR n + 1.
  const auto chain = [](int levels) {
    std::string blocks;
    for (int n = 0; n < levels; ++n) {
      blocks +=
          "SUBROUTINE_BLOCK SBR_" + std::to_string(n) + ":SBR" + std::to_string(n) + "\nBEGIN\nNetwork 1\nLD SM0.0\n";
      blocks += n + 1 < levels ? "CALL SBR_" + std::to_string(n + 1) + "\n" : std::string("= Q0.0\n");
      blocks += "END_SUBROUTINE_BLOCK\n";
    }
    return builtins(inputOf("", "Network 1\nLD I0.0\nCALL SBR_0\n", blocks));
  };
  for (const Outcome outcome : outcomes(chain(8), nesting)) EXPECT_EQ(outcome, Outcome::Proved);
  const Outcomes tooDeep = outcomes(chain(9), nesting);
  EXPECT_NE(std::count(tooDeep.begin(), tooDeep.end(), Outcome::Violated), 0);
}

TEST(Builtin, PointerThatMayLeaveItsArea) {
  // The offset is an input byte times 256: up to 65280 bytes behind VB0, V ends at 10239.
  const ProofRun wide = builtins(inputOf("",
                                         "Network 1\nLD SM0.0\nMOVD &VB0, VD0\nMOVB IB1, VB6\nMOVB 0, VB7\nMOVB 0, "
                                         "VB4\nMOVB 0, VB5\n+D VD4, VD0\nMOVB *VD0, QB0\n"));
  const Outcomes found = outcomes(wide, operandRange);
  EXPECT_NE(std::count(found.begin(), found.end(), Outcome::Violated), 0);
  // One byte of offset cannot leave it.
  const ProofRun narrow = builtins(inputOf("",
                                           "Network 1\nLD SM0.0\nMOVD &VB0, VD0\nMOVB IB1, VB7\nMOVB 0, VB6\nMOVB 0, "
                                           "VB4\nMOVB 0, VB5\n+D VD4, VD0\nMOVB *VD0, QB0\n"));
  for (const Outcome outcome : outcomes(narrow, operandRange)) EXPECT_EQ(outcome, Outcome::Proved);
}

TEST(Builtin, DivisionIsGuardedOrNot) {
  const ProofRun open = builtins(inputOf("", "Network 1\nLD SM0.0\nMOVW IW0, VW0\n/I IW2, VW0\n"));
  EXPECT_EQ(outcomes(open, division), Outcomes{Outcome::Violated});
  const ProofRun guarded = builtins(inputOf("", "Network 1\nLDW<> IW2, 0\nMOVW IW0, VW0\n/I IW2, VW0\n"));
  for (const Outcome outcome : outcomes(guarded, division)) EXPECT_EQ(outcome, Outcome::Proved);
}

TEST(Builtin, TimerThatCanComeOnAndOneThatCannot) {
  // T37 waits 5 s behind its input; T38 is reset by its own first tick of the program: its input is on for one scan
  // only.
  const ProofRun run = builtins(inputOf(
      "", "Network 1\nLD I0.0\nTON T37, 50\nNetwork 2\nLD I0.1\nEU\nTON T38, 100\nNetwork 3\nLD T37\nO T38\n= Q0.0\n"));
  EXPECT_EQ(outcomes(run, firing, "T37 can come on"), Outcomes{Outcome::Reachable});
  EXPECT_EQ(outcomes(run, firing, "T37 can be reset"), Outcomes{Outcome::Reachable});
  EXPECT_EQ(outcomes(run, firing, "T38 can come on"), Outcomes{Outcome::Unreachable});
}

TEST(Builtin, TimerThatIsResetInTheScanInWhichItComesOn) {
  // T5 is on for the contact of network 2 only, which resets it: never at the end of a scan, but it does come on.
  const ProofRun run = builtins(inputOf("", "Network 1\nLD I0.0\nTONR T5, 10\nNetwork 2\nLD T5\nR T5, 1\nINCW VW4\n"));
  EXPECT_EQ(outcomes(run, firing, "T5 can come on"), Outcomes{Outcome::Reachable});
  EXPECT_EQ(outcomes(run, firing, "T5 can be reset"), Outcomes{Outcome::Reachable});
}

/// S5 timers and counters: on-delay behind an input and behind an edge, whose RLO is 1 in one scan of at most 150 ms; a
/// retentive on-delay and a counter that nothing resets; a counter that counts down too. What only R names is TIM009's.
TEST(Builtin, TimersAndCountersOfTheOtherFamily) {
  const ProgramInput input = inputOfSource(
      "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n"
      "A I 0.0;\nL S5T#1S;\nSD T 1;\nA I 0.1;\nFP M 0.0;\nL S5T#1S;\nSD T 2;\nA I 0.2;\nL S5T#1S;\nSS T 3;\n"
      "A I 0.3;\nCU C 1;\nA I 0.4;\nCU C 2;\nA I 0.5;\nCD C 2;\nA I 0.6;\nR T 4;\n"
      "O T 1;\nO T 2;\nO T 3;\nO T 4;\nO C 1;\nO C 2;\n= Q 0.0;\nEND_ORGANIZATION_BLOCK\n");
  ProverOptions options = usualOptions(10);
  options.time.high = 150;
  options.checks.builtin = true;
  const ProofRun run = prove(input.program, input.properties, options);
  const std::map<std::string, Outcome> expected = {
      {"T1 can come on", Outcome::Reachable},    {"T1 can be reset", Outcome::Reachable},
      {"T2 can come on", Outcome::Unreachable},  {"T3 can come on", Outcome::Reachable},
      {"T3 can be reset", Outcome::Unreachable}, {"C1 can come on", Outcome::Reachable},
      {"C1 can be reset", Outcome::Unreachable}, {"C2 can come on", Outcome::Reachable},
      {"C2 can be reset", Outcome::Reachable}};
  for (const auto& [name, outcome] : expected) EXPECT_EQ(outcomes(run, firing, name), Outcomes{outcome}) << name;
  EXPECT_EQ(outcomes(run, firing, "T4 can come on"), Outcomes());
}

/// MAIN, a subroutine or an interrupt routine with these networks; MAIN calls or attaches it.
ProofRun builtinsIn(const std::string& block, const std::string& networks) {
  if (block == "MAIN") return builtins(inputOf("", networks));
  const bool isInterrupt = block == "INT";
  const std::string head = isInterrupt ? "INTERRUPT_BLOCK INT_0:INT0\nBEGIN\n" : "SUBROUTINE_BLOCK SBR_0:SBR0\nBEGIN\n";
  const std::string end = isInterrupt ? "END_INTERRUPT_BLOCK\n" : "END_SUBROUTINE_BLOCK\n";
  return builtins(
      inputOf("", isInterrupt ? "Network 1\nLD SM0.1\nATCH INT_0, 0\nENI\n" : "Network 1\nLD I2.7\nCALL SBR_0\n",
              head + networks + end));
}

class BuiltinIn : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Blocks, BuiltinIn, testing::Values("MAIN", "SBR", "INT"),
                         [](const auto& info) { return std::string(info.param); });

TEST_P(BuiltinIn, LevelsThatTheStackLoses) {
  // Ten loads; eight ALD take the upper nine levels, the ninth one takes the level that the tenth load pushed out.
  const auto loads = [](int count, int joined) {
    std::string text = "Network 1\n";
    for (int i = 0; i < count; ++i) text += "LD I0." + std::to_string(i % 8) + "\n";
    for (int i = 0; i < joined; ++i) text += "ALD\n";
    return text + "= Q0.0\n";
  };
  EXPECT_EQ(outcomes(builtinsIn(GetParam(), loads(10, 9)), stackLevels, "ALD"), Outcomes{Outcome::Violated});
  EXPECT_EQ(outcomes(builtinsIn(GetParam(), loads(10, 8)), stackLevels), Outcomes{Outcome::Proved});
  EXPECT_EQ(outcomes(builtinsIn(GetParam(), loads(9, 8)), stackLevels), Outcomes{Outcome::Proved});
}

TEST_P(BuiltinIn, LevelsLostOnOnePathOnly) {
  // Without the jump ten levels are loaded and the ninth ALD takes the lost one. In the second program the jump is
  // always taken, so that nine loads meet eight ALD.
  std::string head = "Network 1\n", tail;
  for (int i = 0; i < 8; ++i) head += "LD I0." + std::to_string(i) + "\n";
  for (int i = 0; i < 8; ++i) tail += "ALD\n";
  const std::string lost = head + "LD I1.0\nJMP 1\nLD I1.1\nLBL 1\n" + tail + "ALD\n= Q0.0\n";
  const Outcomes ofLost = outcomes(builtinsIn(GetParam(), lost), stackLevels, "ALD");
  EXPECT_EQ(std::count(ofLost.begin(), ofLost.end(), Outcome::Violated), 1);
  const std::string never = head + "LD I1.0\nON I1.0\nJMP 1\nLD I1.1\nLBL 1\n" + tail + "= Q0.0\n";
  for (const Outcome outcome : outcomes(builtinsIn(GetParam(), never), stackLevels))
    EXPECT_EQ(outcome, Outcome::Proved);
}

TEST_P(BuiltinIn, SetAndReset) {
  // An interrupt routine may run twice in a scan: then each of the two can be the last one.
  const Outcomes both = outcomes(
      builtinsIn(GetParam(), "Network 1\nLD I0.1\nS M0.0, 1\nNetwork 2\nLD I0.2\nR M0.0, 1\n"), setAndReset, "M0.0");
  EXPECT_FALSE(both.empty());
  for (const Outcome outcome : both) EXPECT_EQ(outcome, Outcome::Violated);
  for (const Outcome outcome :
       outcomes(builtinsIn(GetParam(), "Network 1\nLD I0.1\nS M0.0, 1\nNetwork 2\nLDN I0.1\nR M0.0, 1\n"), setAndReset,
                "M0.0"))
    EXPECT_EQ(outcome, Outcome::Proved);
}

TEST_P(BuiltinIn, CountsTablesAndStringsThatLeaveTheirArea) {
  // V ends at VB10239 on a CPU 226 (table 6-2). 200 words from VW10000 end at VB10399; 100 of them at VB10199.
  const auto fill = [](const std::string& limit) {
    return "Network 1\nLDB<= IB1, " + limit +
           "\nAB>= IB1, 1\nFILL 0, VW10000, 120\nMOVB IB1, VB0\nBMW VW100, VW10000, VB0\n";
  };
  const Outcomes wide = outcomes(builtinsIn(GetParam(), fill("200")), operandRange, "BMW");
  EXPECT_NE(std::count(wide.begin(), wide.end(), Outcome::Violated), 0);
  for (const Outcome outcome : outcomes(builtinsIn(GetParam(), fill("100")), operandRange, "BMW"))
    EXPECT_EQ(outcome, Outcome::Proved);
  // A string index of 0 is error 009B (001:13972).
  const auto part = [](const std::string& guard) { return "Network 1\n" + guard + "SSCPY VB100, IB1, 2, VB200\n"; };
  const Outcomes zero = outcomes(builtinsIn(GetParam(), part("LD I0.0\n")), operandRange, "SSCPY");
  EXPECT_NE(std::count(zero.begin(), zero.end(), Outcome::Violated), 0);
}

TEST_P(BuiltinIn, PointersThatLeaveTheirArea) {
  // V ends at VB10239 on a CPU 226. The index, 0 to 12, goes on from VB10230 or VB10200; then a ring of five bytes.
  const auto table = [](const std::string& start) {
    return "Network 1\nLD I0.0\nMOVD &" + start +
           ", AC1\nITD IW4, AC0\n+D AC0, AC1\nLDW>= IW4, 0\nAW<= IW4, 12\nA I0.0\nMOVB IB0, *AC1\n";
  };
  EXPECT_EQ(outcomes(builtinsIn(GetParam(), table("VB10230")), operandRange), Outcomes{Outcome::Violated});
  for (const Outcome outcome : outcomes(builtinsIn(GetParam(), table("VB10200")), operandRange))
    EXPECT_EQ(outcome, Outcome::Proved);
  const std::string ring =
      "Network 1\nLD SM0.0\nLPS\nAD= VD40, 0\nMOVD &VB10235, VD40\nLPP\nMOVB IB0, *VD40\nINCD VD40\n"
      "Network 2\nLDD> VD40, &VB10239\nMOVD &VB10235, VD40\n";
  // A routine may run more often at one place than is followed: what the ring holds then is any value, so nothing is
  // decided there.
  const Outcome expected = GetParam() == std::string("INT") ? Outcome::NotCovered : Outcome::Proved;
  for (const Outcome outcome : outcomes(builtinsIn(GetParam(), ring), operandRange, "MOVB"))
    EXPECT_EQ(outcome, expected);
}

TEST_P(BuiltinIn, DivisionByZero) {
  const ProofRun run = builtinsIn(GetParam(),
                                  "Network 1\nLD I0.0\nMOVW 100, VW0\n/I IW4, VW0\n"
                                  "Network 2\nLDW<> IW6, 0\nMOVW 100, VW2\n/I IW6, VW2\n");
  EXPECT_EQ(outcomes(run, division, "/I IW4"), Outcomes{Outcome::Violated});
  for (const Outcome outcome : outcomes(run, division, "/I IW6")) EXPECT_EQ(outcome, Outcome::Proved);
}

TEST_P(BuiltinIn, TableLengthOutOfRange) {
  // 100 entries at most; the table's first word says how many there may be.
  const auto filled = [](const std::string& length) {
    return "Network 1\nLD SM0.0\nMOVW " + length + ", VW10000\nATT IW4, VW10000\n";
  };
  const Outcomes open = outcomes(builtinsIn(GetParam(), filled("IW6")), operandRange, "ATT");
  EXPECT_NE(std::count(open.begin(), open.end(), Outcome::Violated), 0);
  for (const Outcome outcome : outcomes(builtinsIn(GetParam(), filled("50")), operandRange, "ATT"))
    EXPECT_EQ(outcome, Outcome::Proved);
}

TEST_P(BuiltinIn, PresetOutOfRange) {
  EXPECT_EQ(outcomes(builtinsIn(GetParam(), "Network 1\nLD I0.0\nTON T33, IW2\n"), presets),
            Outcomes{Outcome::Violated});
  EXPECT_EQ(outcomes(builtinsIn(GetParam(), "Network 1\nLDW> IW2, 0\nTON T33, IW2\n"), presets),
            Outcomes{Outcome::Proved});
  EXPECT_EQ(outcomes(builtinsIn(GetParam(), "Network 1\nLD I0.0\nLD I0.1\nCTU C1, IW2\n"), presets),
            Outcomes{Outcome::Violated});
}

TEST_P(BuiltinIn, TimerThatFiresAndOneThatNeverDoes) {
  const ProofRun run =
      builtinsIn(GetParam(), "Network 1\nLD I0.0\nTON T33, 5\nNetwork 2\nLD I0.1\nAN I0.1\nTON T34, 5\n");
  EXPECT_EQ(outcomes(run, firing, "T33 can come on"), Outcomes{Outcome::Reachable});
  EXPECT_EQ(outcomes(run, firing, "T34 can come on"), Outcomes{Outcome::Unreachable});
}

TEST(Builtin, LoopBeyondTheLimitLeavesProofsOpen) {
  // A jump back is followed 256 times; in the rounds behind these VW0 counts from any value. The loop is left with 1000
  // in truth, and with 1000 or more as far as that tells: 900 is out of the question, 1500 is left open. VW4 is set
  // anew behind the loop.
  const ProgramInput input =
      inputOf("//@ prove not early: VW2 <> 900\n//@ prove not late: VW2 <> 1500\n//@ prove anew: VW4 = 7\n",
              "Network 1\nLD SM0.0\nMOVW 0, VW0\nNetwork 2\nLBL 1\nNetwork 3\nLD SM0.0\nINCW VW0\nMOVW VW0, VW2\n"
              "MOVW VW0, VW4\nNetwork 4\nLDW< VW0, 1000\nJMP 1\nNetwork 5\nLD SM0.0\nMOVW 7, VW4\n");
  const ProofRun run = prove(input.program, input.properties, usualOptions(15));
  EXPECT_EQ(outcomeOf(run, "not early"), Outcome::Proved);
  EXPECT_EQ(outcomeOf(run, "not late"), Outcome::NotCovered);
  EXPECT_EQ(outcomeOf(run, "anew"), Outcome::Proved);
}

/// OB1 that reads a word of the open block at AR1, which the statements set.
ProofRun readAtPointer(const std::string& statements, const std::string& blocks) {
  const ProgramInput input =
      inputOfSource(blocks + "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n" + statements + "\nEND_ORGANIZATION_BLOCK\n");
  ProverOptions options = usualOptions(10);
  options.time.high = 150;
  options.checks.builtin = true;
  return prove(input.program, input.properties, options);
}
std::string dataOf(int number, int words) {
  return "DATA_BLOCK DB " + std::to_string(number) + "\nSTRUCT\n  a : ARRAY [0 .. " + std::to_string(words - 1) +
         "] OF WORD;\nEND_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n";
}

/// What a pointer finds in a long block may be any value; whether it leaves the block is asked all the same. IW4 words
/// of 2 bytes reach 65,534 bytes, one byte of them 510.
TEST(Builtin, PointersIntoLongDataBlocksAreAsked) {
  const Rules stops{"OBL002"};
  const std::string leaves = "access leaves", word = "OPN DB 20;\nL IW 4;\nL 16;\n*I;\nLAR1;\n",
                    byte = "OPN DB 20;\nL IB 4;\nL 16;\n*I;\nLAR1;\n";
  for (const int words : {256, 257, 500, 3000}) {
    const std::string blocks = dataOf(20, words);
    EXPECT_EQ(outcomes(readAtPointer(word + "L DBW [AR1,P#0.0];\nT MW 10;", blocks), stops, leaves),
              Outcomes{Outcome::Violated})
        << words;
    EXPECT_EQ(outcomes(readAtPointer(word + "L 7;\nT DBW [AR1,P#0.0];", blocks), stops, leaves),
              Outcomes{Outcome::Violated})
        << words;
  }
  // A limit of 499 words keeps the pointer within 500 words and not within 499.
  const std::string limited =
      "OPN DB 20;\nL IW 4;\nL 0;\n<I;\nJC e;\nL IW 4;\nL 499;\n>I;\nJC e;\nL IW 4;\nL 16;\n*I;\nLAR1;\n"
      "L DBW [AR1,P#0.0];\nT MW 10;\ne: NOP 0;";
  for (const Outcome outcome : outcomes(readAtPointer(limited, dataOf(20, 500)), stops))
    EXPECT_EQ(outcome, Outcome::Proved);
  EXPECT_EQ(outcomes(readAtPointer(limited, dataOf(20, 499)), stops, leaves), Outcomes{Outcome::Violated});
  // An address that is no whole byte; a pointer across areas; an area of the CPU.
  EXPECT_EQ(outcomes(readAtPointer("OPN DB 20;\nL ID 4;\nLAR1;\nL DBW [AR1,P#0.0];\nT MW 10;", dataOf(20, 500)), stops,
                     "bit part"),
            Outcomes{Outcome::Violated});
  EXPECT_EQ(outcomes(readAtPointer("OPN DB 20;\nL ID 4;\nLAR1;\nL W [AR1,P#0.0];\nT MW 10;", dataOf(20, 500)), stops,
                     "names an area"),
            Outcomes{Outcome::Violated});
  EXPECT_EQ(outcomes(readAtPointer("L ID 4;\nLAR1;\nL MW [AR1,P#0.0];\nT MW 10;", ""), stops, leaves),
            Outcomes{Outcome::Violated});
}

/// A pointer across the modules may meet one that does not answer, and OB122 sets M0.0 then; one into protected blocks
/// is asked. Within M there are no modules.
TEST(Builtin, PointersToPlacesThatAreNotFoundMayFail) {
  const std::string handler = "ORGANIZATION_BLOCK OB 122\nBEGIN\nNETWORK\nSET;\nS M 0.0;\nEND_ORGANIZATION_BLOCK\n";
  const auto clean = [&](const std::string& access) {
    const ProgramInput input =
        inputOfSource(handler +
                      "ORGANIZATION_BLOCK OB 1\n//@ prove clean: never M0.0\nBEGIN\nNETWORK\nL IW 4;\nL 64;\n"
                      "*I;\nLAR1;\n" +
                      access + "\nEND_ORGANIZATION_BLOCK\n");
    return outcomeOf(prove(input.program, input.properties, usualOptions(5)), "clean");
  };
  EXPECT_NE(clean("L PIW [AR1,P#0.0];\nT MW 10;"), Outcome::Proved);
  EXPECT_EQ(clean("L MW [AR1,P#0.0];\nT MW 10;"), Outcome::Proved);
  std::string protectedData = dataOf(20, 3000);
  protectedData.insert(protectedData.find("STRUCT"), "READ_ONLY\n");
  const Outcomes asked =
      outcomes(readAtPointer("OPN DB 20;\nL IW 4;\nL 16;\n*I;\nLAR1;\nL 7;\nT DBW [AR1,P#0.0];", protectedData),
               Rules{"OBL002"}, "write-protected");
  ASSERT_EQ(asked.size(), 1U);
  EXPECT_NE(asked[0], Outcome::Proved);
}

/// Mode 12 counts the pulses of Q0.0 (001:4237): without PLS there are none.
TEST(Builtin, FastCounterOfPulsesNeedsPulses) {
  const auto stays = [](const std::string& pulses) {
    const ProgramInput input = inputOf("//@ prove still: never Q0.1\n",
                                       "Network 1\nLD SM0.1\nMOVB 16#F8, SMB37\nMOVD 0, SMD38\nHDEF 0, 12\nHSC 0\n" +
                                           pulses + "Network 2\nLDD> HC0, 100\n= Q0.1\n");
    return outcomeOf(prove(input.program, input.properties, usualOptions()), "still");
  };
  EXPECT_EQ(stays(""), Outcome::Proved);
  EXPECT_EQ(stays("MOVB 16#8D, SMB67\nMOVW 500, SMW68\nMOVD 400, SMD72\nPLS 0\n"), Outcome::Violated);
}

/// Hazards that the encoding has met, by place, against the questions that are asked: none is dropped on the way. Where
/// a pointer leads is not always found; that it may lead out of its area is met there all the same.
void expectThatEveryHazardIsAsked(const Program& program, const PropertySet& set, const ProverOptions& given,
                                  const std::string& name) {
  CheckGroups groups;
  groups.builtin = true;
  QuestionSystem system(program, set, {}, encoderOptionsOf(given), groups);
  std::multiset<const Instruction*> asked;
  for (const RuleQuestion& question : system.checks()) asked.insert(question.place);
  const auto isAsked = [&](Hazard hazard) {
    return std::ranges::any_of(groups.rules, [&](const Rule* rule) {
      return groups.has(*rule) && knows(*rule, program.target) &&
             std::ranges::find(rule->ask.hazards, hazard) != rule->ask.hazards.end();
    });
  };
  std::set<std::pair<const Instruction*, Hazard>> met;
  std::set<const Instruction*> withHazard;
  for (const HazardRecord& record : system.askedProperties().encoding().hazards()) {
    if (record.place == nullptr) continue;
    withHazard.insert(record.place);
    if (isAsked(record.hazard)) met.emplace(record.place, record.hazard);
  }
  for (const auto& [place, hazard] : met) {
    const auto wanted = std::ranges::count_if(met, [place = place](const auto& other) { return other.first == place; });
    EXPECT_GE(static_cast<std::ptrdiff_t>(asked.count(place)), wanted) << name << ": " << hazardInfo(hazard).text;
  }
  for (const Approximation& approximation : system.askedProperties().approximations()) {
    if (approximation.reason != "pointer whose targets could not be found") continue;
    EXPECT_TRUE(withHazard.contains(approximation.place)) << name << ": " << approximation.place->desc->stl;
  }
}

TEST(Builtin, EveryHazardOfThePointerProgramsIsAsked) {
  const std::string ring = "OPN DB 20;\nL IW 4;\nL 16;\n*I;\nLAR1;\nL ID 8;\nLAR2;\n";
  for (const char* access : {"L DBW [AR1,P#0.0];", "T DBB [AR1,P#2.0];", "L W [AR1,P#0.0];", "T D [AR2,P#0.0];",
                             "L MW [AR2,P#0.0];", "A DBX [AR2,P#0.0];", "= M [AR2,P#0.0];", "S [AR2,P#0.0];"}) {
    const ProgramInput input = inputOfSource(dataOf(20, 500) + "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n" + ring +
                                             access + "\nEND_ORGANIZATION_BLOCK\n");
    expectThatEveryHazardIsAsked(input.program, input.properties, usualOptions(), access);
  }
}

TEST(Builtin, EveryHazardOfTheCorpusIsAsked) {
  int programs = 0;
  for (const char* folder : {"s7300", "data", "interlocks"}) {
    for (const std::filesystem::path& file : corpusFiles(folder)) {
      const ProgramInput input = corpusInput(file);
      expectThatEveryHazardIsAsked(input.program, input.properties, proverOptions(file), file.filename().string());
      ++programs;
    }
  }
  EXPECT_GE(programs, 30);
}

}  // namespace
}  // namespace rungproof::test
