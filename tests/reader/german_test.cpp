// SIMATIC German mnemonics and areas; detection per file.
#include <gtest/gtest.h>

#include <set>

#include "frontend/stl/stl_likeness.hpp"
#include "ir/s7200/isa.hpp"
#include "tests/reader/read.hpp"

namespace rungproof {
namespace {

TEST(German, DetectedFromOperandsAndMnemonics) {
  const Program program = readLines("LD E0.0\nU E0.1\nUN M0.0\nLD Z5\nULD\n= A0.0\nUW>= AEW0, +100\nMOVW AEW2, AAW0");
  EXPECT_EQ(findings(program), "");
  EXPECT_EQ(show(program.pous[0]), "LD I0.0; A I0.1; AN M0.0; LD C5; ALD; = Q0.0; AW>= AIW0,+100; MOVW AIW2,AQW0");
}

TEST(German, InternationalStaysInternational) {
  const Program program = readLines("LD I0.0\nA I0.1\nA C5\nMOVW AIW0, AQW0\n= Q0.0");
  EXPECT_EQ(show(program.pous[0]), "LD I0.0; A I0.1; A C5; MOVW AIW0,AQW0; = Q0.0");
  EXPECT_EQ(detectSpelling("LD M0.0\n= M0.1\n"), Spelling::International);
  EXPECT_EQ(detectSpelling("LD M0.0\nUN M0.1\n= M0.2\n"), Spelling::German);
}

TEST(German, OptionDecides) {
  ReadOptions german;
  german.mnemonics = Mnemonics::German;
  EXPECT_EQ(show(readLines("LD AB0", german).pous[0]), "LD QB0");
  ReadOptions international;
  international.mnemonics = Mnemonics::International;
  EXPECT_EQ(findings(readLines("LD E0.0\nU E0.1", international)), "SYN019<E0.0> SYN010<U>");
}

TEST(German, LookAlikesInGermanTexts) {
  EXPECT_EQ(show(readLines("LD E0.0\nU EO.1\nUN AO.2").pous[0]), "LD I0.0; A I0.1; AN Q0.2");
}

TEST(German, SpellingsNameOneInstructionEach) {
  std::set<std::string_view> seen;
  for (const Desc& desc : s7200Instructions().all()) {
    if (desc.german.empty() || desc.german == desc.stl) continue;
    EXPECT_TRUE(seen.insert(desc.german).second) << desc.german;
    EXPECT_EQ(s7200Instructions().named(desc.german), nullptr)
        << desc.german << " means something else in the international set";
    EXPECT_EQ(s7200Instructions().namedGerman(desc.german), &desc);
    EXPECT_EQ(s7200Instructions().namedGerman(desc.stl), &desc)
        << "the international spelling is read in German texts, too";
  }
  for (const char* german : {"U", "UN", "UI", "UNI", "ULD", "UENO", "UB=", "UW>=", "UD<", "UR<>", "US="})
    EXPECT_TRUE(seen.count(german) > 0) << german;
}

}  // namespace
}  // namespace rungproof
