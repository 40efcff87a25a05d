// Differences that show after hours: runs of the engine on both programs find them where no search from power-up does.
#include "analysis/equivalence/pair_exploration.hpp"

#include "tests/equivalence/pair.hpp"

namespace rungproof::test {

namespace {

/// Counts seconds by a timer that restarts itself, then minutes.
std::string clockwork(const std::string& seconds, const std::string& minutes) {
  return "LD I0.0;AN T37;TON T37," + seconds + "|LD T37;LD C1;CTU C1,60|LD C1;LD I0.7;CTU C2," + minutes +
         "|LD C2;= Q0.0";
}

struct Explored {
  Explored(const std::string& old, const std::string& now, const char* map = "", const char* properties = "")
      : before(pairSide("old.awl", exportOf(old), properties)), after(pairSide("new.awl", exportOf(now), properties)) {
    Pair pair{"", "", "", Equality::Equal, "", map};
    options = optionsOf(pair, before.program, after.program);
  }
  std::optional<EquivalenceRun> run(double seconds = 20) const {
    const std::atomic<bool> cancel{false};
    const BothRuns runs{before.program, after.program, options, namedOutputs(before.program, after.program, options)};
    return exploredRun({&before.program, before.properties}, {&after.program, after.properties}, runs,
                       std::chrono::steady_clock::now() + std::chrono::milliseconds(int(seconds * 1000)), cancel);
  }

