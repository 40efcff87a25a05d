// The encoding that certificates are about is told how to go on: which conditions have a value, where pointers lead,
// what interrupt routines leave. Each of these is an obligation. Here they are told wrong, one by one: the check and a
// second solver refuse, and no verdict is PROVED.
#include <gtest/gtest.h>

#include <cstdlib>
#include <memory>

#include "analysis/encoding/routine_effects.hpp"
#include "analysis/encoding/trail.hpp"
#include "analysis/proof/as_written.hpp"
#include "tests/corpus/command_output.hpp"
#include "tests/corpus/corpus_program.hpp"
#include "tests/prover/proved_text.hpp"
#include "tests/temporary_folder.hpp"

namespace rungproof::test {
namespace {

using Planted = std::map<std::size_t, std::optional<std::uint64_t>>;

/// A program as it is written, along a trail with these mistakes.
struct Told {
  Told(const ProgramInput& input, Planted planted, std::shared_ptr<const RoutineEffects> effects = nullptr)
      : trail(std::make_shared<Trail>()) {
    trail->decisions.planted = std::move(planted);
    trail->effects = std::move(effects);
    const std::vector<Property> goals = goalsOf(input.properties);
    EncoderOptions encoding = encoderOptionsOf(usualOptions());
    encoding.trail = trail;
    simplified = std::make_unique<QuestionSystem>(input.program, input.properties, goals, encoding, CheckGroups{});
    trail->isFollowed = true;
    try {
      written = std::make_unique<AsWritten>(
          *simplified,
          std::make_unique<QuestionSystem>(input.program, input.properties, goals, encoding, CheckGroups{}));
    } catch (const DecisionsDiverge&) {
    }
  }
  /// Whether the check lets it pass; another way that cannot be gone does not.
  bool passes() { return written != nullptr && written->told().check({}) == CheckResult::Valid; }

