// Reports of the whole corpus in every machine-readable form at once, against their schemas: JSON by its own
// (frontend/report/schema.json), SARIF by the part of the standard that is used (sarif_schema.json) and what a schema
// cannot say, JUnit by the rules of Jenkins' xunit plugin (junit-10.xsd), which GitLab reads as well.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>
#include <set>

#include "ir/s7200/cpu.hpp"
#include "schema_check.hpp"
#include "tests/program_run.hpp"

namespace rungproof {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

const std::string root = RUNGPROOF_SOURCE_DIR;

std::vector<fs::path> programs() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(root + "/corpus")) {
    const std::string ending = entry.path().extension().string();
    if (ending == ".awl" || ending == ".stl" || ending == ".xml") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

/// 3.27.9: a result that is no failure has level "none"; 3.27.6: ruleIndex leads to the rule of that id; 3.30: a region
/// does not end before it begins.
std::string sarifFaults(const json& log) {
  static const json schema = json::parse(test::contentOf(root + "/tests/cli/sarif_schema.json"));
  std::vector<std::string> faults = test::schemaFaults(log, schema);
  if (!faults.empty()) return joined(faults);
  for (const json& run : log["runs"]) {
    const json& rules = run["tool"]["driver"]["rules"];
    std::set<std::string> ids;
    for (const json& rule : rules) {
      if (!ids.insert(rule["id"]).second) faults.push_back("rule twice: " + rule["id"].dump());
    }
    for (const json& result : run["results"]) {
      const auto index = result["ruleIndex"].get<std::size_t>();
      if (index >= rules.size() || rules[index]["id"] != result["ruleId"])
        faults.push_back("ruleIndex: " + result.dump());
      if (result.value("kind", "fail") != "fail" && result["level"] != "none")
        faults.push_back("level: " + result.dump());
      for (const json& location : result.value("locations", json::array())) {
        if (!location.contains("physicalLocation")) continue;
        const json region = location["physicalLocation"].value("region", json::object());
        if (region.empty()) continue;
        const std::pair begin{region["startLine"].get<int>(), region["startColumn"].get<int>()};
        const std::pair end{region["endLine"].get<int>(), region["endColumn"].get<int>()};
        if (end < begin) faults.push_back("region: " + region.dump());
      }
    }
  }
  return joined(faults);
}

/// Elements, attributes, their order and their counts as junit-10.xsd has them.
class JunitCheck {
 public:
  std::string faults(const std::string& text) {
    pugi::xml_document document;
    const pugi::xml_parse_result read = document.load_buffer(text.data(), text.size());
    if (!read) return std::string("no XML: ") + read.description();
    const pugi::xml_node suites = document.document_element();
    expect(std::string(suites.name()) == "testsuites", "the root is testsuites");
    attributes(suites, {"name", "time", "tests", "failures", "errors"}, {});
    int tests = 0, failures = 0;
    for (const pugi::xml_node suite : suites.children()) {
      expect(std::string(suite.name()) == "testsuite", "testsuites holds testsuite only");
      suiteFaults(suite);
      tests += suite.attribute("tests").as_int();
      failures += suite.attribute("failures").as_int();
    }
    expect(tests == suites.attribute("tests").as_int(), "tests of the suites add up");
    expect(failures == suites.attribute("failures").as_int(), "failures of the suites add up");
    return faults_;
  }

 private:
  void expect(bool holds, const std::string& what) {
    if (!holds) faults_ += what + "\n";
  }
  void attributes(pugi::xml_node node, const std::set<std::string>& known, const std::set<std::string>& required) {
    for (const pugi::xml_attribute attribute : node.attributes())
      expect(known.contains(attribute.name()), std::string(node.name()) + " has no attribute " + attribute.name());
    for (const std::string& name : required)
      expect(node.attribute(name.c_str()), std::string(node.name()) + " needs " + name);
  }
  void suiteFaults(pugi::xml_node suite) {
    attributes(suite,
               {"name", "tests", "failures", "errors", "time", "disabled", "skipped", "timestamp", "hostname", "id",
                "package"},
               {"name", "tests", "failures"});
    int cases = 0, failed = 0, skipped = 0;
    for (const pugi::xml_node test : suite.children()) {
      if (std::string(test.name()) == "system-out" && !test.next_sibling()) continue;
      expect(std::string(test.name()) == "testcase", "testsuite holds testcase, and system-out at its end");
      attributes(test, {"name", "assertions", "time", "classname", "status"}, {"name", "classname"});
      expect(std::string(test.attribute("name").value()) != "", "a testcase has a name");
      ++cases;
      int outcomes = 0;
      for (const pugi::xml_node outcome : test.children()) {
        const std::string name = outcome.name();
        if (name == "system-out" && !outcome.next_sibling()) continue;
        expect(name == "failure" || name == "skipped",
               "a testcase holds failure or skipped, and system-out at its end");
        attributes(outcome,
                   name == "failure" ? std::set<std::string>{"type", "message"} : std::set<std::string>{"message"}, {});
        (name == "failure" ? failed : skipped) += 1;
        ++outcomes;
      }
      expect(outcomes <= 1, "a testcase has one outcome");
    }
    expect(cases == suite.attribute("tests").as_int(), "tests counts the cases");
    expect(failed == suite.attribute("failures").as_int(), "failures counts the failures");
    expect(skipped == suite.attribute("skipped").as_int(), "skipped counts the skipped");
  }
  std::string faults_;
};

bool isSmart(const fs::path& file) { return file.string().find("/smart/") != std::string::npos; }

void checkForms(const std::vector<std::string>& command, const fs::path& file) {
  static const json schema = json::parse(test::contentOf(root + "/frontend/report/schema.json"));
  const test::TemporaryFolder folder;
  std::vector<std::string> arguments = command;
  arguments.insert(arguments.end(),
                   {file.string(), "--isolated", "--format", "json=" + folder.path("r.json"), "--format",
                    "sarif=" + folder.path("r.sarif"), "--format", "junit=" + folder.path("r.xml"), "--format",
                    "html=" + folder.path("r.html"), "--format", "github"});
  if (isSmart(file)) arguments.insert(arguments.end(), {"--cpu", "ST40"});
  const test::ProgramRun run = test::run(arguments);
  ASSERT_TRUE(run.exit >= 0 && run.exit <= 3) << file;
  const json report = json::parse(test::contentOf(folder.path("r.json")));
  EXPECT_EQ(joined(test::schemaFaults(report, schema)), "") << file;
  const json log = json::parse(test::contentOf(folder.path("r.sarif")));
  EXPECT_EQ(sarifFaults(log), "") << file;
  EXPECT_EQ(JunitCheck().faults(test::contentOf(folder.path("r.xml"))), "") << file;
  // The forms agree with each other.
  EXPECT_EQ(log["runs"][0]["results"].size(), report["findings"].size() + report["properties"].size()) << file;
}

TEST(CorpusReports, OfLintValidate) {
  const std::vector<fs::path> files = programs();
  ASSERT_GE(files.size(), 100U);
  for (const fs::path& file : files) checkForms({"lint"}, file);
}

/// By default of some programs whose properties are settled at once; RUNGPROOF_REPORTS=all takes every program.
TEST(CorpusReports, OfProveValidate) {
  const char* const wish = std::getenv("RUNGPROOF_REPORTS");
  const bool isWhole = wish != nullptr && std::string(wish) == "all";
  static const std::set<std::string> quick{"double_coil", "reversing", "reversing_faulty", "blinker", "interrupt_byte"};
  std::size_t count = 0;
  for (const fs::path& file : programs()) {
    if (!isWhole && !quick.contains(file.stem().string())) continue;
    checkForms({"prove", "--timeout", "1s", "--bound", "3"}, file);
    ++count;
  }
  EXPECT_GE(count, quick.size());
}

TEST(CorpusReports, UnconfirmedIsSaidInEveryForm) {
  const test::TemporaryFolder folder;
  const std::string file =
      folder.file("a.awl", test::mainBlock("Network 1\nLD I0.0\nS Q0.0, 1\nNetwork 2\nLD I0.1\n/D VD0, VD4\n"));
  const test::ProgramRun run = test::run({"lint", "--isolated", "--select", "ARI001", "--format", "json", file});
  const json report = json::parse(run.out);
  ASSERT_FALSE(report["findings"].empty()) << run.out;
  ASSERT_EQ(report["findings"][0]["confirmed"], false);
  for (const char* form : {"human", "concise", "github", "html", "junit", "sarif"}) {
    const test::ProgramRun other = test::run({"lint", "--isolated", "--select", "ARI001", "--format", form, file});
    EXPECT_NE(other.out.find("unconfirmed"), std::string::npos) << form;
  }
}

}  // namespace
}  // namespace rungproof
