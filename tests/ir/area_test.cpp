// The rows of the area table against the manual's sentences on each area (001:1267-1431).
#include <gtest/gtest.h>

#include "ir/operand.hpp"

namespace rungproof {
namespace {

std::string areasWhere(bool (*holds)(Area)) {
  std::string names;
  for (const AreaInfo& info : areaTable) {
    if (holds(info.area)) names += (names.empty() ? "" : " ") + std::string(info.name);
  }
  return names;
}

TEST(Area, PropertiesName) {
  EXPECT_EQ(areasWhere(addressedByNumber), "T C AC HC");  // 001:1309, 001:1322, 001:1338, 001:1348
  EXPECT_EQ(areasWhere(hasBitAndWord), "T C");
  EXPECT_EQ(areasWhere(isAnalogue), "AI AQ");  // words at even bytes (001:1382, 001:1388)
  EXPECT_EQ(areasWhere(isInputArea), "I AI PI");
  EXPECT_EQ(areasWhere(isOutputArea), "Q AQ PQ");
  EXPECT_EQ(areasWhere(isMemoryArea), "V M S DB");
  EXPECT_EQ(areasWhere(isReadOnlyArea), "AI HC PI");                            // 001:2647, 001:1336
  EXPECT_EQ(areasWhere(mayHoldPointer), "V L AC");                              // 001:1459
  EXPECT_EQ(areasWhere(mayBePointedTo), "I Q AI AQ V M S SM T C");              // 001:1461
  EXPECT_EQ(areasWhere(lastsOverScans), "I Q AI AQ V M S SM T C HC DB PI PQ");  // L belongs to one call (001:1367)
}

TEST(Area, OnlyVMAndTheValuesOfTAndCCanBeRetentive) {  // 001:1534
  EXPECT_EQ(areasWhere([](Area area) { return areaInfo(area).mayRetain; }), "V M T C DB");
}

TEST(Area, TagsOfPointersDiffer) {
  for (const AreaInfo& a : areaTable) {
    for (const AreaInfo& b : areaTable) {
      EXPECT_TRUE(a.area == b.area || !a.tag || a.tag != b.tag) << a.name << " and " << b.name;
    }
  }
}

TEST(Area, AddressesAreWrittenAsTheAreaIsAddressed) {
  EXPECT_EQ(addressName(Area::T, Width::Word, 37), "T37");
  EXPECT_EQ(addressName(Area::HC, Width::DWord, 0), "HC0");
  EXPECT_EQ(addressName(Area::AI, Width::Bit, 4), "AIW4");
  EXPECT_EQ(addressName(Area::V, Width::DWord, 10), "VD10");
  EXPECT_EQ(addressName(Area::SM, Width::Bit, 0, 1), "SM0.1");
}

}  // namespace
}  // namespace rungproof
