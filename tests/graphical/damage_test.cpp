// Damaged XML: cut off anywhere, bytes changed anywhere, bombs, depth, size. Whatever comes: a finding with a place or
// a program, never a crash, and no hang. What stands before and behind the damage is read.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>

#include "tests/graphical/plcopen_text.hpp"
#include "tests/reader/read.hpp"

namespace rungproof {
namespace {

const std::vector<std::string> bits = {"a:BOOL@%IX0.0", "y:BOOL@%QX0.0", "z:BOOL@%QX0.1"};
const std::string rung = railElement(1) + contactElement(2, {"1"}, "a") + coilElement(3, {"2"}, "y");

std::vector<std::string> corpusTexts() {
  std::vector<std::string> texts;
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(std::filesystem::path(RUNGPROOF_SOURCE_DIR) / "corpus")) {
    if (entry.path().extension() != ".xml") continue;
    std::ifstream stream(entry.path(), std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    texts.push_back(text.str());
  }
  std::sort(texts.begin(), texts.end());
  return texts;
}

std::string rules(const Program& program) {
  std::string text;
  for (const Finding& finding : program.findings) text += finding.rule + " ";
  return text;
}

TEST(XmlDamage, CutAnywhere) {
  std::mt19937 random(99);
  for (const std::string& text : corpusTexts()) {
    for (int i = 0; i < 12; ++i) {
      const std::size_t length = 60 + random() % (text.size() - 70);
      const Program program = readText("t.xml", text.substr(0, length));
      EXPECT_TRUE(hasReadErrors(program)) << length;
      for (const Finding& finding : program.findings) EXPECT_LE(finding.span.offset, length);
    }
  }
}

TEST(XmlDamage, BytesChangedAnywhere) {
  std::mt19937 random(100);
  const std::vector<std::string> texts = corpusTexts();
  ASSERT_GE(texts.size(), 18U);
  for (int i = 0; i < 400; ++i) {
    std::string text = texts[random() % texts.size()];
    const int changes = 1 + static_cast<int>(random() % 6);
    for (int k = 0; k < changes; ++k) {
      const std::size_t place = random() % text.size();
      const std::size_t other = random() % text.size();
      switch (random() % 4) {
        case 0: text[place] = static_cast<char>(random()); break;
        case 1: text.erase(place, random() % 40); break;
        case 2: text.insert(place, text.substr(other, random() % 60)); break;
        default: text[place] = '0' + static_cast<char>(random() % 10); break;
      }
    }
    const Program program = readText("t.xml", text);
    EXPECT_TRUE(program.instructionCount() > 0 || !program.findings.empty());
  }
}

TEST(XmlDamage, WhatStandsBehindTheDamageIsRead) {
  const std::string first = pouText("One", "program", "<localVars>" + declarations(bits) + "</localVars>", "LD", rung);
  const std::string broken = "<pou name=\"Two\" pouType=\"functionBlock\"><interface><<<</pou>\n";
  const std::string last =
      pouText("Three", "functionBlock", "<localVars>" + declarations(bits) + "</localVars>", "LD", rung);
  const Program program = readText("t.xml", projectText(first + broken + last));
  EXPECT_NE(rules(program).find("SYN033"), std::string::npos);
  ASSERT_FALSE(program.pous.empty());
  EXPECT_EQ(show(program.pous[0]).substr(0, 16), "LD I0.0; = Q0.0");
  const Program both = readText("t.xml", projectText(broken + first + last));
  ASSERT_FALSE(both.pous.empty());
}

// A document has one element: what follows it is no part of the program.
TEST(XmlDamage, NothingFollowsTheDocument) {
  const std::string project = plcopen(bits, "LD", rung);
  for (const std::string& tail :
       {std::string("LD I0.5\n= Q0.0\n"), std::string("<project/>"), project.substr(project.find("<project"))}) {
    const Program program = readText("t.xml", project + tail);
    EXPECT_EQ(rules(program), "SYN033 ") << tail;
    ASSERT_FALSE(program.pous.empty());
    EXPECT_EQ(show(program.pous[0]), "LD I0.0; = Q0.0") << "the drawing itself is read once";
  }
  EXPECT_EQ(rules(readText("t.xml", project + "\n<!-- made by hand -->\n")), "");
}

TEST(XmlDamage, EntitiesAreRefused) {
  const Program program = readText(
      "t.xml",
      "<?xml version=\"1.0\"?>\n<!DOCTYPE lolz [<!ENTITY lol \"lol\"><!ENTITY lol2 \"&lol;&lol;&lol;&lol;\">]>\n" +
          plcopen(bits, "LD", rung).substr(22));
  EXPECT_EQ(rules(program), "SYN034 ");
  EXPECT_EQ(program.sources->position(program.findings[0].span).line, 2U);
}

TEST(XmlDamage, DepthIsBounded) {
  std::string deep;
  for (int i = 0; i < 100'000; ++i) deep += "<a>";
  for (int i = 0; i < 100'000; ++i) deep += "</a>";
  Program program;
  program = readText("t.xml", plcopen(bits, "LD", rung + deep));
  EXPECT_NE(rules(program).find("SYN035"), std::string::npos);
  ASSERT_FALSE(program.pous.empty());
  EXPECT_EQ(show(program.pous[0]), "!LD I0.0; = Q0.0");  // an element of a drawing that is not known
  program = readText("t.xml", "<project>" + deep.substr(0, 300'000));
}

// Contacts in parallel are one expression, contacts in series one in the other: both have a limit, and what stands
// beside them is read. 2000 and 400 elements are the limits of one result.
TEST(XmlDamage, LongNetworksAreRefusedAndTheRestIsRead) {
  const std::vector<std::string> bits = {"a:BOOL@%IX0.0", "y:BOOL@%QX0.0", "z:BOOL@%QX0.1"};
  const auto messages = [&](const std::string& elements) {
    const Program program = readText(
        "t.xml", projectText(pouText("Main", "program", "<localVars>" + declarations(bits) + "</localVars>", "LD",
                                     railElement(1) + elements + contactElement(900'000, {"1"}, "a", "", 0, 900) +
                                         coilElement(900'001, {"900000"}, "z", "", 0, 900)),
                             ""));
    std::string text;
    for (const Finding& finding : program.findings) text += finding.message + "\n";
    return text;
  };
  constexpr int many = 100'000;
  std::string parallel, series;
  std::vector<std::string> ends;
  for (int i = 2; i < many; ++i) {
    parallel += contactElement(i, {"1"}, "a");
    series += contactElement(i, {std::to_string(i - 1)}, "a");
    ends.push_back(std::to_string(i));
  }
  EXPECT_EQ(messages(parallel + coilElement(many, ends, "y")),
            "more than 2000 elements lead to one result: put a coil between them\n");
  EXPECT_EQ(messages(series + coilElement(many, {std::to_string(many - 1)}, "y")),
            "more than 400 elements stand in series: put a coil between them\n");
}

TEST(XmlDamage, TenMegabytesAreRead) {
  // 10 MB: one body with thousands of circuits, and one with a row of contacts that has no end.
  std::string wide = railElement(1);
  int id = 2;
  for (int i = 0; wide.size() < 5'000'000; ++i, id += 2)
    wide += contactElement(id, {"1"}, "a", "", 10, 100 * i) +
            coilElement(id + 1, {fmt::format("{}", id)}, "y", "", 20, 100 * i);
  Program program;
  program = readText("t.xml", plcopen(bits, "LD", wide));
  EXPECT_GT(program.instructionCount(), 25'000U);
  std::string row = railElement(1) + contactElement(2, {"1"}, "a");
  for (id = 3; row.size() < 10'000'000; ++id) row += contactElement(id, {fmt::format("{}", id - 1)}, "a");
  row += coilElement(id, {fmt::format("{}", id - 1)}, "y");
  program = readText("t.xml", plcopen(bits, "LD", row));
  EXPECT_NE(rules(program).find("GRF001"), std::string::npos);
}

TEST(XmlDamage, ControlCharactersAndEncodings) {
  std::string text = plcopen(bits, "LD", rung);
  text[text.find("<coil") + 10] = '\0';
  EXPECT_NE(rules(readText("t.xml", text)).find("SYN004"), std::string::npos);
  std::string german = plcopen({"a:BOOL@%IX0.0", "Tür:BOOL@%QX0.0"}, "LD",
                               railElement(1) + contactElement(2, {"1"}, "a") + coilElement(3, {"2"}, "Tür"));
  EXPECT_EQ(show(readText("t.xml", german).pous[0]), "LD I0.0; = Q0.0");
  for (std::size_t at = german.find("\xC3\xBC"); at != std::string::npos; at = german.find("\xC3\xBC"))
    german.replace(at, 2, "\xFC");
  EXPECT_EQ(show(readText("t.xml", german).pous[0]), "LD I0.0; = Q0.0");  // CP1252 whatever the first line says
}

TEST(XmlDamage, MissingParts) {
  EXPECT_EQ(rules(readText("t.xml", "<project xmlns=\"http://www.plcopen.org/xml/tc6_0201\"/>")), "SYN036 ");
  EXPECT_EQ(rules(readText("t.xml", projectText("<pou name=\"M\" pouType=\"program\"/>"))), "SYN036 ");
  EXPECT_EQ(rules(readText("t.xml", "<Document><SW.Blocks.OB ID=\"0\"/></Document>")).substr(0, 7), "SYN036 ");
  EXPECT_NE(rules(readText("t.xml", "<html><body/></html>")), "");
}

}  // namespace
}  // namespace rungproof
