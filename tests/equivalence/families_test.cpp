// Starters and interlocks that stand in the corpus for both families: each pair drives the same outputs, and a slip in
// the S7-300 program is found. Scans last 100 ms, whole ticks of every timer, and S5 timers end between scans: with
// scans of any length the timers of the two families end at different moments, and DIFFERENT would be the truth.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "ir/s7300/cpu.hpp"
#include "tests/equivalence/pair.hpp"

namespace rungproof::test {
namespace {

constexpr std::uint32_t wholeTicks = 100;  ///< ms

/// A change that an engineer makes by mistake, as text of the S7-300 program.
struct Slip {
  const char* program;
  const char* right;
  const char* wrong;
  Equality truth = Equality::Equal;
};

const Slip slips[] = {
    {"guard_door", "      AN    Q 0.1;", "      A     Q 0.1;"},
    {"guard_locking", "S5T#3S", "S5T#2S"},
    {"hoist", "      A     I 0.3;\n", ""},
    {"muting_limit", "      AN    T 7;\n", ""},
    {"notaus", "      X     I 0.1;", "      O     I 0.1;"},
    // T32 counts single milliseconds in the middle of a scan, an S5 timer does not.
    {"press_two_hand", "      ON    I 0.2;\n", "", Equality::Different},
    {"press_two_hand_faulty", "      ON    I 0.3;", "      O     I 0.3;"},
    {"pump_alternation", "      FN    M 1.0;", "      FP    M 1.0;"},
    {"reversing", "      AN    Q 0.1;\n      =     Q 0.0;", "      =     Q 0.0;"},
    {"reversing_faulty", "      A     I 0.2;\n", ""},
    {"star_delta", "      AN    Q 0.1;\n      =     Q 0.2;", "      =     Q 0.2;\n      =     Q 0.1;"},
    {"star_delta_dead_time", "S5T#60MS", "S5T#200MS"},
    {"two_speed", "      R     Q 0.1;\n", ""},
    {"wound_rotor", "      A     M 0.3;", "      A     M 0.2;"},
};

std::string textOf(const std::string& folder, const std::string& program) {
  std::ifstream stream(std::filesystem::path(RUNGPROOF_SOURCE_DIR) / "corpus" / folder / (program + ".awl"),
                       std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  EXPECT_FALSE(text.view().empty()) << program;
  return text.str();
}

Equivalence compared(const std::string& before, const std::string& after) {
  const ProgramInput old = pairSide("old.awl", before, ""), now = pairSide("new.awl", after, "");
  EXPECT_NE(isStep7(old.program.target), isStep7(now.program.target));
  EquivalenceOptions options;
  options.prover.time = {wholeTicks, wholeTicks};
  options.prover.timeout = 60;
  EXPECT_TRUE(options.prover.choices.set("s5-time", "synchronous"));
  return compareBehaviour({&old.program, old.properties, nullptr}, {&now.program, now.properties, nullptr}, options);
}

class BothFamilies : public ::testing::TestWithParam<Slip> {};

TEST_P(BothFamilies, DriveTheSameOutputs) {
  const Slip& slip = GetParam();
  const std::string old = textOf("interlocks", slip.program), now = textOf("s7300", slip.program);
  EXPECT_EQ(compared(old, now).equality, slip.truth);
  EXPECT_EQ(compared(now, old).equality, slip.truth) << "the other way round";
}

TEST_P(BothFamilies, ASlipIsFound) {
  const Slip& slip = GetParam();
  std::string wrong = textOf("s7300", slip.program);
  const std::size_t at = wrong.find(slip.right);
  ASSERT_NE(at, std::string::npos);
  wrong.replace(at, std::string_view(slip.right).size(), slip.wrong);
  EXPECT_EQ(compared(textOf("interlocks", slip.program), wrong).equality, Equality::Different);
}

INSTANTIATE_TEST_SUITE_P(Corpus, BothFamilies, ::testing::ValuesIn(slips),
                         [](const auto& info) { return std::string(info.param.program); });

// The one difference of the press: T33 counts the same 500 ms in ticks of 10 ms at the start of the scan.
TEST(BothFamiliesPaired, ThePressIsTheSameWithATimerThatCountsBetweenScans) {
  std::string old = textOf("interlocks", "press_two_hand");
  for (const auto& [own, other] : {std::pair("T32, 500", "T33, 50"), {"T32", "T33"}}) {
    for (std::size_t at = old.find(own); at != std::string::npos; at = old.find(own))
      old.replace(at, std::string_view(own).size(), other);
  }
  const std::string now = textOf("s7300", "press_two_hand");
  EXPECT_EQ(compared(old, now).equality, Equality::Equal);
  EXPECT_EQ(compared(now, old).equality, Equality::Equal);
}

TEST(BothFamiliesPaired, EveryInterlockOfTheCorpusIsThere) {
  std::size_t count = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::filesystem::path(RUNGPROOF_SOURCE_DIR) / "corpus" / "interlocks")) {
    ++count;
    EXPECT_TRUE(std::ranges::any_of(slips, [&](const Slip& s) { return entry.path().stem() == s.program; }))
        << entry.path();
  }
  EXPECT_EQ(count, std::size(slips));
}

}  // namespace
}  // namespace rungproof::test
