// New names for symbols, local variables and labels: every place, and nothing else.
#include "frontend/editor/document.hpp"
#include "tests/editor/editor_session.hpp"
#include "tests/temporary_folder.hpp"

namespace rungproof::test {
namespace {

using Rows = std::vector<std::string>;

class Rename : public testing::Test {
 protected:
  void open(const std::string& text, const std::vector<std::string>& options = {}) {
    session_ = std::make_unique<EditorSession>(options);
    session_->open(text);
  }
  Json ask(int line, int character, const std::string& name) {
    Json params = session_->place(line, character);
    params["newName"] = name;
    return session_->request("textDocument/rename", params);
  }
  /// Ranges of the edits of the document, all with the new name.
  Rows edits(int line, int character, const std::string& name) {
    const Json answer = ask(line, character, name);
    Rows rows;
    const Json changes = at(answer, "result/changes/" + untitled);
    for (const Json& edit : changes.items()) {
      rows.push_back(rangeText(at(edit, "range")));
      EXPECT_EQ(textAt(edit, "newText"), name);
    }
    return rows;
  }
  std::string refusal(int line, int character, const std::string& name) {
    return textAt(ask(line, character, name), "error/message");
  }
  std::unique_ptr<EditorSession> session_;
};

const std::string named =
    "SYMBOL_TABLE\nStart,I0.0,Start button\nMotor,Q0.0,\nEND_SYMBOL_TABLE\nORGANIZATION_BLOCK MAIN:OB1\nBEGIN\n"
    "Network 1 // Start\n//@ prove stop: never Start and Motor\nLD Start\nA StartUp\n= Motor\nJMP 3\nNetwork 2\nLBL 3\n"
    "LD Start\nCALL SBR_0, Start\nEND_ORGANIZATION_BLOCK\nSUBROUTINE_BLOCK SBR_0:SBR0\nVAR_INPUT\nRun:BOOL;\nEND_VAR\n"
    "BEGIN\nNetwork 1\nLD #Run\n= Q0.1\nJMP 3\nNetwork 2\nLBL 3\nEND_SUBROUTINE_BLOCK\n";

// The comment in the table, the title and StartUp only look like the name.
TEST_F(Rename, ASymbolAtItsRowItsUsesAndInProperties) {
  open(named);
  EXPECT_EQ(edits(8, 4, "Go"), (Rows{"1:0-1:5", "7:22-7:27", "8:3-8:8", "14:3-14:8", "15:12-15:17"}));
  EXPECT_EQ(rangeText(at(session_->ask("textDocument/prepareRename", 8, 4), "range")), "8:3-8:8");
}

// Both blocks have a label 3; each is a name of its own block.
TEST_F(Rename, LabelsAndLocalsWithinTheirBlock) {
  open(named);
  EXPECT_EQ(edits(11, 4, "17"), (Rows{"11:4-11:5", "13:4-13:5"}));
  EXPECT_EQ(edits(23, 5, "On"), (Rows{"19:0-19:3", "23:4-23:7"}));
}

TEST_F(Rename, RefusesWhatWouldChangeTheProgram) {
  open(named);
  EXPECT_EQ(refusal(8, 4, "Motor"), "there is a symbol 'Motor' already");
  EXPECT_EQ(refusal(8, 4, "2nd"), "'2nd' is no name: it has letters, digits and _, and begins with a letter");
  EXPECT_EQ(refusal(8, 4, "I0.5"), "'I0.5' is no name: it has letters, digits and _, and begins with a letter");
  EXPECT_EQ(refusal(8, 4, "VW10"), "'VW10' is an address");
  EXPECT_EQ(refusal(11, 4, "256"), "'256' is no label: labels are numbers from 0 to 255");
  EXPECT_EQ(refusal(11, 4, "3"), "the block has a label '3' already");
  EXPECT_EQ(refusal(24, 3, "Lamp"), "nothing there has a name that can be changed");
  EXPECT_EQ(refusal(8, 4, "Run"), "SBR_0 has a local variable 'Run' already");
}

TEST_F(Rename, MarksTellSymbolsFromLocalsInStep7Sources) {
  open(
      "FUNCTION FC 1 : VOID\nVAR_INPUT\n  In : BOOL;\nEND_VAR\nVAR_TEMP\n  Run : BOOL;\nEND_VAR\nBEGIN\nNETWORK\n"
      "      A #In;\n      = #Run;\n      A #Run; // Run\n      JC M001;\n      = Q 4.0;\nM001: NOP 0;\nEND_FUNCTION\n"
      "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n      CALL FC 1 ( In := I 0.0 );\nEND_ORGANIZATION_BLOCK\n",
      {"--dialect", "s7-300"});
  EXPECT_EQ(edits(10, 9, "On"), (Rows{"5:2-5:5", "10:9-10:12", "11:9-11:12"}));
  EXPECT_EQ(edits(12, 10, "ende"), (Rows{"12:9-12:13", "14:0-14:4"}));
  EXPECT_EQ(refusal(12, 10, "finish"),
            "'finish' is no label: it has one to four letters and digits and begins with a letter");
  EXPECT_EQ(refusal(9, 9, "On"), "'In' is a parameter or static data; calls and data blocks name it too");
}

// IN of the call is the timer's; Out.IN is a member.
TEST_F(Rename, AVariableOfStructuredTextWithinItsBlock) {
  open(
      "PROGRAM P\nVAR IN, Late : BOOL; T1 : TON; END_VAR\nVAR_OUTPUT Lamp : BOOL; END_VAR\n"
      "//@ prove on: P.IN implies Lamp or not T1.Q\nT1(IN := IN, PT := T#1s);\nLamp := in AND T1.Q;\nEND_PROGRAM\n"
      "FUNCTION_BLOCK F\nVAR_INPUT Go : BOOL; END_VAR\nVAR Lamp2 : BOOL; END_VAR\nLamp2 := Go;\n"
      "END_FUNCTION_BLOCK\n");
  EXPECT_EQ(edits(1, 5, "Start"), (Rows{"1:4-1:6", "3:16-3:18", "4:9-4:11", "5:8-5:10"}));
  EXPECT_EQ(edits(4, 0, "Delay"), (Rows{"1:21-1:23", "3:39-3:41", "4:0-4:2", "5:15-5:17"}));
  EXPECT_EQ(refusal(1, 5, "Lamp"), "P uses the name 'Lamp' already");
  EXPECT_EQ(refusal(1, 5, "THEN"), "'THEN' is no name: it has letters, digits and _, and begins with a letter");
  EXPECT_EQ(refusal(10, 10, "Run"), "'Go' is declared in VAR_INPUT: other blocks name it too");
  EXPECT_EQ(refusal(4, 4, "Run"), "nothing there has a name that can be changed");
  // From the property it is the same variable: P.IN, and T1 of T1.Q.
  EXPECT_EQ(edits(3, 17, "Start"), (Rows{"1:4-1:6", "3:16-3:18", "4:9-4:11", "5:8-5:10"}));
  EXPECT_EQ(edits(3, 40, "Delay"), (Rows{"1:21-1:23", "3:39-3:41", "4:0-4:2", "5:15-5:17"}));
}

// IEC 61131-3 tells no case of letters: a type, a block and a called function may be spelled as the variable is.
TEST_F(Rename, ATypeOrABlockIsNotTheVariableOfItsName) {
  open(
      "TYPE Mixer : STRUCT on : BOOL; END_STRUCT; END_TYPE\n"
      "FUNCTION Twice : INT\nVAR_INPUT n : INT; END_VAR\nTwice := n * 2;\nEND_FUNCTION\n"
      "PROGRAM Pump\nVAR_OUTPUT pump : BOOL; END_VAR\nVAR mixer, m : Mixer; row : ARRAY[0..1] OF Mixer; twice : INT; "
      "END_VAR\n"
      "pump := mixer.on;\ntwice := Twice(n := 1);\nEND_PROGRAM\n");
  EXPECT_EQ(edits(7, 5, "stirrer"), (Rows{"7:4-7:9", "8:8-8:13"}));
  EXPECT_EQ(edits(8, 1, "motor"), (Rows{"6:11-6:15", "8:0-8:4"}));
  EXPECT_EQ(edits(9, 1, "two"), (Rows{"7:50-7:55", "9:0-9:5"}));
  EXPECT_EQ(refusal(7, 16, "other"), "nothing there has a name that can be changed");
  EXPECT_EQ(refusal(5, 9, "other"), "nothing there has a name that can be changed");
}

/// "m.prop 2:4-2:9" for each edit, sorted.
Rows editsOfFiles(EditorSession& session, const std::string& uri, int line, int character, const std::string& name) {
  Json params = session.place(line, character, uri);
  params["newName"] = name;
  const Json answer = session.request("textDocument/rename", params);
  EXPECT_EQ(textAt(answer, "error/message"), "");
  Rows rows;
  const std::string folder = uri.substr(0, uri.find_last_of('/') + 1);
  const Json edit = at(answer, "result");
  for (const char* file : {"m.awl", "m.st", "m.prop", "sym.csv"}) {
    const Json* const changes = edit.find("changes");
    const Json* const list = changes == nullptr ? nullptr : changes->find(folder + file);
    if (list == nullptr) continue;
    for (const Json& one : list->items()) rows.push_back(std::string(file) + " " + rangeText(at(one, "range")));
  }
  return rows;
}

// Wherever the renaming begins: the property file beside the program is a part of it, also its lines with mistakes. The
// name of a property, a comment and what only begins so stay.
TEST(RenameOfFiles, EachRoadChangesTheSamePlaces) {
  const TemporaryFolder folder;
  folder.file("rungproof.toml", "symbols = [\"sym.csv\"]\n");
  folder.file("sym.csv", "Symbol,Address,Comment\nStart,I0.0,a\nMotor,Q0.0,c\n");
  const std::string program = "Network 1\nLD Start\n= Motor\n//@ reach on: Motor\n";
  const std::string properties =
      "# Motor\nassume Motor: not Start\nprove a: Motor implies Motors\nprove b: Q9.9 implis \"Motor\" # Motor\n"
      "external Motor\n";
  folder.file("m.awl", program);
  folder.file("m.prop", properties);
  const auto uri = [&](const char* name) { return uriOfPath((folder.folder() / name).string()); };
  const Rows all = {"m.awl 2:2-2:7",    "m.awl 3:14-3:19", "m.prop 2:9-2:14",
                    "m.prop 3:22-3:27", "m.prop 4:9-4:14", "sym.csv 2:0-2:5"};
  {
    EditorSession session;
    session.open(program, uri("m.awl"));
    EXPECT_EQ(editsOfFiles(session, uri("m.awl"), 2, 3, "Pump"), all);
    EXPECT_EQ(editsOfFiles(session, uri("m.awl"), 3, 15, "Pump"), all);
    Json params = session.place(2, 3, uri("m.awl"));
    params["context"] = Json{{"includeDeclaration", false}};
    EXPECT_EQ(rangesOf(at(session.request("textDocument/references", params), "result")),
              (Rows{"2:2-2:7", "3:14-3:19", "2:9-2:14", "3:21-3:28", "4:9-4:14"}));
  }
  EditorSession session;
  session.open(properties, uri("m.prop"));
  EXPECT_EQ(editsOfFiles(session, uri("m.prop"), 2, 10, "Pump"), all);
  EXPECT_EQ(editsOfFiles(session, uri("m.prop"), 3, 24, "Pump"), all);
  EXPECT_EQ(editsOfFiles(session, uri("m.prop"), 4, 10, "Pump"), all);
}

TEST(RenameOfFiles, AVariableOfStructuredTextInThePropertyFile) {
  const TemporaryFolder folder;
  const std::string program =
      "PROGRAM P\nVAR_INPUT go : BOOL; END_VAR\nVAR_OUTPUT q : BOOL; END_VAR\nq := go;\nEND_PROGRAM\n";
  const std::string properties = "prove q: P.q implies Go\nprove bad: q impies go\n";
  folder.file("m.st", program);
  folder.file("m.prop", properties);
  const auto uri = [&](const char* name) { return uriOfPath((folder.folder() / name).string()); };
  const Rows all = {"m.st 1:10-1:12", "m.st 3:5-3:7", "m.prop 0:21-0:23", "m.prop 1:20-1:22"};
  EditorSession session;
  session.open(program, uri("m.st"));
  EXPECT_EQ(editsOfFiles(session, uri("m.st"), 3, 6, "run"), all);
  EditorSession other;
  other.open(properties, uri("m.prop"));
  EXPECT_EQ(editsOfFiles(other, uri("m.prop"), 0, 22, "run"), all);
}

// A table alone does not show who uses its names.
TEST(RenameOfFiles, ATableWithoutItsProgramIsRefused) {
  const TemporaryFolder folder;
  const std::string table = "Symbol,Address,Comment\nStart,I0.0,a\n";
  folder.file("sym.csv", table);
  EditorSession session;
  const std::string uri = uriOfPath((folder.folder() / "sym.csv").string());
  session.open(table, uri);
  Json params = session.place(1, 2, uri);
  params["newName"] = "Go";
  EXPECT_NE(textAt(session.request("textDocument/rename", params), "error/message"), "");
}

}  // namespace
}  // namespace rungproof::test
