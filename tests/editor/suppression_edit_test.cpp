// "Allow RULE" in every family: whatever is offered silences the finding, and changes comments only.
#include <algorithm>

#include "frontend/editor/document.hpp"
#include "frontend/input/project.hpp"
#include "tests/editor/editor_session.hpp"

namespace rungproof::test {
namespace {

struct Offer {
  std::string title;
  int line = 0;  ///< of the finding
  std::string code, message;
  std::string after;  ///< the text with the edit
};

std::vector<Offer> offersFor(EditorSession& session, const std::string& text, const std::string& uri) {
  const Json actions =
      at(session.request("textDocument/codeAction", {{"textDocument", Json{{"uri", uri}}},
                                                     {"range", Json{{"start", Json{{"line", 0}, {"character", 0}}},
                                                                    {"end", Json{{"line", 999}, {"character", 0}}}}},
                                                     {"context", Json{{"diagnostics", Json::array()}}}}),
         "result");
  std::vector<Offer> offers;
  for (const Json& action : actions.items()) {
    Offer offer{textAt(action, "title"),
                std::stoi(numberAt(action, "diagnostics/0/range/start/line")),
                textAt(action, "diagnostics/0/code"),
                textAt(action, "diagnostics/0/message"),
                {}};
    if (!offer.title.starts_with("Allow ")) continue;
    Document document{uri, "", 1, text};
    const Json edits = at(action, "edit/changes/" + uri);
    EXPECT_EQ(edits.items().size(), 1U);
    EXPECT_TRUE(applyChange(document, {{"range", at(edits, "0/range")}, {"text", at(edits, "0/newText")}}));
    offer.after = document.text;
    offers.push_back(offer);
  }
  return offers;
}

std::size_t countOf(const Json& diagnostics, const Offer& offer) {
  return static_cast<std::size_t>(std::ranges::count_if(diagnostics.items(), [&](const Json& one) {
    return textAt(one, "code") == offer.code && textAt(one, "message") == offer.message;
  }));
}

/// Statements and properties of a text, comments apart.
std::vector<std::string> saidBy(const std::string& name, const std::string& text) {
  const Program program = readText(name, text);
  std::vector<std::string> rows;
  for (const Pou& pou : program.pous) {
    for (const Network& network : pou.networks) {
      for (const Instruction& instruction : network.instructions) {
        std::string row = pou.name + " " + std::string(instruction.desc->stl);
        for (std::size_t i = 0; i < instruction.operands.size(); ++i) row += " " + toString(instruction.operands[i]);
        rows.push_back(row);
      }
    }
  }
  for (const Directive& directive : program.directives) rows.push_back(directive.text);
  return rows;
}

/// Tries every offer, and gives "8 ADR001 on this line" for each.
std::vector<std::string> tried(const std::string& name, const std::string& text) {
  const std::string uri = "untitled:" + name;
  std::vector<std::string> rows;
  EditorSession session;
  const Json before = session.diagnosticsOf(text, uri);
  int version = 1;
  const auto change = [&](const std::string& to) {
    session.notify("textDocument/didChange", {{"textDocument", Json{{"uri", uri}, {"version", ++version}}},
                                              {"contentChanges", Json::array({Json{{"text", to}}})}});
    return session.nextDiagnostics();
  };
  for (const Offer& offer : offersFor(session, text, uri)) {
    rows.push_back(std::to_string(offer.line) + offer.title.substr(5));
    const Json after = change(offer.after);
    EXPECT_LT(countOf(after, offer), countOf(before, offer)) << offer.title << "\n" << offer.after;
    for (const std::string& code : codesOf(after)) EXPECT_FALSE(code.starts_with("SUP")) << code << "\n" << offer.after;
    EXPECT_EQ(saidBy(name, offer.after), saidBy(name, text)) << offer.title << "\n" << offer.after;
    change(text);
  }
  return rows;
}

std::string afterOffer(const std::string& name, const std::string& text, const std::string& title) {
  EditorSession session;
  session.diagnosticsOf(text, "untitled:" + name);
  for (const Offer& offer : offersFor(session, text, "untitled:" + name)) {
    if (offer.title == title) return offer.after;
  }
  return {};
}

using Rows = std::vector<std::string>;

// VW20000 is beyond V memory (ADR001). Line 3: two statements. Line 4: the property takes the rest of the line, so the
// comment stands before it.
TEST(SuppressionEdit, OfTheS7200) {
  EXPECT_EQ(tried("a.awl",
                  "Network 1\nLD SM0.0\nMOVW 1, VW20000 // grün\nMOVW 2, VW20000; MOVW 3, VW0\n"
                  "MOVW VW0, VW20000 //@ prove p: VW0 = 3\n"),
            (Rows{"2 ADR001 on this line", "2 ADR001 in this network", "3 ADR001 on this line",
                  "3 ADR001 in this network", "4 ADR001 on this line", "4 ADR001 in this network"}));
}

TEST(SuppressionEdit, APropertyBehindTheFirstStatementLeavesTheNetworkOnly) {
  EXPECT_EQ(tried("a.awl", "Network 1\nLD I99.0 //@ prove p: Q0.0 implies Q0.0\n= Q0.0\n"),
            (Rows{"1 ADR001 in this network"}));
}

// Nothing starts T5 (TIM009). Line 3: two statements. Line 4 ends within a comment. Line 6 has a property.
TEST(SuppressionEdit, OfTheS7300) {
  const std::string text =
      "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n      U T 5; = A 0.0;\n      U T 6; (* goes\n on *) = A 0.1;\n"
      "      U T 7; //@ prove p: A0.0 implies A0.0\n      = A 0.2;\n      U T 8; // lamp\n      = A 0.3;\n"
      "END_ORGANIZATION_BLOCK\n";
  EXPECT_EQ(tried("a.awl", text), (Rows{"3 TIM009 on this line", "3 TIM009 in this network", "4 TIM009 on this line",
                                        "4 TIM009 in this network", "6 TIM009 on this line", "6 TIM009 in this network",
                                        "8 TIM009 on this line", "8 TIM009 in this network"}));
  EXPECT_EQ(afterOffer("a.awl", text, "Allow TIM009 on this line").substr(38, 58),
            "      U T 5; = A 0.0;  // rungproof: allow TIM009 say why\n");
}

// Q4.0 has two coils (OUT001); SCL has no networks.
TEST(SuppressionEdit, OfScl) {
  const std::string text =
      "ORGANIZATION_BLOCK OB 1\nBEGIN\n  Q4.0 := M0.5;\n  IF M0.6 THEN MW20 := MW22; END_IF; (* x *)\n"
      "  Q4.0 := M1.5; MW30 := MW32; // two\nEND_ORGANIZATION_BLOCK\n";
  EXPECT_EQ(tried("a.scl", text), (Rows{"4 OUT001 on this line"}));
  EXPECT_EQ(afterOffer("a.scl", text, "Allow OUT001 on this line"),
            "ORGANIZATION_BLOCK OB 1\nBEGIN\n  Q4.0 := M0.5;\n  IF M0.6 THEN MW20 := MW22; END_IF; (* x *)\n"
            "  Q4.0 := M1.5; MW30 := MW32; // rungproof: allow OUT001 two\nEND_ORGANIZATION_BLOCK\n");
}

// The comment says 5 s, the literal 3 s (IEC017).
const std::string timed =
    "PROGRAM P\nVAR_INPUT a : BOOL; END_VAR\nVAR_OUTPUT q : BOOL; END_VAR\nVAR t : TON; END_VAR\n";

TEST(SuppressionEdit, OfStructuredText) {
  for (const char* statement : {"(* run *) t(IN := a, PT := T#3s); (* 5 s *)\n", "t(IN := a, PT := T#3s); // 5 s\n",
                                "q := a; t(IN := a, PT := T#3s); (* 5 s *) //@ prove p: q implies a\n",
                                "t(IN := a,\n  PT := T#3s); (* 5 s *)\n"}) {
    const std::string text = timed + "q := a;\n" + statement + "q := q AND t.Q;\nEND_PROGRAM\n";
    const Rows rows = tried("a.st", text);
    EXPECT_TRUE(std::ranges::any_of(rows, [](const std::string& row) { return row.ends_with("IEC017 on this line"); }))
        << text;
    for (const std::string& row : rows) EXPECT_FALSE(row.ends_with("network")) << row;
  }
  EXPECT_EQ(afterOffer("a.st", timed + "(* run *) t(IN := a, PT := T#3s); (* 5 s *)\nq := t.Q;\nEND_PROGRAM\n",
                       "Allow IEC017 on this line"),
            timed +
                "(* run *) t(IN := a, PT := T#3s); (* 5 s *)  // rungproof: allow IEC017 say why\nq := t.Q;\n"
                "END_PROGRAM\n");
}

// Where the line ends within a comment, the suppression stands before the line. In the head of a block it would speak
// for the block there.
TEST(SuppressionEdit, ACommentThatGoesOnIsNotCut) {
  const std::string statement = "t(IN := a, PT := T#3s); (* 5 s,\n as agreed *)\nq := t.Q;\nEND_PROGRAM\n";
  EXPECT_EQ(afterOffer("a.st", timed + "q := a;\n  " + statement, "Allow IEC017 on this line"),
            timed + "q := a;\n  // rungproof: allow IEC017 say why\n  " + statement);
  EXPECT_EQ(afterOffer("a.st", timed + statement, "Allow IEC017 on this line"),
            timed + "// rungproof: allow IEC017 say why\n" + statement);
  const std::string head =
      "PROGRAM P\nVAR_INPUT x : BOOL; END_VAR //@ reach p: x\nVAR y : BOOL; END_VAR (* goes\n on *)\n";
  EXPECT_EQ(tried("a.st", head + "y := x;\nEND_PROGRAM\n"), Rows());
}

// x is written and never read (IEC004), at its declaration; pump hides its program (IEC009).
TEST(SuppressionEdit, OfDeclarationsAndInstructionLists) {
  EXPECT_EQ(tried("a.st",
                  "PROGRAM pump\nVAR_INPUT a : BOOL; END_VAR\nVAR_OUTPUT pump : BOOL; END_VAR\n"
                  "VAR x : INT; END_VAR\npump := a;\nIF a THEN x := 1; END_IF;\nEND_PROGRAM\n"),
            (Rows{"2 IEC009 on this line", "3 IEC004 on this line"}));
  EXPECT_EQ(tried("a.il",
                  "PROGRAM P\nVAR_INPUT a : BOOL; END_VAR\nVAR x : BOOL; END_VAR (* seen *)\nLD a\nST x\n"
                  "END_PROGRAM\n"),
            (Rows{"2 IEC004 on this line"}));
}

/// Codes of the diagnostics of a text in ST.
Rows codesOfText(const std::string& text) {
  EditorSession session;
  return codesOf(session.diagnosticsOf(text, "untitled:a.st"));
}

// How comments of IEC 61131-3 texts are read: behind code for its line, alone for the line below, in the head for the
// block, and between begin and end.
TEST(SuppressionEdit, CommentsOfTextsAreRead) {
  const auto text = [](const std::string& head, const std::string& before, const std::string& behind) {
    return "PROGRAM P\n" + head + "VAR_INPUT a : BOOL; END_VAR\nVAR t : TON; END_VAR\nVAR_OUTPUT q : BOOL; END_VAR\n" +
           "q := a;\n" + before + "t(IN := a, PT := T#3s); (* 5 s *)" + behind + "\nq := q AND t.Q;\nEND_PROGRAM\n";
  };
  EXPECT_EQ(codesOfText(text("", "", "")), (Rows{"IEC017 2"}));
  EXPECT_EQ(codesOfText(text("", "", "// rungproof: allow IEC017 why")), Rows());
  EXPECT_EQ(codesOfText(text("", "(* rungproof: allow IEC017 why *)\n\n// more\n", "")), Rows());
  EXPECT_EQ(codesOfText(text("// rungproof: allow IEC017 why\n", "", "")), Rows());
  EXPECT_EQ(codesOfText(text("", "// rungproof: begin IEC017 why\n", "\n// rungproof: end")), Rows());
  EXPECT_EQ(codesOfText(text("", "", "\n// rungproof: allow IEC017 why")), (Rows{"IEC017 2", "SUP001 2"}));
  EXPECT_EQ(codesOfText(text("", "", "// rungproof: allow IEC017")), (Rows{"IEC017 2", "SUP002 2"}));
}

}  // namespace
}  // namespace rungproof::test
