// Constants are folded and equal gates are made once; a definition is stored behind its variable.
#include "analysis/recheck/gate_clauses.hpp"

#include <algorithm>
#include <cstdlib>

#include "ir/check.hpp"

namespace rungproof {

namespace {

constexpr int own = 1 << 30;  ///< in a definition: the gate itself

}  // namespace

std::size_t GateClauses::InputsHash::operator()(const std::array<int, 4>& key) const {
  std::uint64_t hash = 0;
  for (const int k : key) {
    hash = (hash ^ static_cast<std::uint32_t>(k)) * 0x9E3779B97F4A7C15ULL;
    hash ^= hash >> 32U;
  }
  return hash;
}

int GateClauses::variable() {
  begin_.push_back(static_cast<std::uint32_t>(literals_.size()));
  return static_cast<int>(begin_.size()) - 2;
}

int GateClauses::define(Gate gate, std::array<int, 3> input,
                        std::initializer_list<std::initializer_list<int>> clauses) {
  const auto [at, isNew] = known_.try_emplace({static_cast<int>(gate), input[0], input[1], input[2]}, 0);
  if (!isNew) return at->second;
  for (const auto& clause : clauses) {
    literals_.insert(literals_.end(), clause.begin(), clause.end());
    literals_.push_back(0);
  }
  return at->second = variable();
}

int GateClauses::both(int a, int b) {
  if (a > b) std::swap(a, b);
  if (a == b || b == yes) return a;
  if (a == -yes || b == -yes || a == -b) return -yes;
  if (a == yes) return b;
  return define(Gate::And, {a, b, 0}, {{-own, a}, {-own, b}, {own, -a, -b}});
}

int GateClauses::differ(int a, int b) {
  bool isInverted = false;
  for (int* l : {&a, &b}) {
    if (*l >= 0) continue;
    *l = -*l;
    isInverted = !isInverted;
  }
  if (a > b) std::swap(a, b);
  const int result = a == b ? -yes
                     : a == yes
                         ? -b
                         : define(Gate::Xor, {a, b, 0}, {{-own, a, b}, {-own, -a, -b}, {own, -a, b}, {own, a, -b}});
  return isInverted ? -result : result;
}

int GateClauses::choose(int condition, int a, int b) {
  if (condition < 0) {
    condition = -condition;
    std::swap(a, b);
  }
  if (condition == yes || a == b) return a;
  if (a == -b) return differ(condition, b);
  if (a == yes || a == condition) return either(condition, b);
  if (a == -yes || a == -condition) return both(-condition, b);
  if (b == yes || b == -condition) return either(-condition, a);
  if (b == -yes || b == condition) return both(condition, a);
  return define(Gate::Choose, {condition, a, b},
                {{-condition, -a, own},
                 {-condition, a, -own},
                 {condition, -b, own},
                 {condition, b, -own},
                 {-a, -b, own},
                 {a, b, -own}});
}

int GateClauses::majority(int a, int b, int c) {
  if (a > b) std::swap(a, b);
  if (b > c) std::swap(b, c);
  if (a > b) std::swap(a, b);
  if (a == b) return a;
  if (b == c) return b;
  if (a == -b) return c;
  if (b == -c) return a;
  if (a == -c) return b;
  for (const auto& [l, x, y] : {std::array{a, b, c}, std::array{b, a, c}, std::array{c, a, b}}) {
    if (l == yes) return either(x, y);
    if (l == -yes) return both(x, y);
  }
  return define(Gate::Majority, {a, b, c},
                {{-a, -b, own}, {-a, -c, own}, {-b, -c, own}, {a, b, -own}, {a, c, -own}, {b, c, -own}});
}

int GateClauses::all(std::span<const int> literals) {
  int result = yes;
  for (const int l : literals) result = both(result, l);
  return result;
}

GateClauses::Word GateClauses::constant(std::uint64_t value, int width) {
  Word result;
  for (int i = 0; i < width; ++i) result.push_back(i < 64 && (value >> i & 1U) != 0 ? yes : -yes);
  return result;
}

GateClauses::Word GateClauses::fresh(int width) {
  Word result;
  for (int i = 0; i < width; ++i) result.push_back(variable());
  return result;
}

GateClauses::Word GateClauses::inverted(Word a) {
  for (int& l : a) l = -l;
  return a;
}

GateClauses::Word GateClauses::choose(int condition, const Word& a, const Word& b) {
  Word result;
  for (std::size_t i = 0; i < a.size(); ++i) result.push_back(choose(condition, a[i], b[i]));
  return result;
}

GateClauses::Word GateClauses::add(const Word& a, const Word& b, int carry) {
  Word result;
  for (std::size_t i = 0; i < a.size(); ++i) {
    result.push_back(differ(differ(a[i], b[i]), carry));
    carry = majority(a[i], b[i], carry);
  }
  return result;
}

GateClauses::Word GateClauses::multiply(const Word& a, const Word& b) {
  const int width = static_cast<int>(a.size());
  Word sum = constant(0, width);
  for (std::size_t i = 0; i < a.size(); ++i) {
    Word summand = constant(0, width);
    for (std::size_t j = i; j < a.size(); ++j) summand[j] = both(b[i], a[j - i]);
    sum = add(sum, summand);
  }
  return sum;
}

GateClauses::Division GateClauses::divide(const Word& a, const Word& b) {
  const int width = static_cast<int>(a.size());
  Word divisor = b, rest = constant(0, width + 1);
  divisor.push_back(-yes);
  Division result{constant(0, width), {}};
  for (std::size_t i = a.size(); i-- > 0;) {
    rest.pop_back();
    rest.insert(rest.begin(), a[i]);
    const int fits = less(divisor, rest, true);
    rest = choose(fits, subtract(rest, divisor), rest);
    result.quotient[i] = fits;
  }
  rest.pop_back();
  result.remainder = std::move(rest);
  return result;
}

GateClauses::Division GateClauses::divideSigned(const Word& a, const Word& b) {
  const int signA = a.back(), signB = b.back();
  Division result = divide(choose(signA, negative(a), a), choose(signB, negative(b), b));
  result.quotient = choose(differ(signA, signB), negative(result.quotient), result.quotient);
  result.remainder = choose(signA, negative(result.remainder), result.remainder);
  return result;
}

GateClauses::Word GateClauses::shift(Word a, const Word& amount, bool isLeft) {
  const std::size_t width = a.size();
  for (std::size_t stage = 0; stage < amount.size(); ++stage) {
    Word moved = constant(0, static_cast<int>(width));
    const std::size_t distance = stage < 8 ? std::size_t{1} << stage : width;
    for (std::size_t i = 0; i + distance < width; ++i) {
      if (isLeft)
        moved[i + distance] = a[i];
      else
        moved[i] = a[i + distance];
    }
    a = choose(amount[stage], moved, a);
  }
  return a;
}

int GateClauses::equal(const Word& a, const Word& b) {
  std::vector<int> same;
  for (std::size_t i = 0; i < a.size(); ++i) same.push_back(-differ(a[i], b[i]));
  return all(same);
}

/// The carry of b - a, or of b - a - 1.
int GateClauses::less(const Word& a, const Word& b, bool orEqual) {
  int carry = orEqual ? yes : -yes;
  for (std::size_t i = 0; i < a.size(); ++i) carry = majority(-a[i], b[i], carry);
  return carry;
}

int GateClauses::lessSigned(Word a, Word b, bool orEqual) {
  a.back() = -a.back();
  b.back() = -b.back();
  return less(a, b, orEqual);
}

GateClauses::Clauses GateClauses::clausesOf(int root, std::span<const int> guide) const {
  Clauses result;
  std::vector<int> number(begin_.size(), 0);
  std::vector<int> open;
  const auto literal = [&](int l) {
    int& named = number[static_cast<std::size_t>(std::abs(l))];
    if (named == 0) {
      named = ++result.variables;
      open.push_back(std::abs(l));
    }
    return l < 0 ? -named : named;
  };
  result.literals = {literal(yes), 0};
  const int wanted = literal(root);
  result.literals.insert(result.literals.end(), {wanted, 0});
  for (const int l : guide) result.guide.push_back(literal(l));
  while (!open.empty()) {
    const int v = open.back();
    open.pop_back();
    const auto at = static_cast<std::size_t>(v);
    const int named = number[at];
    for (std::uint32_t i = begin_[at]; i < begin_[at + 1]; ++i) {
      const int l = literals_[i];
      result.literals.push_back(l == 0 ? 0 : l == own ? named : l == -own ? -named : literal(l));
    }
  }
  return result;
}

}  // namespace rungproof
