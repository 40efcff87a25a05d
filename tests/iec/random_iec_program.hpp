// Random programs in ST, each beside a function of plain C++ that computes the same: the generator writes each
// expression as text and as that function, so that nothing of reader, lowering and engine is shared. Numbers wrap at
// the width of their type after each operator, which is the reading that sums have no more bits than their operands.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace rungproof::iec_random {

using State = std::map<std::string, std::int64_t>;
using Compute = std::function<std::int64_t(State&)>;

struct Width {
  const char* name;
  int bits;
  bool isSigned;
};
inline constexpr Width intType{"INT", 16, true}, dintType{"DINT", 32, true}, usintType{"USINT", 8, false},
    wordType{"WORD", 16, false}, boolType{"BOOL", 1, false};

inline std::int64_t wrapped(std::int64_t value, const Width& width) {
  const std::int64_t size = std::int64_t{1} << width.bits;
  std::int64_t rest = value % size;
  if (rest < 0) rest += size;
  return width.isSigned && rest >= size / 2 ? rest - size : rest;
}

struct Term {
  std::string text;
  Compute compute;
};

class IecProgram {
 public:
  explicit IecProgram(std::uint64_t seed) : random_(seed) {
    for (int i = 0; i < 8; ++i) addStatement(body_, 3, "");
  }

  std::string text() const {
    std::string declared = "VAR_INPUT ";
    for (const auto& [name, type] : inputs_) declared += fmt::format("{} : {}; ", name, type->name);
    declared += "END_VAR VAR ";
    for (const auto& [name, type] : variables_) declared += fmt::format("{} : {}; ", name, type->name);
    declared += "a : ARRAY [0..3] OF INT; k0, k1, k2, k3 : INT; END_VAR";
    std::string statements;
    for (const auto& [line, run] : body_) statements += line;
    return "PROGRAM main\n" + declared + "\n" + statements + "\nEND_PROGRAM\n";
  }
  void scan(State& state) const {
    for (const auto& [line, run] : body_) run(state);
  }
  std::int64_t pick(std::int64_t low, std::int64_t high) {
    return std::uniform_int_distribution<std::int64_t>(low, high)(random_);
  }

  const std::vector<std::pair<std::string, const Width*>> inputs_ = {
      {"x0", &intType}, {"x1", &intType}, {"y0", &boolType}, {"v0", &usintType}};
  const std::vector<std::pair<std::string, const Width*>> variables_ = {
      {"b0", &boolType},  {"b1", &boolType},  {"b2", &boolType}, {"i0", &intType},
      {"i1", &intType},   {"i2", &intType},   {"d0", &dintType}, {"d1", &dintType},
      {"u0", &usintType}, {"u1", &usintType}, {"w0", &wordType}, {"w1", &wordType}};

 private:
  using Run = std::function<void(State&)>;
  using Body = std::vector<std::pair<std::string, Run>>;

  std::string nameOf(const Width& type) {
    std::vector<std::string> names;
    for (const auto& [name, of] : inputs_) {
      if (of == &type) names.push_back(name);
    }
    for (const auto& [name, of] : variables_) {
      if (of == &type) names.push_back(name);
    }
    return names[static_cast<std::size_t>(pick(0, static_cast<std::int64_t>(names.size()) - 1))];
  }
  Term variable(const Width& type) {
    const std::string name = nameOf(type);
    return {name, [name](State& s) { return s[name]; }};
  }
  Term literal(std::int64_t value) {
    return {fmt::format("{}", value), [value](State&) { return value; }};
  }
  Term two(const char* op, Term a, Term b, std::function<std::int64_t(std::int64_t, std::int64_t)> f) {
    return {fmt::format("({} {} {})", a.text, op, b.text), [a, b, f](State& s) {
              const std::int64_t left = a.compute(s);
              return f(left, b.compute(s));
            }};
  }

