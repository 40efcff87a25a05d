// How long the comparison of programs of ordinary size takes, by the wall clock at the pace of a quiet machine. Stands
// here because both cores work on it: another test beside it would take one.
#include "frontend/sides/program_difference.hpp"
#include "tests/equivalence/pair.hpp"
#include "tests/machine_pace.hpp"

namespace rungproof::test {

namespace {

constexpr double equalSeconds = 5, differenceSeconds = 10;

std::string bit(char area, int number) { return area + std::to_string(number / 8) + '.' + std::to_string(number % 8); }

/// A drive: start and stop, a run-up time, a count of starts, an alarm, and a speed that is scaled. 19 instructions.
std::string drive(int k, bool isTidied) {
  const std::string start = bit('I', 3 * k), stop = bit('I', 3 * k + 1), fault = bit('I', 3 * k + 2);
  const std::string run = bit('Q', 2 * k), alarm = bit('Q', 2 * k + 1), timer = 'T' + std::to_string(101 + k),
                    counter = 'C' + std::to_string(k), word = "VW" + std::to_string(100 + 4 * k),
                    limit = "VW" + std::to_string(102 + 4 * k);
  const std::string seal = isTidied ? "LDN " + stop + ";AN " + fault + ";LD " + start + ";O " + run + ";ALD;= " + run
                                    : "LD " + start + ";O " + run + ";AN " + stop + ";AN " + fault + ";= " + run;
  const std::string wait = "LD " + run + ";TON " + timer + ",50";
  const std::string count = "LD " + run + ";EU;LD " + stop + ";CTU " + counter + ",100";
  const std::string alarms = isTidied ? "LD " + timer + ";A " + counter + ";O " + fault + ";= " + alarm
                                      : "LD " + counter + ";A " + timer + ";O " + fault + ";= " + alarm;
  const std::string speed = "LD " + run + ";MOVW " + limit + ',' + word + ";+I 3," + word + ";LPS;AW> " + word +
                            ",1000;MOVW 1000," + word + ";LPP;MOVW " + word + ',' + limit;
  return seal + '|' + wait + '|' + count + '|' + alarms + '|' + speed;
}

/// Tidied: the drives in another order, and the contacts in their networks.
std::string plant(int drives, bool isTidied) {
  std::string text;
  for (int i = 0; i < drives; ++i) text += (i > 0 ? "|" : "") + drive(isTidied ? drives - 1 - i : i, isTidied);
  return text;
}

/// A project of blocks: MAIN calls each of them once.
std::string project(int blocks, int changed) {
  std::string main, rest;
  for (int k = 0; k < blocks; ++k) {
    main += (k > 0 ? "|LD SM0.0;CALL SBR" : "LD SM0.0;CALL SBR") + std::to_string(k);
    std::string text = drive(k, false);
    if (k == changed) text.replace(text.find(",50"), 3, ",60");
    rest += "@SBR" + std::to_string(k) + ':' + text;
  }
  return main + rest;
}

}  // namespace

TEST(Measures, FiveHundredInstructionsAgainstATidiedCopy) {
  const ProgramInput before = pairSide("old.awl", exportOf(plant(22, false)), "");
  const ProgramInput after = pairSide("new.awl", exportOf(plant(22, true)), "");
  ASSERT_GE(before.program.instructionCount(), 500U);
  EquivalenceOptions options;
  Equivalence found;
  const auto compare = [&] { found = compareBehaviour({&before.program, {}}, {&after.program, {}}, options); };
  const double seconds = quietSeconds(compare, equalSeconds, 2, wallSeconds);
  EXPECT_EQ(equalityText(found.equality), "EQUAL");
  EXPECT_LE(seconds, equalSeconds);
  std::printf("%zu instructions: EQUAL after %.2f s\n", before.program.instructionCount(), seconds);
}

TEST(Measures, TwoVersionsOfAProjectOfThirtyBlocks) {
  Sides sides;
  sides.before = pairSide("old.awl", exportOf(project(30, -1)), "");
  sides.after = pairSide("new.awl", exportOf(project(30, 17)), "");
  sides.runBefore = std::make_unique<Program>(sides.before.program);
  sides.runAfter = std::make_unique<Program>(sides.after.program);
  EquivalenceOptions options;
  ProgramDifference found;
  const double seconds = quietSeconds([&] { found = differenceOf(sides, options); }, differenceSeconds, 2, wallSeconds);
  // The run-up time of one drive: its alarm comes later, nothing else changes.
  EXPECT_EQ(found.changes.size(), 1U);
  EXPECT_EQ(found.countOf(Equality::Different), 1U);
  EXPECT_EQ(found.countOf(Equality::Unknown), 0U);
  EXPECT_LE(seconds, differenceSeconds);
  std::printf("%zu instructions in 31 blocks: difference after %.2f s\n", sides.before.program.instructionCount(),
              seconds);
}

}  // namespace rungproof::test
