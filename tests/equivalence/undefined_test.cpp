// What no text says, in a comparison: values that the manual leaves undefined, and blocks without instructions. Both
// programs read the same where equal networks read it; a difference counts only if anyone can repeat it.
#include <filesystem>

#include "analysis/read_errors.hpp"
#include "analysis/unread/unread_code.hpp"
#include "ir/s7200/cpu.hpp"
#include "tests/equivalence/pair.hpp"

namespace rungproof::test {

namespace {

constexpr const char* callsWithOutput =
    "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1\nLD I0.1\nCALL SBR0, Q0.0\n"
    "END_ORGANIZATION_BLOCK\nSUBROUTINE_BLOCK SBR_0:SBR0\nVAR_OUTPUT\nout:BOOL;\n"
    "END_VAR\nBEGIN\n";
constexpr Target st40{s7200Cpu("ST40"), Edition::Smart28};
const std::string hiddenBody = "Network 1 // This POU is password-protected against editing and viewing.\n";

std::string withBody(const std::string& body) { return callsWithOutput + body + "END_SUBROUTINE_BLOCK\n"; }

/// As the commands compare: without what may not be run.
Equivalence comparedTexts(const std::string& before, const std::string& after, bool everyOutput = false,
                          const Target& ofNew = {}) {
  const Program one = readText("old.awl", before), other = readText("new.awl", after, {.target = ofNew});
  const UnreadCode unreadOne(one), unreadOther(other);
  const Program runOne = unreadOne.isWhole() ? one : unreadOne.executable();
  const Program runOther = unreadOther.isWhole() ? other : unreadOther.executable();
  EquivalenceOptions options;
  options.prover.timeout = 20;
  options.everyOutput = everyOutput;
  return compareBehaviour({&runOne, {}, &unreadOne}, {&runOther, {}, &unreadOther}, options);
}

bool namesPart(const std::vector<std::string>& texts, const std::string& part) {
  return std::ranges::any_of(texts, [&](const std::string& text) { return text.find(part) != std::string::npos; });
}

}  // namespace

/// L0.0 keeps what it had while I0.0 is 0, and a block enters with any local memory (001:1373): whatever it is, the
/// same program on the same machine finds the same.
TEST(Undefined, AnOutputThatIsOnlySetIsEqualToItself) {
  const std::string program = withBody("Network 1\nLD I0.0\nS L0.0, 1\n");
  for (const bool everyOutput : {false, true}) {
    const Equivalence found = comparedTexts(program, program, everyOutput);
    EXPECT_EQ(equalityText(found.equality), "EQUAL");
    EXPECT_TRUE(namesPart(found.assumptions, "local memory LB0")) << "what the equality rests on is said";
  }
}

TEST(Undefined, LocalMemoryOfACallThatStandsInBothIsTheSame) {
  const Equivalence found =
      comparedTexts(withBody("Network 1\nLD I0.0\nS L0.0, 1\n"), withBody("Network 1\nLD I0.0\nA I0.0\nS L0.0, 1\n"));
  EXPECT_EQ(equalityText(found.equality), "EQUAL") << "I0.0 AND I0.0 is I0.0";
}

TEST(Undefined, ADifferenceBesideAnUndefinedReadIsFound) {
  const Equivalence found =
      comparedTexts(withBody("Network 1\nLD I0.0\nS L0.0, 1\n"), withBody("Network 1\nLD I0.0\nAN I0.2\nS L0.0, 1\n"));
  EXPECT_EQ(equalityText(found.equality), "DIFFERENT") << "with I0.0, I0.1 and I0.2 on only OLD sets it";
}

/// NEW drives Q0.0 by the bottom of the stack, which no stimulus gives: with 0 there both are alike.
TEST(Undefined, ADifferenceThatRestsOnAnUndefinedValueIsOpenAndNamesIt) {
  const std::string pops = "LD I0.0;LPP;LPP;LPP;LPP;LPP;LPP;LPP;LPP;LPP;= Q0.0";
  const Equivalence found = comparedTexts(exportOf("LD I0.0;AN I0.0;= Q0.0"), exportOf(pops));
  EXPECT_EQ(equalityText(found.equality), "UNKNOWN");
  EXPECT_FALSE(found.run) << "no run that nobody can repeat";
  EXPECT_TRUE(namesPart(found.notes, "logic stack"));
  EXPECT_TRUE(found.disagreements.empty());
  const Equivalence same = comparedTexts(exportOf(pops), exportOf(pops));
  EXPECT_EQ(equalityText(same.equality), "EQUAL");
}

TEST(Undefined, ABlockThatOnlyOneProgramShowsLeavesEverythingOpen) {
  const std::string shown = withBody("Network 1\nLD I0.0\n= L0.0\n"), hidden = withBody(hiddenBody);
  for (const bool everyOutput : {false, true}) {
    for (const auto& [before, after] : {std::pair{shown, hidden}, {hidden, shown}}) {
      const Equivalence found = comparedTexts(before, after, everyOutput);
      EXPECT_EQ(equalityText(found.equality), "UNKNOWN") << "a password protects it in one of them";
      EXPECT_FALSE(found.run);
      EXPECT_TRUE(namesPart(found.notes, "SBR_0 is called in"));
      for (const ObservedVerdict& output : found.outputs) EXPECT_EQ(output.equality, Equality::Unknown) << output.name;
    }
  }
}

TEST(Undefined, AHiddenBlockThatOnlyOneProgramCallsLeavesEverythingOpen) {
  std::string without = withBody(hiddenBody);
  without.replace(without.find("CALL SBR0, Q0.0"), 15, "= Q0.5");
  std::string with = without;
  with.replace(with.find("= Q0.5"), 6, "= Q0.5\nCALL SBR0, Q0.0");
  const Equivalence found = comparedTexts(with, without);
  EXPECT_EQ(equalityText(found.equality), "UNKNOWN");
  EXPECT_TRUE(namesPart(found.notes, "only OLD calls SBR_0"));
}

TEST(Undefined, AHiddenBlockOfBothIsNeverADifference) {
  const std::string hidden = withBody(hiddenBody);
  EXPECT_NE(comparedTexts(hidden, hidden).equality, Equality::Different);
}

/// A missing block against one with text: the readers know it by the same number.
TEST(Undefined, ABlockThatIsInNoFileOfOneProgramLeavesEverythingOpen) {
  const std::string main =
      "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1\nLD I0.1\nCALL SBR0, Q0.0\n"
      "END_ORGANIZATION_BLOCK\n";
  const Equivalence found = comparedTexts(main, withBody("Network 1\nLD I0.0\n= L0.0\n"));
  EXPECT_EQ(equalityText(found.equality), "UNKNOWN");
  EXPECT_FALSE(found.run);
}

/// S7-300/400: KNOW_HOW_PROTECT in a source leaves no statements.
TEST(Undefined, AProtectedFunctionOfAnS7300LeavesEverythingOpen) {
  const std::string main = "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\nUC FC 1;\nEND_ORGANIZATION_BLOCK\n";
  const std::string shown = "FUNCTION FC 1 : VOID\nBEGIN\nNETWORK\nU E 0.0;\n= A 0.0;\nEND_FUNCTION\n" + main;
  const std::string hidden = "FUNCTION FC 1 : VOID\nKNOW_HOW_PROTECT\nBEGIN\nEND_FUNCTION\n" + main;
  for (const auto& [before, after] : {std::pair{shown, hidden}, {hidden, shown}, {hidden, hidden}}) {
    const Equivalence found = comparedTexts(before, after);
    EXPECT_EQ(equalityText(found.equality), "UNKNOWN");
    EXPECT_FALSE(found.run);
    EXPECT_FALSE(found.notes.empty());
  }
}

/// ACCU2 of an organization block that has loaded one number has any value, the same for both.
TEST(Undefined, AccumulatorsAtTheStartOfAnOrganizationBlockAreTheSame) {
  const std::string program = "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\nL 5;\n+I;\nT AW 2;\nEND_ORGANIZATION_BLOCK\n";
  EXPECT_EQ(equalityText(comparedTexts(program, program).equality), "EQUAL");
}

/// What VD0 and VD2 hold is known - 0, cos 0 and what follows - but not to whom checks certificates, for whom COS is
/// any value. Such a certificate proves nothing, and is no fault of the program.
TEST(Undefined, ACertificateThatRestsOnACosineProvesNothing) {
  const std::string loop = "A V2.6;LDN C0;AN SM0.1;COS VD0,VD2;LDN Q0.2";
  const Equivalence found = comparedTexts(exportOf(loop + ";= C0"), exportOf(loop), false, st40);
  EXPECT_NE(equalityText(found.equality), "DIFFERENT");
  EXPECT_TRUE(found.disagreements.empty());
}

/// Without PLS no generator runs, so that the forms of their registers say nothing.
TEST(Undefined, AProgramWithoutPulsesIsEqualOnBothFamilies) {
  const std::string program = exportOf("LD I0.0;TON T37,10|LD T37;= Q0.0|LD I0.1;EU;INCW VW0|LDW>= VW0,5;= Q0.1");
  EXPECT_EQ(equalityText(comparedTexts(program, program, false, st40).equality), "EQUAL");
  EXPECT_EQ(equalityText(comparedTexts(exportOf("LD I0.0;= Q0.0"), exportOf("LDN I0.0;= Q0.0"), false, st40).equality),
            "DIFFERENT");
}

/// 100 and 101 steps of 1 ms: scans of 1 ms show it, and need no moment within a scan.
TEST(Undefined, APlainRunIsPreferred) {
  const Equivalence found =
      comparedTexts(exportOf("LD I0.0;TON T32,100|LD T32;= Q0.0"), exportOf("LD I0.0;TON T32,101|LD T32;= Q0.0"));
  ASSERT_EQ(equalityText(found.equality), "DIFFERENT");
  for (const ReplayScan& scan : found.run->before) EXPECT_TRUE(scan.script.ticks1.empty());
}

/// Whatever a program does, it does it twice alike. One short look at each: a comparison that takes longer is UNKNOWN.
TEST(Undefined, NoProgramOfTheCorpusDiffersFromItself) {
  constexpr std::size_t leastPrograms = 100, leastEqual = 80;
  std::size_t programs = 0, equal = 0;
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(std::filesystem::path(RUNGPROOF_SOURCE_DIR) / "corpus")) {
    const std::string extension = entry.path().extension().string();
    if (extension != ".awl" && extension != ".xml") continue;
    const Program program = readProgram({entry.path().string()});
    if (hasReadErrors(program) || program.main() == nullptr) continue;
    const UnreadCode unread(program);
    const Program run = unread.isWhole() ? program : unread.executable();
    EquivalenceOptions options;
    options.prover.timeout = 3;
    const Equivalence found = compareBehaviour({&run, {}, &unread}, {&run, {}, &unread}, options);
    ++programs;
    equal += found.equality == Equality::Equal ? 1 : 0;
    EXPECT_NE(found.equality, Equality::Different) << entry.path();
    EXPECT_TRUE(found.equality == Equality::Equal || !found.notes.empty()) << entry.path() << ": no reason is named";
    EXPECT_TRUE(found.disagreements.empty()) << entry.path();
  }
  EXPECT_GE(programs, leastPrograms);
  EXPECT_GE(equal, leastEqual);
}

}  // namespace rungproof::test
