// Allow-comments: how they are read, for what they speak, and what is said of those that silence nothing.
#include "analysis/lint/suppress.hpp"

#include <gtest/gtest.h>

#include "frontend/input/project.hpp"
#include "tests/program_run.hpp"

namespace rungproof {
namespace {

Program programOf(const std::string& networks) { return readText("a.awl", test::mainBlock(networks)); }

/// A finding of ADR001 at the first place of the text.
Finding findingAt(const Program& program, std::string_view text, const std::string& rule = "ADR001") {
  Finding finding;
  finding.rule = rule;
  finding.severity = Severity::Error;
  finding.span = {0, static_cast<std::uint32_t>(program.sources->file(0).text().find(text)),
                  static_cast<std::uint32_t>(text.size())};
  return finding;
}

KnownRules everyRuleRan() {
  return {[](std::string_view id) { return id != "XYZ999"; }, [](std::string_view) { return true; }};
}

std::vector<std::string> rulesOf(const std::vector<Finding>& findings) {
  std::vector<std::string> rules;
  for (const Finding& finding : findings) rules.push_back(finding.rule);
  return rules;
}

TEST(AllowsOf, ReadsIdsAndReason) {
  const Program program = programOf(
      "Network 1\n"
      "LD I0.0 // rungproof: allow ADR001, out003 - panel writes it\n"
      "= Q0.0 // see rungproof: allow, this is prose\n");
  const std::vector<Allow> allows = allowsOf(program);
  ASSERT_EQ(allows.size(), 1u);
  EXPECT_EQ(allows[0].ids, (std::vector<std::string>{"ADR001", "OUT003"}));
  EXPECT_EQ(allows[0].reason, "panel writes it");
  EXPECT_EQ(allows[0].problem, "");
}

TEST(AllowsOf, TakesItsScopeFromItsPlace) {
  const Program program = readText("a.awl",
                                   "ORGANIZATION_BLOCK MAIN:OB1\n"
                                   "// rungproof: allow ADR001 whole block\n"
                                   "BEGIN\n"
                                   "Network 1\n"
                                   "// rungproof: allow ADR001 whole network\n"
                                   "LD I0.0 // rungproof: allow ADR001 this line\n"
                                   "// rungproof: allow ADR001 next line\n"
                                   "= Q0.0\n"
                                   "END_ORGANIZATION_BLOCK\n");
  const std::vector<Allow> allows = allowsOf(program);
  ASSERT_EQ(allows.size(), 4u);
  EXPECT_EQ(allows[0].scope, AllowScope::Block);
  EXPECT_EQ(allows[1].scope, AllowScope::Network);
  EXPECT_EQ(allows[2].scope, AllowScope::Line);
  EXPECT_EQ(allows[2].line, 6u);
  EXPECT_EQ(allows[3].scope, AllowScope::Line);
  EXPECT_EQ(allows[3].line, 8u);
}

TEST(AllowsOf, SpeaksForStatementsOfTheS7300) {
  const Program program = readText("a.awl",
                                   "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n      A I 0.0;\n"
                                   "      = Q 0.0; // rungproof: allow OUT001 two hands on purpose\n"
                                   "// rungproof: allow OUT003 reset wins\n      A I 0.1;\nEND_ORGANIZATION_BLOCK\n");
  const std::vector<Allow> allows = allowsOf(program);
  ASSERT_EQ(allows.size(), 2u);
  EXPECT_EQ(allows[0].scope, AllowScope::Line);
  EXPECT_EQ(allows[0].line, 5u);
  EXPECT_EQ(allows[1].line, 7u);
  EXPECT_EQ(allows[1].ids, std::vector<std::string>{"OUT003"});
}

TEST(ApplySuppressions, SilencesOnlyWhereItSpeaks) {
  const Program program = programOf(
      "Network 1\n"
      "LD I0.1 // rungproof: allow ADR001 reason\n"
      "= Q0.1\n"
      "Network 2\n"
      "// rungproof: allow ADR001 reason\n"
      "LD I0.2\n"
      "= Q0.2\n");
  std::vector<Finding> findings = {findingAt(program, "I0.1"), findingAt(program, "Q0.1"), findingAt(program, "I0.2"),
                                   findingAt(program, "Q0.2"), findingAt(program, "Q0.2", "OUT001")};
  EXPECT_EQ(applySuppressions(program, everyRuleRan(), findings), 3u);
  ASSERT_EQ(findings.size(), 2u);
  EXPECT_EQ(program.sources->text(findings[0].span), "Q0.1");
  EXPECT_EQ(findings[1].rule, "OUT001");
}

TEST(ApplySuppressions, ABlockCommentSpeaksForItsBlockOnly) {
  const Program program =
      readText("a.awl",
               "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1\nLD I0.1\n= Q0.1\nEND_ORGANIZATION_BLOCK\n"
               "SUBROUTINE_BLOCK SBR_0:SBR0\n// rungproof: allow ADR001 reason\nBEGIN\nNetwork 1\nLD I0.2\n= "
               "Q0.2\nEND_SUBROUTINE_BLOCK\n");
  std::vector<Finding> findings = {findingAt(program, "I0.1"), findingAt(program, "I0.2"), findingAt(program, "Q0.2")};
  EXPECT_EQ(applySuppressions(program, everyRuleRan(), findings), 2u);
  EXPECT_EQ(rulesOf(findings), std::vector<std::string>{"ADR001"});
}

TEST(ApplySuppressions, EachIdMustEarnItsPlace) {
  const Program program = programOf("Network 1\nLD I0.1 // rungproof: allow ADR001 OUT001 reason\n= Q0.1\n");
  std::vector<Finding> findings = {findingAt(program, "I0.1")};
  EXPECT_EQ(applySuppressions(program, everyRuleRan(), findings), 1u);
  ASSERT_EQ(rulesOf(findings), std::vector<std::string>{"SUP001"});
  EXPECT_NE(findings[0].message.find("OUT001"), std::string::npos);
}

TEST(ApplySuppressions, RulesThatDidNotRunAreNotCalledUnused) {
  const Program program = programOf("Network 1\nLD I0.1 // rungproof: allow OUT003 the solver knows\n= Q0.1\n");
  std::vector<Finding> findings;
  applySuppressions(
      program, {[](std::string_view) { return true; }, [](std::string_view id) { return id != "OUT003"; }}, findings);
  EXPECT_TRUE(findings.empty());
}

// Rules hold back beside what could not be read, so their silence says nothing about a comment.
TEST(ApplySuppressions, NothingIsUnusedWhileATextCannotBeRead) {
  const Program program = programOf("Network 1\nLD I0.1 // rungproof: allow OUT003 reason\n= Q0.1\n");
  for (const char* id : {"SYN010", "SYN018", "SYN049"}) {
    std::vector<Finding> findings = {findingAt(program, "Q0.1", id)};
    EXPECT_EQ(applySuppressions(program, everyRuleRan(), findings), 0u);
    EXPECT_EQ(rulesOf(findings), std::vector<std::string>{id});
  }
  // A note of the readers hides nothing; a rule that does not exist is said in any case.
  std::vector<Finding> noted = {findingAt(program, "Q0.1", "SYN026")};
  noted[0].severity = Severity::Note;
  applySuppressions(program, everyRuleRan(), noted);
  EXPECT_EQ(rulesOf(noted), (std::vector<std::string>{"SYN026", "SUP001"}));
  const Program unknown = programOf("Network 1\nLD I0.1 // rungproof: allow XYZ999 reason\n= Q0.1\n");
  std::vector<Finding> broken = {findingAt(unknown, "Q0.1", "SYN010")};
  applySuppressions(unknown, everyRuleRan(), broken);
  EXPECT_EQ(rulesOf(broken), (std::vector<std::string>{"SYN010", "SUP001"}));
}

TEST(ApplySuppressions, WithoutCodeOrReasonItSilencesNothing) {
  for (const char* comment :
       {"allow", "allow ADR001", "allow ADR001 - ", "allow because", "disable ADR001 reason", ""}) {
    const Program program = programOf("Network 1\nLD I0.1 // rungproof: " + std::string(comment) + "\n= Q0.1\n");
    std::vector<Finding> findings = {findingAt(program, "I0.1")};
    EXPECT_EQ(applySuppressions(program, everyRuleRan(), findings), 0u) << comment;
    EXPECT_EQ(rulesOf(findings), (std::vector<std::string>{"ADR001", "SUP002"})) << comment;
  }
}

TEST(ApplySuppressions, NamesRulesThatDoNotExist) {
  const Program program = programOf("Network 1\nLD I0.1 // rungproof: allow XYZ999 reason\n= Q0.1\n");
  std::vector<Finding> findings;
  applySuppressions(program, everyRuleRan(), findings);
  EXPECT_EQ(rulesOf(findings), std::vector<std::string>{"SUP001"});
}

TEST(ApplySuppressions, ErrorsOfTheReadersStay) {
  const Program program = programOf("Network 1\nLD I0.1 // rungproof: allow SYN010 reason\n= Q0.1\n");
  std::vector<Finding> findings = {findingAt(program, "I0.1", "SYN010")};
  EXPECT_EQ(applySuppressions(program, everyRuleRan(), findings), 0u);
}

}  // namespace
}  // namespace rungproof
