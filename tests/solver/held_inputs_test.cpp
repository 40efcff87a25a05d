// Runs with held inputs find what needs thousands of equal scans, and give up where nothing of the kind exists.
#include <gtest/gtest.h>

#include "analysis/bits/bit_arithmetic.hpp"
#include "analysis/bits/bit_unrolling.hpp"
#include "analysis/bits/engine_contract.hpp"

namespace rungproof {
namespace {

constexpr int width = 15;

/// A word that is counted up in scans with `steps`; bad: it stands at `end`.
void addCounter(BitSystem& system, Lit steps, const LitVector& word, std::uint64_t end) {
  BitArithmetic arithmetic(system);
  const LitVector more = arithmetic.add(word, BitArithmetic::constant(1, width));
  for (int bit = 0; bit < width; ++bit) {
    const auto i = static_cast<std::size_t>(bit);
    system.setNext(word[i], system.addIte(steps, more[i], word[i]));
  }
  system.bads.push_back(arithmetic.equal(word, BitArithmetic::constant(end, width)));
}

LitVector newWord(BitSystem& system) {
  LitVector word;
  for (int bit = 0; bit < width; ++bit) word.push_back(system.addLatch("n", LatchInit::Zero));
  return word;
}

/// A byte of inputs with the value 16#A5: one choice in 256.
Lit isCode(BitSystem& system) {
  LitVector code;
  for (int bit = 0; bit < 8; ++bit) code.push_back(system.addInput("code"));
  return BitArithmetic(system).equal(code, BitArithmetic::constant(0xA5, 8));
}

Verdict verdictOn(const BitSystem& system) {
  const std::unique_ptr<Engine> engine = makeHeldInputs(system, {});
  return engine->advance(Budget::seconds(30));
}

TEST(HeldInputs, CountsToTheEndOfAWord) {
  // From 0 to 32767 takes 32767 scans with the code, the scan after them is bad.
  BitSystem system;
  const Lit steps = isCode(system);
  const LitVector word = newWord(system);
  addCounter(system, steps, word, 32767);
  const Verdict verdict = verdictOn(system);
  ASSERT_EQ(verdict.answer, Answer::Violated);
  EXPECT_EQ(verdict.depth, 32767);
  EXPECT_TRUE(isViolation(system, *verdict.trace));
}

TEST(HeldInputs, CountsEdgesByTakingTurns) {
  // A step needs the code now and not in the scan before: 1000 steps take 2000 scans, or one less.
  BitSystem system;
  const Lit now = isCode(system);
  const Lit before = system.addLatch("before", LatchInit::Zero);
  system.setNext(before, now);
  const LitVector word = newWord(system);
  addCounter(system, system.addAnd(now, negate(before)), word, 1000);
  const Verdict verdict = verdictOn(system);
  ASSERT_EQ(verdict.answer, Answer::Violated);
  EXPECT_GE(verdict.depth, 1999);
  EXPECT_LE(verdict.depth, 2000);
}

TEST(HeldInputs, GivesUpWhereTheCodeIsForbidden) {
  BitSystem system;
  const Lit steps = isCode(system);
  system.constraints.push_back(negate(steps));
  const LitVector word = newWord(system);
  addCounter(system, steps, word, 100);
  const std::unique_ptr<Engine> engine = makeHeldInputs(system, {});
  EXPECT_EQ(engine->advance(Budget::seconds(30)).answer, Answer::Unknown);
  EXPECT_TRUE(engine->isExhausted());
}

}  // namespace
}  // namespace rungproof
