// Each tool with a program of a few lines whose answer is plain, and wrong arguments.
#include <stdlib.h>

#include <filesystem>

#include "tests/assistant/assistant_session.hpp"
#include "tests/temporary_folder.hpp"

namespace rungproof::test {
namespace {

/// Each coil locks the other.
const std::string locked =
    "Network 1\n"
    "//@ prove never both: never Q0.0 and Q0.1\n"
    "LD I0.0\nAN Q0.1\n= Q0.0\n"
    "Network 2\nLD I0.1\nAN Q0.0\n= Q0.1\n";

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

// A file with a name that others can guess would be written through a link that they planted: what a command writes
// beside its text stands in a folder of its own, which goes with the call.
TEST(Tool, NothingStaysInTheCommonTemporaryFolder) {
  const TemporaryFolder common;
  const char* given = std::getenv("TMPDIR");
  const std::string before = given == nullptr ? "" : given;
  ::setenv("TMPDIR", common.folder().c_str(), 1);
  {
    AssistantSession session;
    const Json run = session.call("sim", {{"program", locked}, {"stimulus", "scan,I0.0\n1,1\n"}});
    EXPECT_TRUE(contains(textAt(run, "structuredContent/trace"), "Q0.0")) << run.dump(1);
    for (const auto& entry : std::filesystem::directory_iterator(common.folder()))
      ADD_FAILURE() << entry.path() << " stays after the call";
  }
  given == nullptr ? ::unsetenv("TMPDIR") : ::setenv("TMPDIR", before.c_str(), 1);
}

TEST(Tool, LintNamesRuleAndPlace) {
  AssistantSession session;
  const Json result = session.call("lint", {{"program", "Network 1\nLD SM0.0\nMOVW 1, VW20000\n"}});
  EXPECT_FALSE(at(result, "isError").isTrue());
  EXPECT_TRUE(contains(toolText(result), "ADR001")) << toolText(result);
  EXPECT_EQ(textAt(result, "structuredContent/findings/0/rule"), "ADR001");
  EXPECT_EQ(numberAt(result, "structuredContent/findings/0/line"), "3");
  EXPECT_EQ(numberAt(result, "structuredContent/exit_code"), "1");
}

TEST(Tool, LintTakesAPathAndOptions) {
  const TemporaryFolder folder;
  const std::string file = folder.file("p.awl", "Network 1\nLD SM0.0\nMOVW 1, VW3000\n");
  AssistantSession session({"--root", folder.folder().string()});
  // The V memory of the CPU 221 ends with VB2047 (001:2697), that of the 226 with VB10239.
  EXPECT_TRUE(contains(toolText(session.call("lint", {{"path", file}, {"cpu", "221"}})), "ADR001"));
  EXPECT_FALSE(contains(toolText(session.call("lint", {{"path", file}})), "ADR001"));
  EXPECT_FALSE(
      contains(toolText(session.call("lint", {{"path", file}, {"cpu", "221"}, {"ignore", "ADR001"}})), "ADR001"));
}

// An assistant may be told by a text that it reads to look at other files of the user.
TEST(Tool, NothingOutsideTheRootIsRead) {
  const TemporaryFolder folder;
  const std::string secret = folder.file("secret.awl", "Network 1\nLD I0.0\n= Q9.9 // secret\n");
  folder.file("project/p.awl", "Network 1\nLD I0.0\n= Q0.0\n");
  std::filesystem::create_symlink(secret, folder.path("project/link.awl"));
  folder.file("project/deep/rungproof.toml", "extend = \"../../secret.awl\"\n");
  folder.file("project/deep/p.awl", "Network 1\nLD I0.0\n= Q0.0\n");
  folder.file("project/table/rungproof.toml", "symbols = [\"../../secret.awl\"]\n");
  folder.file("project/table/p.awl", "Network 1\nLD I0.0\n= Q0.0\n");
  AssistantSession session({"--root", folder.path("project")});
  EXPECT_FALSE(at(session.call("lint", {{"path", folder.path("project/p.awl")}}), "isError").isTrue());
  for (const char* name : {"secret.awl", "project/../secret.awl", "project/link.awl", "", "project/deep/p.awl",
                           "project/table/p.awl", "project"}) {
    const std::string answer = session.call("lint", {{"path", folder.path(name)}}).dump();
    EXPECT_TRUE(contains(answer, "lies outside")) << name << ": " << answer;
    EXPECT_FALSE(contains(answer, "Q9.9")) << name << ": " << answer;
  }
}

TEST(Tool, ProveSaysProvedOrShowsTheRun) {
  AssistantSession session;
  const Json proved = session.call("prove", {{"program", locked}});
  EXPECT_EQ(textAt(proved, "structuredContent/properties/0/verdict"), "PROVED") << toolText(proved);
  EXPECT_EQ(numberAt(proved, "structuredContent/exit_code"), "0");
  const Json violated = session.call(
      "prove",
      {{"program", locked}, {"properties", "prove off: never Q0.0\n"}, {"only", "off"}, {"scan_time", "10ms"}});
  EXPECT_EQ(textAt(violated, "structuredContent/properties/0/verdict"), "VIOLATED") << toolText(violated);
  EXPECT_TRUE(contains(toolText(violated), "I0.0")) << toolText(violated);  // the run that shows it
  EXPECT_EQ(numberAt(violated, "structuredContent/exit_code"), "1");
}

TEST(Tool, SimRunsAStimulusAndCompares) {
  AssistantSession session;
  const std::string stimulus = "scan,I0.0\n1,0\n2,1\n3,1\n";
  const Json run = session.call("sim", {{"program", locked}, {"stimulus", stimulus}});
  // The coil follows its input in the same scan.
  EXPECT_TRUE(contains(textAt(run, "structuredContent/trace"), "Q0.0")) << run.dump(1);
  EXPECT_EQ(numberAt(run, "structuredContent/exit_code"), "0");
  const Json good =
      session.call("sim", {{"program", locked}, {"stimulus", stimulus}, {"expected", "scan,Q0.0\n1,0\n2,1\n3,1\n"}});
  EXPECT_EQ(numberAt(good, "structuredContent/exit_code"), "0") << toolText(good);
  const Json wrong =
      session.call("sim", {{"program", locked}, {"stimulus", stimulus}, {"expected", "scan,Q0.0\n1,0\n2,0\n"}});
  EXPECT_EQ(numberAt(wrong, "structuredContent/exit_code"), "1");
  EXPECT_EQ(numberAt(wrong, "structuredContent/comparison/scan"), "2");
}

TEST(Tool, ShowExplainXrefAndCheck) {
  AssistantSession session;
  const std::string drawing = toolText(session.call("show", {{"program", locked}, {"network", "2"}}));
  EXPECT_TRUE(contains(drawing, "Network 2")) << drawing;
  EXPECT_FALSE(contains(drawing, "Network 1"));
  EXPECT_TRUE(contains(toolText(session.call("explain", {{"topic", "T37"}})), "100 ms"));
  const Json uses = session.call("xref", {{"program", locked}, {"address", "Q0.1"}});
  EXPECT_TRUE(contains(toolText(uses), "AN Q0.1")) << toolText(uses);
  EXPECT_EQ(textAt(uses, "structuredContent/addresses/0/address"), "Q0.1");
  const Json check = session.call("check", {{"program", "Network 1\nLD I0.0\nBOGUS Q0.0\n"}, {"cpu", "ST40"}});
  EXPECT_FALSE(at(check, "structuredContent/networks/0/valid").isTrue());
  EXPECT_EQ(numberAt(check, "structuredContent/exit_code"), "1");
}

TEST(Tool, SymbolsComeAsText) {
  AssistantSession session;
  const Json result =
      session.call("xref", {{"program", "Network 1\nLD Start\n= Q0.0\n"}, {"symbols", "Start,I0.3,button\n"}});
  EXPECT_TRUE(contains(toolText(result), "I0.3")) << toolText(result);
}

TEST(Tool, ErrorsAreResultsWithTheMessageOfTheTool) {
  AssistantSession session;
  const auto errorOf = [&](const std::string& tool, const Json& arguments) {
    const Json result = session.call(tool, arguments);
    EXPECT_TRUE(at(result, "isError").isTrue()) << result.dump(1);
    return toolText(result);
  };
  EXPECT_TRUE(contains(errorOf("lint", {{"path", "/nowhere/p.awl"}}), "lies outside"));
  EXPECT_TRUE(contains(errorOf("lint", {{"path", "nowhere.awl"}}), "cannot read"));
  EXPECT_TRUE(contains(errorOf("lint", {{"program", "Network 1\nLD I0.0\n= Q0.0\n"}, {"cpu", "227"}}), "227"));
  EXPECT_TRUE(contains(errorOf("prove", {{"program", "Network 1\nLD I0.0\n= Q0.0\n"}}), "no property"));
  EXPECT_TRUE(contains(errorOf("lint", Json::object()), "give the program"));
  EXPECT_TRUE(contains(errorOf("lint", {{"program", "x"}, {"path", "y"}}), "not both"));
  EXPECT_TRUE(contains(errorOf("lint", {{"program", 7}}), "'program' must be a text"));
  EXPECT_TRUE(contains(errorOf("lint", {{"program", "x"}, {"verbose", true}}), "has only the arguments"));
  EXPECT_TRUE(contains(errorOf("show", {{"program", "x"}, {"as", "picture"}}), "'as' can be lad, fbd, stl"));
  EXPECT_TRUE(contains(errorOf("sim", {{"program", "x"}, {"scans", -1}}), "not negative"));
  EXPECT_TRUE(contains(errorOf("explain", {{"topic", "--version"}}), "--version"));
}

TEST(Tool, AnswersAreShort) {
  std::string program;
  for (int i = 1; i <= 300; ++i)
    program += "Network " + std::to_string(i) + "\nLD I0.0\nMOVW " + std::to_string(i) + ", VW20000\n";
  AssistantSession session;
  const Json result = session.call("lint", {{"program", program}});
  EXPECT_LE(toolText(result).size(), 12100u);
  EXPECT_TRUE(contains(toolText(result), "cut; the structured content has everything"));
  EXPECT_GE(at(result, "structuredContent/findings").size(), 300u);
}

TEST(Tool, OthersGoOnWhileOneWorks) {
  AssistantSession session({"--timeout", "40s"});
  const int slow =
      session.begin("tools/call", {{"name", "prove"},
                                   {"arguments", Json{{"program",
                                                       "Network 1\n//@ prove far: VD0 <> 123456789\n"
                                                       "LD I0.0\nEU\nINCD VD0\nLD I0.1\nEU\n+D VD0, VD4\nLD I0.2\n"
                                                       "MOVD VD4, VD0\nLD I0.3\n*R VD8, VD12\n"}}}});
  EXPECT_TRUE(contains(toolText(session.call("explain", {{"topic", "TON"}})), "on-delay"));
  session.notify("notifications/cancelled", {{"requestId", slow}, {"reason", "enough"}});
  EXPECT_EQ(at(session.request("ping", Json::object()), "result").dump(), "{}");
  EXPECT_EQ(session.end(), 0);
}

TEST(Tool, TestRunsATable) {
  AssistantSession session;
  const std::string table = "test,set I0.0,set I0.1,expect Q0.0,expect Q0.1\nlock,1,0,1,0\nlock,,1,1,0\n";
  const Json passed = session.call("test", {{"program", locked}, {"table", table}, {"coverage", true}});
  EXPECT_EQ(numberAt(passed, "structuredContent/exit_code"), "0") << passed.dump(1);
  EXPECT_EQ(numberAt(passed, "structuredContent/coverage/networks/covered"), "1");  // Q0.1 was never reached
  const Json failed = session.call("test", {{"program", locked}, {"table", "test,set I0.0,expect Q0.0\nt,1,0\n"}});
  EXPECT_EQ(numberAt(failed, "structuredContent/exit_code"), "1");
  EXPECT_TRUE(contains(toolText(failed), "Q0.0 expected 0, actual 1")) << toolText(failed);
}

}  // namespace
}  // namespace rungproof::test
