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

TEST(IecEquivalence, OtherFamiliesAreRefused) {
  const TemporaryFolder folder;
  const std::string other =
      folder.file("other.awl", "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1\nLD I0.0\n= Q0.0\n");
  const IecOutput refused = runIec({"equiv", other}, press);
  EXPECT_EQ(refused.exit, 2);
  EXPECT_TRUE(refused.has("compared with one of its own family only")) << refused.text;
}

TEST(IecEquivalence, ChangedNetworksNameTheirOutputs) {
  const IecOutput changed = compared("diff", press, with(press, "speed > 10", "speed > 11"));
  EXPECT_EQ(changed.exit, 1);
  EXPECT_TRUE(changed.has("can differ: n") && changed.has("1 network changed, 1 output can differ")) << changed.text;
  EXPECT_EQ(compared("diff", press, press).exit, 0);
}

}  // namespace
}  // namespace rungproof::test
