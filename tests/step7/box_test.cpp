// The 112 boxes and elements of FBD: a row of each in the table of boxes; the statements of each are read, printed and
// run, and the values that the boxes make are those of the manual's names.
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <sstream>

#include "engine/simulator.hpp"
#include "frontend/step7/source_writer.hpp"
#include "ir/s7300/fbd_box.hpp"
#include "read7.hpp"

namespace rungproof {
namespace {

using s7300::FbdBox;

/// What stands at the pins of a box; words at 10, 20 in, 30, 40, 44 out; bits of M 0 in, Q 4 out.
std::string pinText(const FbdBox& box, const std::string& pin) {
  const std::string text = expansionOf(box);
  const bool isTimer = text.find("$TV") != std::string::npos || text.find("$BI;") != std::string::npos;
  static const std::map<std::string, std::string> bits = {
      {"EN", "M0.0"}, {"ENO", "Q4.0"},    {"Q", "Q4.1"},    {"S", "M0.2"}, {"R", "M0.3"},  {"CU", "M0.4"},
      {"CD", "M0.5"}, {"M_BIT", "M1.0"},  {"TV", "S5T#2S"}, {"PV", "C#5"}, {"BI", "MW40"}, {"BCD", "MW44"},
      {"CV", "MW40"}, {"CV_BCD", "MW44"}, {"N", "2"},       {"DB", "DB2"}};
  if (const auto found = bits.find(pin); found != bits.end()) return found->second;
  const bool isBitBox = box.frame == s7300::BoxFrame::Plain && text.find("L $IN") == std::string::npos;
  if (pin == "BOX") {
    if (box.frame == s7300::BoxFrame::Call)
      return std::string(box.name.ends_with("SFB")   ? "SFB 4"
                         : box.name.ends_with("FB")  ? "FB 2"
                         : box.name.ends_with("SFC") ? "SFC 43"
                                                     : "FC 1");
    if (text.find("CC $BOX") != std::string::npos) return "FC 1";
    if (text.find("OPN") != std::string::npos) return "DB2";
    if (text.find("JC") != std::string::npos) return "end";
    if (box.frame == s7300::BoxFrame::Counter || text.find("CU $BOX") != std::string::npos ||
        text.find("CD $BOX") != std::string::npos || text.find("$PV") != std::string::npos)
      return "C1";
    return isTimer ? "T1" : "M2.0";
  }
  if (isBitBox) return pin == "IN1" ? "M0.1" : pin == "IN2" ? "M0.2" : pin == "IN3" ? "M0.3" : "M0.0";
  return pin == "OUT" ? "MD30" : pin == "IN2" ? "MD20" : "MD10";
}

std::string filled(const FbdBox& box) {
  const std::string text = expansionOf(box);
  std::string result;
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (text[at] != '$') {
      result += text[at];
      continue;
    }
    std::size_t end = at + 1;
    while (end < text.size() && (std::isupper(static_cast<unsigned char>(text[end])) != 0 ||
                                 std::isdigit(static_cast<unsigned char>(text[end])) != 0 || text[end] == '_'))
      ++end;
    result += pinText(box, text.substr(at + 1, end - at - 1));
    at = end - 1;
  }
  return result;
}

std::string sourceOf(const FbdBox& box) {
  const std::string instance = box.name == "CALL_SFB" ? "SFB 4" : "FB 2";
  return fmt::format(
      "FUNCTION FC 1 : VOID\nBEGIN\nNETWORK\n  SET; SAVE;\nEND_FUNCTION\nFUNCTION_BLOCK FB 2\nVAR\n  x : WORD "
      ";\nEND_VAR\n"
      "BEGIN\nNETWORK\n  SET; SAVE;\nEND_FUNCTION_BLOCK\nDATA_BLOCK DB 2\n{}\nBEGIN\nEND_DATA_BLOCK\n"
      "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n  {};\nend: NOP 0;\nEND_ORGANIZATION_BLOCK\n",
      instance, filled(box) + (box.name == "MCR<" ? "; )MCR" : ""));
}

TEST(Boxes7, EveryRowOfTheManualHasOne) {
  std::ifstream in(RUNGPROOF_SOURCE_DIR "/tests/data/s7300_boxes.tsv");
  std::size_t rows = 0;
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("# ")) continue;  // one of the elements is called #
    std::stringstream cells(line);
    std::string name, german, manual;
    std::getline(cells, name, '\t');
    std::getline(cells, german, '\t');
    std::getline(cells, manual, '\t');
    const FbdBox& box = s7300::fbdBoxes()[rows++];
    EXPECT_EQ(box.name, name == "(none)" ? "" : name);
    EXPECT_EQ(box.manual, manual) << name;
    german.erase(std::remove(german.begin(), german.end(), ' '), german.end());
    EXPECT_EQ(box.german, german == name || name == "(none)" ? "" : german);
  }
  EXPECT_EQ(rows, 112U);
  EXPECT_EQ(s7300::fbdBoxes().size(), 112U);
}