  Term truth(int depth) {
    if (depth == 0) return pick(0, 5) == 0 ? Term{"TRUE", [](State&) { return 1; }} : variable(boolType);
    switch (pick(0, 6)) {
      case 0: {
        const Term inner = truth(depth - 1);
        return {"NOT " + inner.text, [inner](State& s) { return 1 - inner.compute(s); }};
      }
      case 1: return two("AND", truth(depth - 1), truth(depth - 1), [](auto a, auto b) { return a & b; });
      case 2: return two("OR", truth(depth - 1), truth(depth - 1), [](auto a, auto b) { return a | b; });
      case 3: return two("XOR", truth(depth - 1), truth(depth - 1), [](auto a, auto b) { return a ^ b; });
      case 4:
        return two("<", number(intType, depth - 1), number(intType, depth - 1),
                   [](auto a, auto b) { return a < b ? 1 : 0; });
      case 5:
        return two(">=", number(dintType, depth - 1), number(dintType, depth - 1),
                   [](auto a, auto b) { return a >= b ? 1 : 0; });
      default:
        return two("<>", number(usintType, depth - 1), number(usintType, depth - 1),
                   [](auto a, auto b) { return a != b ? 1 : 0; });
    }
  }

  Term bitString(int depth) {
    if (depth == 0) return variable(wordType);
    const std::int64_t n = pick(0, 17);
    const Term inner = bitString(depth - 1);
    switch (pick(0, 5)) {
      case 0: return {"NOT " + inner.text, [inner](State& s) { return ~inner.compute(s) & 0xFFFF; }};
      case 1: return two("AND", inner, bitString(depth - 1), [](auto a, auto b) { return a & b; });
      case 2: return two("XOR", inner, bitString(depth - 1), [](auto a, auto b) { return a ^ b; });
      case 3:
        return {fmt::format("SHL({}, {})", inner.text, n),
                [inner, n](State& s) { return n > 15 ? 0 : inner.compute(s) << n & 0xFFFF; }};
      case 4:
        return {fmt::format("SHR({}, {})", inner.text, n),
                [inner, n](State& s) { return n > 15 ? 0 : inner.compute(s) >> n; }};
      default:
        return {fmt::format("ROL({}, {})", inner.text, n), [inner, n](State& s) {
                  const std::int64_t value = inner.compute(s), by = n % 16;
                  return (value << by | value >> (16 - by)) & 0xFFFF;
                }};
    }
  }

  Term number(const Width& type, int depth) {
    if (&type == &wordType) return bitString(depth);
    if (depth == 0) return pick(0, 3) == 0 ? literal(pick(0, 100)) : variable(type);
    const Width* const width = &type;
    const auto wrap = [width](auto f) {
      return [width, f](std::int64_t a, std::int64_t b) { return wrapped(f(a, b), *width); };
    };
    const auto side = [&] { return number(type, depth - 1); };
    switch (pick(0, 10)) {
      case 0: return two("+", variable(type), side(), wrap([](auto a, auto b) { return a + b; }));
      case 1: return two("-", variable(type), side(), wrap([](auto a, auto b) { return a - b; }));
      case 2: return two("*", variable(type), side(), wrap([](auto a, auto b) { return a * b; }));
      case 3: return two("/", variable(type), literal(pick(1, 9)), wrap([](auto a, auto b) { return a / b; }));
      case 4: return two("MOD", variable(type), literal(pick(1, 9)), wrap([](auto a, auto b) { return a % b; }));
      case 5: {
        const Term which = truth(depth - 1), zero = variable(type), one = side();
        return {fmt::format("SEL({}, {}, {})", which.text, zero.text, one.text), [which, zero, one](State& s) {
                  const std::int64_t chosen = which.compute(s), a = zero.compute(s), b = one.compute(s);
                  return chosen != 0 ? b : a;
                }};
      }
      case 6: {
        const Term a = variable(type), b = side();
        return {fmt::format("MAX({}, {})", a.text, b.text),
                [a, b](State& s) { return std::max(a.compute(s), b.compute(s)); }};
      }
      case 7: {
        const Term a = variable(type);
        return {fmt::format("LIMIT(3, {}, 50)", a.text),
                [a](State& s) { return std::min<std::int64_t>(std::max<std::int64_t>(a.compute(s), 3), 50); }};
      }
      case 8: {
        const Width& from = &type == &intType ? dintType : intType;
        const Term inner = number(from, depth - 1);
        const Term value = inner.text.find_first_not_of("0123456789") == std::string::npos ? variable(from) : inner;
        return {fmt::format("{}_TO_{}({})", from.name, type.name, value.text),
                [value, width](State& s) { return wrapped(value.compute(s), *width); }};
      }
      case 9: {
        const Term inner = truth(depth - 1);
        return {fmt::format("BOOL_TO_{}({})", type.name, inner.text), inner.compute};
      }
      default: {
        const Term index = variable(usintType);
        if (&type != &intType) return variable(type);
        return {fmt::format("a[{} MOD 4]", index.text),
                [index](State& s) { return s[fmt::format("a[{}]", index.compute(s) % 4)]; }};
      }
    }
  }

