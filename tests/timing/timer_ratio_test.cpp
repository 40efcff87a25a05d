// The engine on words against IC3 on bits, both alone, on timers with presets of 100, 1,000 and 30,000 ticks against an
// independent count, in CPU time at the pace of a quiet machine.
#include <gtest/gtest.h>

#include "analysis/words/word_engine.hpp"
#include "tests/machine_pace.hpp"
#include "tests/solver/families.hpp"

namespace rungproof {
namespace {

constexpr double bitSeconds = 1;     ///< for IC3 on bits, wall time
constexpr double wordSeconds = 0.1;  ///< CPU time
constexpr int measurings = 3;

struct Measured {
  Answer answer = Answer::Unknown;
  double seconds = 0;  ///< CPU time
};

Measured onWords(const families::Family& family, WordSolverKind solver) {
  Measured measured;
  const auto search = [&] {
    measured.answer = makeWordEngine(family.system, 0, {}, solver)->advance(Budget::seconds(20)).answer;
  };
  measured.seconds = test::quietSeconds(search, 0, measurings);
  return measured;
}

Measured onBits(const families::Family& family) {
  Measured measured;
  const double begin = test::processorSeconds();
  const BitBlast blast(family.system, {0});
  measured.answer = makeIc3(blast.bits(), {})->advance(Budget::seconds(bitSeconds)).answer;
  measured.seconds = test::processorSeconds() - begin;
  return measured;
}

// IC3 on bits does not finish with any of the presets; the ratio is one of which it had at least so much.
TEST(TimerRatio, HoldsWhateverThePreset) {
  double least = 1e9, most = 0;
  for (const std::uint64_t preset : {100U, 1000U, 30000U}) {
    const families::Family family = families::timed(1, preset, false);
    const Measured words = onWords(family, WordSolverKind::Bits), terms = onWords(family, WordSolverKind::Terms),
                   bits = onBits(family);
    std::printf("preset %5lu: words %.4f s, words on Z3 %.4f s, IC3 on bits %s %.4f s: ratio %.0f\n",
                static_cast<unsigned long>(preset), words.seconds, terms.seconds,
                bits.answer == Answer::Unknown ? "undecided after" : "decided in", bits.seconds,
                bits.seconds / words.seconds);
    EXPECT_EQ(words.answer, Answer::Proved);
    EXPECT_EQ(terms.answer, Answer::Proved);
    EXPECT_NE(bits.answer, Answer::Violated);
    EXPECT_LE(words.seconds, wordSeconds);
    least = std::min(least, words.seconds);
    most = std::max(most, words.seconds);
  }
  // The cost does not grow with the preset; a millisecond is what a measurement is worth.
  EXPECT_LE(most, 3 * least + 0.001);
}

}  // namespace
}  // namespace rungproof
