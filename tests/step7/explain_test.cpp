// Pages of the S7-300/400, and the tables behind them: status bits against the stated cases of every instruction, the
// list of what is not covered against the guide.
#include <gtest/gtest.h>

#include <fstream>
#include <regex>
#include <sstream>

#include "frontend/explain/step7_address_page.hpp"
#include "frontend/explain/step7_page.hpp"
#include "frontend/step7/library_source.hpp"
#include "ir/dialect.hpp"
#include "ir/s7200/cpu.hpp"
#include "ir/s7300/block.hpp"
#include "ir/s7300/fbd_box.hpp"
#include "ir/s7300/isa.hpp"
#include "ir/s7300/library.hpp"
#include "ir/s7300/organization_block.hpp"
#include "ir/s7300/status_effect.hpp"

namespace rungproof {
namespace {

std::string pageText7(const std::string& word, Mnemonics mnemonics = Mnemonics::Auto) {
  const auto page = step7Page(word, mnemonics, Paint{false});
  return page ? page->text : "";
}

std::vector<std::vector<std::string>> rowsOf7(const std::string& name) {
  std::ifstream in(RUNGPROOF_SOURCE_DIR "/tests/data/" + name);
  std::vector<std::vector<std::string>> rows;
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line[0] == '#') continue;
    std::vector<std::string> cells;
    std::stringstream stream(line);
    for (std::string cell; std::getline(stream, cell, '\t');) cells.push_back(cell);
    rows.push_back(std::move(cells));
  }
  return rows;
}

TEST(Explain7, EveryInstructionHasItsPageInBothSets) {
  for (const std::vector<std::string>& row : rowsOf7("s7300_rows.tsv")) {
    std::string name = row[1], german = row[2];
    if (row[0].starts_with("status condition")) name = name.substr(0, 1), german = german.substr(0, 1);
    if (name.find(" <") != std::string::npos || name.find(" (") != std::string::npos) {
      name = name.substr(0, name.find(' '));
      german = german.substr(0, german.find(' '));
    }
    for (const auto& [word, set] : {std::pair(name, Mnemonics::International), {german, Mnemonics::German}}) {
      const std::string text = pageText7(word, set);
      EXPECT_TRUE(text.find("Writes") != std::string::npos) << row[1] << ": " << word;
      EXPECT_TRUE(text.find("00") != std::string::npos) << word;
    }
  }
}

TEST(Explain7, StatusBitsAgreeWithTheStatedCases) {
  int compared = 0;
  for (const std::vector<std::string>& cells : rowsOf7("s7300_cases.tsv")) {
    if (cells.size() < 5 || cells[2].find(';') != std::string::npos || cells[2].find('{') != std::string::npos)
      continue;
    if (cells[2].find('|') != std::string::npos || cells[4].find("STOP") != std::string::npos) continue;
    const std::string statement = cells[2].substr(cells[2].find_first_not_of("@ "));
    const Desc* desc = s7300Instructions().named(statement);
    if (desc == nullptr) desc = s7300Instructions().named(statement.substr(0, statement.find(' ')));
    const bool isVariant = statement.find(' ') != std::string::npos && desc != nullptr && desc->stl.size() <= 2 &&
                           std::string("LTSR").find(desc->stl[0]) != std::string::npos;
    if (desc == nullptr || isVariant || (statement == "O" && desc->stl == "O")) continue;
    const std::string_view bits = s7300::statusEffect(*desc);
    const std::string after = cells[4].substr(0, 9), before = cells[3].substr(0, 9);
    ASSERT_EQ(bits.size(), 9U) << statement;
    for (std::size_t i = 0; i < 9; ++i) {
      if (after[i] == '?') continue;
      const char value = after[i] == '.' ? before[i] : after[i];
      const char expected = bits[i] == '-' ? before[i] : bits[i] == 'x' ? value : bits[i];
      EXPECT_EQ(value, expected) << cells[2] << " case " << cells[1] << " bit " << i;
      ++compared;
    }
  }
  EXPECT_GT(compared, 2000);
}

TEST(Explain7, TheSetOfMnemonicsDecidesWhereTheyDisagree) {
  EXPECT_NE(pageText7("SE", Mnemonics::International).find("extended pulse"), std::string::npos);
  EXPECT_EQ(pageText7("SE", Mnemonics::International).find("on-delay"), std::string::npos);
  EXPECT_NE(pageText7("SE", Mnemonics::German).find("on-delay"), std::string::npos);
  const std::string both = pageText7("SE");
  EXPECT_NE(both.find("on-delay"), std::string::npos);
  EXPECT_NE(both.find("extended pulse"), std::string::npos);
}

TEST(Explain7, ShowsWhatAnInstructionWrites) {
  EXPECT_NE(pageText7("JNB").find("BR, OR = 0, STA = 1, RLO = 1, /FC = 0"), std::string::npos) << pageText7("JNB");
  EXPECT_NE(pageText7("NOP 0").find("no bit of the status word"), std::string::npos);
  EXPECT_NE(pageText7("O").find("or of AND groups"), std::string::npos);  // O without operand
  EXPECT_NE(pageText7("L").find("L STW"), std::string::npos);
}

