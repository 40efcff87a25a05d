// The cross reference: entries by address and width, overlaps, free ranges, questions for one address.
#include "analysis/flow/xref.hpp"

#include <gtest/gtest.h>

#include "frontend/input/program_input.hpp"
#include "tests/program_run.hpp"

namespace rungproof {
namespace {

class XrefOf {
 public:
  explicit XrefOf(const std::string& networks)
      : program_(readText("a.awl", test::mainBlock("Network 1\n" + networks))),
        facts_(program_),
        xref(crossReference(facts_)) {}

  const XrefEntry* entry(const std::string& name) const {
    for (const XrefEntry& e : xref.entries) {
      if (entryName(e) == name) return &e;
    }
    return nullptr;
  }
  std::vector<std::string> overlapsOf(const std::string& name) const {
    std::vector<std::string> names;
    for (const std::size_t i : entry(name)->overlaps) names.push_back(entryName(xref.entries[i]));
    return names;
  }
  std::vector<std::string> touching(const std::string& address) const {
    std::vector<std::string> names;
    for (const std::size_t i : entriesTouching(xref, *lookupIn(program_)(address)))
      names.push_back(entryName(xref.entries[i]));
    return names;
  }
  std::vector<std::string> freeOf(Area area) const {
    std::vector<std::string> names;
    for (const FreeRange& range : xref.free) {
      if (range.area == area) names.push_back(rangeName(range));
    }
    return names;
  }

 private:
  Program program_;
  Facts facts_;

 public:
  Xref xref;
};

using Names = std::vector<std::string>;

TEST(CrossReference, ListsReadersAndWritersInProgramOrder) {
  const XrefOf x("LD Q0.0\nA I0.0\n= Q0.0\n");
  const XrefEntry* entry = x.entry("Q0.0");
  ASSERT_NE(entry, nullptr);
  ASSERT_EQ(entry->uses.size(), 2u);
  EXPECT_FALSE(entry->uses[0]->write);
  EXPECT_TRUE(entry->uses[1]->write);
}

// VW10 covers VB10 and VB11 (001:1272): the high byte first.
TEST(CrossReference, FindsOverlapsAcrossWidths) {
  const XrefOf x("LD I0.0\nMOVW VW10, VW20\nMOVB VB11, VB30\nMOVD VD8, VD40\nLD V12.7\n= Q0.0\n");
  EXPECT_EQ(x.overlapsOf("VW10"), (Names{"VD8", "VB11"}));
  EXPECT_EQ(x.overlapsOf("VD8"), (Names{"VW10", "VB11"}));  // VB8..VB11; V12.7 lies behind
  EXPECT_EQ(x.overlapsOf("V12.7"), Names{});
}

TEST(CrossReference, SetAndResetCoverTheirBits) {
  const XrefOf x("LD I0.0\nS Q0.6, 4\nR Q1.1, 1\n");
  EXPECT_EQ(x.overlapsOf("Q0.6..Q1.1"), Names{"Q1.1"});
  EXPECT_EQ(x.touching("QB0"), Names{"Q0.6..Q1.1"});
  EXPECT_EQ(x.touching("Q0.5"), Names{});
}

TEST(CrossReference, BitAndValueOfATimerDoNotOverlap) {
  const XrefOf x("LD I0.0\nTON T37, 10\nLD T37\nMOVW T37, VW0\n");
  EXPECT_EQ(x.overlapsOf("T37 (bit)"), Names{});
  EXPECT_EQ(x.touching("T37"), (Names{"T37 (bit)", "T37 (value)"}));
}

TEST(CrossReference, FreeRangesAreWhatNobodyNames) {
  const XrefOf x("LD I0.0\nMOVD &VB100, VD0\nMOVB VB6, QB0\nTON T0, 10\nCTU C255, 5\n");
  const Names v = x.freeOf(Area::V);
  ASSERT_EQ(v.size(), 3u);
  EXPECT_EQ(v[0], "VB4..VB5");
  EXPECT_EQ(v[1], "VB7..VB99");
  EXPECT_EQ(v[2], "VB101..VB10239");  // CPU 226, edition 2004: V ends at 10239
  EXPECT_EQ(x.freeOf(Area::T), Names{"T1..T255"});
  EXPECT_EQ(x.freeOf(Area::C), Names{"C0..C254"});
  EXPECT_EQ(x.freeOf(Area::Q), Names{"QB1..QB15"});
}

TEST(CrossReference, KeepsPointersApart) {
  const XrefOf x("LD I0.0\nMOVW *VD10, VW20\n");
  EXPECT_EQ(x.xref.throughPointers.size(), 1u);
  ASSERT_NE(x.entry("VD10"), nullptr);
}

}  // namespace
}  // namespace rungproof
