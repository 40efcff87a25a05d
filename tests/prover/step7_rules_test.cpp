// Rules that the prover answers on programs of the S7-300/400: found and not found, reasoned beside each case.
#include <set>

#include "analysis/lint/lint.hpp"
#include "frontend/linting/solver_rules.hpp"
#include "proved_text.hpp"

namespace rungproof::test {
namespace {

/// What lint --prove says at or above a warning: "OUT003 Q0.0".
std::multiset<std::string> provedFindings(const std::string& statements, const std::string& otherBlocks = "") {
  const ProgramInput input = inputOfSource(otherBlocks + "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n" + statements +
                                           "\nEND_ORGANIZATION_BLOCK\n");
  const Facts facts(input.program, input.properties.externals);
  std::vector<Finding> findings = runRules(facts, RuleSelection(), {});
  settleBySolver(
      input, usualOptions(5), [](std::string_view) { return true; }, findings);
  std::multiset<std::string> said;
  for (const Finding& finding : findings) {
    if (finding.confirmation != Confirmation::Unconfirmed && finding.severity >= Severity::Warning)
      said.insert(finding.rule + (finding.address.empty() ? "" : " " + finding.address));
  }
  return said;
}
using Said = std::multiset<std::string>;

TEST(Step7SolverRules, SetAndResetInOneScan) {
  EXPECT_EQ(provedFindings("A I 0.0;\nR Q 0.0;\nA I 0.1;\nS Q 0.0;"), Said{"OUT003 Q0.0"});
  EXPECT_EQ(provedFindings("A I 0.0;\nS Q 0.0;\nA I 0.1;\nR Q 0.0;"), Said()) << "reset dominant: a note";
  EXPECT_EQ(provedFindings("A I 0.0;\nAN I 0.1;\nS Q 0.0;\nA I 0.1;\nR Q 0.0;"), Said());
}

TEST(Step7SolverRules, TwoCoilsOfWhichBothRun) {
  // Two jumps that are both not taken with I0.0 and I0.1 on.
  const std::string both = "A I 0.0;\nJCN a;\nA I 0.2;\n= Q 0.0;\na: A I 0.1;\nJCN b;\nA I 0.3;\n= Q 0.0;\nb: NOP 0;";
  EXPECT_EQ(provedFindings(both), Said{"OUT001 Q0.0"});
  // The second jump is taken whenever the first one is not.
  const std::string one = "A I 0.0;\nJCN a;\nA I 0.2;\n= Q 0.0;\na: A I 0.0;\nJC b;\nA I 0.3;\n= Q 0.0;\nb: NOP 0;";
  EXPECT_EQ(provedFindings(one), Said());
}

TEST(Step7SolverRules, ErrorsThatStopTheCpu) {
  const std::string start = "A I 0.0;\nL IW 6;\nSP T 1;";  // any word comes in, also 16#00FA
  EXPECT_EQ(provedFindings(start), Said{"OBL002"});
  EXPECT_EQ(provedFindings(start, "ORGANIZATION_BLOCK OB 121\nBEGIN\nNETWORK\nNOP 0;\nEND_ORGANIZATION_BLOCK\n"),
            Said());
  EXPECT_EQ(provedFindings("L IW 6;\nL W#16#0999;\nAW;\nL 100;\n>I;\nJC e;\nA I 0.0;\nL S5T#1S;\nSP T 1;\ne: NOP 0;"),
            Said());
  EXPECT_EQ(provedFindings("A I 0.0;\nJCN e;\nCALL SFC 46;\ne: NOP 0;"), Said{"OBL002"});
}

TEST(Step7SolverRules, CallsThatNestTooDeep) {
  const std::string itself = "FUNCTION FC 1 : VOID\nBEGIN\nNETWORK\nA I 0.0;\nCC FC 1;\nEND_FUNCTION\n";
  EXPECT_EQ(provedFindings("UC FC 1;", itself), (Said{"SUB001", "SUB002"}));
}

TEST(Step7SolverRules, CoilsThatNeverChange) {
  EXPECT_EQ(provedFindings("A I 0.0;\nAN I 0.0;\n= Q 0.0;"), Said{"LOG001 Q0.0"});
  EXPECT_EQ(provedFindings("A I 0.0;\nON I 0.0;\n= Q 0.0;"), Said{"LOG001 Q0.0"});
  EXPECT_EQ(provedFindings("A I 0.0;\n= M 0.0;\nAN I 0.0;\n= M 0.1;\nA M 0.0;\nA M 0.1;\n= Q 0.0;"),
            Said{"LOG001 Q0.0"});
  // 300 does not fit into a byte.
  EXPECT_EQ(provedFindings("L IB 0;\nL 300;\n>I;\nS Q 0.0;\nA I 1.0;\nR Q 0.0;"), Said{"LOG001 Q0.0"});
  EXPECT_EQ(provedFindings("L IB 0;\nL 200;\n>I;\n= Q 0.0;"), Said());
  EXPECT_EQ(provedFindings("A I 0.0;\nO I 0.1;\n= Q 0.0;"), Said());
  EXPECT_EQ(provedFindings("SET;\n= Q 0.0;\nCLR;\n= Q 0.1;"), Said());
  EXPECT_EQ(provedFindings("A I 0.0;\nL S5T#1S;\nSD T 1;\nA T 1;\n= Q 0.0;"), Said());
  EXPECT_EQ(provedFindings("A M 20.0;\nFP M 20.1;\n= Q 0.0;\nAN M 20.0;\n= M 20.0;"), Said());
  // MB0 to MB15 keep their values without power: the pulse may come in the first scan.
  EXPECT_EQ(provedFindings("A M 0.0;\nFP M 0.1;\n= Q 0.0;\nAN M 0.0;\n= M 0.0;"), Said{"SAF005 Q0.0"});
}

TEST(Step7SolverRules, PropertiesThatDoNotHold) {
  EXPECT_EQ(provedFindings("//@ prove apart: never Q0.0 and Q0.1\nA I 0.0;\n= Q 0.0;\nA I 0.1;\n= Q 0.1;"),
            Said{"SAF003"});
  EXPECT_EQ(provedFindings("//@ prove apart: never Q0.0 and Q0.1\nA I 0.0;\n= Q 0.0;\nA I 0.1;\nAN Q 0.0;\n= Q 0.1;"),
            Said());
  EXPECT_EQ(provedFindings("//@ prove stop: not I0.1 implies not Q0.0\nA I 0.0;\nO Q 0.0;\n= Q 0.0;"), Said{"SAF004"});
  EXPECT_EQ(
      provedFindings("//@ prove stop: not I0.1 implies not Q0.0\nA(;\nO I 0.0;\nO Q 0.0;\n);\nA I 0.1;\n= Q 0.0;"),
      Said());
  EXPECT_EQ(provedFindings("//@ prove follows: Q0.0 implies I0.0\nA I 0.0;\nO I 0.1;\n= Q 0.0;"), Said{"SAF001"});
}

}  // namespace
}  // namespace rungproof::test
