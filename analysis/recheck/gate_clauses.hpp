// Gates as clauses that define them, and arithmetic on words made of them: the checker's own, so that an error in the
// circuits of the engines (analysis/bits) is not repeated. Literals are DIMACS ones; words have their lowest bit first.
// Tested by tests/recheck.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

namespace rungproof {

class GateClauses {
 public:
  using Word = std::vector<int>;
  static constexpr int yes = 1;  ///< variable 1 is true

  int variable();
  int both(int a, int b);
  int either(int a, int b) { return -both(-a, -b); }
  int differ(int a, int b);
  int choose(int condition, int a, int b);
  int majority(int a, int b, int c);
  int all(std::span<const int> literals);

  static Word constant(std::uint64_t value, int width);
  Word fresh(int width);
  static Word inverted(Word a);
  Word choose(int condition, const Word& a, const Word& b);
  Word add(const Word& a, const Word& b, int carry = -yes);
  Word subtract(const Word& a, const Word& b) { return add(a, inverted(b), yes); }
  Word multiply(const Word& a, const Word& b);
  /// Unsigned; by 0: all ones and the dividend, as SMT-LIB has it.
  struct Division {
    Word quotient, remainder;
  };
  Division divide(const Word& a, const Word& b);
  /// Truncating; the remainder has the dividend's sign.
  Division divideSigned(const Word& a, const Word& b);
  /// Shifted by the width or more: 0.
  Word shift(Word a, const Word& amount, bool isLeft);
  int equal(const Word& a, const Word& b);
  /// a < b or, if `orEqual`, a <= b; unsigned.
  int less(const Word& a, const Word& b, bool orEqual = false);
  int lessSigned(Word a, Word b, bool orEqual = false);

  /// The clauses that define what `root` rests on, and that it is true; each ends with 0. Variables are numbered anew
  /// from 1.
  struct Clauses {
    std::vector<int> literals;
    int variables = 0;
    std::vector<int> guide{};  ///< literals that follow from the clauses one after the other, presumably
  };
  /// `guide` becomes Clauses::guide; what its literals rest on is defined too.
  Clauses clausesOf(int root, std::span<const int> guide = {}) const;

 private:
  enum class Gate : std::uint8_t { And, Xor, Choose, Majority };
  int define(Gate gate, std::array<int, 3> input, std::initializer_list<std::initializer_list<int>> clauses);
  Word negative(const Word& a) { return subtract(constant(0, static_cast<int>(a.size())), a); }

  struct InputsHash {
    std::size_t operator()(const std::array<int, 4>& key) const;
  };
  std::unordered_map<std::array<int, 4>, int, InputsHash> known_;  ///< by gate and inputs
  std::vector<int> literals_;                                      ///< of definitions; 0 stands for the gate's own sign
  std::vector<std::uint32_t> begin_{0, 0, 0};                      ///< by variable, where its definition begins
};

}  // namespace rungproof
