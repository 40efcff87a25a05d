// What foreign files seem to be, and that of the corpus only the programs of the S7-300 do.
#include "frontend/input/foreign_family.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "frontend/files/encoding.hpp"

namespace rungproof {
namespace {

std::string familyOf(const std::string& text) {
  const std::optional<ForeignFamily> family = foreignText(text);
  return family ? std::string(family->what.substr(0, family->what.find(' '))) : "none";
}

TEST(ForeignFamily, BySignsOfItsLanguage) {
  EXPECT_EQ(
      familyOf(
          "ORGANIZATION_BLOCK OB 1\nVERSION : 0.1\nBEGIN\nNETWORK\n  U E 0.0;\n  = A 4.0;\nEND_ORGANIZATION_BLOCK\n"),
      "STL");
  EXPECT_EQ(familyOf("DATA_BLOCK DB 1\nVERSION : 0.1\nSTRUCT\n a : INT;\nEND_STRUCT\nBEGIN\nEND_DATA_BLOCK\n"), "STL");
  EXPECT_EQ(familyOf("FUNCTION FC 1 : VOID\nBEGIN\n  IF x THEN\n  y := 1;\n  END_IF;\nEND_FUNCTION\n"), "SCL");
  EXPECT_EQ(familyOf("a := b AND c;\nd := NOT a;\n"), "structured");
  EXPECT_EQ(familyOf("LD X0\nOUT Y0\nLDI X1\nOUT T0 K10\n"), "an");  // instruction list for Mitsubishi MELSEC
  EXPECT_EQ(familyOf("LD 0.00\nAND NOT 0.01\nOUT 10.00\n"), "mnemonics");
  EXPECT_EQ(familyOf("<?xml version=\"1.0\"?>\n<!-- x -->\n<TcPlcObject Version=\"1.1\">\n"), "a");
  EXPECT_EQ(familyOf("<!DOCTYPE html>\n<html></html>"), "a");
}

TEST(ForeignFamily, IsNotSaidOfProgramsWithMistakes) {
  EXPECT_EQ(familyOf("Network 1\nLD I0.0\n= Q0.0\n"), "none");
  EXPECT_EQ(familyOf("LD I0.0;\nA I0.1\n= Q0.0\n"), "none");
  EXPECT_EQ(familyOf("LD X0\nA I0.1\n= Q0.0\n"), "none");
  EXPECT_EQ(familyOf("Dear colleague, the program is on the other disk.\n"), "none");
  EXPECT_EQ(familyOf("<!DOCTYPE project [<!ENTITY a \"b\">]>\n<project/>"), "none");
  EXPECT_EQ(familyOf(""), "none");
}

TEST(ForeignFamily, ContainersByTheirFirstBytes) {
  EXPECT_TRUE(foreignContainer("\xD0\xCF\x11\xE0\xA1\xB1"));
  EXPECT_TRUE(foreignContainer("PK\x03\x04"));
  EXPECT_TRUE(foreignContainer("%PDF-1.7"));
  EXPECT_FALSE(foreignContainer("PK"));
  EXPECT_FALSE(foreignContainer("LD I0.0"));
}

TEST(ForeignFamily, OnlyThoseOfTheSecondFamilySeemForeignInTheCorpus) {
  int files = 0;
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(std::string(RUNGPROOF_SOURCE_DIR) + "/corpus")) {
    const std::string ending = entry.path().extension().string();
    if (ending != ".awl" && ending != ".stl" && ending != ".xml" && ending != ".txt") continue;
    std::ifstream stream(entry.path(), std::ios::binary);
    std::ostringstream bytes;
    bytes << stream.rdbuf();
    EXPECT_FALSE(foreignContainer(bytes.str())) << entry.path();
    const bool isStep7 = entry.path().parent_path().filename() == "s7300";
    EXPECT_EQ(familyOf(decode(bytes.str(), TextEncoding::Auto).text), isStep7 ? "STL" : "none") << entry.path();
    ++files;
  }
  EXPECT_GE(files, 120);
}

}  // namespace
}  // namespace rungproof