TEST(Boxes7, EachIsReadPrintedAndRun) {
  for (const FbdBox& box : s7300::fbdBoxes()) {
    const std::string source = sourceOf(box);
    const Program program = read7(source);
    EXPECT_EQ(findings7(program), "") << source;
    for (const step7::MnemonicSet set : {step7::MnemonicSet::International, step7::MnemonicSet::German}) {
      ReadOptions options;
      options.dialect = "s7-300";
      options.mnemonics = set == step7::MnemonicSet::German ? Mnemonics::German : Mnemonics::International;
      const Program again = read7(step7::writeSource(program, set), options);
      EXPECT_EQ(findings7(again), "") << step7::writeSource(program, set);
      EXPECT_EQ(again.instructionCount(), program.instructionCount()) << box.name;
    }
    Simulator simulator(program, {});
    simulator.scan({});
    simulator.scan({});
    EXPECT_TRUE(simulator.isRunning()) << box.name;
  }
}

/// MD30 after one scan in which EN is 1 and the inputs hold that; Q4.0 is ENO.
struct BoxRun {
  const char* box;
  std::int64_t first, second, out;
  bool eno;
};

TEST(Boxes7, ComputeWhatTheirNamesSay) {
  // Words lie in the lower half of the double words; ADD_I wraps and takes ENO away (003:799).
  const BoxRun runs[] = {
      {"ADD_I", 30000, 2000, 32000, true},
      {"ADD_I", 30000, 3000, 33000, false},
      {"SUB_DI", 7, 9, -2, true},
      {"MUL_DI", 70000, 70000, 605032704, false},  // 4,900,000,000 - 4,294,967,296
      {"DIV_DI", 17, 5, 3, true},
      {"MOD", 17, 5, 2, true},
      {"MOVE", 12345678, 0, 12345678, true},
      {"WAND_DW", 0xFF0, 0x3C, 0x30, true},
      {"WXOR_DW", 0xFF0, 0x3C, 0xFCC, true},
      {"SHL_DW", 5, 0, 20, true},
      {"SHR_DI", -8, 0, -2, true},
      {"DI_BCD", 1234, 0, 0x1234, true},
      {"BCD_DI", 0x1234, 0, 1234, true},
      {"NEG_DI", 5, 0, -5, true},
      {"INV_DI", 5, 0, -6, true},
      {"ROUND", 0x40200000, 0, 2, true},  // 2.5 goes to the even one
      {"CEIL", 0x40200000, 0, 3, true},
      {"FLOOR", 0x40200000, 0, 2, true},
      {"TRUNC", 0x40200000, 0, 2, true},
      {"SQR", 0x40000000, 0, 0x40800000, true},  // 2.0, 4.0
      {"ADD_R", 0x3F800000, 0x3F800000, 0x40000000, true},
      {"DI_R", 4, 0, 0x40800000, true},
  };
  for (const BoxRun& run : runs) {
    const FbdBox& box = *s7300::fbdBoxesNamed(run.box).front();
    const std::string text = fmt::format(
        "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n  SET; = M0.0; L DW#16#{:X}; T MD10; L DW#16#{:X}; T "
        "MD20;\nNETWORK\n  "
        "{};\nEND_ORGANIZATION_BLOCK\n",
        static_cast<std::uint32_t>(run.first), static_cast<std::uint32_t>(run.second), filled(box));
    const Program program = read7(text);
    ASSERT_EQ(findings7(program), "") << text;
    Simulator simulator(program, {});
    simulator.scan({});
    EXPECT_EQ(simulator.read(direct(Area::M, Width::DWord, 30)), static_cast<std::uint32_t>(run.out)) << run.box;
    EXPECT_EQ(simulator.read(direct(Area::Q, Width::Bit, 4, 0)) != 0, run.eno) << run.box;
  }
}

}  // namespace
}  // namespace rungproof
