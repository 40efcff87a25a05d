// Words of literals against 64-bit arithmetic: random operands of random widths, 64 pairs at once through the
// simulator. Results are cut to the width; divisions by 0 are as SMT-LIB has them.
#include "analysis/bits/bit_arithmetic.hpp"

#include <gtest/gtest.h>

#include <array>
#include <random>

#include "analysis/bits/bit_simulator.hpp"

namespace rungproof {
namespace {

using Lanes = std::array<std::uint64_t, 64>;

std::uint64_t maskOf(int width) { return (1ULL << width) - 1; }
std::int64_t signedOf(std::uint64_t value, int width) {
  const std::uint64_t sign = 1ULL << (width - 1);
  return static_cast<std::int64_t>(value ^ sign) - static_cast<std::int64_t>(sign);
}

/// Two inputs words of one width, and values for them: small ones, large ones and equal ones among them.
struct Operands {
  BitSystem graph;
  LitVector a, b;
  Lanes x{}, y{};
  int width;

  Operands(int w, std::mt19937_64& random) : width(w) {
    for (int bit = 0; bit < w; ++bit) a.push_back(graph.addInput());
    for (int bit = 0; bit < w; ++bit) b.push_back(graph.addInput());
    for (std::size_t lane = 0; lane < 64; ++lane) {
      x[lane] = random() & maskOf(w);
      y[lane] = random() & (lane % 3 == 0 ? maskOf(w) : 15) & maskOf(w);
      if (lane % 16 == 7) y[lane] = x[lane];
      if (lane % 16 == 9) y[lane] = 0;
    }
  }

  Lanes values(const LitVector& word) const {
    BitSimulator simulator(graph);
    for (int bit = 0; bit < width; ++bit) {
      std::uint64_t left = 0, right = 0;
      for (std::size_t lane = 0; lane < 64; ++lane) {
        left |= (x[lane] >> bit & 1U) << lane;
        right |= (y[lane] >> bit & 1U) << lane;
      }
      simulator.setInput(static_cast<std::size_t>(bit), left);
      simulator.setInput(static_cast<std::size_t>(width + bit), right);
    }
    simulator.evaluate();
    Lanes result{};
    for (std::size_t bit = 0; bit < word.size(); ++bit) {
      for (std::size_t lane = 0; lane < 64; ++lane) result[lane] |= (simulator.value(word[bit]) >> lane & 1U) << bit;
    }
    return result;
  }

  template <class Expected>
  void expect(const char* name, const LitVector& word, Expected&& expected) const {
    const Lanes found = values(word);
    const std::uint64_t mask = maskOf(static_cast<int>(word.size()));
    for (std::size_t lane = 0; lane < 64; ++lane) {
      EXPECT_EQ(found[lane], expected(x[lane], y[lane]) & mask)
          << name << " of " << x[lane] << " and " << y[lane] << ", width " << width;
    }
  }
};

TEST(BitArithmetic, AgreesWithNumbers) {
  constexpr std::uint64_t seed = 20261122;
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  std::mt19937_64 random(seed);
  for (const int w : {1, 2, 3, 8, 13, 16, 21, 32}) {
    Operands o(w, random);
    BitArithmetic words(o.graph);
    using U = std::uint64_t;
    const LitVector sum = words.add(o.a, o.b), difference = words.subtract(o.a, o.b),
                    product = words.multiply(o.a, o.b);
    LitVector quotient, remainder, signedQuotient, signedRemainder;
    words.divide(o.a, o.b, quotient, remainder);
    words.divideSigned(o.a, o.b, signedQuotient, signedRemainder);
    const LitVector left = words.shiftLeft(o.a, o.b), right = words.shiftRight(o.a, o.b);
    const LitVector relations{words.equal(o.a, o.b), words.less(o.a, o.b), words.lessSigned(o.a, o.b), words.any(o.a)};
    const LitVector chosen = words.choose(o.b[0], o.a, o.b);
    o.expect("sum", sum, [](U x, U y) { return x + y; });
    o.expect("difference", difference, [](U x, U y) { return x - y; });
    o.expect("product", product, [](U x, U y) { return x * y; });
    o.expect("quotient", quotient, [](U x, U y) { return y == 0 ? ~0ULL : x / y; });
    o.expect("remainder", remainder, [](U x, U y) { return y == 0 ? x : x % y; });
    // Truncated; by 0: -1 for a dividend that is not negative, else 1, and the dividend.
    o.expect("signed quotient", signedQuotient, [w](U x, U y) {
      const std::int64_t a = signedOf(x, w), b = signedOf(y, w);
      return static_cast<U>(b == 0 ? (a >= 0 ? -1 : 1) : a / b);
    });
    o.expect("signed remainder", signedRemainder, [w](U x, U y) {
      const std::int64_t a = signedOf(x, w), b = signedOf(y, w);
      return static_cast<U>(b == 0 ? a : a % b);
    });
    o.expect("shifted left", left, [w](U x, U y) { return y >= static_cast<U>(w) ? 0 : x << y; });
    o.expect("shifted right", right, [w](U x, U y) { return y >= static_cast<U>(w) ? 0 : x >> y; });
    o.expect("relations", relations, [w](U x, U y) {
      return U{x == y} | U{x < y} << 1 | U{signedOf(x, w) < signedOf(y, w)} << 2 | U{x != 0} << 3;
    });
    o.expect("choice", chosen, [](U x, U y) { return (y & 1U) != 0 ? x : y; });
  }
}

}  // namespace
}  // namespace rungproof
