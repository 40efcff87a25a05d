// A dialect answers for its family: names of CPUs and editions, system bits, instructions.
#include "ir/dialect.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "ir/block_map.hpp"
#include "ir/iec/dialect.hpp"
#include "ir/machine/choices.hpp"
#include "ir/program.hpp"
#include "ir/s7200/dialect.hpp"
#include "ir/s7300/block.hpp"
#include "ir/s7300/dialect.hpp"

namespace rungproof {
namespace {

TEST(Dialect, EveryCpuBelongsToOneDialectAndHasOneName) {
  std::set<std::string_view> names;
  CpuSet seen = 0;
  for (const Dialect* dialect : dialects()) {
    for (const CpuModel& model : dialect->cpus) {
      EXPECT_EQ(&dialectOf(model.cpu), dialect) << model.name;
      EXPECT_TRUE(names.insert(model.name).second) << model.name;
      EXPECT_EQ(seen & cpuBit(model.cpu), 0u) << model.name;
      seen |= cpuBit(model.cpu);
      EXPECT_EQ(cpuNamed(model.name), model.cpu);
      EXPECT_EQ(cpuName(model.cpu), model.name);
    }
    for (const EditionModel& model : dialect->editions) {
      EXPECT_EQ(editionNamed(model.name), model.edition);
      EXPECT_EQ(editionName(model.edition), model.name);
      EXPECT_EQ(editionText(model.edition), model.text);
    }
  }
  EXPECT_EQ(cpuNamed("st60"), cpuNamed("ST60")) << "in any case of letters";
  EXPECT_EQ(cpuNamed("CPU 224"), cpuNamed("224"));
  EXPECT_EQ(cpuNamed("cpu315-2"), cpuNamed("315-2"));
  EXPECT_EQ(cpuNamed("Cpu-224xp"), cpuNamed("224XP"));
  // What is printed on the devices (001:11612-11622) and on their boxes.
  EXPECT_EQ(cpuNamed("CPU 224 DC/DC/DC"), cpuNamed("224"));
  EXPECT_EQ(cpuNamed("CPU 224XP CN AC/DC/Relay"), cpuNamed("224XP"));
  EXPECT_EQ(cpuNamed("CPU 315-2 DP"), cpuNamed("315-2"));
  EXPECT_FALSE(cpuNamed("CPU 224 turbo")) << "a word that is not known may name another model";
  EXPECT_FALSE(cpuNamed("CPU"));
  EXPECT_FALSE(cpuNamed("999"));
}

TEST(Dialect, TheS7200IsMeantWhereNothingIsSaid) {
  EXPECT_EQ(dialects().front(), &s7200Dialect);
  EXPECT_EQ(cpuName(Target().cpu), "226");
  EXPECT_EQ(editionName(Target().edition), "2004");
}

TEST(Dialect, SystemBitsOfTheS7200) {  // 001:14050-14056
  const SystemBits& bits = s7200Dialect.systemBits;
  EXPECT_EQ(toString(bits.alwaysOn.operand()), "SM0.0");
  EXPECT_EQ(toString(bits.firstScan.operand()), "SM0.1");
  EXPECT_EQ(toString(bits.minuteClock.operand()), "SM0.4");
  EXPECT_EQ(toString(bits.secondClock.operand()), "SM0.5");
  EXPECT_EQ(toString(bits.scanClock.operand()), "SM0.6");
  EXPECT_TRUE(isBit(direct(Area::SM, Width::Bit, 0, 5), bits.secondClock));
  EXPECT_FALSE(isBit(direct(Area::SM, Width::Bit, 0, 5), bits.minuteClock));
  EXPECT_FALSE(isBit(direct(Area::M, Width::Bit, 0, 5), bits.secondClock));
}

/// The dialects for which that holds.
template <class Holds>
std::set<std::string_view> namesWhere(Holds holds) {
  std::set<std::string_view> names;
  for (const Dialect* dialect : dialects()) {
    if (holds(*dialect)) names.insert(dialect->name);
  }
  return names;
}
using Names = std::set<std::string_view>;

TEST(Dialect, QuestionsAboutTheProgramHaveTheAnswersOfTheManuals) {
  const Names s7 = {"s7-300", "s7-400"};
  EXPECT_EQ(namesWhere([](const Dialect& d) { return d.form == StatementForm::Rungs; }), Names{"s7-200"});
  EXPECT_EQ(namesWhere([](const Dialect& d) { return d.form == StatementForm::Accumulators; }), s7);
  EXPECT_EQ(namesWhere([](const Dialect& d) { return d.form == StatementForm::Expressions; }), Names{"iec"});
  EXPECT_EQ(namesWhere([](const Dialect& d) { return d.memory.isOfVariables; }), Names{"iec"});
  EXPECT_EQ(namesWhere([](const Dialect& d) { return d.memory.hasSpecialMemory; }), Names{"s7-200"});  // 001:14045
  EXPECT_EQ(namesWhere([](const Dialect& d) { return d.memory.hasDataBlocks; }), s7);
  EXPECT_EQ(namesWhere([](const Dialect& d) { return d.memory.declaresLocals; }), s7);
  EXPECT_EQ(namesWhere([](const Dialect& d) { return d.memory.numbersArePointers; }), s7);
  EXPECT_EQ(namesWhere([](const Dialect& d) { return d.memory.pointersMayMiss; }), s7);            // 002:1288, 002:1292
  EXPECT_EQ(namesWhere([](const Dialect& d) { return !d.memory.hasTerminals; }), s7);              // PIB, PQB
  EXPECT_EQ(namesWhere([](const Dialect& d) { return d.memory.numberBits > 32; }), Names{"iec"});  // LINT
  EXPECT_EQ(namesWhere([](const Dialect& d) { return d.text.quotesSymbols; }), s7);
  EXPECT_EQ(namesWhere([](const Dialect& d) { return !d.text.hasProducts; }), Names{"iec"});
  EXPECT_EQ(namesWhere([](const Dialect& d) { return d.text.hasSystemBlocks; }), s7);
}

TEST(Dialect, QuestionsAboutTheRunHaveTheAnswersOfTheManuals) {
  const Names s7 = {"s7-300", "s7-400"};
  EXPECT_EQ(namesWhere([](const Dialect& d) { return d.run.counting == Counting::Boxes; }), Names{"s7-200"});
  EXPECT_EQ(namesWhere([](const Dialect& d) { return d.run.counting == Counting::Elements; }), s7);
  EXPECT_EQ(namesWhere([](const Dialect& d) { return d.run.counting == Counting::Instances; }), Names{"iec"});
  EXPECT_EQ(namesWhere([](const Dialect& d) { return d.run.startsBlocks; }), s7);  // 002:1096
  EXPECT_EQ(namesWhere([](const Dialect& d) { return d.run.ranksEvents; }), s7);   // 002:817, against 001:5426
  EXPECT_EQ(namesWhere([](const Dialect& d) { return d.run.restartsWarm; }), s7);  // 002:1367-1375
  EXPECT_EQ(namesWhere([](const Dialect& d) { return !d.run.hasWatchdog; }), Names{"iec"});
  EXPECT_EQ(namesWhere([](const Dialect& d) { return d.run.listsTimes; }), Names{"s7-200"});  // Appendix F, 001:14522
  EXPECT_EQ(s7200Dialect.run.endlessScan, Hazard::FatalWatchdog);
  EXPECT_EQ(s7300Dialect.run.endlessScan, Hazard::S7CycleTime);
  EXPECT_EQ(iecDialect.run.endlessScan, Hazard::IecEndless);
}

TEST(Dialect, SaysHowDeepCallsMayNest) {
  Pou main, routine, block;
  routine.kind = PouKind::Interrupt;
  block.kind = PouKind::Subroutine;
  block.type = BlockType::Ob;
  const auto allowed = [](std::string_view cpu, const Pou& pou) {
    const Target target{*cpuNamed(cpu), Edition{}};
    return dialectOf(target).run.nesting(target, pou);
  };
  EXPECT_EQ(allowed("224", main), 8);     // 001:6748
  EXPECT_EQ(allowed("224", routine), 1);  // 001:5444
  EXPECT_EQ(allowed("ST40", routine), 4);
  EXPECT_EQ(allowed("224", block), std::nullopt);
  EXPECT_EQ(allowed("315-2", block), 8);
  EXPECT_EQ(allowed("417", block), 24);
  EXPECT_EQ(allowed("417", main), std::nullopt) << "no organization block";
  EXPECT_EQ(allowed("IEC-4K", main), std::nullopt);
}

TEST(Dialect, SaysHowLongAScanMayLast) {
  Program program;
  const Choices choices;
  EXPECT_EQ(s7200Dialect.run.watchdogMs(program, choices), choices.watchdogMs());
  EXPECT_EQ(s7300Dialect.run.watchdogMs(program, choices), 150);  // 002:1296
  EXPECT_EQ(s7300Dialect.run.scanLimitMs(program, choices), 150u);
  program.pous.emplace_back().number = blockNumber(BlockType::Ob, 80);
  EXPECT_EQ(s7300Dialect.run.scanLimitMs(program, choices), 300u) << "the first excess calls OB80 (002:1314)";
  EXPECT_EQ(iecDialect.run.scanLimitMs(program, choices), 500u);
  program.taskMs = 20;
  EXPECT_EQ(iecDialect.run.scanLimitMs(program, choices), 20u) << "the interval of the task";
  const Target smart{*cpuNamed("ST40"), Edition{}};
  EXPECT_EQ(s7200Dialect.run.longestScanMs(smart, choices), 5000) << "whatever WDR does";
  EXPECT_EQ(s7200Dialect.run.longestScanMs(Target(), choices), choices.longestScanMs());
}

TEST(Dialect, SaysWhatKeepsItsValue) {
  const auto has = [](const std::vector<RetentiveRange>& ranges, Area area, std::uint32_t cell) {
    return std::ranges::any_of(
        ranges, [&](const RetentiveRange& r) { return r.area == area && r.first <= cell && cell <= r.last; });
  };
  Program program;
  const auto old = s7200Dialect.memory.retentive(program, s7200Dialect.memory.usuallyRetentive(Target()));
  EXPECT_TRUE(has(old, Area::V, 0));
  EXPECT_FALSE(has(old, Area::M, 13));  // 001:1619
  EXPECT_TRUE(has(old, Area::M, 14));
  EXPECT_TRUE(has(old, Area::T, 0)) << "a TONR";
  EXPECT_FALSE(has(s7200Dialect.memory.retentive(program, {{Area::T, 0, 255}}), Area::T, 37)) << "a TON (001:6556)";
  EXPECT_TRUE(s7200Dialect.memory.usuallyRetentive({*cpuNamed("ST40"), Edition{}}).empty());
  program.dataBlocks.emplace_back().number = 3;
  program.dataBlocks.emplace_back().number = 4;
  program.dataBlocks.back().nonRetain = true;
  const auto blocks = s7300Dialect.memory.retentive(program, s7300Dialect.memory.usuallyRetentive(Target()));
  EXPECT_TRUE(has(blocks, Area::DB, dataByte(3, 10)));  // 002:563
  EXPECT_FALSE(has(blocks, Area::DB, dataByte(4, 10)));
  EXPECT_TRUE(has(blocks, Area::M, 15));
  EXPECT_FALSE(has(blocks, Area::M, 16));
  program.retained = {{8, 11}};
  const auto variables = iecDialect.memory.retentive(program, iecDialect.memory.usuallyRetentive(Target()));
  EXPECT_TRUE(has(variables, Area::V, 11));
  EXPECT_FALSE(has(variables, Area::V, 12));
}

TEST(Dialect, InstructionsAreNumberedByTheirPlace) {
  for (const Dialect* dialect : dialects()) {
    const std::span<const Desc> all = dialect->instructions().all();
    for (std::size_t i = 0; i < all.size(); ++i) {
      EXPECT_EQ(all[i].opcode, i);
      EXPECT_EQ(dialect->instructions().named(all[i].stl), &all[i]);
    }
  }
}

}  // namespace
}  // namespace rungproof
