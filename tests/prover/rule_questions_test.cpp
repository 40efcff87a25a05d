// The rules that only the prover can answer: each on its own examples, and on programs in which a suspicion of the flow
// analysis is confirmed by a run or dismissed by a proof - in the main program, a subroutine and an interrupt routine.
#include <fmt/ranges.h>

#include <set>

#include "analysis/lint/lint.hpp"
#include "analysis/rule.hpp"
#include "frontend/linting/solver_rules.hpp"
#include "proved_text.hpp"

namespace rungproof::test {
namespace {

/// What lint --prove finds: the flow analysis settled by the prover.
std::vector<Finding> findingsOf(const ProgramInput& input) {
  const Facts facts(input.program, input.properties.externals);
  std::vector<Finding> findings = runRules(facts, RuleSelection(), {});
  settleBySolver(
      input, usualOptions(5), [](std::string_view) { return true; }, findings);
  return findings;
}
std::vector<Finding> findingsOf(const std::string& networks, const std::string& otherBlocks = "",
                                const std::string& properties = "") {
  return findingsOf(inputOf(properties, networks, otherBlocks));
}

/// The findings of one rule as "address at network".
std::multiset<std::string> of(std::string_view rule, const std::vector<Finding>& findings) {
  std::multiset<std::string> found;
  for (const Finding& finding : findings) {
    if (finding.rule == rule && finding.confirmation != Confirmation::Unconfirmed) found.insert(finding.address);
  }
  return found;
}
bool isSilent(std::string_view rule, const std::vector<Finding>& findings) {
  return std::none_of(findings.begin(), findings.end(), [&](const Finding& finding) { return finding.rule == rule; });
}
using Found = std::multiset<std::string>;

std::vector<const Rule*> solverRules() {
  std::vector<const Rule*> rules;
  for (const Rule* rule : allRules()) {
    if (rule->needs == Needs::Solver && !rule->bad.empty()) rules.push_back(rule);
  }
  return rules;
}

class SolverRule : public testing::TestWithParam<const Rule*> {};

std::vector<Finding> onExample(std::string_view example) {
  const std::size_t networks = example.find("Network");
  return findingsOf(std::string(example.substr(networks)), "", std::string(example.substr(0, networks)));
}

TEST_P(SolverRule, SpeaksOnTheBadExample) {
  const Rule& rule = *GetParam();
  const std::vector<Finding> findings = onExample(rule.bad);
  EXPECT_FALSE(of(rule.id, findings).empty()) << rule.bad;
  for (const Finding& finding : findings) {
    if (finding.rule != rule.id) continue;
    EXPECT_FALSE(finding.message.empty());
    EXPECT_FALSE(finding.help.empty()) << finding.message;
    EXPECT_GT(finding.span.length, 0U) << finding.message;
    EXPECT_EQ(finding.severity, rule.severity);
    EXPECT_EQ(finding.confirmation, Confirmation::Confirmed);
  }
}
TEST_P(SolverRule, IsSilentOnTheGoodExample) {
  EXPECT_TRUE(isSilent(GetParam()->id, onExample(GetParam()->good))) << GetParam()->good;
}

INSTANTIATE_TEST_SUITE_P(Rules, SolverRule, testing::ValuesIn(solverRules()),
                         [](const auto& info) { return std::string(info.param->id); });

TEST(SolverRules, AllOfTheCatalogueHaveExamples) {
  std::set<std::string_view> rules;
  for (const Rule* rule : solverRules()) rules.insert(rule->id);
  for (const char* id : {"LOG001", "LOG002", "LOG006", "SAF003", "SAF004", "SAF005", "SAF006", "SCR004", "OUT003",
                         "TIM008", "SAF001", "SAF002"})
    EXPECT_TRUE(rules.contains(id)) << id;
}

// ---- LOG ------------------------------------------------------------------------------------------------

TEST(AlwaysOrNever, NeedsReachableStates) {
  // M0.0 and M0.1 exclude each other in every reachable state, not in every state: only a proof can tell.
  const std::string step =
      "Network 1\nLD I0.0\nAN M0.1\nS M0.0, 1\nNetwork 2\nLD I0.1\nAN M0.0\nS M0.1, 1\nNetwork 3\nLD I0.2\nR M0.0, 2\n";
  EXPECT_EQ(of("LOG001", findingsOf(step + "Network 4\nLD M0.0\nA M0.1\n= Q0.0\n")), Found{"Q0.0"});
  EXPECT_TRUE(isSilent("LOG001", findingsOf(step + "Network 4\nLD M0.0\nAN M0.1\n= Q0.0\n")));
}

TEST(AlwaysOrNever, ComparesBytesWithoutSign) {
  // A byte is never negative and never above 255 (001:3384).
  EXPECT_EQ(of("LOG001", findingsOf("Network 1\nLDB>= IB0, 0\n= Q0.0\n")), Found{"Q0.0"});
  EXPECT_TRUE(isSilent("LOG001", findingsOf("Network 1\nLDW>= IW0, 0\n= Q0.0\n")));
}

TEST(AlwaysOrNever, SpeaksInSubroutinesAndInterruptRoutines) {
  const std::string call = "Network 1\nLD I0.7\nCALL SBR_0\n", attach = "Network 1\nLD SM0.1\nATCH INT_0, 0\nENI\n";
  const std::string dead = "BEGIN\nNetwork 1\nLD I0.0\nAN I0.0\n= Q0.0\n",
                    live = "BEGIN\nNetwork 1\nLD I0.0\nAN I0.1\n= Q0.0\n";
  EXPECT_EQ(of("LOG001", findingsOf(call, "SUBROUTINE_BLOCK SBR_0:SBR0\n" + dead + "END_SUBROUTINE_BLOCK\n")),
            Found{"Q0.0"});
  EXPECT_TRUE(isSilent("LOG001", findingsOf(call, "SUBROUTINE_BLOCK SBR_0:SBR0\n" + live + "END_SUBROUTINE_BLOCK\n")));
  EXPECT_EQ(of("LOG001", findingsOf(attach, "INTERRUPT_BLOCK INT_0:INT0\n" + dead + "END_INTERRUPT_BLOCK\n")),
            Found{"Q0.0"});
  EXPECT_TRUE(isSilent("LOG001", findingsOf(attach, "INTERRUPT_BLOCK INT_0:INT0\n" + live + "END_INTERRUPT_BLOCK\n")));
}

TEST(AlwaysOrNever, LeavesSpecialMemoryAlone) {
  EXPECT_TRUE(isSilent("LOG001", findingsOf("Network 1\nLD SM0.0\n= Q0.0\nNetwork 2\nLDN SM0.0\n= Q0.1\nNetwork 3\nLD "
                                            "I0.0\n= Q0.2\nLD SM0.0\nMOVB 1, VB0\n")));
}

TEST(IdleContact, IsFoundInSeriesParallelAndBranches) {
  EXPECT_EQ(of("LOG002", findingsOf("Network 1\nLD I0.0\nA I0.1\nO I0.0\n= Q0.0\n")),
            Found{"I0.1"});  // absorbed: a or (a and b) is a
  EXPECT_EQ(of("LOG002", findingsOf("Network 1\nLD I0.0\nLPS\nA I0.1\n= Q0.0\nLPP\nA I0.0\n= Q0.1\n")), Found{"I0.0"});
  EXPECT_EQ(of("LOG002", findingsOf("Network 1\nLD I0.0\nLD I0.1\nO I0.2\nALD\nLD I0.0\nA I0.3\nOLD\n= Q0.0\n")),
            Found{});
}

TEST(IdleContact, NeedsReachableStates) {
  // Q0.1 is on only where I0.0 is: in the second network I0.0 says nothing new. Without the first one it would.
  EXPECT_EQ(of("LOG002", findingsOf("Network 1\nLD I0.0\nA I0.1\n= M0.0\nNetwork 2\nLD M0.0\nA I0.0\n= Q0.1\n")),
            Found{"I0.0"});
  EXPECT_TRUE(
      isSilent("LOG002", findingsOf("Network 1\nLD I0.3\nA I0.1\n= M0.0\nNetwork 2\nLD M0.0\nA I0.0\n= Q0.1\n")));
}

TEST(IdleContact, MattersIfAnEdgeOrATimerSeesIt) {
  EXPECT_TRUE(isSilent("LOG002", findingsOf("Network 1\nLD I0.0\nA I0.1\nEU\n= Q0.0\nNetwork 2\nLD I0.2\nA I0.3\nTON "
                                            "T37, 10\nNetwork 3\nLD T37\n= Q0.1\n")));
}

TEST(Latch, WithResetThatIsNeverReached) {
  // M0.1 needs I0.1 and not I0.1, so the reset never comes.
  const std::vector<Finding> stuck =
      findingsOf("Network 1\nLD I0.0\nS Q0.0, 1\nNetwork 2\nLD I0.1\nAN I0.1\nR Q0.0, 1\n");
  EXPECT_EQ(of("LOG006", stuck), Found{"Q0.0"});
  EXPECT_TRUE(isSilent("LOG006", findingsOf("Network 1\nLD I0.0\nS Q0.0, 1\nNetwork 2\nLD I0.1\nR Q0.0, 1\n")));
}

TEST(Latch, OneThatIsOnWithinAScanOnlyDoesDropOut) {
  // Set by an edge and taken back behind its only reader: on within the scan, never at its end.
  const std::string blip = "Network 1\nLD I0.0\nEU\nS M0.1, 1\nNetwork 2\nLD M0.1\n= Q0.0\n";
  EXPECT_TRUE(isSilent("LOG006", findingsOf(blip + "Network 3\nLD M0.1\nR M0.1, 1\n")));
  EXPECT_TRUE(isSilent("LOG006", findingsOf(blip + "Network 3\nLD SM0.0\nR M0.1, 1\n")));
  // The reset needs I0.1 and not I0.1.
  EXPECT_EQ(of("LOG006", findingsOf(blip + "Network 3\nLD I0.1\nAN I0.1\nR M0.1, 1\n")), Found{"M0.1"});
}

TEST(Latch, OneThatNothingSwitchesOnIsNoLatchThatStays) {
  // V200.3 is never written: LOG001 says that the set never comes.
  const std::string reset = "Network 3\nLD I0.0\nR Q0.1, 1\n";
  for (const std::string set :
       {"Network 1\nLD V200.3\nS Q0.1, 1\n", "Network 1\nLD V200.3\nS Q0.1, 1\nLD V200.4\nS Q0.1, 1\n",
        "Network 1\nLD V200.3\nS Q0.0, 2\n"}) {
    EXPECT_TRUE(isSilent("LOG006", findingsOf(set + reset))) << set;
    EXPECT_FALSE(isSilent("LOG001", findingsOf(set + reset))) << set;
  }
  EXPECT_TRUE(isSilent("LOG006", findingsOf("Network 1\nLD V200.3\nO Q0.1\n= Q0.1\n")));
}

TEST(Latch, ARangeThatStaysIsNamedOnce) {
  // Q0.3 is reset by I0.5, the other three by nothing that can come to pass.
  const std::vector<Finding> stuck = findingsOf(
      "Network 1\nLD I0.0\nS Q0.0, 4\nNetwork 2\nLD I0.1\nAN I0.1\nR Q0.0, 4\nNetwork 3\nLD I0.5\nR Q0.3, 1\n");
  EXPECT_EQ(of("LOG006", stuck), Found{"Q0.0"});
  const auto finding = std::ranges::find(stuck, "LOG006", &Finding::rule);
  ASSERT_NE(finding, stuck.end());
  EXPECT_EQ(finding->message, "once on, Q0.0 to Q0.2 never go off again in any reachable state");
}

TEST(AlwaysOrNever, NamesEveryNetworkThatIsDead) {
  // V200.0 to V200.5 are never written; three networks share one of them, two are dead by a contradiction.
  std::string networks;
  for (int n = 0; n < 6; ++n) {
    const std::string number = std::to_string(n);
    networks += "Network " + std::to_string(n + 1) + "\nLD V200." + (n < 3 ? std::string("0") : number) + "\n= Q0." +
                number + "\n";
  }
  networks += "Network 7\nLD I0.0\nAN I0.0\n= Q1.0\n= Q1.1\nNetwork 8\nLD I0.1\nAN I0.1\n= Q1.2\n";
  EXPECT_EQ(of("LOG001", findingsOf(networks)),
            (Found{"Q0.0", "Q0.1", "Q0.2", "Q0.3", "Q0.4", "Q0.5", "Q1.0", "Q1.2"}));
  // Always on, in two networks.
  EXPECT_EQ(of("LOG001", findingsOf("Network 1\nLDB>= IB0, 0\n= Q0.0\nNetwork 2\nLDB>= IB0, 0\nS Q0.1, 1\nNetwork "
                                    "3\nLD I0.0\nR Q0.1, 1\n")),
            (Found{"Q0.0", "Q0.1"}));
}

// ---- Ranges ---------------------------------------------------------------------------------------------

/// "address: message" of the findings of a rule.
std::set<std::string> messages(std::string_view rule, const std::vector<Finding>& findings) {
  std::set<std::string> found;
  for (const Finding& finding : findings) {
    if (finding.rule == rule) found.insert(finding.address + ": " + finding.message);
  }
  return found;
}
using MessageSet = std::set<std::string>;

TEST(Conflict, NamesEachRangeOnce) {
  EXPECT_EQ(messages("OUT003", findingsOf("Network 1\nLD I0.0\nS Q0.2, 6\nNetwork 2\nLD I0.1\nR Q0.2, 6\nNetwork 3\nLD "
                                          "I0.2\nS M0.0, 4\nNetwork 4\nLD I0.3\nR M0.0, 5\n")),
            (MessageSet{"Q0.2: Q0.2 to Q0.7 are set and reset in one scan; R comes last and wins",
                        "M0.0: M0.0 to M0.3 are set and reset in one scan; R comes last and wins"}));
}

TEST(Conflict, OneBlockAgainstManySingleBits) {
  std::string sets;
  for (int n = 0; n < 4; ++n) {
    const std::string number = std::to_string(n);
    sets += "Network " + std::to_string(n + 1) + "\nLD I0." + number + "\nS M0." + number + ", 1\n";
  }
  const std::string reset = "Network 8\nLD I0.4\nR M0.0, 5\n";
  EXPECT_EQ(messages("OUT003", findingsOf(sets + reset)),
            MessageSet{"M0.0: M0.0 to M0.3 are set and reset in one scan; R comes last and wins"});
  EXPECT_EQ(messages("OUT003", findingsOf(reset + sets)),
            MessageSet{"M0.0: M0.0 to M0.3 are set and reset in one scan; S comes last and wins"});
  // M0.1 cannot be set while it is reset.
  EXPECT_EQ(
      messages("OUT003", findingsOf("Network 1\nLD I0.0\nS M0.0, 1\nNetwork 2\nLDN I0.4\nS M0.1, 1\nNetwork 3\nLD "
                                    "I0.2\nS M0.2, 1\n" +
                                    reset)),
      MessageSet{"M0.0: M0.0 and M0.2 are set and reset in one scan; R comes last and wins"});
}

TEST(Conflict, SeveralResetsOfOneBitKeepTheirPlaces) {
  const std::vector<Finding> findings =
      findingsOf("Network 1\nLD I0.0\nS Q0.0, 1\nNetwork 2\nLD I0.1\nR Q0.0, 1\nNetwork 3\nLD I0.2\nR Q0.0, 1\n");
  EXPECT_EQ(of("OUT003", findings), (Found{"Q0.0", "Q0.0"}));
}

/// "severity address" of what OUT003 says.
Found severities(const std::string& networks, const std::string& properties = "", const std::string& blocks = "") {
  Found found;
  for (const Finding& finding : findingsOf(networks, blocks, properties)) {
    if (finding.rule == "OUT003") found.insert(fmt::format("{} {}", severityName(finding.severity), finding.address));
  }
  return found;
}

/// A reset that comes last switches off whatever sets the bit: reset dominant, the safe order. A set that comes last
/// keeps the bit on against its reset.
TEST(Conflict, AResetThatComesLastIsANote) {
  const std::string set = "Network 1\nLD I0.0\nS Q0.0, 1\n", reset = "Network 2\nLD I0.1\nR Q0.0, 1\n",
                    coil = "Network 3\nLD I0.2\n= Q0.0\n";
  EXPECT_EQ(severities(set + reset), Found{"note Q0.0"});
  EXPECT_EQ(severities(reset + set), Found{"warning Q0.0"});
  EXPECT_EQ(severities(coil + reset), Found{"note Q0.0"});
  EXPECT_EQ(severities(reset + coil), Found{"warning Q0.0"});
  // An interrupt comes anywhere in a scan: its reset need not be the last word.
  const std::string attach = "Network 5\nLD SM0.1\nATCH 0, 0\nENI\n",
                    interrupt =
                        "INTERRUPT_BLOCK INT_0:INT0\nBEGIN\nNetwork 1\nLD SM0.0\nR Q0.0, 1\nEND_INTERRUPT_BLOCK\n";
  for (const std::string& said : severities(set + attach, "", interrupt)) EXPECT_EQ(said, "warning Q0.0");
}

/// Stated: a reset that comes last says nothing any more; a set that comes last contradicts the statement. Other bits
/// are not meant.
TEST(Conflict, ResetDominantCanBeStated) {
  const std::string set = "Network 1\nLD I0.0\nS Q0.0, 2\n", reset = "Network 2\nLD I0.1\nR Q0.0, 2\n";
  EXPECT_EQ(severities(set + reset, "//@ reset dominant Q0.0, Q0.1\n"), Found());
  EXPECT_EQ(severities(set + reset, "//@ reset dominant Q0.0\n"), Found{"note Q0.1"});
  EXPECT_EQ(severities(reset + set, "//@ reset dominant Q0.0, Q0.1\n"), Found{"warning Q0.0"});
}

/// `count` sets and as many resets of a bit, each while IB0 is another number: never two in one scan.
std::string apartWriters(int count) {
  std::string text;
  for (int i = 0; i < 2 * count; ++i)
    text += fmt::format("Network {}\nLDB= IB0, {}\n{} Q0.0, 1\n", i + 1, i, i < count ? "S" : "R");
  return text;
}

/// A bit with many writers is asked about once for each of them, not for each pair: the answers are the same.
TEST(Conflict, ManyWritersOfOneBit) {
  const std::string reset = "Network 90\nLDB= IB0, 3\nR Q0.0, 1\n", set = "Network 91\nLDB= IB0, 45\nS Q0.0, 1\n";
  EXPECT_EQ(severities(apartWriters(40)), Found());
  EXPECT_EQ(severities(apartWriters(40) + reset), Found{"note Q0.0"});
  EXPECT_EQ(severities(apartWriters(40) + set), Found{"warning Q0.0"});
  EXPECT_EQ(severities(apartWriters(40) + reset + set), (Found{"note Q0.0", "warning Q0.0"}));
  EXPECT_EQ(severities(apartWriters(40) + reset, "//@ reset dominant Q0.0\n"), Found());
  EXPECT_EQ(severities(apartWriters(40) + set, "//@ reset dominant Q0.0\n"), Found{"warning Q0.0"});
  // A reset of several bits switches a coil off in general; the sets in front of it are still asked about.
  const std::string coil = "Network 92\nLDB= IB0, 100\n= Q1.0\n", row = "Network 93\nLDB= IB0, 100\nR Q1.0, 2\n";
  std::string others;
  for (int i = 0; i < 20; ++i) others += fmt::format("Network {}\nLDB= IB0, {}\nR Q1.0, 1\n", 100 + i, i);
  EXPECT_EQ(severities(coil + row + "Network 94\nLDB= IB0, 101\nR Q1.0, 1\n"), Found());
  EXPECT_EQ(severities(coil + row + others), Found());
  EXPECT_EQ(severities("Network 95\nLDB= IB0, 100\nS Q1.0, 1\n" + row + others), Found{"note Q1.0"});
  ProgramInput input = inputOf("", apartWriters(200), "");
  ProverOptions options = usualOptions();
  options.checks.builtin = true;
  std::size_t asked = 0;
  for (const ProofResult& result : prove(input.program, input.properties, options).results)
    asked += result.builtin && result.builtin->rule->id == "OUT003" ? 1 : 0;
  EXPECT_LE(asked, 800U) << "one or two for each of 400 writers, not for each of 40,000 pairs";
}

TEST(Conflict, ASwitchOffBehindTheCoilsIsMeant) {
  const std::string coils = "Network 1\nLD I0.0\n= Q0.1\nNetwork 2\nLD I0.1\n= Q0.2\n",
                    off = "Network 3\nLDN I1.0\nR Q0.0, 8\n";
  const std::vector<Finding> last = findingsOf(coils + off);
  EXPECT_TRUE(isSilent("OUT003", last));
  EXPECT_TRUE(isSilent("OUT005", last));
  EXPECT_EQ(messages("OUT003", findingsOf(off + coils)),
            MessageSet{"Q0.1: Q0.1 to Q0.2 are set and reset in one scan; = comes last and wins"});
}

TEST(PowerUp, NamesARangeOnce) {
  EXPECT_EQ(
      messages("SAF005", findingsOf("Network 1\nLD I0.0\nS M14.0, 1\nNetwork 2\nLD I0.1\nR M14.0, 1\nNetwork "
                                    "3\nLD M14.0\nS Q0.0, 4\nNetwork 4\nLDN M14.0\nR Q0.0, 4\n")),
      MessageSet{"Q0.0: Q0.0 to Q0.3 can be on at the end of the first scan because of what retentive memory holds"});
}

// ---- Suspicions of the flow analysis --------------------------------------------------------------------

TEST(Suspicion, DoubleCoilInRoutinesThatExcludeEachOther) {
  const std::string blocks =
      "SUBROUTINE_BLOCK SBR_0:SBR0\nBEGIN\nNetwork 1\nLD I0.1\n= Q0.0\nEND_SUBROUTINE_BLOCK\n"
      "SUBROUTINE_BLOCK SBR_1:SBR1\nBEGIN\nNetwork 1\nLD I0.2\n= Q0.0\nEND_SUBROUTINE_BLOCK\n";
  EXPECT_TRUE(
      isSilent("OUT001", findingsOf("Network 1\nLD I0.0\nCALL SBR_0\nNetwork 2\nLDN I0.0\nCALL SBR_1\n", blocks)));
  EXPECT_EQ(of("OUT001", findingsOf("Network 1\nLD I0.0\nCALL SBR_0\nNetwork 2\nLD I0.3\nCALL SBR_1\n", blocks)),
            Found{"Q0.0"});
}

TEST(Suspicion, BitThatTogglesWhileAContactHolds) {
  EXPECT_EQ(of("LOG005", findingsOf("Network 1\nLD I0.0\nAN M0.0\n= M0.0\nNetwork 2\nLD M0.0\n= Q0.0\n")),
            Found{"M0.0"});
  // The other contacts exclude each other.
  EXPECT_TRUE(
      isSilent("LOG005", findingsOf("Network 1\nLD I0.0\nAN I0.0\nAN M0.0\n= M0.0\nNetwork 2\nLD M0.0\n= Q0.0\n")));
}

TEST(Suspicion, BoxThatRunsWhileItsConditionHolds) {
  const std::string table = "Network 1\nLD SM0.1\nMOVW +10, VW200\n";
  EXPECT_EQ(of("HSP004", findingsOf(table + "Network 2\nLD I0.0\nATT VW0, VW200\n")).size(), 1U);
  // M0.0 is taken back by the next network, so that it is never 1 in two scans in a row.
  const std::string once =
      "Network 2\nLD I0.0\nAN M0.1\n= M0.0\nNetwork 3\nLD I0.0\n= M0.1\nNetwork 4\nLD M0.0\nATT VW0, VW200\n";
  EXPECT_TRUE(isSilent("HSP004", findingsOf(table + once)));
}

TEST(Suspicion, TimerBehindAReturnThatNeverComes) {
  const auto block = [](const std::string& condition) {
    return findingsOf("Network 1\nLD SM0.0\nCALL SBR_0\nNetwork 2\nLD T37\n= Q0.0\n",
                      "SUBROUTINE_BLOCK SBR_0:SBR0\nBEGIN\nNetwork 1\n" + condition +
                          "CRET\nNetwork 2\nLD I0.1\nTON T37, 10\nLD I0.3\n= Q0.5\nEND_SUBROUTINE_BLOCK\n");
  };
  // V200.3 is never written; M0.0 and M0.1 exclude each other.
  for (const char* never : {"LD V200.3\n", "LD I0.2\nAN I0.2\n"}) {
    EXPECT_TRUE(isSilent("TIM004", block(never))) << never;
    EXPECT_TRUE(isSilent("OUT007", block(never))) << never;
  }
  EXPECT_EQ(of("TIM004", block("LD I0.2\n")), Found{"T37"});
  EXPECT_FALSE(isSilent("OUT007", block("LD I0.2\n")));
}

TEST(Suspicion, TimerBehindAJumpOrACall) {
  const std::string timer = "Network 2\nLD I0.1\nTON T37, 10\nNetwork 3\nLBL 1\nNetwork 4\nLD T37\n= Q0.0\n";
  EXPECT_TRUE(isSilent("TIM004", findingsOf("Network 1\nLD I0.0\nAN I0.0\nJMP 1\n" + timer)));
  EXPECT_EQ(of("TIM004", findingsOf("Network 1\nLD I0.0\nJMP 1\n" + timer)), Found{"T37"});
  const std::string block =
      "SUBROUTINE_BLOCK SBR_0:SBR0\nBEGIN\nNetwork 1\nLD I0.1\nTON T37, 10\nEND_SUBROUTINE_BLOCK\n";
  const std::string reads = "Network 4\nLD T37\n= Q0.0\n";
  // The call comes in every scan: I0.0 or not I0.0.
  EXPECT_TRUE(isSilent("TIM004", findingsOf("Network 1\nLD I0.0\nON I0.0\nCALL SBR_0\n" + reads, block)));
  EXPECT_EQ(of("TIM004", findingsOf("Network 1\nLD I0.0\nCALL SBR_0\n" + reads, block)), Found{"T37"});
}

// Of two boxes the one that may be left out is the one to look at.
TEST(Suspicion, OfTwoBoxesTheOneThatIsLeftOut) {
  const std::string box = "TON T37, 10\n", reads = "Network 8\nLD T37\n= Q0.0\n";
  const std::string runs = "LD I0.0\n" + box, skipped = "LD I0.2\nJMP 1\nLD I0.1\n" + box + "LBL 1\n";
  // TIM001 speaks at the second box: whether TIM004 speaks there, too, and nowhere else.
  const auto isAtSecond = [&](const std::string& first, const std::string& second) {
    const std::vector<Finding> findings = findingsOf("Network 1\n" + first + "Network 2\n" + second + reads);
    std::vector<std::uint32_t> slow, twice;
    for (const Finding& finding : findings) {
      if (finding.rule == "TIM004") slow.push_back(finding.span.offset);
      if (finding.rule == "TIM001") twice.push_back(finding.span.offset);
    }
    EXPECT_EQ(slow.size(), 1U);
    return slow == twice;
  };
  EXPECT_TRUE(isAtSecond(runs, skipped));
  EXPECT_FALSE(isAtSecond(skipped, runs));
  EXPECT_TRUE(isAtSecond(runs, "LD I0.1\n" + box)) << "both run in every scan: the second counts the time twice";
}

TEST(Course, NetworkBehindAJumpThatIsAlwaysTaken) {
  const std::string exclusive =
      "Network 1\nLD I0.0\n= M0.0\nNetwork 2\nLD I0.0\nO M0.0\nON M0.0\nJMP 1\nNetwork 3\nLD I0.2\n= Q0.0\nNetwork "
      "4\nLBL 1\n";
  EXPECT_EQ(of("CTL005", findingsOf(exclusive)).size(), 1U);
  EXPECT_TRUE(
      isSilent("CTL005", findingsOf("Network 1\nLD I0.0\nJMP 1\nNetwork 2\nLD I0.2\n= Q0.0\nNetwork 3\nLBL 1\n")));
}

TEST(Course, CounterThatIsHeldOrNeverCounts) {
  EXPECT_EQ(of("TIM012", findingsOf("Network 1\nLD I0.0\nLD I0.1\nON I0.1\nCTU C1, 10\nNetwork 2\nLD C1\n= Q0.0\n")),
            Found{"C1"});
  EXPECT_EQ(of("TIM012", findingsOf("Network 1\nLD I0.0\nAN I0.0\nLD I0.1\nCTU C1, 10\nNetwork 2\nLD C1\n= Q0.0\n")),
            Found{"C1"});
  EXPECT_TRUE(isSilent("TIM012", findingsOf("Network 1\nLD I0.0\nLD I0.1\nCTU C1, 10\nNetwork 2\nLD C1\n= Q0.0\n")));
}

TEST(Course, StepWhoseTransitionNeverComes) {
  const auto chain = [](const std::string& condition) {
    return "Network 1\nLD SM0.1\nS S0.0, 1\nNetwork 2\nLSCR S0.0\nNetwork 3\nLD I0.0\nSCRT S0.1\nNetwork "
           "4\nSCRE\nNetwork 5\nLSCR S0.1\nNetwork 6\n" +
           condition + "SCRT S0.0\nNetwork 7\nSCRE\n";
  };
  EXPECT_EQ(of("SCR003", findingsOf(chain("LD I0.1\nAN I0.1\n"))), Found{"S0.1"});
  EXPECT_TRUE(isSilent("SCR003", findingsOf(chain("LD I0.1\n"))));
}

TEST(Course, StepsOfOneChainByASetFromOutside) {
  const std::string chain =
      "Network 1\nLD SM0.1\nS S0.0, 1\nNetwork 2\nLSCR S0.0\nNetwork 3\nLD I0.0\nSCRT S0.1\nNetwork 4\nSCRE\nNetwork "
      "5\nLSCR S0.1\nNetwork 6\nLD I0.1\nSCRT S0.0\nNetwork 7\nSCRE\n";
  EXPECT_TRUE(isSilent("SCR004", findingsOf(chain)));
  EXPECT_EQ(of("SCR004", findingsOf(chain + "Network 8\nLD I0.5\nS S0.0, 1\n")).size(), 1U);
  EXPECT_TRUE(isSilent("SCR004", findingsOf(chain + "Network 8\nLD I0.5\nR S0.0, 2\nS S0.0, 1\n")));
}

TEST(Course, OneRungForBothTransitionsIsMeant) {
  // The manual's way to divide a sequence (001:5848-5860).
  EXPECT_TRUE(
      isSilent("SCR004", findingsOf("Network 1\nLD SM0.1\nS S0.0, 1\nNetwork 2\nLSCR S0.0\nNetwork 3\nLD I0.0\nSCRT "
                                    "S0.1\nSCRT S0.2\nNetwork 4\nSCRE\n"
                                    "Network 5\nLSCR S0.1\nNetwork 6\nLD I0.1\nSCRT S0.0\nNetwork 7\nSCRE\nNetwork "
                                    "8\nLSCR S0.2\nNetwork 9\nLD I0.2\nSCRT S0.3\nNetwork 10\nSCRE\n")));
}

// ---- OUT ------------------------------------------------------------------------------------------------

TEST(SeveralBlocks, OneAtATimeIsProvedWhereTheTextLeavesItOpen) {
  const std::string block =
      "SUBROUTINE_BLOCK SBR_{0}:SBR{0}\nBEGIN\nNetwork 1\nLD I1.{0}\n= Q0.2\nEND_SUBROUTINE_BLOCK\n";
  const std::string two = fmt::format(fmt::runtime(block), 0) + fmt::format(fmt::runtime(block), 1);
  const std::string calls = "Network 8\nLD M1.0\nCALL SBR0\nNetwork 9\nLD M1.1\nCALL SBR1\n";
  // Of two flags each resets the other; without the resets both may be on.
  EXPECT_TRUE(isSilent("OUT006", findingsOf("Network 1\nLD I0.0\nS M1.0, 1\nR M1.1, 1\nNetwork 2\nLD I0.1\nS M1.1, "
                                            "1\nR M1.0, 1\n" +
                                                calls,
                                            two)));
  EXPECT_EQ(of("OUT006", findingsOf("Network 1\nLD I0.0\nS M1.0, 1\nNetwork 2\nLD I0.1\nS M1.1, 1\nR M1.0, 1\nNetwork "
                                    "3\nLD I0.2\nR M1.1, 1\nS M1.0, 1\nNetwork 4\nLD I0.0\nS M1.1, 1\n" +
                                        calls,
                                    two)),
            Found{"Q0.2"});
}

// ---- SAF ------------------------------------------------------------------------------------------------

TEST(PowerUp, AStartButtonThatIsHeldIsNoOldMemory) {
  EXPECT_TRUE(isSilent("SAF005", findingsOf("Network 1\nLD I0.0\nO Q0.0\nA I0.1\n= Q0.0\n")));
  // M13.0 is not retentive, M14.0 is (001:1619).
  const auto kept = [](const std::string& bit) {
    return "Network 1\nLD I0.0\nO " + bit + "\nA I0.1\n= " + bit + "\nNetwork 2\nLD " + bit + "\n= Q0.0\n";
  };
  EXPECT_TRUE(isSilent("SAF005", findingsOf(kept("M13.0"))));
  EXPECT_EQ(of("SAF005", findingsOf(kept("M14.0"))), Found{"Q0.0"});
}

TEST(Restart, AStartButtonThatIsHeldIsACommand) {
  const std::string stop = "//@ prove stop: not I0.1 implies not Q0.0\n";
  EXPECT_TRUE(isSilent("SAF006", findingsOf("Network 1\nLD I0.0\nO Q0.0\nA I0.1\n= Q0.0\n", "", stop)));
  EXPECT_TRUE(isSilent("SAF006", findingsOf("Network 1\nLD I0.0\nEU\nO Q0.0\nA I0.1\n= Q0.0\n", "", stop)));
  // The same latch behind the stop instead of in front of it.
  EXPECT_EQ(of("SAF006", findingsOf("Network 1\nLD I0.0\nO M0.0\nAN I0.2\n= M0.0\nNetwork 2\nLD M0.0\nA I0.1\n= Q0.0\n",
                                    "", stop)),
            Found{"Q0.0"});
}

TEST(SafetyShape, IsReadFromTheStatement) {
  const auto rule = [](const std::string& statement) {
    const ProgramInput input = inputOf("//@ prove p: " + statement + "\n", "Network 1\nLD I0.0\n= Q0.0\n");
    return input.properties.properties.empty() ? std::string_view("none")
                                               : ruleOfViolation(input.properties.properties[0])->id;
  };
  EXPECT_EQ(rule("never Q0.0 and Q0.1"), "SAF003");
  EXPECT_EQ(rule("not (Q0.0 and Q0.1)"), "SAF003");
  EXPECT_EQ(rule("never Q0.0 and M0.1"), "SAF001");
  EXPECT_EQ(rule("not I0.0 implies not Q0.0"), "SAF004");
  EXPECT_EQ(rule("I0.0 or not I0.1 implies not (Q0.0 or Q0.1)"), "SAF004");
  EXPECT_EQ(rule("not I0.0 implies not Q0.0 and not Q0.1"), "SAF004");
  EXPECT_EQ(rule("M0.0 implies not Q0.0"), "SAF001");
  EXPECT_EQ(rule("not I0.0 implies Q0.0"), "SAF001");
}

// A request of a library must be started by a pulse: the coil of its first input is asked for two scans in a row.
TEST(SolverRules, StartsOfLibraryRequestsAreSettled) {
  const std::string call = "Network 9\nLD SM0.0\nCALL USS_RPM_W, M3.0, 0, 3, 0, &VB100, M0.1, VB10, VW12\n";
  // M5.0 does not depend on the request: I0.0 and I0.4 held on start it in every scan from the second on.
  EXPECT_EQ(of("LIB002", findingsOf("Network 1\nLD I0.0\nA M5.0\n= M3.0\nNetwork 3\nLD I0.4\n= M5.0\n" + call)),
            Found{"M3.0"});
  // M4.0 holds itself from the scan of the start until I0.0 goes: M3.0 is on for one scan only.
  EXPECT_TRUE(isSilent("LIB002", findingsOf("Network 1\nLD I0.0\nAN M4.0\n= M3.0\nNetwork 2\nLD M3.0\nO M4.0\nA I0.0\n"
                                            "= M4.0\n" +
                                            call)));
}

}  // namespace
}  // namespace rungproof::test
