// A rule is one file: these rules are written down here and nowhere else, given to the prover beside the program, and
// asked and told like those of analysis/checks. If the runner had to know a rule by its id, they would stay silent.
#include <array>
#include <set>

#include "analysis/asking/asking.hpp"
#include "analysis/flow/facts.hpp"
#include "frontend/linting/solver_rules.hpp"
#include "proved_text.hpp"

namespace rungproof::test {
namespace {

/// Plain coils with the places that they write.
std::vector<std::pair<const Instruction*, Place>> coilsOf(Asking& asking) {
  std::vector<std::pair<const Instruction*, Place>> coils;
  for (const Instruction* coil : asking.executed()) {
    if (!isPlainCoil(*coil->desc)) continue;
    const Operand& bit = coil->operands[0];
    coils.emplace_back(coil, memoryPlace(bit.area, bit.offset, Width::Bit, bit.bit));
  }
  return coils;
}

void askOn(Asking& asking) {
  for (const auto& [coil, place] : coilsOf(asking)) {
    const std::string name = toString(coil->operands[0]);
    asking.ask({.name = name + " can be on",
                .message = name + " is never on",
                .address = name,
                .place = coil,
                .bad = asking.encoding().atEnd(place)});
  }
}
constexpr Rule neverOn = {.id = "OWN001",
                          .title = "Never on",
                          .severity = Severity::Note,
                          .needs = Needs::Solver,
                          .detects = "a coil that is never on",
                          .why = "for the test",
                          .ask = {.in = asked::Lint, .wantsYes = true, .program = askOn},
                          .tell = {.advice = "look at it"}};

void askFalls(Asking& asking) {
  for (const auto& [coil, place] : coilsOf(asking)) {
    const std::string name = toString(coil->operands[0]);
    const Graph::Bool before{asking.encoding().atStart(place)}, now{asking.encoding().atEnd(place)};
    asking.ask({.name = name + " can fall",
                .message = name + " never falls",
                .address = name,
                .place = coil,
                .bad = asking.graph().land(before, asking.graph().lnot(now)).node});
  }
}
constexpr Explanation deadCoil[] = {{"OWN001", Where::SameAddress}};
constexpr Rule neverFalls = {.id = "OWN002",
                             .title = "Never falls",
                             .severity = Severity::Warning,
                             .needs = Needs::Solver,
                             .detects = "a coil that never falls",
                             .why = "for the test",
                             .ask = {.in = asked::Lint, .wantsYes = true, .program = askFalls},
                             .tell = {.advice = "look at it"},
                             .explainedBy = deadCoil};

/// Every coil is a candidate.
void checkFirstScan(const Facts& facts, FindingSink& sink) {
  for (const InstructionPlace& place : facts.instructions()) {
    if (isPlainCoil(*place.instruction->desc)) sink.report(place.instruction->span, "may be on in the first scan");
  }
}
void askFirstScan(Asking& asking) {
  for (const auto& [coil, place] : coilsOf(asking)) {
    const Graph::Bool first{asking.encoding().firstScan()}, on{asking.encoding().atEnd(place)};
    asking.ask({.name = toString(coil->operands[0]) + " is on in the first scan",
                .message = "is on in the first scan",
                .place = coil,
                .bad = asking.graph().land(first, on).node});
  }
}
constexpr Rule onAtFirst = {.id = "OWN003",
                            .title = "On at first",
                            .needs = Needs::FlowThenSolver,
                            .detects = "a coil that is on in the first scan",
                            .why = "for the test",
                            .check = checkFirstScan,
                            .ask = {.in = asked::Lint, .onlySettles = true, .program = askFirstScan}};

constexpr Hazard divisions[] = {Hazard::DivideByZero};
constexpr Rule quotient = {
    .id = "OWN004",
    .title = "No quotient",
    .needs = Needs::Solver,
    .detects = "a division by zero",
    .why = "for the test",
    .ask = {.in = asked::Builtin, .turn = 1, .whenNone = "nothing divides", .hazards = divisions}};

std::optional<std::string> tellBroken(const ProofResult& result) {
  if (result.outcome != Outcome::Violated) return std::nullopt;
  return "broken: " + result.property.name;
}
constexpr Rule broken = {.id = "OWN005",
                         .title = "Broken",
                         .severity = Severity::Error,
                         .needs = Needs::Solver,
                         .detects = "a property that fails",
                         .why = "for the test",
                         .tell = {.property = tellBroken}};

constexpr std::array<const Rule*, 5> ownRules{&neverOn, &neverFalls, &onAtFirst, &quotient, &broken};

std::vector<Finding> foundIn(const ProgramInput& input) {
  const Facts facts(input.program, input.properties.externals);
  const RuleSettings settings;
  FindingSink sink(input.program, settings);
  for (const Rule* rule : ownRules) {
    sink.begin(*rule);
    if (rule->check != nullptr) rule->check(facts, sink);
  }
  std::vector<Finding> findings = sink.take();
  ProverOptions options = usualOptions(5);
  options.checks.rules = ownRules;
  settleBySolver(
      input, options, [](std::string_view) { return true; }, findings);
  return findings;
}
std::multiset<std::string> messagesOf(std::string_view rule, const std::vector<Finding>& findings) {
  std::multiset<std::string> messages;
  for (const Finding& finding : findings) {
    EXPECT_EQ(finding.confirmation, Confirmation::Confirmed) << finding.message;
    if (finding.rule == rule) messages.insert(finding.message + " in network " + std::to_string(finding.network));
  }
  return messages;
}
using Messages = std::multiset<std::string>;

// Q0.0 is never on, Q0.1 always, Q0.2 comes and goes; in the first scan Q0.1 is on and Q0.2 can be.
const char* const coils =
    "Network 1\nLD I0.0\nAN I0.0\n= Q0.0\nNetwork 2\nLD SM0.0\n= Q0.1\nNetwork 3\nLD I0.0\n= Q0.2\n";

TEST(OwnRule, IsAskedAndTold) {
  const ProgramInput input = inputOf("", coils);
  const std::vector<Finding> findings = foundIn(input);
  const auto found = std::ranges::find(findings, "OWN001", &Finding::rule);
  ASSERT_NE(found, findings.end());
  EXPECT_EQ(found->message, "Q0.0 is never on");
  EXPECT_EQ(found->severity, Severity::Note);
  EXPECT_EQ(found->address, "Q0.0");
  EXPECT_EQ(found->help, "proved for every run; look at it");
  EXPECT_EQ(std::ranges::count(findings, "OWN001", &Finding::rule), 1);
}

// What is never on never falls either; its rule names the answer that explains it.
TEST(OwnRule, SaysWhichAnswerExplainsIt) {
  const std::vector<Finding> findings = foundIn(inputOf("", coils));
  ASSERT_EQ(std::ranges::count(findings, "OWN002", &Finding::rule), 1);
  EXPECT_EQ(std::ranges::find(findings, "OWN002", &Finding::rule)->message, "Q0.1 never falls");
}

// Three candidates: the first is refuted, the others are confirmed in the words of the check.
TEST(OwnRule, SettlesItsCandidates) {
  EXPECT_EQ(messagesOf("OWN003", foundIn(inputOf("", coils))),
            (Messages{"may be on in the first scan in network 2", "may be on in the first scan in network 3"}));
}

TEST(OwnRule, AsksAboutHazards) {
  const auto asked = [](const std::string& networks) {
    const ProgramInput input = inputOf("", networks);
    ProverOptions options = usualOptions(5);
    options.checks = {.builtin = true, .rules = ownRules};
    return prove(input.program, input.properties, options).results;
  };
  const std::vector<ProofResult> none = asked(coils);
  ASSERT_EQ(none.size(), 1U);
  EXPECT_EQ(none[0].property.name, "nothing divides");
  EXPECT_EQ(none[0].outcome, Outcome::Proved);
  const std::vector<ProofResult> divided = asked("Network 1\nLD I0.0\n/I IW2, VW0\n");
  ASSERT_EQ(divided.size(), 1U);
  EXPECT_TRUE(divided[0].property.name.starts_with("/I IW2, VW0: never")) << divided[0].property.name;
  EXPECT_EQ(divided[0].outcome, Outcome::Violated);
}

TEST(OwnRule, TellsOfDeclaredProperties) {
  const std::vector<Finding> findings =
      foundIn(inputOf("//@ prove lamp: never Q0.2\n//@ prove dark: never Q0.0\n", coils));
  ASSERT_EQ(std::ranges::count(findings, "OWN005", &Finding::rule), 1);
  const auto found = std::ranges::find(findings, "OWN005", &Finding::rule);
  EXPECT_EQ(found->message, "broken: lamp");
  EXPECT_EQ(found->severity, Severity::Error);
}

}  // namespace
}  // namespace rungproof::test
