// Counting, exit codes and the JSON contract of reports, on reports made by hand.
#include "frontend/report.hpp"

#include <gtest/gtest.h>

#include <set>
#include <sstream>

#include "frontend/test_results.hpp"
#include "schema_check.hpp"
#include "tests/program_run.hpp"

namespace rungproof {
namespace {

Finding finding(const std::string& rule, Severity severity, std::uint32_t offset = 0) {
  Finding f;
  f.rule = rule;
  f.severity = severity;
  f.message = "message of " + rule;
  f.span = {0, offset, 2};
  return f;
}

PropertyResult property(Outcome verdict) {
  PropertyResult result;
  result.name = "p";
  result.verdict = verdict;
  result.depth = 7;
  return result;
}

Report reportWith(std::vector<Finding> findings, std::vector<PropertyResult> properties = {}) {
  Report report;
  report.command = "lint";
  auto sources = std::make_shared<SourceSet>();
  sources->add("a.awl", "LD I0.0\n= Q0.0\n");
  report.sources = sources;
  report.findings = std::move(findings);
  report.properties = std::move(properties);
  return report;
}

std::string written(std::string_view form, const Report& report) {
  std::ostringstream out;
  reporterNamed(form)->write(report, {}, out);
  return out.str();
}

nlohmann::json schema() {
  return nlohmann::json::parse(test::contentOf(std::string(RUNGPROOF_SOURCE_DIR) + "/frontend/report/schema.json"));
}

TEST(ExitOf, FollowsTheContract) {
  EXPECT_EQ(exitOf(reportWith({})), Exit::Clean);
  EXPECT_EQ(exitOf(reportWith({finding("ADR011", Severity::Note)})), Exit::Clean) << "notes do not fail";
  EXPECT_EQ(exitOf(reportWith({finding("ADR011", Severity::Warning)})), Exit::Found);
  EXPECT_EQ(exitOf(reportWith({finding("SYN010", Severity::Error), finding("ADR001", Severity::Error)})), Exit::Failed);
  EXPECT_EQ(exitOf(reportWith({finding("PRP001", Severity::Error)})), Exit::Failed);
  EXPECT_EQ(exitOf(reportWith({finding("SYN018", Severity::Note)})), Exit::Clean);
  EXPECT_EQ(exitOf(reportWith({}, {property(Outcome::Proved), property(Outcome::Reachable)})), Exit::Clean);
  EXPECT_EQ(exitOf(reportWith({}, {property(Outcome::Unknown), property(Outcome::Violated)})), Exit::Found);
  for (const Outcome verdict : {Outcome::Unreachable, Outcome::Vacuous})
    EXPECT_EQ(exitOf(reportWith({}, {property(verdict)})), Exit::Found);
  for (const Outcome verdict : {Outcome::Unknown, Outcome::HoldsToBound, Outcome::NotCovered}) {
    EXPECT_EQ(exitOf(reportWith({}, {property(verdict)})), Exit::Undecided);
  }
  Report compared = reportWith({});
  compared.comparison = Comparison{};
  EXPECT_EQ(exitOf(compared), Exit::Clean);
  compared.comparison->equal = false;
  EXPECT_EQ(exitOf(compared), Exit::Found);
}

TEST(JsonReport, SaysWhereAPropertyStandsAndWhatItSays) {
  PropertyResult declared = property(Outcome::Proved);
  declared.statement = "prove p: Q0.0 implies I0.0";
  declared.span = Span{0, 8, 6};
  declared.certificate = "proofs/p.smt2";
  PropertyResult builtin = property(Outcome::Proved);
  builtin.kind = ResultKind::Builtin;
  std::ostringstream text;
  reporterNamed("json")->write(reportWith({}, {declared, builtin}), {}, text);
  const nlohmann::json rows = nlohmann::json::parse(text.str())["properties"];
  EXPECT_EQ(rows[0]["file"], "a.awl");
  EXPECT_EQ(rows[0]["line"], 2);
  EXPECT_EQ(rows[0]["expression"], "prove p: Q0.0 implies I0.0");
  EXPECT_EQ(rows[0]["certificate"], "proofs/p.smt2");
  for (const char* key : {"file", "line", "expression", "certificate"}) EXPECT_TRUE(rows[1][key].is_null()) << key;
}

TEST(ExitReason, IsTheWorstOfAll) {
  Report report = reportWith({finding("ADR011", Severity::Note)});
  EXPECT_EQ(exitReasonOf(report).text, "findings below 'warning' do not fail");
  report.failLevel = Severity::Note;
  EXPECT_EQ(exitReasonOf(report).exit, Exit::Found);
  report.reasons.push_back({Exit::Undecided, "a part of the program was not read"});
  EXPECT_EQ(exitReasonOf(report).exit, Exit::Found);
  report.exitsZero = true;
  EXPECT_EQ(exitReasonOf(report).exit, Exit::Clean);
  report.reasons.push_back({Exit::Failed, "nothing was checked"});
  EXPECT_EQ(exitReasonOf(report).exit, Exit::Failed) << "--exit-zero is no way round what could not be done";
  EXPECT_EQ(exitReasonOf(report).text, "nothing was checked");
}

TEST(Worse, PrefersFailedThenFoundThenUndecided) {
  EXPECT_EQ(worse(Exit::Undecided, Exit::Found), Exit::Found);
  EXPECT_EQ(worse(Exit::Failed, Exit::Found), Exit::Failed);
  EXPECT_EQ(worse(Exit::Clean, Exit::Undecided), Exit::Undecided);
}

TEST(SortFindings, OrdersByPlaceAndDropsRepetitions) {
  Report report =
      reportWith({finding("B", Severity::Note, 9), finding("A", Severity::Error, 0), finding("B", Severity::Note, 9)});
  sortFindings(report);
  ASSERT_EQ(report.findings.size(), 2u);
  EXPECT_EQ(report.findings[0].rule, "A");
}

TEST(JsonReport, OfTestsConformsToItsSchema) {
  Report report = reportWith({});
  report.command = "test";
  TestReport tests;
  tests.tests = {{.name = "start", .table = "t.csv", .steps = 2}, {.name = "stop", .table = "t.csv", .steps = 3}};
  TestResult& failed = tests.tests[1];
  failed.passed = false;
  failed.step = 2;
  failed.signal = "Q0.0";
  failed.expected = "1";
  failed.actual = "0";
  failed.scan = 4;
  tests.coverage.emplace();
  MeasureResult& contacts = tests.coverage->measures[Measure::Contacts];
  contacts = {.covered = 1, .total = 3, .unreachable = 1, .open = 1};
  contacts.missing = {{"MAIN:1 A I0.1", "its bit was never 1"},
                      {"MAIN:2 A M0.0", "proved", MissingGoal::State::Unreachable, "proofs/goal_1.smt2"}};
  tests.kills.emplace();
  report.tests = std::make_shared<const TestReport>(tests);
  const nlohmann::json json = nlohmann::json::parse(written("json", report));
  EXPECT_EQ(test::schemaFaults(json, schema()), std::vector<std::string>());
  EXPECT_EQ(json["tests"][1]["step"], 2);
  EXPECT_TRUE(json["tests"][0]["signal"].is_null());
  // Only what is open is missing; what is proved impossible stands among the goals.
  EXPECT_EQ(json["coverage"]["contacts"]["missing"], nlohmann::json({"MAIN:1 A I0.1"}));
  EXPECT_EQ(json["coverage"]["contacts"]["goals"].size(), 2U);
  EXPECT_EQ(exitOf(report), Exit::Found);
  tests.tests.pop_back();
  report.tests = std::make_shared<const TestReport>(tests);
  EXPECT_EQ(exitOf(report), Exit::Clean);
  tests.tests[0].isDecided = false;
  report.tests = std::make_shared<const TestReport>(tests);
  EXPECT_EQ(exitOf(report), Exit::Undecided);
}

TEST(JsonReport, ConformsToItsSchema) {
  Report report = reportWith({finding("ADR001", Severity::Error), finding("STK006", Severity::Note, 8)},
                             {property(Outcome::HoldsToBound), property(Outcome::Proved)});
  report.findings[0].related.push_back({{0, 8, 1}, "second place"});
  report.findings[0].pou = "MAIN";
  report.findings[0].network = 3;
  report.comparison = Comparison{false, 7, 70, "Q0.0", 1, 0, {}, {}};
  report.assumptions = {"CPU 226"};
  report.properties[1].assumptions = {"inputs are free"};
  const nlohmann::json json = nlohmann::json::parse(written("json", report));
  EXPECT_EQ(test::schemaFaults(json, schema()), std::vector<std::string>());
  EXPECT_EQ(json["findings"][1]["line"], 2);
  EXPECT_EQ(json["findings"][1]["column"], 1);
  EXPECT_EQ(json["properties"][0]["verdict"], "HOLDS TO BOUND 7");
  EXPECT_EQ(json["properties"][1]["assumptions"], (std::vector<std::string>{"CPU 226", "inputs are free"}));
  EXPECT_EQ(json["comparison"],
            nlohmann::json(
                {{"equal", false}, {"scan", 7}, {"time_ms", 70}, {"signal", "Q0.0"}, {"expected", 1}, {"actual", 0}}));
  EXPECT_EQ(
      json["summary"],
      nlohmann::json({{"errors", 1}, {"warnings", 0}, {"notes", 1}, {"proved", 1}, {"violated", 0}, {"undecided", 1}}));
}

TEST(JsonReport, KeepsTextThatIsNotUtf8Readable) {
  Report report = reportWith({finding("ADR001", Severity::Error)});
  report.findings[0].message = "name \xFF";
  EXPECT_FALSE(nlohmann::json::parse(written("json", report), nullptr, false).is_discarded());
}

TEST(SchemaCheck, NoticesWhatDoesNotConform) {
  nlohmann::json json = nlohmann::json::parse(written("json", reportWith({finding("ADR001", Severity::Error)})));
  json["findings"][0]["severity"] = "fatal";
  json["findings"][0].erase("rule");
  json["extra"] = 1;
  json["summary"]["errors"] = "one";
  EXPECT_EQ(test::schemaFaults(json, schema()).size(), 4u);
}

// SARIF 2.1.0: section 3.27.5 ruleId, 3.27.6 ruleIndex into tool.driver.rules, 3.30 regions from 1, 3.4.3 URIs.
TEST(SarifReport, MeetsTheRequirementsOfTheStandard) {
  Report report = reportWith({finding("ADR001", Severity::Error), finding("STK006", Severity::Note, 8),
                              finding("ADR001", Severity::Error, 8)});
  auto sources = std::make_shared<SourceSet>();
  sources->add("pump station #2.awl", "LD I0.0\n= Q0.0\n");
  report.sources = sources;
  const nlohmann::json log = nlohmann::json::parse(written("sarif", report));
  EXPECT_EQ(log["version"], "2.1.0");
  const nlohmann::json& sarifRun = log["runs"][0];
  const nlohmann::json& rules = sarifRun["tool"]["driver"]["rules"];
  ASSERT_EQ(sarifRun["results"].size(), 3u);
  EXPECT_EQ(rules.size(), 2u);
  for (const nlohmann::json& result : sarifRun["results"]) {
    EXPECT_EQ(rules[result["ruleIndex"].get<std::size_t>()]["id"], result["ruleId"]);
    const nlohmann::json& place = result["locations"][0]["physicalLocation"];
    EXPECT_EQ(place["artifactLocation"]["uri"], "pump%20station%20%232.awl");
    EXPECT_GE(place["region"]["startLine"].get<int>(), 1);
    EXPECT_GE(place["region"]["startColumn"].get<int>(), 1);
    EXPECT_GT(place["region"]["endColumn"].get<int>(), place["region"]["startColumn"].get<int>());
  }
}

TEST(GithubReport, EscapesWhatTheCommandFormReserves) {
  Report report = reportWith({finding("ADR001", Severity::Error)});
  report.findings[0].message = "50 % of a: b,\nnext";
  EXPECT_EQ(written("github", report),
            "::error file=a.awl,line=1,endLine=1,col=1,title=ADR001::50 %25 of a: b,%0Anext\n");
}

// The members that GitLab's documentation of the code quality report requires; equal findings need fingerprints of
// their own, or one of them vanishes.
TEST(GitlabReport, HasWhatAMergeRequestNeeds) {
  const Report report = reportWith(
      {finding("ADR001", Severity::Error), finding("ADR001", Severity::Error), finding("NET001", Severity::Note, 8)},
      {property(Outcome::Proved), property(Outcome::Violated), property(Outcome::Unknown)});
  const nlohmann::json issues = nlohmann::json::parse(written("gitlab", report));
  ASSERT_EQ(issues.size(), 5U);  // what is proved is no issue
  std::set<std::string> fingerprints;
  for (const nlohmann::json& issue : issues) {
    fingerprints.insert(issue["fingerprint"]);
    EXPECT_EQ(issue["location"]["path"], "a.awl");
  }
  EXPECT_EQ(fingerprints.size(), 5U);
  EXPECT_EQ(issues[0]["check_name"], "ADR001");
  EXPECT_EQ(issues[0]["severity"], "critical");
  EXPECT_EQ(issues[2]["severity"], "info");
  EXPECT_EQ(issues[2]["location"]["lines"]["begin"], 2);
  EXPECT_EQ(issues[3]["severity"], "blocker");
  EXPECT_EQ(issues[3]["description"], "VIOLATED: p");
  EXPECT_EQ(issues[4]["severity"], "minor");
}

TEST(JunitReport, CountsTestsAndFailures) {
  const std::string text = written("junit", reportWith({finding("ADR001", Severity::Error)},
                                                       {property(Outcome::Proved), property(Outcome::Unknown)}));
  EXPECT_NE(text.find("<testsuites name=\"rungproof\" tests=\"3\" failures=\"1\" errors=\"0\">"), std::string::npos)
      << text;
  EXPECT_NE(text.find("<skipped message=\"UNKNOWN\""), std::string::npos) << text;
}

TEST(HtmlReport, EscapesTextOfTheProgram) {
  Report report = reportWith({finding("ADR001", Severity::Error)});
  report.findings[0].message = "<script>\"&";
  const std::string text = written("html", report);
  EXPECT_EQ(text.find("<script>"), std::string::npos);
  EXPECT_NE(text.find("&lt;script&gt;&quot;&amp;"), std::string::npos);
}

TEST(HtmlReport, SaysWhatAProofRestsOnAndWhatTheSelfCheckFound) {
  Report report = reportWith({}, {property(Outcome::Proved)});
  report.properties[0].networks = "MAIN 1, 3-5; SBR_0 2";
  report.assumptions = {"every scan lasts 1 to 500 ms"};
  report.coverage.approximated = {"SIN at a.awl:3: the result of its REAL operation is taken as any value"};
  report.selfCheck = std::vector<PlantedFault>{
      {"removed contact", "A I0.1", "a.awl", 4, "MAIN", 1, "noticed", "stop", ""},
      {"contact polarity", "LDN I0.0 for LD I0.0", "a.awl", 3, "MAIN", 1, "unnoticed", "", "Q0.0 in scan 1"},
      {"edge", "ED for EU", "a.awl", 9, "MAIN", 2, "without effect", "", ""}};
  const std::string text = written("html", report);
  for (const char* part : {"Rests on networks</dt><dd>MAIN 1, 3-5; SBR_0 2", "assumes: every scan lasts 1 to 500 ms",
                           "approximated: SIN at a.awl:3", ">Self-check<",
                           "1 of 2 planted faults that change the outputs are noticed", "1 change nothing, 0 undecided",
                           "<code>LDN I0.0 for LD I0.0</code></td><td>Q0.0 in scan 1", "a.awl:3 in MAIN, network 1"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part;
  }
  EXPECT_EQ(text.find("A I0.1"), std::string::npos) << "what is noticed needs no row";
}

TEST(HumanReport, PrintsTheFirstDifferenceWithTheScansAround) {
  Report report = reportWith({});
  report.command = "compare";
  report.comparison = Comparison{
      false, 2, 20, "Q0.0", 1, 0, {"I0.0", "Q0.0"}, {{1, 10, {"0", "0"}, {"0", "0"}}, {2, 20, {"1", "1"}, {"1", "0"}}}};
  EXPECT_EQ(written("human", report),
            "first difference: scan 2, 20 ms, Q0.0: expected 1, actual 0\n"
            "    scan        ms            I0.0  Q0.0\n"
            "       1        10  expected     0     0\n"
            "                    actual       0     0\n"
            "     > 2        20  expected     1     1\n"
            "                    actual       1     0\n");
}

TEST(Report, SaysWhenTheTraceEndsBeforeTheExpectedScan) {
  Comparison comparison{false, 7, 70, "Q0.0", 1, 0, {}, {}};
  EXPECT_EQ(differenceText(comparison), "scan 7, 70 ms, Q0.0: expected 1, actual 0");
  comparison.hasEnded = true;
  EXPECT_EQ(differenceText(comparison), "scan 7, 70 ms, Q0.0: expected 1, but the trace ends before that scan");
}

TEST(Report, WritesWholeNumbersWithAllTheirDigits) {
  EXPECT_EQ(plainNumber(1476000), "1476000");
  EXPECT_EQ(plainNumber(4294967295.0), "4294967295");
  EXPECT_EQ(plainNumber(-1), "-1");
  EXPECT_EQ(plainNumber(12.5), "12.5");
  const Comparison comparison{false, 2952, 1476000, "VD0", 1234567, -7654321, {}, {}};
  EXPECT_EQ(differenceText(comparison), "scan 2952, 1476000 ms, VD0: expected 1234567, actual -7654321");
}

/// Of two programs: no scan is named where nothing is decided.
TEST(Report, EachFormatSaysWhatIsUndecidedAboutTwoPrograms) {
  Report report;
  report.command = "equiv";
  Comparison& comparison = report.comparison.emplace();
  comparison.equal = false;
  comparison.verdict = "UNKNOWN";
  comparison.notes = {"the time was over"};
  for (const char* name : {"human", "concise", "github", "junit", "html"}) {
    std::ostringstream out;
    reporterNamed(name)->write(report, {}, out);
    EXPECT_NE(out.str().find("the time was over"), std::string::npos) << name;
    EXPECT_EQ(out.str().find("scan 0"), std::string::npos) << name;
  }
}

TEST(Report, EachFormatNamesTheProgramsThatDiffer) {
  Report report;
  report.command = "equiv";
  report.comparison = Comparison{false, 7, 70, "Q0.0", 1, 0, {}, {}};
  report.comparison->verdict = "DIFFERENT";
  for (const char* name : {"human", "concise", "github", "junit", "html"}) {
    std::ostringstream out;
    reporterNamed(name)->write(report, {}, out);
    EXPECT_NE(out.str().find("scan 7, 70 ms, Q0.0: OLD 1, NEW 0"), std::string::npos) << name << out.str();
  }
}

/// What people read names chapter and section; the bare line of our copy of the manual leads them nowhere.
TEST(Reports, CiteTheManualByItsChapter) {
  Finding cited = finding("TIM004", Severity::Warning);
  cited.message = "use a faster timer (001:6611)";
  for (const char* form : {"human", "concise", "github", "gitlab", "junit", "sarif", "html"}) {
    const std::string text = written(form, reportWith({cited}));
    EXPECT_NE(text.find("use a faster timer (System Manual 2004, chapter 6, Timers)"), std::string::npos) << form;
  }
}

TEST(ConciseReport, TellsWhatStaysOpen) {
  Report report = reportWith({});
  report.coverage.leftOut = {"OUT003: 1 of 2 questions to the prover are open"};
  EXPECT_EQ(written("concise", report), "left out: OUT003: 1 of 2 questions to the prover are open\n");
}

/// lint --prove --traces: the finding names the file of its run, and sim repeats the run from it. The set in front of
/// the reset loses in the scan in which both inputs are on.
TEST(LintTraces, TheRunOfAConfirmedFindingIsWritten) {
  const test::TemporaryFolder folder;
  const std::string program =
      folder.file("latch.awl", test::mainBlock("Network 1\nLD I0.1\nR Q0.0, 1\nNetwork 2\nLD I0.0\nS Q0.0, 1\n"));
  const test::ProgramRun result = test::run(
      {"lint", "--prove", "--select", "OUT003", "--traces", folder.path("runs"), program, "--format", "json"});
  const nlohmann::json json = nlohmann::json::parse(result.out);
  ASSERT_EQ(json["findings"].size(), 1U) << result.out;
  ASSERT_TRUE(json["findings"][0]["trace"].is_string());
  const std::string trace = json["findings"][0]["trace"];
  EXPECT_NE(trace.find("OUT003"), std::string::npos);
  EXPECT_NE(test::contentOf(trace).find("I0.0"), std::string::npos);
  EXPECT_EQ(test::run({"sim", program, "--stimulus", trace, "--expect", trace}).exit, 0);
  EXPECT_EQ(test::run({"lint", "--traces", folder.path("runs"), program}).exit, 2) << "without --prove";
}

/// A network that the editor leaves out of the download is named with its place, the reason and what can be done.
TEST(LeftOut, SaysWhatAndWhatToDo) {
  const test::TemporaryFolder folder;
  const std::string program =
      folder.file("p.awl", "//@ prove never on: never Q0.1\n" +
                               test::mainBlock("Network 1\nLD I0.0\n= Q0.0\nNetwork 2\nLD I0.1\nA\n= Q0.1\n"));
  const test::ProgramRun result = test::run({"prove", program, "--as-downloaded", "--cpu", "CPU ST40"});
  EXPECT_TRUE(result.says("left out: MAIN, network 2 (")) << result.out;
  EXPECT_TRUE(result.says("is not in the download: A takes 1 operand, not 0; mend it, or give no --as-downloaded"))
      << result.out;
}

/// On a terminal the progress of a proof says what was proved, how, how deep and how long it took.
TEST(Progress, NamesPropertyMethodDepthAndSeconds) {
  const test::TemporaryFolder folder;
  const std::string program =
      folder.file("p.awl",
                  "ORGANIZATION_BLOCK MAIN:OB1\n//@ prove never on: never Q0.0\nBEGIN\nNetwork 1\nLD I0.0\n= Q0.0\n"
                  "END_ORGANIZATION_BLOCK\n");
  std::istringstream in;
  std::ostringstream out, err;
  EXPECT_EQ(runProgram({"prove", program}, {in, out, err, false, true}), 1);
  EXPECT_NE(err.str().find("prove: 1 of 1: VIOLATED never on by "), std::string::npos) << err.str();
  EXPECT_NE(err.str().find(", depth 1 in "), std::string::npos) << err.str();
}

}  // namespace
}  // namespace rungproof
