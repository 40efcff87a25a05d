// What is offered where.
#include <algorithm>

#include "tests/editor/editor_session.hpp"
#include "tests/editor/press.hpp"

namespace rungproof::test {
namespace {

std::vector<std::string> labelsAt(EditorSession& session, int line, int character) {
  return textsOf(at(session.ask("textDocument/completion", line, character), "items"), "label");
}
bool has(const std::vector<std::string>& labels, const std::string& label) {
  return std::ranges::find(labels, label) != labels.end();
}

TEST(Completion, MnemonicsOfTheCpuAtTheBeginningOfALine) {
  EditorSession session;
  session.open(press + "Network 9\nL\n");
  const std::vector<std::string> labels = labelsAt(session, 30, 1);
  for (const char* mnemonic : {"LD", "TON", "MOVW", "LDW>=", "NETR"}) EXPECT_TRUE(has(labels, mnemonic)) << mnemonic;
  for (const char* other : {"GET", "Q0.0", "U", "MEND"})
    EXPECT_FALSE(has(labels, other)) << other;  // SMART, address, German
  EditorSession smart({"--cpu", "ST40"});
  smart.open("Network 1\nG\n");
  EXPECT_TRUE(has(labelsAt(smart, 1, 1), "GET"));
  EXPECT_FALSE(has(labelsAt(smart, 1, 1), "NETR"));
}

TEST(Completion, GermanMnemonicsInAGermanProgram) {
  EditorSession session;
  session.open("Network 1\nU E0.0\n= A0.0\nX\n");
  const std::vector<std::string> labels = labelsAt(session, 3, 1);
  EXPECT_TRUE(has(labels, "UN"));
  EXPECT_FALSE(has(labels, "AN"));
}

// CC and JC are statements of an S7-300/400 only, TON and LDW>= of an S7-200.
TEST(Completion, AStep7SourceHasItsOwnWords) {
  EditorSession session({"--dialect", "s7-300"});
  session.open(
      "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n      A I 0.0;\n      JC M001;\n      L MW 10;\n"
      "M001: \n      = \nEND_ORGANIZATION_BLOCK\n");
  for (const int line : {3, 6}) {  // after blanks, after a label
    const std::vector<std::string> labels = labelsAt(session, line, 6);
    for (const char* mnemonic : {"A", "JC", "CC", "OPN", "L"}) EXPECT_TRUE(has(labels, mnemonic)) << mnemonic << line;
    for (const char* other : {"TON", "LDW>=", "ALD"}) EXPECT_FALSE(has(labels, other)) << other << line;
  }
  const std::vector<std::string> bits = labelsAt(session, 7, 8);
  EXPECT_TRUE(has(bits, "I0.0"));
  EXPECT_FALSE(has(bits, "MW10"));
}

// U and E: the source would not be read with I0.1 in it.
TEST(Completion, AGermanStep7SourceHasGermanAddresses) {
  EditorSession session({"--dialect", "s7-300"});
  session.open(
      "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n      U E 0.1;\n      = A 4.0;\n      U \n"
      "END_ORGANIZATION_BLOCK\n");
  const std::vector<std::string> labels = labelsAt(session, 5, 8);
  EXPECT_TRUE(has(labels, "E0.1"));
  EXPECT_TRUE(has(labels, "A4.0"));
  EXPECT_FALSE(has(labels, "I0.1"));
}

TEST(Completion, StructuredTextHasItsKeywordsAndVariables) {
  EditorSession session;
  session.open("PROGRAM P\nVAR_INPUT Start : BOOL; END_VAR\n \nEND_PROGRAM\n", "untitled:p.st");
  const Json offered = at(session.ask("textDocument/completion", 2, 1, "untitled:p.st"), "items");
  const std::vector<std::string> labels = textsOf(offered, "label");
  for (const char* word : {"IF", "END_VAR", "TRUE", "Start"}) EXPECT_TRUE(has(labels, word)) << word;
  EXPECT_FALSE(has(labels, "LD"));
}

TEST(Completion, AddressesThatFitTheOperand) {
  EditorSession session;
  session.open(press + "SYMBOL_TABLE\nStart,I0.0,\nLevel,VW10,\nEND_SYMBOL_TABLE\n");
  const std::vector<std::string> bits = labelsAt(session, 5, 3);  // AN
  for (const char* bit : {"I0.0", "Q0.5", "M0.0", "T37", "Start"}) EXPECT_TRUE(has(bits, bit)) << bit;
  EXPECT_FALSE(has(bits, "Level"));                                          // a word is no contact
  EXPECT_EQ(labelsAt(session, 13, 4), (std::vector<std::string>{"T37"}));    // TON
  EXPECT_EQ(labelsAt(session, 16, 5), (std::vector<std::string>{"SBR_0"}));  // CALL
  EXPECT_EQ(labelsAt(session, 19, 4), (std::vector<std::string>{"3"}));      // JMP
}

TEST(Completion, ReplacesTheWordThatIsBeingTyped) {
  EditorSession session;
  session.open("Network 1\nLD I0.0\n= Q0.0\nNetwork 2\nLD I0.\n");
  const Json items = at(session.ask("textDocument/completion", 4, 6), "items");
  ASSERT_FALSE(items.empty());
  EXPECT_EQ(rangeText(at(items, "0/textEdit/range")), "4:3-4:6");
}

TEST(Completion, WordsOfThePropertyLanguage) {
  EditorSession session;
  session.open(press);
  const std::vector<std::string> labels = labelsAt(session, 3, 10);
  for (const char* word : {"prove", "never", "leads", "within", "rises", "first_scan", "Q0.0"})
    EXPECT_TRUE(has(labels, word)) << word;
  EXPECT_FALSE(has(labels, "LD"));
}

TEST(Completion, EveryWordOfThePropertyLanguageIsOneOfIts) {
  // Statements that use each offered word once and are all read: a word that the language lost would fail here.
  EditorSession session;
  const Json diagnostics = session.diagnosticsOf(
      "Network 1\n"
      "//@ assume a: not I0.7\n"
      "//@ prove b: always Q0.0 implies I0.0 or I0.1 xor I0.2\n"
      "//@ prove c: never Q0.0 and not I0.0 and prev(I0.0) and once(I0.0) and since(I0.0, I0.1)\n"
      "//@ prove d: I0.0 leads to Q0.0 within 3 scans\n"
      "//@ prove e: rises(Q0.0) only after first_scan or falls(I0.1) or I0.0\n"
      "//@ prove f: Q0.0 unless not I0.0\n"
      "//@ prove g: I0.0 held 2s implies Q0.0\n"
      "//@ at every instruction prove h: never Q0.0 and not Q0.0\n"
      "//@ reach i: Q0.0\n"
      "//@ external VB100..VB101\n"
      "//@ initial retentive\n"
      "//@ pulse I0.3 at most every 50ms\n"
      "LD I0.0\n= Q0.0\n");
  for (const Json& diagnostic : diagnostics.items())
    EXPECT_NE(textAt(diagnostic, "code").substr(0, 3), "PRP") << diagnostic.dump();
}

TEST(Completion, CodesInSuppressions) {
  EditorSession session;
  session.open("Network 1\nLD I0.0 // rungproof: \n= Q0.0 // rungproof: allow O\n// text \n");
  EXPECT_EQ(labelsAt(session, 1, 22), (std::vector<std::string>{"allow", "begin", "end"}));
  const std::vector<std::string> codes = labelsAt(session, 2, 28);
  EXPECT_TRUE(has(codes, "OUT001"));
  EXPECT_TRUE(has(codes, "ADR001"));
  EXPECT_FALSE(has(codes, "SYN001"));            // errors of the readers cannot be silenced
  EXPECT_TRUE(labelsAt(session, 3, 8).empty());  // in prose nothing
}

}  // namespace
}  // namespace rungproof::test
