// The baseline: what it holds, what it hides, when it is stale, and that edits elsewhere leave it alone.
#include "frontend/linting/baseline.hpp"

#include <gtest/gtest.h>

#include "frontend/linting/fingerprint.hpp"

namespace rungproof {
namespace {

Report reportOf(const std::string& text, const std::vector<std::string>& marks) {
  Report report;
  auto sources = std::make_shared<SourceSet>();
  sources->add("a.awl", text);
  for (const std::string& mark : marks) {
    Finding finding;
    finding.rule = "ADR001";
    finding.message = "about " + mark;
    finding.address = mark;
    finding.pou = "MAIN";
    finding.span = {0, static_cast<std::uint32_t>(text.find(mark)), static_cast<std::uint32_t>(mark.size())};
    report.findings.push_back(finding);
  }
  report.sources = sources;
  return report;
}

/// The same report with the baseline's file added, as the lint command does.
Report withBaseline(Report report, const std::string& text) {
  auto sources = std::make_shared<SourceSet>();
  sources->add("a.awl", std::string(report.sources->file(0).text()));
  const std::uint32_t file = sources->add("known.json", text);
  report.sources = sources;
  Baseline baseline;
  EXPECT_FALSE(readBaseline(text, "known.json", baseline));
  applyBaseline(
      baseline, file, [](std::string_view) { return true; }, report);
  return report;
}

TEST(Baseline, HidesWhatItLists) {
  const Report old = reportOf("LD I0.9\n= Q0.9\n", {"I0.9", "Q0.9"});
  const Report now = withBaseline(old, toJson(baselineOf(old)));
  EXPECT_TRUE(now.findings.empty());
  EXPECT_EQ(now.baselined, 2u);
}

TEST(Baseline, NothingIsStaleWhileATextCannotBeRead) {
  const Report old = reportOf("LD I0.9\n= Q0.9\n", {"I0.9", "Q0.9"});
  Report now = reportOf("LDX I0.9\n= Q0.9\n", {"I0.9"});
  now.findings[0].rule = "SYN010";
  now.findings[0].severity = Severity::Error;
  const Report left = withBaseline(now, toJson(baselineOf(old)));
  ASSERT_EQ(left.findings.size(), 1u);
  EXPECT_EQ(left.findings[0].rule, "SYN010");
}

TEST(Baseline, SurvivesEditsElsewhere) {
  const Report old = reportOf("LD I0.9\n= Q0.0\n", {"I0.9"});
  const Report moved = reportOf("LD I0.1\n= Q0.1\nLD   I0.9\n= Q0.0\n", {"I0.9"});
  EXPECT_TRUE(withBaseline(moved, toJson(baselineOf(old))).findings.empty());
}

TEST(Baseline, LetsNewFindingsThrough) {
  const Report old = reportOf("LD I0.9\n= Q0.9\n", {"I0.9"});
  const Report now = withBaseline(reportOf("LD I0.9\n= Q0.9\n", {"I0.9", "Q0.9"}), toJson(baselineOf(old)));
  ASSERT_EQ(now.findings.size(), 1u);
  EXPECT_EQ(now.findings[0].address, "Q0.9");
}

// Two findings on one line with one fingerprint are counted, so that a third one is new.
TEST(Baseline, CountsFindingsOfOneFingerprint) {
  const std::string text = "LD I0.9\n";
  const Report old = reportOf(text, {"I0.9", "I0.9"});
  const Report now = withBaseline(reportOf(text, {"I0.9", "I0.9", "I0.9"}), toJson(baselineOf(old)));
  EXPECT_EQ(now.findings.size(), 1u);
  EXPECT_EQ(now.baselined, 2u);
}

TEST(Baseline, ReportsStaleEntriesWithTheirPlace) {
  const Report old = reportOf("LD I0.9\n= Q0.9\n", {"I0.9", "Q0.9"});
  const std::string text = toJson(baselineOf(old));
  const Report now = withBaseline(reportOf("LD I0.9\n= Q0.1\n", {"I0.9"}), text);
  ASSERT_EQ(now.findings.size(), 1u);
  EXPECT_EQ(now.findings[0].rule, "SUP003");
  EXPECT_EQ(now.sources->text(now.findings[0].span), fingerprintOf(old.findings[1], *old.sources));
}

TEST(Baseline, RefusesOtherTexts) {
  Baseline baseline;
  for (const char* text :
       {"", "[]", "{}", "{\"findings\":[]}", "{\"rungproof_baseline\":2,\"findings\":[]}",
        "{\"rungproof_baseline\":1,\"findings\":[{}]}", "{\"rungproof_baseline\":1,\"findings\":[1]}"}) {
    EXPECT_TRUE(readBaseline(text, "b.json", baseline)) << text;
  }
}

TEST(Fingerprint, DependsOnRuleBlockAddressAndLine) {
  const Report report = reportOf("LD I0.9\n= Q0.9\n", {"I0.9", "Q0.9"});
  const Finding& base = report.findings[0];
  const std::string print = fingerprintOf(base, *report.sources);
  EXPECT_EQ(print.size(), 16u);
  Finding other = base;
  other.rule = "ADR002";
  EXPECT_NE(fingerprintOf(other, *report.sources), print);
  other = base;
  other.pou = "SBR_0";
  EXPECT_NE(fingerprintOf(other, *report.sources), print);
  EXPECT_NE(fingerprintOf(report.findings[1], *report.sources), print);
  other = base;
  other.message = "another wording of a later version";
  EXPECT_EQ(fingerprintOf(other, *report.sources), print);
}

}  // namespace
}  // namespace rungproof