  void addStatement(Body& into, int depth, const std::string& indent) {
    const std::string inner = indent + "  ";
    const auto text = [](const Body& body) {
      std::string all;
      for (const auto& [line, run] : body) all += line;
      return all;
    };
    const auto runAll = [](Body body) {
      return [body](State& s) {
        for (const auto& [line, run] : body) run(s);
      };
    };
    const std::int64_t kind = depth == 0 ? 0 : pick(0, 6);
    if (kind == 4) {
      const Term condition = truth(2);
      Body yes, no;
      addStatement(yes, depth - 1, inner);
      addStatement(no, depth - 1, inner);
      into.emplace_back(
          fmt::format("{0}IF {1} THEN\n{2}{0}ELSE\n{3}{0}END_IF;\n", indent, condition.text, text(yes), text(no)),
          [condition, yes = runAll(yes), no = runAll(no)](State& s) {
            if (condition.compute(s) != 0) {
              yes(s);
            } else {
              no(s);
            }
          });
      return;
    }
    if (kind == 5) {
      const Term selector = variable(usintType);
      Body first, second, rest;
      addStatement(first, depth - 1, inner);
      addStatement(second, depth - 1, inner);
      addStatement(rest, depth - 1, inner);
      into.emplace_back(fmt::format("{0}CASE {1} OF\n{0}0, 3..40:\n{2}{0}1..90:\n{3}{0}ELSE\n{4}{0}END_CASE;\n", indent,
                                    selector.text, text(first), text(second), text(rest)),
                        [selector, first = runAll(first), second = runAll(second), rest = runAll(rest)](State& s) {
                          const std::int64_t value = selector.compute(s);
                          if (value == 0 || (value >= 3 && value <= 40)) return first(s);
                          if (value >= 1 && value <= 90) return second(s);
                          rest(s);
                        });
      return;
    }
    if (kind == 6) {
      const std::string counter = fmt::format("k{}", depth);
      const std::int64_t last = pick(0, 4), step = pick(1, 2);
      Body loop;
      addStatement(loop, depth - 1, inner);
      into.emplace_back(
          fmt::format("{0}FOR {1} := 1 TO {2} BY {3} DO\n{4}{0}END_FOR;\n", indent, counter, last, step, text(loop)),
          [counter, last, step, loop = runAll(loop)](State& s) {
            for (s[counter] = 1; s[counter] <= last; s[counter] += step) loop(s);
          });
      return;
    }
    if (kind == 3) {
      const Term index = variable(usintType), value = number(intType, 2);
      into.emplace_back(fmt::format("{}a[{} MOD 4] := {};\n", indent, index.text, value.text),
                        [index, value](State& s) {
                          const std::int64_t at = index.compute(s) % 4;
                          s[fmt::format("a[{}]", at)] = value.compute(s);
                        });
      return;
    }
    const auto& [name, type] =
        variables_[static_cast<std::size_t>(pick(0, static_cast<std::int64_t>(variables_.size()) - 1))];
    const Term value = type == &boolType ? truth(3) : number(*type, 3);
    into.emplace_back(fmt::format("{}{} := {};\n", indent, name, value.text),
                      [target = name, value](State& s) { s[target] = value.compute(s); });
  }

  std::mt19937_64 random_;
  Body body_;
};

}  // namespace rungproof::iec_random
