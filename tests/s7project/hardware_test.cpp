// What the hardware configuration says counts like options, and options count more.
#include "frontend/s7project/hardware.hpp"

#include <gtest/gtest.h>

#include "tests/s7project/plant.hpp"

namespace rungproof {
namespace {

using test::TemporaryFolder;

std::string words(std::initializer_list<unsigned> values) {
  std::string bytes;
  for (const unsigned value : values) {
    bytes += static_cast<char>(value >> 8);
    bytes += static_cast<char>(value);
  }
  return bytes;
}

test::ProjectPart configured() {
  test::ProjectPart part = test::plantPart();
  part.dataSets[2] = words({0x1401, 600, 0, 0});                // scan limit 600 ms
  part.dataSets[6] = words({200, 3, 8, 1, 10, 2, 6, 0, 0, 0});  // MB0..199, T0..2, C0..7, DB10 bytes 2 to 7
  part.dataSets[7] = words({0x0001, 68, 0});                    // clock memory MB68
  std::string cyclic(54, '\0');
  cyclic.replace(30, 6, words({0x0C00, 250, 0}));  // OB35 every 250 ms
  part.dataSets[13] = cyclic;
  return part;
}

TEST(S7Hardware, DataSetsBecomeOptions) {
  const TemporaryFolder folder;
  const test::ProgramRun run =
      test::run({"show", "--isolated", "--list", writeFiles(folder, test::writeProject({configured()}, 1252))});
  for (const char* text : {"cpu 315-2", "cycle-monitoring 600ms", "clock-memory MB68", "retentive MB0..MB199",
                           "retentive T0..T2", "retentive C0..C7", "retentive DB10.DBB2..DBB7", "ob35 250ms"})
    EXPECT_TRUE(run.says(text)) << text << "\n" << run.out;
}

TEST(S7Hardware, AbsentDataSetsAreDefaults) {
  const TemporaryFolder folder;
  const test::ProgramRun run =
      test::run({"show", "--isolated", "--list", writeFiles(folder, test::writeProject({test::plantPart()}, 1252))});
  EXPECT_TRUE(run.says("cycle-monitoring 150ms (the default of the CPU)")) << run.out;
  EXPECT_TRUE(run.says("no clock memory (the default of the CPU)")) << run.out;
  EXPECT_TRUE(run.says("ob35 100ms (the default of the CPU)")) << run.out;
}

// MB68 flashes because the configuration says so, and lies still where an option names another byte.
TEST(S7Hardware, ClockMemoryIsThatOfTheConfiguration) {
  const TemporaryFolder folder;
  const std::string project = writeFiles(folder, test::writeProject({configured()}, 1252));
  const std::string properties = folder.file("p.props", "reach flashes: M68.0\n");
  const test::ProgramRun flashing = test::run({"prove", "--isolated", "--props", properties, project});
  EXPECT_EQ(flashing.exit, 0) << flashing.out << flashing.err;
  const test::ProgramRun other =
      test::run({"prove", "--isolated", "--clock-memory", "MB70", "--props", properties, project});
  EXPECT_TRUE(other.says("UNREACHABLE")) << other.out << other.err;
}

TEST(S7Hardware, ChainEndsAtLengthZeroOrDamage) {
  const auto sets = s7project::dataSetsOf(std::string("\4\2ab\3\7c\0\4\2zz", 12));
  EXPECT_EQ(sets.size(), 2U);
  EXPECT_EQ(sets.at(2), "ab");
  EXPECT_EQ(sets.at(7), "c");
  EXPECT_TRUE(s7project::dataSetsOf("\xFF\2ab").empty());
}

TEST(S7Hardware, TypesByOrderNumberAndName) {
  EXPECT_EQ(s7project::cpuTypeOf("6ES7 315-2AG10-0AB0"), "315-2");
  EXPECT_EQ(s7project::cpuTypeOf("6ES7 417-4HL01-0AB0"), "417");
  EXPECT_EQ(s7project::cpuTypeOf("CPU 314C-2 DP"), "314");
  EXPECT_EQ(s7project::cpuTypeOf("CPU416-1"), "416");
  EXPECT_EQ(s7project::cpuTypeOf("Line 4"), "");
}

}  // namespace
}  // namespace rungproof
