// Diagnostics are what lint says: over the corpus, with configurations, encodings, suppressions, while typing.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "frontend/cli/cli.hpp"
#include "frontend/editor/document.hpp"
#include "frontend/files/disk_file.hpp"
#include "frontend/files/encoding.hpp"
#include "tests/editor/editor_session.hpp"
#include "tests/temporary_folder.hpp"

namespace rungproof::test {
namespace {

namespace fs = std::filesystem;

/// MOVW names a word that the CPU 226 does not have (001:2697): ADR001, an error, in line 3 at the second operand.
const std::string wrongAddress =
    "Network 1\n"
    "LD SM0.0\n"
    "MOVW 1, VW20000\n";

std::string bytesOf(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

/// "12:5 ADR001 error" of each finding of the file, as `rungproof lint` reports it.
std::vector<std::string> lintOf(const fs::path& file) {
  std::istringstream in;
  std::ostringstream out, err;
  runProgram({"lint", file.string(), "--format", "json"}, {in, out, err});
  const std::optional<Json> report = Json::read(out.str());
  std::vector<std::string> rows;
  for (const Json& finding : report ? at(*report, "findings").items() : std::vector<Json>()) {
    rows.push_back(numberAt(finding, "line") + ":" + numberAt(finding, "column") + " " + textAt(finding, "rule") + " " +
                   textAt(finding, "severity"));
  }
  std::ranges::sort(rows);
  return rows;
}

std::vector<std::string> rowsOf(const Json& diagnostics) {
  std::vector<std::string> rows;
  for (const Json& diagnostic : diagnostics.items()) {
    const auto line = at(diagnostic, "range/start/line").natural().value_or(0) + 1;
    const auto column = at(diagnostic, "range/start/character").natural().value_or(0) + 1;
    const std::string severity = numberAt(diagnostic, "severity");
    rows.push_back(std::to_string(line) + ":" + std::to_string(column) + " " + textAt(diagnostic, "code") + " " +
                   (severity == "1"   ? "error"
                    : severity == "2" ? "warning"
                                      : "note"));
  }
  std::ranges::sort(rows);
  return rows;
}

TEST(Diagnostics, AreTheFindingsOfLintForEveryProgramOfTheCorpus) {
  EditorSession session;
  std::size_t programs = 0, findings = 0;
  for (const auto& entry : fs::recursive_directory_iterator(RUNGPROOF_SOURCE_DIR "/corpus")) {
    const std::string ending = entry.path().extension().string();
    if (ending != ".awl" && ending != ".xml" && ending != ".stl") continue;
    const std::string text = decode(bytesOf(entry.path()), TextEncoding::Auto).text;
    const std::vector<std::string> expected = lintOf(entry.path());
    const std::string uri = uriOfPath(entry.path().string());
    EXPECT_EQ(rowsOf(session.diagnosticsOf(text, uri)), expected) << entry.path();
    session.notify("textDocument/didClose", {{"textDocument", Json{{"uri", uri}}}});
    EXPECT_TRUE(session.nextDiagnostics().empty());
    ++programs;
    findings += expected.size();
  }
  EXPECT_GE(programs, 100u);
  EXPECT_GE(findings, 100u);
}

TEST(Diagnostics, FollowTheTyping) {
  EditorSession session;
  EXPECT_EQ(codesOf(session.diagnosticsOf(wrongAddress)), (std::vector<std::string>{"ADR001 1"}));
  const auto type = [&](int version, int from, int to, const std::string& text) {
    session.notify(
        "textDocument/didChange",
        {{"textDocument", Json{{"uri", untitled}, {"version", version}}},
         {"contentChanges", Json::array({Json{{"range", Json{{"start", Json{{"line", 2}, {"character", from}}},
                                                             {"end", Json{{"line", 2}, {"character", to}}}}},
                                              {"text", text}}})}});
  };
  type(2, 10, 15, "200");  // VW20000 becomes VW200
  const Json cleared = session.notification("textDocument/publishDiagnostics");
  EXPECT_EQ(numberAt(cleared, "params/version"), "2");
  // The address is there now, and nothing reads what is written to it.
  EXPECT_EQ(codesOf(at(cleared, "params/diagnostics")), (std::vector<std::string>{"ADR011 3"}));
  type(3, 10, 13, "20001");
  EXPECT_EQ(codesOf(session.nextDiagnostics()), (std::vector<std::string>{"ADR001 1"}));
}

TEST(Diagnostics, PlacesAreUtf16Units) {
  EditorSession session;
  // Behind the instruction nothing counts; a name of Cyrillic letters and a pair before the wrong operand does. The
  // comment of the network shifts no line. MOVW "имя" is read as a name that nobody declares.
  const Json diagnostics = session.diagnosticsOf(
      "Network 1 // 😀 Насос für Öl\n"
      "LD SM0.0 // 😀\n"
      "MOVB '😀', VB20000\n");
  // M0 O1 V2 B3 blank4 quote5 😀6-7 quote8 comma9 blank10: the address begins at 11 and has 7 units.
  std::vector<std::string> ranges;
  for (const Json& diagnostic : diagnostics.items()) {
    if (textAt(diagnostic, "code") == "ADR001") ranges.push_back(rangeText(at(diagnostic, "range")));
  }
  EXPECT_EQ(ranges, (std::vector<std::string>{"2:11-2:18"}));
}

TEST(Diagnostics, UseTheNearestConfiguration) {
  const TemporaryFolder folder;
  fs::create_directories(folder.folder() / "sub");
  const fs::path config = folder.folder() / "rungproof.toml";
  std::ofstream(config) << "[rules.ADR011]\nseverity = \"error\"\n";
  const std::string uri = uriOfPath((folder.folder() / "sub" / "p.awl").string());
  const std::string unread = "Network 1\nLD I0.0\n= M0.0\n";  // M0.0 is never read: ADR011, a note by itself
  EditorSession session;
  EXPECT_EQ(codesOf(session.diagnosticsOf(unread, uri)), (std::vector<std::string>{"ADR011 1"}));
  std::ofstream(config) << "ignore = [\"ADR011\"]\n";
  session.notify("workspace/didChangeWatchedFiles", {{"changes", Json::array()}});
  EXPECT_TRUE(session.nextDiagnostics().empty());
  std::ofstream(config) << "ignored = 1\n";
  session.notify("textDocument/didSave", {{"textDocument", Json{{"uri", uri}}}});
  const Json broken = session.nextDiagnostics();
  ASSERT_EQ(broken.size(), 1u);
  EXPECT_NE(textAt(broken, "0/message").find("unknown key 'ignored'"), std::string::npos);
}

TEST(Diagnostics, TextComesFromTheClientAndNotFromTheDisk) {
  const TemporaryFolder folder;
  const fs::path file = folder.folder() / "p.awl";
  std::ofstream(file) << wrongAddress;
  EditorSession session;
  EXPECT_TRUE(session.diagnosticsOf("Network 1\nLD I0.0\n= Q0.0\n", uriOfPath(file.string())).empty());
}

TEST(Diagnostics, AFileOfAProjectIsCheckedWithIt) {
  // The symbol stands in a table beside the program; by itself the program would name something unknown.
  const TemporaryFolder folder;
  std::ofstream(folder.folder() / "rungproof.toml") << "inputs = [\"p.awl\", \"symbols.csv\"]\n";
  std::ofstream(folder.folder() / "symbols.csv") << "Name,Address,Comment\nStart,I0.0,button\nMotor,Q0.0,drive\n";
  const std::string table = uriOfPath((folder.folder() / "symbols.csv").string());
  const std::string program = uriOfPath((folder.folder() / "p.awl").string());
  EditorSession session;
  EXPECT_TRUE(session.diagnosticsOf("Network 1\nLD \"Start\"\n= \"Motor\"\n", program).empty());
  // A change of the table in the editor counts for the program at once.
  session.open("Name,Address,Comment\nBegin,I0.0,button\nMotor,Q0.0,drive\n", table);
  std::size_t unresolved = 0;
  for (int i = 0; i < 2; ++i) {
    const Json message = session.notification("textDocument/publishDiagnostics");
    if (textAt(message, "params/uri") == program) unresolved = at(message, "params/diagnostics").size();
  }
  EXPECT_GE(unresolved, 1u);
}

TEST(Diagnostics, GermanTextOfCodePage1252KeepsItsBytes) {
  // The string has five characters in CP1252 and one more byte in UTF-8; both ways lint and editor agree, because the
  // encoding is that of the file on the disk.
  const TemporaryFolder folder;
  const fs::path file = folder.folder() / "p.awl";
  const std::string head =
      "Network 1 // Gr\xF6\xDF"
      "e\nLD SM0.0\nMOVW 1, VW20000\n";
  std::ofstream(file, std::ios::binary) << head;
  EditorSession session;
  const Json diagnostics =
      session.diagnosticsOf("Network 1 // Größe\nLD SM0.0\nMOVW 1, VW20000\n", uriOfPath(file.string()));
  EXPECT_EQ(rowsOf(diagnostics), lintOf(file));
  EXPECT_EQ(rowsOf(diagnostics), (std::vector<std::string>{"3:9 ADR001 error"}));
}

TEST(Diagnostics, AByteOrderMarkTakesOnePlace) {
  EditorSession session;
  const Json diagnostics = session.diagnosticsOf("\xEF\xBB\xBFMOVW 1, VW20000\n");
  bool isShifted = false;
  for (const Json& diagnostic : diagnostics.items())
    isShifted = isShifted || rangeText(at(diagnostic, "range")) == "0:9-0:16";
  EXPECT_TRUE(isShifted) << diagnostics.dump(1);
}

TEST(Diagnostics, WhatIsSurplusIsTagged) {
  EditorSession session;
  const Json diagnostics = session.diagnosticsOf("Network 1\nLD I0.0\n= M0.0\n");  // nobody reads M0.0
  EXPECT_EQ(numberAt(diagnostics, "0/tags/0"), "1") << diagnostics.dump(1);
}

TEST(Diagnostics, SuppressionsAndRelatedPlaces) {
  EditorSession session;
  EXPECT_TRUE(session
                  .diagnosticsOf("Network 1\nLD SM0.0\n"
                                 "MOVW 1, VW20000 // rungproof: allow ADR001 of the old machine\n")
                  .empty());
  session.notify("textDocument/didClose", {{"textDocument", Json{{"uri", untitled}}}});
  session.nextDiagnostics();
  // Two coils of one output: OUT001 at the second one names the first.
  const Json two = session.diagnosticsOf("Network 1\nLD I0.0\n= Q0.0\nNetwork 2\nLD I0.1\n= Q0.0\n");
  bool isRelated = false;
  for (const Json& diagnostic : two.items()) {
    if (textAt(diagnostic, "code") != "OUT001") continue;
    isRelated = textAt(diagnostic, "relatedInformation/0/location/uri") == untitled;
  }
  EXPECT_TRUE(isRelated) << two.dump(1);
}

TEST(Diagnostics, PropertyFilesAreReadBesideTheirProgram) {
  const TemporaryFolder folder;
  std::ofstream(folder.folder() / "p.awl") << "Network 1\nLD I0.0\n= Q0.0\n";
  EditorSession session;
  const std::string uri = uriOfPath((folder.folder() / "p.prop").string());
  EXPECT_TRUE(session.diagnosticsOf("prove follows: Q0.0 implies I0.0\n", uri).empty());
  session.notify("textDocument/didClose", {{"textDocument", Json{{"uri", uri}}}});
  session.nextDiagnostics();
  EXPECT_EQ(codesOf(session.diagnosticsOf("prove follows: Q0.0 implies Nobody\n", uri)),
            (std::vector<std::string>{"PRP002 1"}));
}

// Whatever language the program is written in.
TEST(Diagnostics, PropertyFilesFindTextsOfEachLanguage) {
  const std::pair<std::string, std::string> programs[] = {
      {"p.st", "PROGRAM P\nVAR x AT %IX0.0 : BOOL; q AT %QX0.0 : BOOL; END_VAR\nq := x;\nEND_PROGRAM\n"},
      {"p.scl", "ORGANIZATION_BLOCK OB 1\nBEGIN\n Q0.0 := I0.0;\nEND_ORGANIZATION_BLOCK\n"}};
  for (const auto& [name, text] : programs) {
    const TemporaryFolder folder;
    folder.file(name, text);
    EditorSession session;
    const std::string uri = uriOfPath((folder.folder() / "p.prop").string());
    const std::string property = name == "p.st" ? "prove follows: q implies x\n" : "prove follows: Q0.0 implies I0.0\n";
    EXPECT_TRUE(session.diagnosticsOf(property, uri).empty()) << name;
    session.notify("textDocument/didClose", {{"textDocument", Json{{"uri", uri}}}});
    session.nextDiagnostics();
    EXPECT_EQ(codesOf(session.diagnosticsOf("prove follows: Nobody\n", uri)), (std::vector<std::string>{"PRP002 1"}))
        << name;
  }
}

TEST(Diagnostics, OptionsOfTheCommandLineCountForAll) {
  EditorSession session({"--ignore", "ADR001"});
  EXPECT_TRUE(session.diagnosticsOf(wrongAddress).empty());
}

}  // namespace
}  // namespace rungproof::test
