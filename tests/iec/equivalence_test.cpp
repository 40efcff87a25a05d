// `equiv` and `diff` of IEC 61131-3 programs: variables stand for each other by their names, wherever they lie.
#include <gtest/gtest.h>

#include "tests/iec/iec_output.hpp"
#include "tests/temporary_folder.hpp"

namespace rungproof::test {
namespace {

const std::string press =
    "PROGRAM main\nVAR_INPUT start, stop, guard : BOOL; speed : INT; END_VAR\n"
    "VAR_OUTPUT motor : BOOL; lamp : BOOL; n : INT; END_VAR\nVAR t : TON; END_VAR\n"
    "motor := (start OR motor) AND NOT stop AND guard;\nt(IN := motor, PT := T#2s);\nlamp := t.Q;\n"
    "IF speed > 10 THEN n := n + 1; END_IF;\nEND_PROGRAM\n";
/// The same in other words, with other variables in between and everything elsewhere.
const std::string tidied =
    "PROGRAM main\nVAR delay : TON; helper : BOOL; END_VAR\nVAR_INPUT stop, start, guard : BOOL; speed : INT; END_VAR\n"
    "VAR_OUTPUT lamp, motor : BOOL; n : INT; END_VAR\nhelper := start OR motor;\n"
    "IF stop OR NOT guard THEN helper := FALSE; END_IF;\nmotor := helper;\ndelay(IN := motor, PT := T#2000ms);\n"
    "lamp := delay.Q;\nIF NOT (speed <= 10) THEN n := 1 + n; END_IF;\nEND_PROGRAM\n";

std::string with(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
    text.replace(at, from.size(), to);
  return text;
}

IecOutput compared(const std::string& command, const std::string& before, const std::string& after,
                   const std::vector<std::string>& more = {}) {
  const TemporaryFolder folder;
  std::vector<std::string> arguments = {command, folder.file("new.st", after)};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return runIec(arguments, before, "old.st");
}

TEST(IecEquivalence, ProgramsInOtherWordsAreEqual) {
  const IecOutput same = compared("equiv", press, press);
  EXPECT_TRUE(same.has("EQUAL") && !same.has("DIFFERENT")) << same.text;
  EXPECT_EQ(same.exit, 0);
  const IecOutput other = compared("equiv", press, tidied, {"--timeout", "60s"});
  EXPECT_TRUE(other.has("EQUAL  ")) << other.text;
  EXPECT_EQ(other.exit, 0);
}

// 10 ms more: in a scan between 2 s and 2.01 s behind the start the lamps differ. `<` for `<=`: at speed 10 only OLD
// counts not. A guard that is called otherwise is another input.
TEST(IecEquivalence, EachDifferenceIsShownWithItsVariable) {
  const IecOutput late = compared("equiv", press, with(tidied, "T#2000ms", "T#2s10ms"));
  EXPECT_EQ(late.exit, 1);
  EXPECT_TRUE(late.has("lamp: OLD 1, NEW 0")) << late.text;
  const IecOutput limit = compared("equiv", press, with(tidied, "speed <= 10", "speed < 10"));
  EXPECT_EQ(limit.exit, 1);
  EXPECT_TRUE(limit.has("n: OLD 0, NEW 1") && limit.has("speed becomes 10 in scan")) << limit.text;
  const IecOutput renamed = compared("equiv", press, with(tidied, "guard", "gate"));
  EXPECT_EQ(renamed.exit, 1) << renamed.text;
}

// Inputs of different names that lie at the same place are two inputs.
TEST(IecEquivalence, InputsAreTheirNames) {
  const auto program = [](const std::string& input) {
    return "PROGRAM main\nVAR_INPUT " + input + " : BOOL; END_VAR\nVAR_OUTPUT q : BOOL; END_VAR\nq := " + input +
           ";\nEND_PROGRAM\n";
  };
  EXPECT_EQ(compared("equiv", program("a"), program("a")).exit, 0);
  EXPECT_EQ(compared("equiv", program("a"), program("b")).exit, 1);
  const TemporaryFolder folder;
  const std::string map = folder.file("pairs.map", "a = b\n");
  const IecOutput paired = compared("equiv", program("a"), program("b"), {"--map", map});
  EXPECT_EQ(paired.exit, 0) << paired.text;
}

// OLD gives a with a delay of one scan, NEW at once: with a latency of 1 NEW's value is compared with that of OLD one
// scan ago, which is the value of a two scans ago.
TEST(IecEquivalence, ADifferenceShowsTheValuesThatWereCompared) {
  const IecOutput late =
      compared("equiv",
               "PROGRAM main\nVAR_INPUT a : BOOL; END_VAR\nVAR_OUTPUT q : BOOL; END_VAR\nVAR m : BOOL; END_VAR\n"
               "q := m; m := a;\nEND_PROGRAM\n",
               "PROGRAM main\nVAR_INPUT a : BOOL; END_VAR\nVAR_OUTPUT q : BOOL; END_VAR\nq := a;\nEND_PROGRAM\n",
               {"--latency", "1"});
  EXPECT_EQ(late.exit, 1);
  EXPECT_TRUE(late.has("q: OLD 0, NEW 1") || late.has("q: OLD 1, NEW 0")) << late.text;
}

TEST(IecEquivalence, AnInputIsNotCompared) {
  const std::string text =
      "PROGRAM main\nVAR_INPUT a : BOOL; END_VAR\nVAR_OUTPUT q : BOOL; END_VAR\nq := a;\nEND_PROGRAM\n";
  const IecOutput output = compared("equiv", text, text, {"--observe", "a"});
  EXPECT_EQ(output.exit, 2);
  EXPECT_TRUE(output.has("a is an input")) << output.text;
}

TEST(IecEquivalence, AProgramMayBeNamedLikeItsOutput) {  // m is no output: its negation is seen nowhere else
  const auto text = [](const std::string& sign) {
    return "PROGRAM Pump\nVAR_INPUT a : BOOL; END_VAR\nVAR_OUTPUT pump : BOOL; END_VAR\nVAR m : BOOL; END_VAR\n"
           "m := " +
           sign + "a; pump := " + sign + "m;\nEND_PROGRAM\n";
  };
  EXPECT_EQ(compared("equiv", text(""), text("NOT ")).exit, 0);
}

TEST(IecEquivalence, OutputsThatOneProgramLacksAreNamed) {
  const IecOutput lost = compared("equiv", press, with(with(tidied, "lamp, motor", "motor"), "lamp := delay.Q;", ""));
  EXPECT_EQ(lost.exit, 2);
  EXPECT_TRUE(lost.has("OLD has the output lamp, NEW has no variable of that name and size")) << lost.text;
  const IecOutput wider = compared("equiv", with(tidied, "n : INT", "n : DINT"), press);
  EXPECT_EQ(wider.exit, 2);
  EXPECT_TRUE(wider.has("the output n")) << wider.text;
  const IecOutput chosen = compared("equiv", press, with(with(tidied, "lamp, motor", "motor"), "lamp := delay.Q;", ""),
                                    {"--observe", "motor"});
  EXPECT_EQ(chosen.exit, 0) << chosen.text;
  const IecOutput none = compared("equiv", "PROGRAM m\nVAR x : INT; END_VAR\nx := 1;\nEND_PROGRAM\n",
                                  "PROGRAM m\nVAR x : INT; END_VAR\nx := 1;\nEND_PROGRAM\n");
  EXPECT_EQ(none.exit, 2);
  EXPECT_TRUE(none.has("no output that could be compared")) << none.text;
}

TEST(IecEquivalence, ChangedNetworksNameTheirOutputs) {
  const IecOutput changed = compared("diff", press, with(press, "speed > 10", "speed > 11"));
  EXPECT_EQ(changed.exit, 1);
  EXPECT_TRUE(changed.has("can differ: n") && changed.has("1 network changed, 1 output can differ")) << changed.text;
  EXPECT_EQ(compared("diff", press, press).exit, 0);
}

/// `forms`: OLD, NEW and options.
IecOutput comparedForms(const std::vector<std::string>& forms, const std::string& command = "equiv") {
  std::vector<std::string> arguments = {command};
  arguments.insert(arguments.end(), forms.begin(), forms.end());
  arguments.insert(arguments.end(), {"--isolated", "--timeout", "200s"});
  std::istringstream in;
  std::ostringstream out, err;
  const int exit = runProgram(arguments, {in, out, err});
  return {exit, out.str() + err.str()};
}
std::string formPath(const std::string& name) { return std::string(RUNGPROOF_SOURCE_DIR "/corpus/") + name; }
std::string awl(const std::string& text) {
  return "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1\n" + text + "END_ORGANIZATION_BLOCK\n";
}

// Scans of 100 ms are whole ticks of T37, and a timer of IEC 61131-3 and an S5 timer that ends between scans see the
// same moments. T32 of the S7-200 press counts single milliseconds in the middle of a scan, which the others do not.
TEST(IecOtherFamilies, ThreeFormsOfACorpusProgramDriveTheSameOutputs) {
  const std::vector<std::string> ticks = {"--dialect", "old:iec",  "--scan-time",
                                          "100ms",     "--choice", "s5-time=synchronous"};
  struct Form {
    const char *drawn, *other;
    int exit;
  };
  for (const Form& form : {Form{"iec/star_delta_drawn.xml", "interlocks/star_delta.awl", 0},
                           {"iec/star_delta_drawn.xml", "s7300/star_delta.awl", 0},
                           {"iec/reversing_drawn.xml", "interlocks/reversing.awl", 0},
                           {"iec/press_window.st", "s7300/press_two_hand.awl", 0},
                           {"iec/press_window.st", "interlocks/press_two_hand.awl", 1}}) {
    std::vector<std::string> arguments = {formPath(form.drawn), formPath(form.other), "--show", "none"};
    arguments.insert(arguments.end(), ticks.begin(), ticks.end());
    const IecOutput output = comparedForms(arguments);
    EXPECT_EQ(output.exit, form.exit) << form.drawn << " and " << form.other << "\n" << output.text;
  }
}

// T37 counts ticks of 100 ms whose phase nobody knows: 300 ms last as little as 201 ms and one scan. A scan of 10 ms
// sees that; a TON of IEC 61131-3 comes at 300 ms.
TEST(IecOtherFamilies, AnotherGranularityIsADifference) {
  const TemporaryFolder folder;
  const std::string timed = folder.file("timed.st",
                                        "PROGRAM p\nVAR a AT %IX0.0 : BOOL; q AT %QX0.0 : BOOL; t : TON; END_VAR\n"
                                        "t(IN := a, PT := T#300ms);\nq := t.Q;\nEND_PROGRAM\n");
  const std::string coarse = folder.file("coarse.awl", awl("LD I0.0\nTON T37, 3\nNetwork 2\nLD T37\n= Q0.0\n"));
  const std::string fine = folder.file("fine.awl", awl("LD I0.0\nTON T33, 30\nNetwork 2\nLD T33\n= Q0.0\n"));
  EXPECT_EQ(comparedForms({timed, coarse, "--scan-time", "100ms"}).exit, 0);
  EXPECT_EQ(comparedForms({coarse, timed, "--scan-time", "100ms"}).exit, 0) << "the other way round";
  EXPECT_EQ(comparedForms({timed, fine, "--scan-time", "100ms"}).exit, 0);
  const IecOutput differs = comparedForms({timed, coarse, "--scan-time", "10ms", "--show", "none"});
  EXPECT_EQ(differs.exit, 1);
  EXPECT_TRUE(differs.has("q: OLD")) << differs.text;
  const std::string shorter = folder.file("shorter.awl", awl("LD I0.0\nTON T37, 2\nNetwork 2\nLD T37\n= Q0.0\n"));
  EXPECT_EQ(comparedForms({timed, shorter, "--scan-time", "100ms"}).exit, 1);
}

// Memory of one family is none of the other's: `a` lies where the S7-200 program has V0.0, and is no V0.0.
TEST(IecOtherFamilies, InputsAreWhatNamesAddressesAndTheMapPair) {
  const TemporaryFolder folder;
  const std::string free = folder.file("free.st",
                                       "PROGRAM p\nVAR_INPUT a : BOOL; END_VAR\nVAR q AT %QX0.0 : BOOL; END_VAR\n"
                                       "q := a;\nEND_PROGRAM\n");
  const std::string memory = folder.file("memory.awl", "//@ external V0.0\n" + awl("LD V0.0\n= Q0.0\n"));
  EXPECT_EQ(comparedForms({free, memory}).exit, 1);
  EXPECT_EQ(comparedForms({memory, free}).exit, 1);
  EXPECT_EQ(comparedForms({free, memory, "--map", folder.file("old.map", "a = V0.0\n")}).exit, 0);
  EXPECT_EQ(comparedForms({memory, free, "--map", folder.file("new.map", "V0.0 = a\n")}).exit, 0);
  const std::string terminal = folder.file("terminal.awl", awl("LD I0.5\n= Q0.0\n"));
  const std::string symbols = folder.file("symbols.sdf", "\"A\",\"I0.5\",\"\"\n");
  EXPECT_EQ(comparedForms({free, terminal}).exit, 1) << "nothing says that a is I0.5";
  const IecOutput named = comparedForms({free, terminal, "--with", "new:" + symbols});
  EXPECT_EQ(named.exit, 0) << named.text;
  const std::string other = folder.file("other.sdf", "\"A\",\"I0.4\",\"\"\n");
  EXPECT_EQ(comparedForms({free, terminal, "--with", "new:" + other}).exit, 1) << "a is I0.4";
}

TEST(IecOtherFamilies, OutputsOfEitherAreCompared) {
  const TemporaryFolder folder;
  const std::string one = folder.file("one.st",
                                      "PROGRAM p\nVAR a AT %IX0.0 : BOOL; q AT %QX0.0 : BOOL; END_VAR\nq := a;\n"
                                      "END_PROGRAM\n");
  const std::string two = folder.file("two.awl", awl("LD I0.0\n= Q0.0\n= Q0.1\n"));
  const IecOutput more = comparedForms({one, two, "--show", "none"});
  EXPECT_EQ(more.exit, 1) << "Q0.1 of NEW is compared with 0";
  EXPECT_TRUE(more.has("Q0.1: OLD 0, NEW 1")) << more.text;
  EXPECT_EQ(comparedForms({two, one}).exit, 1);
  EXPECT_EQ(comparedForms({two, one, "--observe", "Q0.0"}).exit, 0);
  const std::string none = folder.file("none.awl", awl("LD I0.0\n= M0.0\n"));
  EXPECT_EQ(comparedForms({one, none}).exit, 1) << "q of OLD is compared with Q0.0, which stays 0";
  const std::string unplaced = folder.file("unplaced.st",
                                           "PROGRAM p\nVAR_INPUT a : BOOL; END_VAR\nVAR_OUTPUT lamp : BOOL; END_VAR\n"
                                           "lamp := a;\nEND_PROGRAM\n");
  const IecOutput lost = comparedForms({unplaced, two});
  EXPECT_EQ(lost.exit, 2);
  EXPECT_TRUE(lost.has("OLD has the output lamp, NEW has no symbol of that name and size")) << lost.text;
}

// A sum that does not fit wraps in IEC 61131-3; the S7-200 leaves its target as it was.
TEST(IecOtherFamilies, NumbersArePairedByTheirSymbols) {
  const TemporaryFolder folder;
  const auto iec = [&](const std::string& value) {
    return folder.file("number.st",
                       "PROGRAM p\nVAR_INPUT Level : INT; END_VAR\nVAR_OUTPUT Shown : INT; END_VAR\nShown := " + value +
                           ";\nEND_PROGRAM\n");
  };
  const std::string symbols = folder.file("n.sdf", "\"Level\",\"IW2\",\"\"\n\"Shown\",\"QW4\",\"\"\n");
  const auto exitOf = [&](const std::string& value, const std::string& statements) {
    const std::string other = folder.file("other.awl", awl("LD SM0.0\n" + statements));
    return comparedForms({iec(value), other, "--with", "new:" + symbols, "--show", "none"}).exit;
  };
  EXPECT_EQ(exitOf("Level", "MOVW IW2, QW4\n"), 0);
  EXPECT_EQ(exitOf("Level", "MOVB IB3, QB5\n"), 1) << "the high byte stays 0";
  EXPECT_EQ(exitOf("Level + Level", "MOVW IW2, QW4\n+I IW2, QW4\n"), 1);
}

// Each engine repeats its side of the run out of the written trace.
TEST(IecOtherFamilies, TheRunIsATraceForBothPrograms) {
  const TemporaryFolder folder;
  const std::string one = folder.file("one.st",
                                      "PROGRAM p\nVAR a AT %IX0.0 : BOOL; q AT %QX0.0 : BOOL; END_VAR\nq := a;\n"
                                      "END_PROGRAM\n");
  const std::string two = folder.file("two.awl", awl("LDN I0.0\n= Q0.0\n"));
  const std::string trace = folder.path("run.csv");
  EXPECT_EQ(comparedForms({one, two, "--trace", trace, "--show", "none"}).exit, 1);
  for (const auto& [file, side] : {std::pair(one, "old"), std::pair(two, "new")}) {
    std::istringstream in;
    std::ostringstream out, err;
    EXPECT_EQ(
        runProgram({"sim", file, "--stimulus", trace, "--expect", trace, "--side", side, "--isolated"}, {in, out, err}),
        0)
        << out.str() << err.str();
  }
}

TEST(IecOtherFamilies, DiffTellsWhatEachNetworkCanChange) {
  const TemporaryFolder folder;
  const std::string one = folder.file("one.st",
                                      "PROGRAM p\nVAR a AT %IX0.0 : BOOL; q AT %QX0.0 : BOOL; END_VAR\nq := a;\n"
                                      "END_PROGRAM\n");
  const IecOutput same = comparedForms({one, folder.file("two.awl", awl("LD I0.0\n= Q0.0\n"))}, "diff");
  EXPECT_TRUE(same.has("proved equal") && !same.has("can differ:")) << same.text;
  const IecOutput other = comparedForms({one, folder.file("other.awl", awl("LDN I0.0\n= Q0.0\n"))}, "diff");
  EXPECT_EQ(other.exit, 1);
  EXPECT_TRUE(other.has("can differ: q")) << other.text;
}

}  // namespace
}  // namespace rungproof::test