  ProgramInput before, after;
  EquivalenceOptions options;
};

}  // namespace

TEST(PairExploration, TwoHoursAgainstTwoHoursAndAMinute) {
  const auto run = Explored(clockwork("10", "120"), clockwork("10", "121")).run();
  ASSERT_TRUE(run.has_value());
  EXPECT_EQ(run->signal, "Q0.0");
  EXPECT_TRUE(run->valueBefore);
  // 120 minutes of 60 periods; a period is the timer's second, less a tick and a scan that count in advance, and the
  // scan in which the timer restarts.
  EXPECT_GE(run->milliseconds, 120U * 60 * 900);
}

/// Twenty parts have to be shifted along while none is cleared; the last place of OLD is the one before of NEW.
TEST(PairExploration, ALongShiftRegister) {
  const std::string shift = "LD I0.0;EU;SHRB I0.1,V10.0,24|LD I0.7;R V10.0,24|";
  const auto run = Explored(shift + "LD V12.3;= Q0.0", shift + "LD V12.2;= Q0.0").run();
  ASSERT_TRUE(run.has_value());
  EXPECT_TRUE(run->valueAfter) << "the part comes to V12.2 first";
  EXPECT_GE(run->scan, 2U * 19) << "V12.2 is the 19th place, and each edge takes two scans";
}

/// Fifty edges take a hundred scans; what else the walk has done is left out of the run.
TEST(PairExploration, ARunHasOnlyWhatItNeeds) {
  const std::string reset = ";LD I0.2;CTU C10,50|LD C10;= Q0.0|LD I0.3;= Q0.1|LD I0.4;= Q0.2";
  const auto run = Explored("LD I0.0" + reset, "LD I0.0;A I0.1" + reset).run();
  ASSERT_TRUE(run.has_value());
  EXPECT_EQ(run->signal, "Q0.0");
  EXPECT_LE(run->scan, 200U);
  for (const ReplayScan& scan : run->before) {
    for (const PresetValue& input : scan.inputs) {
      const bool isNeeded = addressOf(input.operand) == Address{Area::I, 0};
      EXPECT_TRUE(isNeeded || input.value == 0) << toString(input.operand);
    }
  }
}

TEST(PairExploration, NoDifferenceOfAProgramFromItself) {
  EXPECT_FALSE(Explored(clockwork("1", "2"), clockwork("1", "2")).run(0.5).has_value());
}

TEST(PairExploration, ATerminalIsOneThatOnlyARangeReaches) {
  EXPECT_FALSE(Explored("LD SM0.0;BMB IB0,QB0,2", "LD SM0.0;MOVW IW0,QW0").run(0.5).has_value())
      << "OLD reads IB1 without naming it";
  EXPECT_FALSE(Explored("LD SM0.0;MOVW IW0,QW0", "LD SM0.0;BMB IB0,QB0,2").run(0.5).has_value());
}

TEST(PairExploration, TheMapJoinsInputs) {
  EXPECT_FALSE(Explored("LD I0.0;= Q0.0", "LD I1.0;= Q0.0", "I0.0 = I1.0").run(0.5).has_value());
  EXPECT_TRUE(Explored("LD I0.0;= Q0.0", "LD I1.0;= Q0.0").run().has_value());
  EXPECT_FALSE(Explored("LDW> AIW0,9;= Q0.0", "LDW> AIW4,9;= Q0.0", "AIW0 = AIW4").run(0.5).has_value());
  EXPECT_FALSE(Explored("LD SM0.5;= Q0.0", "LD M10.5;= Q0.0", "SM0.5 = M10.5", "external M10.5..M10.5").run(0.5))
      << "the panel shows the clock; no run of this kind can, so that there is none";
  EXPECT_FALSE(Explored("LD M10.5;= Q0.0", "LD SM0.5;= Q0.0", "M10.5 = SM0.5", "external M10.5..M10.5").run(0.5));
}

TEST(PairExploration, WhatThePanelWritesIsOneValue) {
  EXPECT_FALSE(Explored("LDB> VB10,7;= Q0.0", "LDB>= VB10,8;= Q0.0", "", "external VB10..VB10").run(0.5).has_value());
  EXPECT_TRUE(Explored("LDB> VB10,7;= Q0.0", "LDB> VB11,7;= Q0.0", "", "external VB10..VB11").run().has_value());
}

TEST(PairExploration, KeepsAssumptions) {
  EXPECT_FALSE(Explored("LD I0.0;A I0.1;= Q0.0", "LD I0.0;= Q0.0", "", "assume a: I0.0 implies I0.1").run(0.5));
}

/// A word from outside that the map gives another place: what stands for each other stays equal while the run gets
/// shorter. At 10 only OLD is on.
TEST(PairExploration, PairedMemoryFromOutsideStaysEqual) {
  const auto before = pairSide("old.awl", exportOf("LDW>= VW0,10;= Q0.0"), "external VW0\n"),
             after = pairSide("new.awl", exportOf("LDW>= VW10,11;= Q0.0"), "external VW10\n");
  Pair pair{"", "", "", Equality::Equal, "", "VB0..VB1 = VB10..VB11\n"};
  const EquivalenceOptions options = optionsOf(pair, before.program, after.program);
  const BothRuns runs{before.program, after.program, options, namedOutputs(before.program, after.program, options)};
  const std::atomic<bool> cancel{false};
  const auto run = exploredRun({&before.program, before.properties}, {&after.program, after.properties}, runs,
                               std::chrono::steady_clock::now() + std::chrono::seconds(20), cancel);
  ASSERT_TRUE(run.has_value());
  const auto valueOf = [](const std::vector<PresetValue>& inputs) {
    std::uint64_t value = 0;
    for (const PresetValue& input : inputs) {
      if (input.operand.area == Area::V && input.value != 0)
        value |= input.operand.width == Width::Bit
                     ? std::uint64_t{1} << (8 * ((input.operand.offset & 1U) == 0 ? 1 : 0) + input.operand.bit)
                     : input.value << ((input.operand.offset & 1U) == 0 && input.operand.width == Width::Byte ? 8 : 0);
    }
    return value;
  };
  EXPECT_EQ(valueOf(run->before.back().inputs), 10U);
  EXPECT_EQ(valueOf(run->after.back().inputs), 10U);
}

}  // namespace rungproof::test
