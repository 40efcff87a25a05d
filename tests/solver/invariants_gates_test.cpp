// Equal gates: what is found on systems whose equalities can be stated by hand, and on random ones, state by state,
// that it holds at the start and is kept by every scan.
#include "analysis/portfolio/invariants_gates.hpp"

#include <gtest/gtest.h>

#include <random>

#include "analysis/bits/bit_arithmetic.hpp"
#include "analysis/bits/bit_simulator.hpp"
#include "tests/prover/proved_text.hpp"

namespace rungproof::test {
namespace {

constexpr double enough = 60;

std::vector<Lit> mined(BitSystem& system) { return mineEqualGates(system, 1, Budget::seconds(enough)); }

/// Whether all literals are true with these values of the latches.
bool areTrue(const BitSystem& system, BitSimulator& simulator, const std::vector<Lit>& literals, unsigned state) {
  for (std::size_t i = 0; i < system.latches.size(); ++i) simulator.setLatch(i, (state >> i & 1U) != 0 ? ~0ULL : 0);
  simulator.evaluate();
  return std::ranges::all_of(literals, [&](Lit l) { return (simulator.value(l) & 1U) != 0; });
}

/// In all states and with all inputs; the system is small.
void expectInductive(const BitSystem& system, const std::vector<Lit>& literals, const std::string& what) {
  BitSimulator simulator(system);
  for (unsigned state = 0; state < 1U << system.latches.size(); ++state) {
    bool isInitial = true;
    for (std::size_t i = 0; i < system.latches.size(); ++i) {
      const LatchInit init = system.latches[i].init;
      isInitial = isInitial && (init == LatchInit::Free || (init == LatchInit::One) == ((state >> i & 1U) != 0));
    }
    const bool holds = areTrue(system, simulator, literals, state);
    EXPECT_TRUE(holds || !isInitial) << what << ": broken in initial state " << state;
    for (unsigned inputs = 0; holds && inputs < 1U << system.inputs.size(); ++inputs) {
      for (std::size_t i = 0; i < system.inputs.size(); ++i) simulator.setInput(i, (inputs >> i & 1U) != 0 ? ~0ULL : 0);
      areTrue(system, simulator, literals, state);
      const bool isLegal =
          std::ranges::all_of(system.constraints, [&](Lit l) { return (simulator.value(l) & 1U) != 0; });
      simulator.step();
      simulator.evaluate();
      for (const Lit l : literals)
        EXPECT_TRUE(!isLegal || (simulator.value(l) & 1U) != 0) << what << ": lost after state " << state;
    }
  }
}

LitVector addWord(BitSystem& system, const std::string& name, int width) {
  LitVector word;
  for (int bit = 0; bit < width; ++bit) word.push_back(system.addLatch(name + std::to_string(bit), LatchInit::Zero));
  return word;
}

/// Two stores take turns: what one loses the other gets, so that their sum stays 0 modulo 16. No bit of one is a bit
/// of the other; only the gates of the sum say it.
TEST(EqualGates, ASumThatStays) {
  BitSystem system;
  const Lit moves = system.addInput("moves");
  const LitVector left = addWord(system, "left", 4), right = addWord(system, "right", 4);
  BitArithmetic arithmetic(system);
  const LitVector amount{moves, falseLit, falseLit, falseLit};
  const LitVector less = arithmetic.subtract(left, amount), more = arithmetic.add(right, amount);
  for (int bit = 0; bit < 4; ++bit) {
    system.setNext(left[bit], less[bit]);
    system.setNext(right[bit], more[bit]);
  }
  const LitVector sum = arithmetic.add(left, right);
  const std::vector<Lit> equal = mined(system);
  expectInductive(system, equal, "two stores");
  BitSimulator simulator(system);
  for (unsigned state = 0; state < 256; ++state) {
    if (!areTrue(system, simulator, equal, state)) continue;
    EXPECT_EQ((state + (state >> 4U)) % 16, 0U) << "the sum is not known to be 0";
  }
  EXPECT_TRUE(areTrue(system, simulator, equal, 0xF1)) << "15 and 1 can be reached";
}

/// What only holds for the first scans is not kept: a counter to 15 whose highest bit is 0 for eight of them.
TEST(EqualGates, WhatALongRunBreaksIsLeftOut) {
  BitSystem system;
  const LitVector word = addWord(system, "count", 4);
  const Lit counts = system.addInput("counts");
  BitArithmetic arithmetic(system);
  const LitVector next = arithmetic.add(word, {counts, falseLit, falseLit, falseLit});
  for (int bit = 0; bit < 4; ++bit) system.setNext(word[bit], next[bit]);
  const std::vector<Lit> equal = mined(system);
  BitSimulator simulator(system);
  for (unsigned state = 0; state < 16; ++state)
    EXPECT_TRUE(areTrue(system, simulator, equal, state)) << state << " can be reached";
}

TEST(EqualGates, RandomSystemsKeepThem) {
  std::size_t found = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    std::mt19937_64 random(seed);
    BitSystem system;
    std::vector<Lit> any;
    for (int i = 0; i < 3; ++i) any.push_back(system.addInput());
    for (int i = 0; i < 7; ++i)
      any.push_back(system.addLatch({}, static_cast<LatchInit>(i < 2 ? random() % 3 : random() % 2)));
    const auto pick = [&] { return any[random() % any.size()] ^ (random() & 1U); };
    for (int i = 0; i < 40; ++i) any.push_back(system.addAnd(pick(), pick()));
    for (const Latch& latch : std::vector<Latch>(system.latches)) system.setNext(positive(latch.variable), pick());
    if (seed % 3 == 0) system.constraints.push_back(system.addOr(pick(), pick()));
    const std::vector<Lit> equal = mined(system);
    found += equal.size();
    expectInductive(system, equal, "seed " + std::to_string(seed));
  }
  EXPECT_GT(found, 60U) << "random systems have latches that stay";
}

TEST(EqualGates, WithoutTimeNothingIsClaimed) {
  BitSystem system;
  const Lit latch = system.addLatch("stays", LatchInit::Zero), input = system.addInput("input");
  system.setNext(latch, system.addAnd(latch, input));
  EXPECT_TRUE(mineEqualGates(system, 1, Budget::seconds(0)).empty());
  EXPECT_EQ(mined(system).size(), 1U);  // it stays off
}

/// A queue of six places: what came in less what went out is asked for, and the program counts what is there. Proved by
/// the equal gates, with a certificate that was checked.
TEST(EqualGates, ProveWhatADifferenceOfCountersIs) {
  const ProgramInput input = inputOf("//@ prove room: VW0 - VW2 <= 6\n",
                                     "Network 1\nLD I0.0\nEU\nAW< VW4, 6\nAW< VW0, 32000\nINCW VW0\nINCW VW4\n"
                                     "Network 2\nLD I0.1\nEU\nAW> VW4, 0\nINCW VW2\nDECW VW4\n");
  ProverOptions options = usualOptions(20);
  options.certificates = true;
  const ProofRun run = prove(input.program, input.properties, options);
  EXPECT_EQ(outcomeOf(run, "room"), Outcome::Proved);
  EXPECT_FALSE(resultNamed(run, "room")->certificate.empty());
  EXPECT_EQ(run.techniques[static_cast<std::size_t>(Technique::EqualGates)].settled, 1U);
}

}  // namespace
}  // namespace rungproof::test
