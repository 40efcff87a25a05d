// Columns of each family; and over the corpus: the second time nothing changes, and the same instructions are read.
#include <filesystem>

#include "frontend/files/encoding.hpp"
#include "frontend/input/project.hpp"
#include "tests/editor/editor_session.hpp"
#include "tests/program_run.hpp"

namespace rungproof::test {
namespace {

/// The text after the edits, which are in the order of the text and do not overlap.
std::string applied(const std::string& text, const Json& edits) {
  std::vector<std::size_t> lines{0};
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\n') lines.push_back(i + 1);
  }
  const auto offset = [&](const Json& place) {  // what is replaced is ASCII or begins its line
    const std::size_t begin = lines.at(*at(place, "line").natural());
    std::size_t units = *at(place, "character").natural(), i = begin;
    for (; units > 0 && i < text.size(); --units) {
      const auto lead = static_cast<unsigned char>(text[i]);
      if (lead >= 0xF0) --units;  // two units
      i += lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : lead >= 0xC0 ? 2 : 1;
    }
    return i;
  };
  std::string result;
  std::size_t done = 0;
  std::vector<std::pair<std::pair<std::size_t, std::size_t>, std::string>> sorted;
  for (const Json& edit : edits.items())
    sorted.push_back({{offset(at(edit, "range/start")), offset(at(edit, "range/end"))}, textAt(edit, "newText")});
  std::ranges::sort(sorted);
  for (const auto& [range, replacement] : sorted) {
    EXPECT_GE(range.first, done);
    result += text.substr(done, range.first - done) + replacement;
    done = range.second;
  }
  return result + text.substr(done);
}

Json editsOf(EditorSession& session, const std::string& uri) {
  return at(session.request("textDocument/formatting",
                            {{"textDocument", Json{{"uri", uri}}}, {"options", Json{{"tabSize", 2}}}}),
            "result");
}

std::string formatted(const std::string& text, const std::string& uri = untitled,
                      const std::vector<std::string>& options = {}) {
  EditorSession session(options);
  session.open(text, uri);
  return applied(text, editsOf(session, uri));
}

TEST(Formatting, PutsOperandsOfAStatementListInColumnEight) {
  EXPECT_EQ(
      formatted(
          "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1 // Pump\n// as  it is\n  ld   I0.0 // start\nTON T37 ,+100\n"
          "\tMOVW  +5,VW2\nNOT\n= Q0.0\nXYZ  1\nEND_ORGANIZATION_BLOCK\n"),
      "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1 // Pump\n// as  it is\nLD     I0.0 // start\nTON    T37, +100\n"
      "MOVW   +5, VW2\nNOT\n=      Q0.0\nXYZ  1\nEND_ORGANIZATION_BLOCK\n");
}

TEST(Formatting, KeepsLabelsInFrontOfStep7Statements) {
  EXPECT_EQ(
      formatted("ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\nA I  0.0;\n  L   S5T#2S ; // two\nSD T 1;\nJC m1;\n= Q 4.0;\n"
                "m1:NOP 0;\nA( ;\nA \"Start  button\";\n);\nL MW 2; L 5;\nEND_ORGANIZATION_BLOCK\n",
                untitled, {"--dialect", "s7-300"}),
      "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n      A     I 0.0;\n      L     S5T#2S; // two\n      SD    T 1;\n"
      "      JC    m1;\n      =     Q 4.0;\nm1:   NOP   0;\n      A(;\n      A     \"Start  button\";\n      );\n"
      "L MW 2; L 5;\nEND_ORGANIZATION_BLOCK\n");
}

// What goes on with a condition is further in than what the condition leads to.
TEST(Formatting, IndentsStructuredTextByItsNesting) {
  EXPECT_EQ(
      formatted(
          "PROGRAM P\nVAR\nA, B : BOOL; // in\n   N : INT;\nEND_VAR\nIF A AND\nB THEN\nCASE N OF\n1: N := 2;\nELSE\n"
          "N := 0;\nEND_CASE;\nELSIF B THEN\nFOR N := 1 TO 3 DO A := B; END_FOR;\nEND_IF;\n(* a\n  b *)\n"
          "END_PROGRAM\n",
          "untitled:p.st"),
      "PROGRAM P\n  VAR\n    A, B : BOOL; // in\n    N : INT;\n  END_VAR\n  IF A AND\n      B THEN\n    CASE N OF\n"
      "      1: N := 2;\n    ELSE\n      N := 0;\n    END_CASE;\n  ELSIF B THEN\n"
      "    FOR N := 1 TO 3 DO A := B; END_FOR;\n  END_IF;\n(* a\n  b *)\nEND_PROGRAM\n");
}

TEST(Formatting, OnlyTheLinesThatAreAsked) {
  EditorSession session;
  session.open("ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1\nLD I0.0\n= Q0.0\nEND_ORGANIZATION_BLOCK\n");
  const Json edits =
      at(session.request("textDocument/rangeFormatting", {{"textDocument", Json{{"uri", untitled}}},
                                                          {"range", Json{{"start", Json{{"line", 4}, {"character", 0}}},
                                                                         {"end", Json{{"line", 4}, {"character", 6}}}}},
                                                          {"options", Json{{"tabSize", 2}}}}),
         "result");
  ASSERT_EQ(edits.size(), 1U);
  EXPECT_EQ(textAt(edits, "0/newText"), "=      Q0.0");
}

/// What the reader makes of a text, without places.
std::string meaningOf(const std::string& name, const std::string& text) {
  std::string result;
  const Program program = readText(name, text);
  for (const Pou& pou : program.pous) {
    result += pou.name + "\n";
    for (const Network& network : pou.networks) {
      for (const Instruction& instruction : network.instructions) {
        result += instruction.desc->stl;
        for (const Operand& operand : instruction.operands) result += " " + toString(operand);
        result += "\n";
      }
    }
  }
  return result + fmt::format("{} findings", program.findings.size());
}

TEST(Formatting, KeepsTheMeaningOfTheCorpusAndIsDoneOnce) {
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(RUNGPROOF_SOURCE_DIR "/corpus")) {
    const std::string extension = entry.path().extension().string();
    if (extension != ".awl" && extension != ".st" && extension != ".il" && extension != ".scl") continue;
    const std::string text = decode(contentOf(entry.path()), TextEncoding::Auto).text;
    const std::string uri = "untitled:corpus" + extension;
    const std::string once = formatted(text, uri);
    EXPECT_EQ(formatted(once, uri), once) << entry.path();
    EXPECT_EQ(meaningOf("corpus" + extension, once), meaningOf("corpus" + extension, text)) << entry.path();
    ++files;
  }
  EXPECT_GT(files, 130U);
}

}  // namespace
}  // namespace rungproof::test
