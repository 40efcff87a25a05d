// REAL arithmetic out of whole numbers gives what the processor's own arithmetic gives, bit by bit: on all pairs of
// special patterns, on random ones, and on neighbours whose results are rounded, cancel, or leave the normal range.
#include "analysis/graph/real_words.hpp"

#include <gtest/gtest.h>

#include "engine/concrete.hpp"
#include "tests/differential/random_source.hpp"

namespace rungproof {
namespace {

struct NothingOutside final : Outside {
  std::uint64_t external(const ExternalSite&, int) override { return 0; }
  void report(Hazard, const Instruction*) override {}
};

class RealWordsTest : public testing::Test {
 protected:
  /// Patterns with a field of the exponent that is often near another one, and fractions at their edges.
  std::uint64_t pattern(std::uint64_t near) {
    const std::uint64_t field = random_.chance(40)   ? near >> 23 & 255U
                                : random_.chance(30) ? random_.below(3)
                                : random_.chance(30) ? 253 + random_.below(3)
                                                     : random_.below(256);
    const std::uint64_t moved = (field + random_.below(5) + 254) % 256;
    return (random_.chance(50) ? 1ULL << 31 : 0) | moved << 23 | random_.value(23);
  }
  void compare(std::uint64_t a, std::uint64_t b) {
    const auto two = [&](const char* name, std::uint64_t got, std::uint64_t want) {
      ASSERT_EQ(got, want) << name << " of " << std::hex << a << " and " << b << ", seed " << std::dec << seed_;
    };
    two("sum", words_.add(a, b), d_.radd(a, b));
    two("difference", words_.sub(a, b), d_.rsub(a, b));
    two("product", words_.mul(a, b), d_.rmul(a, b));
    two("quotient", words_.div(a, b), d_.rdiv(a, b));
    two("equality", words_.equal(a, b), d_.requal(a, b));
    two("order", words_.less(a, b), d_.rless(a, b));
    two("legality", words_.legal(a), d_.rlegal(a));
    two("root", words_.sqrt(a), d_.rfunction(static_cast<std::uint64_t>(RealFunction::Sqrt), a));
    two("conversion", words_.fromInt(a), d_.rfromInt(a));
    two("rounding", words_.toInt(a, true), d_.rtoInt(a, true));
    two("truncation", words_.toInt(a, false), d_.rtoInt(a, false));
  }

  const std::uint64_t seed_ = testSeed();
  RandomSource random_{seed_};
  NothingOutside outside_;
  Concrete d_{outside_};
  RealWords<Concrete> words_{d_};
};

TEST_F(RealWordsTest, SpecialPatterns) {
  const std::vector<std::uint64_t> special = {
      0,          0x80000000, 1,          0x80000001, 0x007FFFFF, 0x00800000, 0x00800001, 0x3F800000, 0xBF800000,
      0x3F7FFFFF, 0x3F800001, 0x3F000000, 0xBF000000, 0x7F7FFFFF, 0xFF7FFFFF, 0x7F800000, 0xFF800000, 0x7FC00000,
      0xFFC00001, 0x4B000000, 0x4B7FFFFF, 0x4B800000, 0x5EF9CCCD, 0x5F000000, 0xDF000000, 0x33800000, 0x34000000};
  for (const std::uint64_t a : special) {
    for (const std::uint64_t b : special) compare(a, b);
  }
}

TEST_F(RealWordsTest, RandomPatterns) {
  for (int i = 0; i < 60000 && !HasFatalFailure(); ++i) {
    const std::uint64_t a = pattern(random_.value(32));
    compare(a, pattern(a));
  }
}

TEST_F(RealWordsTest, WholeNumbers) {
  for (int i = 0; i < 20000 && !HasFatalFailure(); ++i) {
    const std::uint64_t a = random_.value(32) >> random_.below(32), b = random_.value(16);
    compare(a, d_.rfromInt(b));
    compare(d_.rfromInt(a), d_.rfromInt(b));
  }
}

}  // namespace
}  // namespace rungproof