TEST(Explain7, BoxesShowTheirStatements) {
  EXPECT_NE(pageText7("ADD_I").find("L $IN1; L $IN2; +I; T $OUT; AN OV; SAVE; CLR"), std::string::npos);
  EXPECT_NE(pageText7("S_EVERZ").find("S_ODT"), std::string::npos);
  for (const s7300::FbdBox& box : s7300::fbdBoxes()) {
    EXPECT_EQ(pageText7(std::string(box.name)).empty(), box.name.empty()) << box.name;
  }
}

std::string addressText7(const std::string& word, const char* cpu = "319-3") {
  const auto page = step7AddressPage({*cpuNamed(cpu), usualEdition(*cpuNamed(cpu))}, word, Paint{false});
  return page ? page->text : "";
}

// Not the pages of the S7-200, where T5 has a base of 100 ms and M ends at MB31.
TEST(Explain7, AddressesOfTheFamily) {
  EXPECT_TRUE(addressText7("T5").starts_with("T5: S5 timer")) << addressText7("T5");
  EXPECT_EQ(addressText7("T5").find("100 ms"), std::string::npos);
  EXPECT_TRUE(addressText7("Z3").starts_with("C3: counter"));
  EXPECT_NE(addressText7("C3").find("keeps its value"), std::string::npos);
  EXPECT_NE(addressText7("MW16").find("CPU 319-3: up to MW8190"), std::string::npos) << addressText7("MW16");
  EXPECT_EQ(addressText7("MW16").find("keeps its value"), std::string::npos);
  EXPECT_NE(addressText7("M300.0", "314").find("the last one is M255.7"), std::string::npos);
  EXPECT_NE(addressText7("DB10.DBW2").find("DB10.DBB2 is the most significant"), std::string::npos);
  EXPECT_TRUE(addressText7("PEW256").starts_with("PIW256: input of a module"));
  EXPECT_TRUE(addressText7("DBW2").empty());
}

TEST(Explain7, BlocksOfTheSystemThatNoTableDescribes) {
  EXPECT_NE(pageText7("SFC 14").find("contract only"), std::string::npos);
  EXPECT_NE(pageText7("SFB 14").find("contract only"), std::string::npos);
  EXPECT_NE(pageText7("SFB 38").find("NOT COVERED"), std::string::npos);
}

TEST(Explain7, OrganizationBlocks) {
  EXPECT_NE(pageText7("OB35").find("cyclic interrupt"), std::string::npos);
  EXPECT_NE(pageText7("OB 1").find("modelled"), std::string::npos);
  EXPECT_NE(pageText7("OB101").find("NOT COVERED: what a hot restart leaves"), std::string::npos);
  EXPECT_NE(pageText7("OB102").find("S7-400 and CPU 318-2"), std::string::npos);
  EXPECT_TRUE(pageText7("OB2").empty());
  for (const s7300::OrganizationBlock& row : s7300::organizationBlocks())
    EXPECT_FALSE(pageText7("OB" + std::to_string(row.last)).empty()) << row.last;
}

TEST(Explain7, LibraryBlocksByNumberAndName) {
  EXPECT_NE(pageText7("SFB 4").find("PT"), std::string::npos);
  EXPECT_EQ(pageText7("SFB 4"), pageText7("TON"));
  for (const s7300::LibraryBlock& block : s7300::libraryBlocks()) {
    const std::string text = pageText7(blockName(blockNumber(block.type, block.number)));
    EXPECT_EQ(text.find("NOT COVERED") == std::string::npos, step7::isModelled(block)) << block.name;
  }
}

// SFC 39 locks interrupts (002:2353); SFC 31 asks for the state of one, and its outputs are all that a call changes.
TEST(Explain7, SystemFunctionsThatActOnTheCpuSaySo) {
  EXPECT_NE(pageText7("SFC 39").find("modelled: what it does to interrupts"), std::string::npos) << pageText7("SFC 39");
  EXPECT_NE(pageText7("SFC 31").find("contract only"), std::string::npos) << pageText7("SFC 31");
}

TEST(Explain7, TheGuideListsWhatIsNotCovered) {
  std::stringstream chapter;
  chapter << std::ifstream(RUNGPROOF_SOURCE_DIR "/frontend/guide/64_s7300.md").rdbuf();
  const std::string text = std::regex_replace(chapter.str(), std::regex("\\s+"), " ");
  const std::size_t begin = text.find("NOT COVERED, so that nothing is proved beside it:");
  ASSERT_NE(begin, std::string::npos);
  const std::string list = text.substr(begin, text.find(". A loop", begin) - begin);
  std::string expected = "NOT COVERED, so that nothing is proved beside it:";
  for (const std::string& line : step7NotCovered()) expected += (expected.back() == ':' ? " " : "; ") + line;
  EXPECT_EQ(list, expected);
  for (const std::string& line : step7NotCovered())
    EXPECT_NE(std::regex_replace(pageText7("COVERAGE"), std::regex("\\s+"), " ").find(line), std::string::npos) << line;
}

}  // namespace
}  // namespace rungproof