  std::shared_ptr<Trail> trail;
  std::unique_ptr<QuestionSystem> simplified;
  std::unique_ptr<AsWritten> written;
};

std::size_t parts(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

/// Obligations that cvc5 refutes, of all.
std::pair<std::size_t, std::size_t> refutedByCvc5(const std::string& text) {
  const TemporaryFolder folder;
  const std::string answer =
      outputOf("cvc5 --incremental --lang smt2 '" + folder.file("told.smt2", text) + "' 2>/dev/null");
  return {parts(answer, "unsat\n"), parts(text, "(check-sat)")};
}

ProofRun provedAlong(const ProgramInput& input, Planted planted, std::shared_ptr<const RoutineEffects> effects) {
  ProverOptions options = usualOptions();
  options.certificates = true;
  options.usesCone = false;  // decisions are counted over the whole program
  options.planted = std::make_shared<Trail>();
  options.planted->decisions.planted = std::move(planted);
  options.planted->effects = std::move(effects);
  return prove(input.program, input.properties, options);
}

void expectRefused(const ProgramInput& input, const Planted& planted, const std::string& what,
                   const std::shared_ptr<const RoutineEffects>& effects = nullptr) {
  Told told(input, planted, effects);
  ASSERT_NE(told.written, nullptr) << "the mistake is noticed earlier, by another way through the program";
  EXPECT_EQ(told.written->told().check({}), CheckResult::Invalid);
  EXPECT_EQ(told.written->told().reason(), what);
  const auto [refuted, all] = refutedByCvc5(told.written->told().text());
  EXPECT_EQ(refuted + 1, all);
  const ProofRun run = provedAlong(input, planted, effects);
  ASSERT_EQ(run.results.size(), 1U);
  EXPECT_EQ(run.results[0].outcome, Outcome::Unknown);
  EXPECT_TRUE(run.results[0].certificate.empty());
  EXPECT_NE(run.results[0].notes.back().find("fails for " + what), std::string::npos) << run.results[0].notes.back();
}

void expectShown(const ProgramInput& input, const char* obligation) {
  Told told(input, {});
  EXPECT_TRUE(told.passes()) << told.written->told().reason();
  const ProofRun run = provedAlong(input, {}, nullptr);
  ASSERT_EQ(run.results.size(), 1U);
  ASSERT_EQ(run.results[0].outcome, Outcome::Proved);
  const std::string& text = run.results[0].certificate;
  EXPECT_EQ(parts(text, std::string("; ") + obligation), 1U) << text;
  const auto [refuted, all] = refutedByCvc5(text);
  EXPECT_EQ(refuted, all);
}

/// The first decision of that kind with that answer.
std::size_t decisionOf(const ProgramInput& input, Decisions::Kind kind, std::optional<std::uint64_t> answer) {
  const Told told(input, {});
  const std::vector<Decisions::One>& made = told.trail->decisions.made;
  for (std::size_t i = 0; i < made.size(); ++i) {
    if (made[i].kind == kind && made[i].answer == answer) return i;
  }
  ADD_FAILURE() << "no such decision";
  return 0;
}

// M0.0 is 0 at its first read and 1 at no other: the jump's condition is I0.0 and not I0.0, which simplification knows.
const char* const conditions =
    "//@ prove exclude: never Q0.0 and Q0.1\nLD I0.0\nAN I0.0\nJMP 1\nLD I0.1\nAN I0.2\n= Q0.0\nLBL 1\n"
    "LD I0.2\nAN I0.1\n= Q0.1\n";
// Two places that the pointer reaches. Both are written only through it.
const char* const pointers =
    "//@ prove exclude: never Q0.0 and Q0.1\nLD SM0.0\nMOVD &VB100, VD0\nLD I0.0\nMOVD &VB102, VD0\nLD I0.3\nMOVW 7, "
    "*VD0\nLDW= VW102, 7\nA I0.1\nAN I0.2\n= Q0.0\nLD I0.2\nAN I0.1\n= Q0.1\n";
// Two routines that count, as long as an input brings them.
const char* const interrupts =
    "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1 //@ prove exclude: never Q0.0 and Q0.1\nLD SM0.1\nATCH INT_0, 0\n"
    "ATCH INT_1, 2\nENI\nNetwork 2\nLDB> VB20, 3\nA I0.1\nAN I0.2\n= Q0.0\nNetwork 3\nLDB> VB21, 3\nA I0.2\nAN I0.1\n"
    "= Q0.1\nEND_ORGANIZATION_BLOCK\nINTERRUPT_BLOCK INT_0:INT0\nBEGIN\nNetwork 1\nLDB< VB20, 200\nINCB VB20\n"
    "END_INTERRUPT_BLOCK\nINTERRUPT_BLOCK INT_1:INT1\nBEGIN\nNetwork 1\nLDB< VB21, 200\nINCB VB21\n"
    "END_INTERRUPT_BLOCK\n";

TEST(ToldFacts, AConditionWithTheWrongValueIsRefused) {
  const ProgramInput input = inputOfSource(conditions);
  expectShown(input, "known conditions");
  // I0.1 and not I0.2 is not known: a write of its outcome is told to happen never.
  const Told told(input, {});
  std::size_t refused = 0;
  const std::vector<Decisions::One>& made = told.trail->decisions.made;
  for (std::size_t i = 0; i < made.size(); ++i) {
    if (made[i].kind != Decisions::Kind::Value) continue;
    // Of two values one is wrong; of one that was found the other.
    std::size_t passed = made[i].answer ? 1 : 0;
    for (const std::uint64_t value : {0U, 1U}) {
      if (made[i].answer == value) continue;
      Told other(input, {{i, value}});
      const bool passes = other.passes();
      passed += passes ? 1 : 0;
      refused += passes ? 0 : 1;
    }
    EXPECT_LE(passed, 1U) << "decision " << i << " of " << made.size();
  }
  EXPECT_GE(refused, made.size());
  expectRefused(input, {{decisionOf(input, Decisions::Kind::Value, std::nullopt), 0}}, "known conditions");
}

// Event 26 is the end of a transmission that nothing starts: the port is never busy. That rests on a queue which stays
// empty, a cell that is no constant of the program; the engines find it.
TEST(ToldFacts, ConditionsOfDevicesAreShown) {
  const ProgramInput input = inputOfSource(
      "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1 //@ prove quiet: never M0.0\nLD SM0.1\nATCH INT_0, 26\nENI\n"
      "END_ORGANIZATION_BLOCK\nINTERRUPT_BLOCK INT_0:INT0\nBEGIN\nNetwork 1\nLD SM0.0\nS M0.0, 1\n"
      "END_INTERRUPT_BLOCK\n");
  const ProofRun run = provedAlong(input, {}, nullptr);
  ASSERT_EQ(run.results.size(), 1U);
  ASSERT_EQ(run.results[0].outcome, Outcome::Proved);
  const std::string& text = run.results[0].certificate;
  EXPECT_GE(parts(text, "what the encoding was told, known conditions"), 1U) << text;
  const auto [refuted, all] = refutedByCvc5(text);
  EXPECT_EQ(refuted, all);
}

// MD0 is written nowhere, so that the logarithm of it is the one of 0, which is no number; that is known of it alone.
TEST(ToldFacts, FunctionsOfKnownArguments) {
  for (const char* function : {"LN", "EXP", "SIN", "COS", "TAN"})
    expectShown(inputOfSource(std::string("//@ prove exclude: never Q0.0 and Q0.1\nLD I0.0\n") + function +
                              " MD0, MD8\nLD I0.1\nAN I0.2\n= Q0.0\nLD I0.2\nAN I0.1\n= Q0.1\n"),
                "known conditions");
}

TEST(ToldFacts, AMissingTargetOfAPointerIsRefused) {
  const ProgramInput input = inputOfSource(pointers);
  expectShown(input, "targets of pointers");
  expectRefused(input, {{decisionOf(input, Decisions::Kind::Targets, 2), 1}}, "targets of pointers");
}

TEST(ToldFacts, AMissingEffectOfARoutineIsRefused) {
  const ProgramInput input = inputOfSource(interrupts);
  expectShown(input, "effects of interrupt routines");
  const Plan plan(input.program, {});
  MemoryLayout layout(plan);
  layout.add(input.program, plan);
  for (const std::uint32_t byte : {20U, 21U}) {
    const auto effects = std::make_shared<RoutineEffects>(plan, layout, RoutineEffects::Given{.routines = {0, 1}});
    effects->forget(memoryPlace(Area::V, byte, Width::Byte));
    expectRefused(input, {}, "effects of interrupt routines", effects);
  }
}

// Of every third program; RUNGPROOF_EVERY_CERTIFICATE=1: of all.
TEST(ToldFacts, WhatTheCorpusIsToldHolds) {
  const bool takesAll = std::getenv("RUNGPROOF_EVERY_CERTIFICATE") != nullptr;
  std::size_t told = 0, programs = 0;
  for (const std::filesystem::path& path : corpusFiles()) {
    if (programs++ % 3 != 0 && !takesAll) continue;
    const ProgramInput input = corpusInput(path);
    if (hasReadErrors(input.program)) continue;
    Told encoded(input, {});
    if (encoded.written == nullptr) continue;
    // A PID loop may take longer than the check has on a busy machine; nothing is refused.
    EXPECT_NE(encoded.written->told().check({}), CheckResult::Invalid)
        << path << ": " << encoded.written->told().reason();
    told += encoded.passes() && !encoded.written->told().text().empty() ? 1 : 0;
  }
  EXPECT_GE(told, takesAll ? 90U : 30U);
}

}  // namespace
}  // namespace rungproof::test
