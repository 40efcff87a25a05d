// References become places: spot checks against the manual's table of contents, and every reference of the tables.
#include "ir/manual.hpp"

#include <gtest/gtest.h>

#include "ir/s7200/cpu.hpp"
#include "ir/s7200/isa.hpp"

namespace rungproof {
namespace {

TEST(Manual, PlacesFollowTheTableOfContents) {  // 001:262-563
  EXPECT_EQ(manualPlace("001:6551"), "System Manual 2004, chapter 6, Timers (001:6551)");
  EXPECT_EQ(manualPlace("001:4013"), "System Manual 2004, chapter 6, Counters (001:4013)");
  EXPECT_EQ(manualPlace("001:2892"), "System Manual 2004, chapter 6, Set and reset dominant bistables (001:2892)");
  EXPECT_EQ(manualPlace("001:1401-1410"), "System Manual 2004, chapter 4, Access to the data (001:1401-1410)");
  EXPECT_EQ(manualPlace("001:14073"), "System Manual 2004, appendix D, Special memory bits (001:14073)");
  EXPECT_EQ(manualPlace("000:3376"), "System Manual 2003, chapter 6, Counters (000:3376)");
  EXPECT_EQ(manualPlace("004:4584"), "Application Examples (004:4584)");
}

TEST(Manual, OtherTextsStay) {
  EXPECT_EQ(manualPlace(""), "");
  EXPECT_EQ(manualPlace("Appendix F"), "Appendix F");
  EXPECT_EQ(manualPlace("001"), "001");
  EXPECT_EQ(manualPlace("001:x"), "001:x");
}

TEST(Manual, EveryInstructionStandsInTheInstructionSetOrAnAppendix) {
  for (const Desc& desc : s7200Instructions().all()) {
    const std::string place = manualPlace(desc.manual);
    if (place == smartManual) continue;
    EXPECT_TRUE(place.find(", chapter 6") != std::string::npos || place.find(", appendix ") != std::string::npos)
        << desc.stl << ": " << place;
  }
}

}  // namespace
}  // namespace rungproof
