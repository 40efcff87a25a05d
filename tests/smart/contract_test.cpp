// Blocks without text: what a call of one may write is any value, what it cannot write is decided as ever. Libraries by
// their parameters (001:10594-10834 and the libraries of the S7-200 SMART), other blocks by what the call gives them.
#include "analysis/drawing/editor_verdict.hpp"
#include "analysis/lint/lint.hpp"
#include "analysis/unread/hidden_blocks.hpp"
#include "engine/simulator.hpp"
#include "frontend/cli/cli.hpp"
#include "frontend/settings/retentive_range.hpp"
#include "ir/s7200/call_contract.hpp"
#include "tests/prover/proved_text.hpp"
#include "tests/temporary_folder.hpp"

namespace rungproof {
namespace {

using test::outcomeOf;
using test::usualOptions;

constexpr Target callingCpu{s7200Cpu("ST40"), Edition::Smart28};

/// A main program; ';' ends a line, '|' begins a network.
std::string mainOf(const std::string& lines, const std::string& properties = "") {
  std::string text = "ORGANIZATION_BLOCK MAIN:OB1\n" + properties + "BEGIN\n";
  int network = 0;
  for (const char c : "|" + lines) {
    if (c == '|')
      text += "\nNetwork " + std::to_string(++network) + "\n";
    else
      text += c == ';' ? '\n' : c;
  }
  return text + "\nEND_ORGANIZATION_BLOCK\n";
}

struct Proved {
  Outcome outcome = Outcome::Unknown;
  std::string assumptions;
};

/// The verdict on "prove p: PROPERTY" over a program of the S7-200 SMART.
Proved provedOn(const std::string& lines, const std::string& property, const std::string& otherBlocks = "",
                const Choices& choices = {}, const std::string& libraryMemory = "") {
  ProgramInput input;
  input.program =
      readText("test.awl", mainOf(lines, "//@ prove p: " + property + "\n") + otherBlocks, {.target = callingCpu});
  if (!libraryMemory.empty()) input.program.libraryMemory.push_back(*libraryMemoryNamed(libraryMemory));
  input.properties = readProperties(input.program, {}, lookupIn(input.program));
  const UnreadCode unread(input.program, choices);
  EXPECT_FALSE(unread.isRefused()) << lines;
  ProverOptions options = usualOptions();
  options.choices = choices;
  options.unread = &unread;
  const ProofRun run = prove(unread.executable(), input.properties, options);
  EXPECT_TRUE(run.disagreements.empty()) << lines;
  Proved proved{outcomeOf(run, "p"), ""};
  for (const std::string& text : run.assumptions) proved.assumptions += text + "\n";
  return proved;
}

Outcome verdictOn(const std::string& lines, const std::string& property) { return provedOn(lines, property).outcome; }

constexpr const char* ctrl = "LD SM0.0;CALL MBUS_CTRL, SM0.0, 9600, 0, 0, 1000, M0.0, MB1|";
constexpr const char* interlock = "|LD V10.0;AN V10.1;= Q0.0|LD V10.1;AN V10.0;= Q0.1";

/// A master reads two words to VB100; another request sends those from VB200.
const std::string master = std::string(ctrl) +
                           "LD SM0.5;EU;= M5.0|LD SM0.5;CALL MBUS_MSG, M5.0, 2, 0, 40001, 2, &VB100, M2.0, MB3|"
                           "LDN SM0.5;CALL MBUS_MSG, M5.0, 2, 1, 40003, 2, &VB200, M2.1, MB4";

TEST(Contract, OutputsOfALibraryBlockAreAnyValue) {
  EXPECT_EQ(verdictOn(master, "never M0.0"), Outcome::Violated);
  EXPECT_EQ(verdictOn(master, "MB1 = 0"), Outcome::Violated);
  EXPECT_EQ(verdictOn(master + "|LD M2.0;= Q0.0", "never Q0.0"), Outcome::Violated);
  // Inputs are read: MBUS_CTRL does not write its Mode, nor MBUS_MSG its First.
  EXPECT_EQ(verdictOn("LD I0.0;= M9.0|LD SM0.0;CALL MBUS_CTRL, M9.0, 9600, 0, 0, 1000, M0.0, MB1", "M9.0 = I0.0"),
            Outcome::Proved);
}

TEST(Contract, AMessageThatIsReadFillsItsBufferAndNoMore) {
  for (const char* inside : {"VW100 = 0", "VB103 = 0"})
    EXPECT_EQ(verdictOn(master, inside), Outcome::Violated) << inside;
  const std::string beside = master + "|LD I0.0;MOVW 7, VW104;MOVW 7, VW98";
  EXPECT_EQ(verdictOn(beside, "VW104 = 0 or VW104 = 7"), Outcome::Proved) << "two words end at VB103";
  EXPECT_EQ(verdictOn(beside, "VW98 = 0 or VW98 = 7"), Outcome::Proved);
  EXPECT_EQ(verdictOn(master + "|LD I0.0;MOVW 7, VW200", "VW200 = 0 or VW200 = 7"), Outcome::Proved)
      << "RW = 1 sends the buffer";
}

TEST(Contract, BitsCountAsBits) {
  const std::string call = "LD SM0.5;EU;CALL MBUS_MSG, SM0.0, 2, 0, 10001, 12, &VB100, M2.0, MB3|LD I0.0;MOVB 7, VB102";
  EXPECT_EQ(verdictOn(call, "VB101 = 0"), Outcome::Violated);
  EXPECT_EQ(verdictOn(call, "VB102 = 0 or VB102 = 7"), Outcome::Proved) << "twelve bits are two bytes";
}

TEST(Contract, ACountThatTheProgramMakesMayBeTheLongest) {
  const std::string call =
      "LD SM0.5;EU;CALL MBUS_MSG, SM0.0, 2, 0, 40001, VW0, &VB100, M2.0, MB3|LD I0.0;MOVB 7, VB340";
  EXPECT_EQ(verdictOn(call, "VB339 = 0"), Outcome::Violated);
  EXPECT_EQ(verdictOn(call, "VB340 = 0 or VB340 = 7"), Outcome::Proved) << "120 words are 240 bytes (001:10711)";
}

/// The buffer changes in the call: in front of it and behind it the program may read two values in one scan.
TEST(Contract, ABufferChangesInTheMiddleOfAScan) {
  const std::string twice = std::string(ctrl) + "LDW= VW100, 1;= M6.0|" +
                            "LD SM0.0;CALL MBUS_MSG, M5.0, 2, 0, 40001, 2, &VB100, M2.0, MB3|" +
                            "LDW= VW100, 1;AN M6.0;= Q0.0";
  EXPECT_EQ(verdictOn(twice, "never Q0.0"), Outcome::Violated);
}

TEST(Contract, WhatDoesNotDependOnItIsDecided) {
  EXPECT_EQ(verdictOn(master + interlock, "not (Q0.0 and Q0.1)"), Outcome::Proved);
  EXPECT_EQ(verdictOn(master + "|LD V100.0;A I0.1;= Q0.2", "Q0.2 implies I0.1"), Outcome::Proved)
      << "whatever the partner sends";
  EXPECT_EQ(verdictOn(master + "|LD V100.0;A I0.1;= Q0.2", "not Q0.2"), Outcome::Violated);
}

TEST(Contract, TheSlaveLetsTheMasterWriteWhatInitGaveIt) {
  const std::string slave =
      "LD SM0.1;CALL MBUS_INIT, 1, 3, 9600, 0, 0, 0, 4, 0, 10, &VB500, M0.0, MB1|LD SM0.0;CALL MBUS_SLAVE, M0.1, MB2|";
  EXPECT_EQ(verdictOn(slave + "LD I0.0;= Q1.0", "VW518 = 0"), Outcome::Violated);
  EXPECT_EQ(verdictOn(slave + "LD I0.0;MOVW 7, VW520", "VW520 = 0 or VW520 = 7"), Outcome::Proved);
  // Four outputs: Q0.3 reaches the terminal as the master wrote it, Q0.4 does not (001:10715).
  EXPECT_EQ(verdictOn(slave, "never Q0.3"), Outcome::Violated);
  EXPECT_EQ(verdictOn(slave + "LD I0.0;AN I0.0;= Q0.4", "never Q0.4"), Outcome::Proved);
  EXPECT_EQ(verdictOn(slave + "LD I0.0;AN I0.0;= Q0.3", "never Q0.3"), Outcome::Proved) << "assigned behind the slave";
  EXPECT_EQ(verdictOn("LD I0.0;AN I0.0;= Q0.3|" + slave, "never Q0.3"), Outcome::Violated) << "assigned in front of it";
}

TEST(Contract, ASlaveThatNobodyInitialisesMayBeGivenAnything) {
  const std::string slave = "LD SM0.0;CALL MBUS_SLAVE, M0.1, MB2|LD I0.0;= M7.0";
  EXPECT_EQ(verdictOn(slave, "VW518 = 0"), Outcome::NotCovered);
  EXPECT_EQ(verdictOn(slave, "M7.0 = I0.0"), Outcome::Proved);
}

TEST(Contract, TheServerHasItsRegistersInItsCall) {
  const std::string server = "LD SM0.0;CALL MBUS_SERVER, SM0.0, 502, 0, 0, 4, &VB900, M0.0, MB1|LD I0.0;MOVB 1, VB908";
  EXPECT_EQ(verdictOn(server, "VB907 = 0"), Outcome::Violated);
  EXPECT_EQ(verdictOn(server, "VB908 <= 1"), Outcome::Proved);
}

TEST(Contract, APointerThatTheProgramMakesLeavesVOpen) {
  const std::string call = "LD SM0.0;MOVD &VB100, VD0|LD SM0.5;EU;CALL MBUS_MSG, SM0.0, 2, 0, 40001, 2, VD0, M2.0, MB3";
  EXPECT_EQ(verdictOn(call, "VB3000 = 0"), Outcome::NotCovered);
  EXPECT_EQ(verdictOn(call + "|LD I0.0;= Q0.0", "Q0.0 = I0.0"), Outcome::Proved);
}

TEST(Contract, ARecipeLiesWhereTheWizardPutIt) {
  const std::string recipe = "LD I0.0;CALL RCP0_READ, 1, VB10|LD I0.1;= Q0.0";
  EXPECT_EQ(verdictOn(recipe, "VB100 = 0"), Outcome::NotCovered);
  EXPECT_EQ(verdictOn(recipe, "Q0.0 = I0.1"), Outcome::Proved);
  EXPECT_EQ(provedOn(recipe, "VB100 = 0", "", {}, "RCP0_READ=VB100..VB119").outcome, Outcome::Violated);
  const std::string beside = recipe + "|LD I0.0;MOVB 7, VB120";
  EXPECT_EQ(provedOn(beside, "VB120 = 0 or VB120 = 7", "", {}, "RCP0_READ=VB100..VB119").outcome, Outcome::Proved);
  EXPECT_EQ(provedOn(beside, "VB120 = 0 or VB120 = 7", "", {}, "VB100..VB119").outcome, Outcome::NotCovered)
      << "the memory of some library need not be the recipe's";
}

/// A network wizard moves data to V memory of its own choice.
TEST(Contract, ANetworkWizardFillsVWhereItLikes) {
  const std::string call = "LD SM0.0;CALL NET_EXE, 0, M0.0, M0.1|LD I0.1;= Q0.0";
  EXPECT_EQ(verdictOn(call, "VW200 = 0"), Outcome::NotCovered);
  EXPECT_EQ(verdictOn(call, "never M0.1"), Outcome::Violated);
  EXPECT_EQ(verdictOn(call, "Q0.0 = I0.1"), Outcome::Proved);
}

TEST(Contract, TheMemoryOfALibraryIsFreeWhereItIsPlaced) {
  const std::string program = std::string(ctrl) + "LD I0.0;MOVB 7, VB1000";
  EXPECT_EQ(verdictOn(program, "VB1000 = 0 or VB1000 = 7"), Outcome::Proved);
  EXPECT_NE(provedOn(program, "VB1000 <= 7").assumptions.find("286 bytes"), std::string::npos);
  const Proved placed = provedOn(program, "VB1000 = 0 or VB1000 = 7", "", {}, "VB1000..VB1285");
  EXPECT_EQ(placed.outcome, Outcome::Violated);
  EXPECT_EQ(placed.assumptions.find("286 bytes"), std::string::npos);
}

TEST(Contract, AccumulatorsAndStatusAreDestroyedUnlessByModbus) {  // 001:6769, 001:10038, 001:10704
  const auto across = [](const std::string& call) { return "LD SM0.0;MOVW 5, AC1|" + call + "|LDW<> AC1, 5;= Q0.0"; };
  EXPECT_EQ(verdictOn(across("LD SM0.0;CALL AXIS0_RSEEK, M0.0, M0.1, MB1"), "never Q0.0"), Outcome::Violated);
  EXPECT_EQ(verdictOn(across("LD SM0.0;CALL SBR21, I0.0, M0.1"), "never Q0.0"), Outcome::Violated);
  EXPECT_EQ(verdictOn(across("LD SM0.0;CALL MBUS_CTRL, SM0.0, 9600, 0, 0, 1000, M0.0, MB1"), "never Q0.0"),
            Outcome::Proved);
  EXPECT_EQ(verdictOn("LD SM0.0;MOVW 5, VW0;+I 1, VW0|LD SM0.0;CALL SBR21, I0.0, M0.1|LD SM1.0;= Q0.0", "never Q0.0"),
            Outcome::Violated);
}

/// What a block that is in no file is given to write.
TEST(Contract, AMissingBlockMayWriteWhatItIsGiven) {
  const std::string call = "LD SM0.0;CALL SBR21, I0.0, 5, VW10, M0.0, Q0.3, VD20|LD I0.0;MOVW 7, VW12";
  for (const char* given : {"VW10 = 0", "never M0.0", "never Q0.3", "VD20 = 0"})
    EXPECT_EQ(verdictOn(call, given), Outcome::Violated) << given;
  EXPECT_EQ(verdictOn(call, "VW12 = 0 or VW12 = 7"), Outcome::Proved);
  EXPECT_EQ(verdictOn(call + interlock, "not (Q0.0 and Q0.1)"), Outcome::Proved);
  EXPECT_EQ(verdictOn(call + "|LD I0.0;= Q0.4", "Q0.4 = I0.0"), Outcome::Proved) << "inputs stay what they are";
  EXPECT_NE(provedOn(call, "VW12 = 0 or VW12 = 7").assumptions.find("missing-blocks = by-signature"),
            std::string::npos);
}

TEST(Contract, AnAddressIsGivenWithWhatStandsBehindIt) {
  const std::string call = "LD SM0.0;CALL SBR21, &VB100, M0.0|LD I0.0;MOVW 7, VW98";
  EXPECT_EQ(verdictOn(call, "VB100 = 0"), Outcome::Violated);
  EXPECT_EQ(verdictOn(call, "VB4000 = 0"), Outcome::Violated);
  EXPECT_EQ(verdictOn(call, "VW98 = 0 or VW98 = 7"), Outcome::Proved);
}

/// It is not called for nothing: where it writes what, nobody says.
TEST(Contract, AMissingBlockThatIsGivenNothingMayDoAnything) {
  for (const char* call : {"LD SM0.0;CALL SBR21, I0.0|LD I0.0;= Q0.0", "LD SM0.0;CALL SBR21, 5, AIW16|LD I0.0;= Q0.0"})
    EXPECT_EQ(verdictOn(call, "Q0.0 = I0.0"), Outcome::NotCovered) << call;
}

TEST(Contract, TheChoiceMayLetMissingBlocksDoAnything) {
  Choices choices;
  ASSERT_TRUE(choices.set("missing-blocks", "anything"));
  EXPECT_EQ(provedOn("LD SM0.0;CALL SBR21, I0.0, M0.0|LD I0.0;= Q0.0", "Q0.0 = I0.0", "", choices).outcome,
            Outcome::NotCovered);
  EXPECT_EQ(provedOn("LD SM0.0;CALL MBUS_SLAVE, M0.1, MB2|LD I0.0;= M7.0", "M7.0 = I0.0", "", choices).outcome,
            Outcome::Proved)
      << "a library block is described";
}

TEST(Contract, AProtectedBlockIsDescribedByItsTable) {
  const std::string block =
      "SUBROUTINE_BLOCK Dosing:SBR4\nVAR_INPUT\nGo:BOOL;\nEND_VAR\nVAR_IN_OUT\nTotal:INT;\nEND_VAR\nVAR_OUTPUT\n"
      "Open:BOOL;\nEND_VAR\nBEGIN\nNetwork 1 // This POU is password-protected against editing and viewing.\n"
      "END_SUBROUTINE_BLOCK\n";
  const std::string call = "LD I0.0;= M3.0|LD SM0.0;CALL Dosing, M3.0, VW10, M0.1|LD I0.0;= Q0.4";
  EXPECT_EQ(provedOn(call, "VW10 = 0", block).outcome, Outcome::Violated);
  EXPECT_EQ(provedOn(call, "never M0.1", block).outcome, Outcome::Violated);
  EXPECT_EQ(provedOn(call, "M3.0 = I0.0", block).outcome, Outcome::Proved) << "an input is read";
  EXPECT_EQ(provedOn(call, "Q0.4 = I0.0", block).outcome, Outcome::Proved);
}

// What the library's row says stands where the listing has no table.
TEST(Contract, AProtectedLibraryBlockNeedsNoTable) {
  const std::string block =
      "SUBROUTINE_BLOCK MBUS_CTRL:SBR4\nBEGIN\nNetwork 1 // This POU is password-protected against editing and "
      "viewing.\nEND_SUBROUTINE_BLOCK\n";
  const std::string call = "LD SM0.0;CALL SBR4, SM0.0, 9600, 0, 1000, M0.1, MB1|LD I0.0;= Q0.4";
  EXPECT_EQ(provedOn(call, "Q0.4 = I0.0", block).outcome, Outcome::Proved);
  EXPECT_EQ(provedOn(call, "never M0.1", block).outcome, Outcome::Violated) << "Done";
  EXPECT_EQ(provedOn(call, "MB1 = 0", block).outcome, Outcome::Violated) << "Error";
}

std::vector<std::string> rulesOn(const std::string& text) {
  const Program program = readText("test.awl", text, {.target = callingCpu});
  const Facts facts(program);
  std::vector<std::string> rules;
  for (const Finding& finding : runRules(facts, RuleSelection(), {})) rules.push_back(finding.rule);
  return rules;
}

TEST(Contract, LintNotesAMissingBlockOnce) {
  const std::vector<std::string> rules =
      rulesOn(mainOf("LD I0.0;CALL SBR21, I0.0, M0.0|LD I0.1;CALL SBR21, I0.1, M0.1|LD M0.0;O M0.1;= Q0.0"));
  EXPECT_EQ(std::ranges::count(rules, "SUB008"), 1);
  for (const char* silent : {"SUB001", "SUB003", "SUB006", "SYM001", "ADR010", "ADR011"})
    EXPECT_EQ(std::ranges::count(rules, silent), 0) << silent;
  EXPECT_EQ(std::ranges::count(rulesOn(mainOf("LD SM0.0;CALL SBR21|LD I0.0;= Q0.0")), "SUB003"), 1);
  // A name that nothing explains is no block: the editor leaves the network out.
  for (const char* call : {"CALL Foo", "CALL Mixer_Unit, I0.0, M0.0"}) {
    const std::vector<std::string> unknown = rulesOn(mainOf(std::string("LD SM0.0;") + call + "|LD I0.0;= Q0.0"));
    EXPECT_EQ(std::ranges::count(unknown, "SYM001"), 1) << call;
    EXPECT_EQ(std::ranges::count(unknown, "SUB008"), 0) << call;
  }
}

TEST(Contract, TheNoteSaysWhatTheBlockMayWrite) {
  const auto noteOn = [](const std::string& lines) {
    const Program program = readText("test.awl", mainOf(lines), {.target = callingCpu});
    const Facts facts(program);
    const std::vector<MissingBlock> blocks = missingBlocks(facts);
    return blocks.size() == 1 ? missingText(blocks[0]) : "";
  };
  EXPECT_EQ(noteOn("LD I0.0;CALL SBR21, I0.0, M0.0|LD I0.0;CALL SBR21, I0.0, M0.1"),
            "SBR21 is called 2 times, but no file holds it: what its calls give it to write may be any value");
  EXPECT_EQ(noteOn("LD I0.0;CALL SBR22, I0.0"),
            "SBR22 is called, but no file holds it, and a call gives it nothing to write: it may write anything");
}

TEST(Contract, LibrariesComeInSeveralVersions) {
  // The master of the S7-200 has no parameter Port; the text of 2004 knows neither.
  for (const char* call : {"LD SM0.0;CALL MBUS_CTRL, SM0.0, 9600, 0, 1000, M0.0, MB1",
                           "LD SM0.0;CALL MBUS_CTRL, SM0.0, 9600, 0, 0, 1000, M0.0, MB1",
                           "LD SM0.0;CALL PID0_CTRL, AIW16, 0.5, SM0.0, 0.0, AQW16, M0.0, M0.1",
                           "LD SM0.0;CALL TCP_RECV, 1, 100, &VB100, M0.0, M0.1, M0.2, MB1, VW8"}) {
    const std::vector<std::string> rules = rulesOn(mainOf(std::string(call) + "|LD M0.0;= Q0.0"));
    for (const char* silent : {"SUB003", "SUB008", "SYM001", "ADR010"})
      EXPECT_EQ(std::ranges::count(rules, silent), 0) << call;
  }
}

TEST(Contract, WhereParametersDifferInputsComeFirstAndOutputsLast) {
  const std::string log = "LD I0.0;= M3.0|LD M3.0;EU;CALL DAT0_WRITE, VD100, M3.0, VW104, MB20";
  EXPECT_EQ(verdictOn(log, "VD100 = 0"), Outcome::Proved) << "nothing writes the fields of the record";
  EXPECT_EQ(verdictOn(log, "M3.0 = I0.0"), Outcome::Proved);
  EXPECT_EQ(verdictOn(log, "MB20 = 0"), Outcome::Violated);
  const std::string loop = "LD I0.0;= M3.0|LD SM0.0;CALL PID0_CTRL, AIW16, VD200, M3.0, VD204, AQW16, M4.0";
  EXPECT_EQ(verdictOn(loop, "VD200 = 0"), Outcome::Proved) << "the setpoint is an input";
  EXPECT_EQ(verdictOn(loop, "never M4.0"), Outcome::Violated);
}

TEST(Contract, CheckTakesNetworksWithSuchCalls) {
  for (const char* call :
       {"LD SM0.0;CALL SBR21, I0.0, VW10, M0.0", "LD SM0.0;CALL SBR22, I0.0, M0.0",
        "LD SM0.0;CALL MBUS_SLAVE, M0.1, MB2", "LD SM0.0;CALL AXIS0_CTRL, I0.0, M0.0, MB1, VD0, VD4, M0.1"}) {
    const Program program = readText("test.awl", mainOf(call), {.target = callingCpu});
    const UnreadCode unread(program);
    EXPECT_EQ(editorVerdicts(program, unread, EditorLanguage::Ladder).front().reason, "") << call;
  }
}

TEST(Contract, ARunGivesMissingBlocksWhatTheStimulusSays) {
  const Program program = readText("test.awl", mainOf("LD I0.0;MOVW 7, VW10|LD SM0.0;CALL SBR21, I0.0, VW10, M0.0"),
                                   {.target = callingCpu});
  Simulator simulator(program);
  simulator.write(direct(Area::I, Width::Bit, 0, 0), 1);
  simulator.scan();
  EXPECT_EQ(simulator.read(direct(Area::V, Width::Word, 10)), 7U) << "perhaps an input: it stays";
  simulator.devices().setLibraryOutput("SBR21", 3, 1);
  simulator.scan();
  EXPECT_EQ(simulator.read(direct(Area::M, Width::Bit, 0, 0)), 1U);
}

/// The trace of a witness says what the block gave, and a run with that stimulus shows the same.
TEST(Contract, AWitnessIsAStimulus) {
  const test::TemporaryFolder folder;
  const std::string file = folder.file(
      "a.awl", mainOf("LD SM0.0;CALL MBUS_MSG, SM0.0, 2, 1, 40001, 2, &VB100, M2.0, MB3|LD SM0.0;CALL SBR21, "
                      "I0.0, VB9|LDB= VB9, 7;A M2.0;= Q0.0",
                      "//@ prove p: never Q0.0\n"));
  const auto run = [](const std::vector<std::string>& arguments) {
    std::istringstream in;
    std::ostringstream out, err;
    runProgram(arguments, {in, out, err});
    return out.str() + err.str();
  };
  const std::string proved = run({"prove", "--isolated", "--cpu", "ST40", file, "--traces", folder.path("traces")});
  EXPECT_NE(proved.find("VIOLATED"), std::string::npos) << proved;
  EXPECT_NE(proved.find("MBUS_MSG.Done"), std::string::npos) << "the run is shown with it\n" << proved;
  EXPECT_NE(proved.find("SBR21.2"), std::string::npos) << proved;
  const std::string shown = run({"sim", "--isolated", "--cpu", "ST40", file, "--stimulus", folder.path("traces/p.csv"),
                                 "--signals", "Q0.0", "--trace", "-"});
  EXPECT_NE(shown.find("Q0.0\n1,10,10,1\n"), std::string::npos) << shown;
}

TEST(Contract, LintTellsOfAccessesToTheMemoryOfALibrary) {
  Program program =
      readText("test.awl", mainOf("LD I0.0;MOVW 7, VW1284;MOVW 7, VW1286;MOVB 1, VB100"), {.target = callingCpu});
  program.libraryMemory = {*libraryMemoryNamed("VB1000..VB1285"), *libraryMemoryNamed("RCP0_READ=VB100..VB119")};
  const Facts facts(program);
  std::vector<std::string> addresses;
  for (const Finding& finding : runRules(facts, RuleSelection({"LIB003"}, {}), {}))
    addresses.push_back(finding.address);
  EXPECT_EQ(addresses, std::vector<std::string>{"VW1284"});
}

TEST(Contract, LibraryMemoryIsNamedByItsBytes) {
  EXPECT_TRUE(libraryMemoryNamed("VB0..VB9"));
  EXPECT_FALSE(libraryMemoryNamed("MB0..MB9"));
  EXPECT_FALSE(libraryMemoryNamed("=VB0..VB9"));
  EXPECT_FALSE(libraryMemoryNamed("RCP0_READ"));
  EXPECT_EQ(libraryMemoryNamed("RCP0_READ=VB100..VB119")->block, "RCP0_READ");
}

/// A file whose name has no number takes none that the project gives to another block: SBR0 and, by the symbol table,
/// SBR1 are missing, and Pump is neither.
TEST(Contract, AMissingNumberIsNoOtherBlock) {
  const test::TemporaryFolder folder;
  folder.file("MAIN.stl",
              "Network 1\nLD SM0.0\nCALL Pump\nNetwork 2\nLD I0.0\nCALL SBR0, I0.0, M0.0\nNetwork 3\nLD I0.1\nCALL "
              "MBUS_SLAVE, M0.1, MB4\n");
  folder.file("Pump.stl",
              "Network 1\nLD I0.2\nEU\n= M0.2\nNetwork 2\nLD I0.3\nCALL SBR0, I0.1, M0.3\nNetwork 3\nLD M0.2\nCALL "
              "Drive, I0.4, Q0.0\n");
  folder.file("symbols.txt", "MBUS_SLAVE\tSBR2\tlibrary\nDrive\tSBR1\tmaker\n");
  const Program program = readProgram(expandFolders({folder.folder().string()}), {.target = callingCpu});
  for (const Finding& finding : program.findings) EXPECT_NE(finding.severity, Severity::Error) << finding.message;
  const Facts facts(program);
  std::vector<std::string> names;
  for (const auto& [id, contract] : facts.contracts().all()) names.push_back(contract.name);
  EXPECT_EQ(names, (std::vector<std::string>{"SBR0", "MBUS_SLAVE", "SBR0", "SBR1"}));
  for (const Finding& finding : runRules(facts, RuleSelection(), {}))
    EXPECT_FALSE(finding.rule.starts_with("SUB") && finding.severity != Severity::Note) << finding.message;
}

/// What is formed with & may be handed over in any double word, also by way of an accumulator or a pointer.
TEST(Contract, ADoubleWordMayHoldAnyAddressThatTheProgramForms) {
  for (const char* given : {"VD0", "AC1", "*VD4"}) {
    const std::string program = std::string("LD SM0.0;MOVD &VB200,VD0;MOVD &VB200,AC1;MOVD &VB0,VD4;CALL SBR21, ") +
                                given + ", M5.0|LD V210.0;= Q0.0";
    EXPECT_EQ(verdictOn(program, "never Q0.0"), Outcome::Violated) << given;
    EXPECT_EQ(verdictOn(program, "Q0.0 = V210.0"), Outcome::Proved) << given;
  }
  EXPECT_EQ(verdictOn("LD SM0.0;MOVD &VB200,VD0;CALL SBR21, VW0, M5.0|LD V210.0;= Q0.0", "never Q0.0"), Outcome::Proved)
      << "a word holds no address";
}

}  // namespace
}  // namespace rungproof
