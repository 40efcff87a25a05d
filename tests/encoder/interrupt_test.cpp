// Where interrupts and 1 ms ticks are let in: only where they can be noticed, and after the program.
#include <gtest/gtest.h>

#include <algorithm>

#include "analysis/encoding/encoder.hpp"
#include "tests/encoder/statements.hpp"

namespace rungproof {
namespace {

std::vector<std::uint32_t> placesOf(const std::vector<EventSite>& sites) {
  std::vector<std::uint32_t> places;
  for (const EventSite& site : sites) places.push_back(site.where.instruction);
  return places;
}

TEST(Interrupts, ComeInFrontOfInstructionsThatShareMemory) {
  // The routine sets M0.0. Instruction 5 reads it; 0 to 2 attach; 3, 4 and 6 have nothing to do with it.
  const Program program =
      programOf("LD SM0.1\nATCH 0, 0\nENI\nLD I0.0\n= Q0.0\nLD M0.0\n= Q0.1\nINT 0\nLD SM0.0\nS M0.0, 1");
  EncodedScan scan(program, {});
  const std::vector<std::uint32_t> places = placesOf(scan.eventSites());
  const auto has = [&](std::uint32_t place) { return std::find(places.begin(), places.end(), place) != places.end(); };
  EXPECT_TRUE(has(5));
  EXPECT_TRUE(has(ScanPlace::afterProgram));
  for (const std::uint32_t apart : {0U, 3U, 4U, 6U}) EXPECT_FALSE(has(apart)) << apart;
}

TEST(Interrupts, RoutineThatIsNeverAttachedNeverRuns) {
  const Program program = programOf("LD M0.0\n= Q0.1\nINT 0\nLD SM0.0\nS M0.0, 1");
  EncodedScan scan(program, {});
  EXPECT_TRUE(scan.eventSites().empty());
  EXPECT_EQ(scan.atEnd(operandOf("Q0.1"), 1), scan.graph().constantNode(0, 1));
}

TEST(Ticks, OfOneMillisecondComeInFrontOfTheirTimer) {
  const Program program = programOf("LD I0.0\nTON T32, 10\nLD I0.1\n= Q0.0\nLD T32\n= Q0.1");
  EncodedScan scan(program, {});
  std::vector<std::uint32_t> places;
  for (const TickSite& site : scan.tickSites()) places.push_back(site.where.instruction);
  EXPECT_EQ(places, (std::vector<std::uint32_t>{1, 4, ScanPlace::afterProgram}));
}

}  // namespace
}  // namespace rungproof
