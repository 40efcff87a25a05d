// Mutants of every instruction of the S7-300/400 are tried against the stated cases (tests/data/s7300_cases.tsv).
// It fails when an instruction is reached by no case or has no mutant that is noticed, or when fewer than 90 % of all
// mutants are noticed, those that mean the same included. "test_mutation7 +I" tries one mnemonic, or
// those that fit a pattern as of file names, and prints each mutant.
#include <fmt/format.h>
#include <fnmatch.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "ir/s7300/isa.hpp"
#include "tests/agreement7/case_run.hpp"
#include "tests/mutation/trial.hpp"

namespace rungproof::mutation {
namespace {

class StatedCase : public testing::Test {
 public:
  explicit StatedCase(const naive7::Case& c) : case_(c) {}
  void TestBody() override { EXPECT_EQ(agreement7::differences(case_), "") << case_.name(); }

 private:
  const naive7::Case& case_;
};

/// One test for each case, so that a mutant is tried against those only that reach its site.
void registerCases(const std::vector<naive7::Case>& cases) {
  for (std::size_t i = 0; i < cases.size(); ++i) {
    testing::RegisterTest("Stated", fmt::format("Case{}", i + 1).c_str(), nullptr, nullptr, __FILE__, __LINE__,
                          [&one = cases[i]]() -> testing::Test* { return new StatedCase(one); });
  }
}

/// Changes that make sense at a site.
bool applies(const Site& site, int change) {
  const std::string& file = Mutation::instance().fileName(site);
  const std::string_view function = Mutation::instance().functionName(site);
  // The frame keeps the books of guards, which are all true where plain numbers run at all.
  const bool isFrame = file == "guarded_run.hpp" || file == "flow_walk.hpp" || file == "scan.hpp" ||
                       file == "control.hpp" || (file == "machine.hpp" && function == "error");
  if (isFrame) return site.op == Op::Whole || function == "run";
  return site.op != Op::Whole || change <= 2;
}

std::string_view mnemonicOf(const Site& site) { return s7300Instructions().all()[site.opcode].stl; }

struct Tally {
  int mutants = 0;
  int noticed = 0;
};

int judge(const std::vector<std::string>& tests, const std::string& only) {
  std::vector<Candidate> candidates;
  for (const auto& [site, reachedBy] : Mutation::instance().sites()) {
    if (!only.empty() && fnmatch(only.c_str(), std::string(mnemonicOf(site)).c_str(), 0) != 0) continue;
    for (int change = 1; change <= static_cast<int>(changesOf(site.op).size()); ++change) {
      if (applies(site, change)) candidates.push_back({{site, static_cast<std::uint8_t>(change)}, &reachedBy});
    }
  }
  const std::vector<Verdict> verdicts =
      only.empty() ? tryChosenMutants(candidates, tests) : tryMutants(candidates, tests);
  std::vector<Tally> byOpcode(s7300Instructions().all().size());
  Tally all;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (verdicts[i] == Verdict::LeftOut) continue;
    const Site& site = candidates[i].mutant.site;
    const bool isNoticed = verdicts[i] == Verdict::Noticed;
    for (Tally* tally : {&byOpcode[site.opcode], &all}) {
      ++tally->mutants;
      tally->noticed += isNoticed ? 1 : 0;
    }
    if (only.empty()) continue;
    const Mutation& mutation = Mutation::instance();
    fmt::print("{}\t{} {} line {}:{}\t{}\t{}: {}\n", mnemonicOf(site), mutation.fileName(site),
               mutation.functionName(site), site.line, site.column, opName(site.op),
               changesOf(site.op)[static_cast<std::size_t>(candidates[i].mutant.change - 1)],
               isNoticed ? "noticed" : "unnoticed");
  }
  int problems = 0;
  const double share = 100.0 * all.noticed / std::max(all.mutants, 1);
  fmt::print("{} mutants: {} noticed ({:.2f} %)\n", all.mutants, all.noticed, share);
  if (!only.empty()) return 0;
  for (std::size_t i = 0; i < byOpcode.size(); ++i) {
    const Desc& desc = s7300Instructions().all()[i];
    if (desc.control == Control::LabelMark || desc.drawingOnly || byOpcode[i].noticed > 0) continue;
    fmt::print("{}: {} mutants, {} noticed\n", desc.stl, byOpcode[i].mutants, byOpcode[i].noticed);
    ++problems;
  }
  return problems + (share < 90 ? 1 : 0);
}

}  // namespace
}  // namespace rungproof::mutation

int main(int argc, char** argv) {
  using namespace rungproof::mutation;
  testing::GTEST_FLAG(brief) = true;
  testing::InitGoogleTest(&argc, argv);
  const auto cases = naive7::readCases(std::string(RUNGPROOF_SOURCE_DIR) + "/tests/data/s7300_cases.tsv");
  registerCases(cases);
  const std::vector<std::string> tests = recordTests();
  if (tests.empty()) return 1;
  return judge(tests, argc > 1 ? argv[1] : "") == 0 ? 0 : 1;
}
