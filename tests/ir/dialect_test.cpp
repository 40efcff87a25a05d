// A dialect answers for its family: names of CPUs and editions, system bits, instructions.
#include "ir/dialect.hpp"

#include <gtest/gtest.h>

#include <set>

#include "ir/s7200/dialect.hpp"

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
