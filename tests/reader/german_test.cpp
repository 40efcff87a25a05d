// SIMATIC German mnemonics and areas; detection per file.
#include "ir/german.hpp"

#include <gtest/gtest.h>

#include "frontend/stl_likeness.hpp"
#include "ir/isa.hpp"
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

TEST(German, EveryRowNamesAnInstructionOnce) {
  for (std::size_t i = 0; i < germanMnemonics.size(); ++i) {
    EXPECT_NE(germanMnemonics[i].german, germanMnemonics[i].international);
    EXPECT_EQ(instructionNamed(germanMnemonics[i].german), nullptr) << germanMnemonics[i].german << " means something else in the international set";
    EXPECT_EQ(instructionNamedGerman(germanMnemonics[i].german), instructionNamed(germanMnemonics[i].international));
    for (std::size_t k = i + 1; k < germanMnemonics.size(); ++k) EXPECT_NE(germanMnemonics[i].german, germanMnemonics[k].german);
  }
}

}  // namespace
}  // namespace rungproof
