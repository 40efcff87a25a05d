// Random programs in ST over all elementary types, subranges, arrays of two dimensions and nested structures, each
// beside the same in plain C++: the generator writes each expression as text and as a function. Whole numbers are
// computed in 128 bits and cut to their type behind each operator, so that nothing of reader, lowering and engine is
// shared. The variables of REAL and LREAL stay within a million, where all conversions are defined.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "tests/iec/naive_types.hpp"

namespace rungproof::iec_types {

class TypeProgram {
 public:
  /// Without LREAL for proofs, in which its results are any number.
  explicit TypeProgram(std::uint64_t seed, bool hasLongReals = true) : random_(seed), hasLongReals_(hasLongReals) {
    for (int i = 0; i < 9; ++i) add(body_, 2);
  }

  /// The variables: `lint0`, `lint1` and `lintx` of LINT, the last an input.
  static std::string nameOf(const Kind& kind, char which) {
    std::string name = kind.name;
    std::ranges::transform(name, name.begin(), [](char c) { return static_cast<char>(c - 'A' + 'a'); });
    return name + which;
  }
  static const std::vector<std::pair<std::string, const Kind*>>& others() {
    static const std::vector<std::pair<std::string, const Kind*>> all = [] {
      std::vector<std::pair<std::string, const Kind*>> made = {
          {"sub", &intKind}, {"s.in.a", &dintKind}, {"s.in.b", &usintKind}, {"s.t", &timeKind}, {"k", &dintKind}};
      for (int i = 0; i < 2; ++i) {
        for (int j = -1; j < 2; ++j) made.emplace_back(fmt::format("grid[{},{}]", i, j), &dintKind);
        made.emplace_back(fmt::format("rows[{}].in.a", i), &dintKind);
        made.emplace_back(fmt::format("rows[{}].in.b", i), &usintKind);
        made.emplace_back(fmt::format("rows[{}].t", i), &timeKind);
      }
      return made;
    }();
    return all;
  }
  static constexpr const char *truths[] = {"b0", "b1", "b2"}, *reals[] = {"r0", "r1"}, *longReals[] = {"l0", "l1"},
                              *texts[] = {"w0", "w1"};

  std::string text() const {
    std::string declared = "VAR_INPUT x0, x1 : BOOL; ";
    for (const Kind& kind : kinds) declared += fmt::format("{} : {}; ", nameOf(kind, 'x'), kind.name);
    declared += "END_VAR VAR ";
    for (const Kind& kind : kinds)
      declared += fmt::format("{}, {} : {}; ", nameOf(kind, '0'), nameOf(kind, '1'), kind.name);
    std::string statements;
    for (const auto& [line, run] : body_) statements += line;
    return "TYPE inner : STRUCT a : DINT; b : USINT; END_STRUCT; outer : STRUCT in : inner; t : TIME; END_STRUCT; "
           "END_TYPE\nPROGRAM main\n" +
           declared +
           "b0, b1, b2 : BOOL; r0, r1 : REAL; l0, l1 : LREAL; w0, w1 : STRING[20]; sub : INT (-50..50) := 0; k : DINT; "
           "grid : ARRAY [0..1, -1..1] OF DINT; s : outer; rows : ARRAY [0..1] OF outer; END_VAR\n" +
           statements + "END_PROGRAM\n";
  }
  void scan(State& state) const {
    try {
      for (const auto& [line, run] : body_) run(state);
    } catch (const Returned&) {
    }
  }
  std::int64_t pick(std::int64_t low, std::int64_t high) {
    return std::uniform_int_distribution<std::int64_t>(low, high)(random_);
  }
  /// A value from outside, often at the ends of the type. Dates lie between 1970 and 2033.
  Whole valueOf(const Kind& kind) {
    if (kind.sort == 'C')
      return kind.name[0] == 'D' && kind.name[1] == 'A' ? pick(0, 23000) * 86400
             : kind.name[1] == 'O'                      ? pick(0, 86399999)
                                                        : pick(0, 2'000'000'000);
    const Whole value = pick(0, 2) == 0 ? static_cast<Whole>(pick(-3, 3)) : static_cast<Whole>(random_());
    const Whole bounded = kind.sort == 'T' && kind.bits == 32 ? value % 1'000'000'000 : value;
    return cut(pick(0, 3) == 0 ? bounded + (static_cast<Whole>(1) << (kind.bits - 1)) : bounded, kind);
  }

 private:
  using Run = std::function<void(State&)>;
  using Body = std::vector<std::pair<std::string, Run>>;

  const Kind& anyKind(std::string_view sorts) {
    while (true) {
      const Kind& kind = kinds[pick(0, std::size(kinds) - 1)];
      if (sorts.find(kind.sort) != std::string_view::npos) return kind;
    }
  }
  template <class T = Whole>
  Number named(std::string name) {
    return {name, [name](State& s) { return s.whole[name]; }};
  }
  Number variable(const Kind& kind) {
    if (&kind == &dintKind && pick(0, 2) == 0) {
      const Number i = variable(usintKind), j = variable(usintKind);
      return {fmt::format("grid[{} MOD 2, {} MOD 3 - 1]", i.text, "USINT_TO_INT(" + j.text + ")"), [i, j](State& s) {
                const int row = static_cast<int>(i.compute(s) % 2), column = static_cast<int>(j.compute(s) % 3) - 1;
                return s.whole[fmt::format("grid[{},{}]", row, column)];
              }};
    }
    if (&kind == &dintKind && pick(0, 3) == 0) return named(pick(0, 1) == 0 ? "s.in.a" : "rows[1].in.a");
    if (&kind == &usintKind && pick(0, 3) == 0) return named(pick(0, 1) == 0 ? "s.in.b" : "rows[0].in.b");
    if (&kind == &timeKind && pick(0, 3) == 0) return named("s.t");
    if (&kind == &intKind && pick(0, 4) == 0) return named("sub");
    return named(nameOf(kind, "01x"[pick(0, 2)]));
  }
  Number constant(const Kind& kind) {
    const std::int64_t value = pick(0, kind.sort == 'C' ? 80000 : 100);
    const std::string name = kind.name;
    if (name == "TIME") return {fmt::format("T#{}ms", value), [value](State&) { return value; }};
    if (name == "LTIME") return {fmt::format("LTIME#{}us", value), [value](State&) { return value * 1000; }};
    return {fmt::format("{}#{}", name, value), [value](State&) { return value; }};
  }
  template <class F>
  Number two(const std::string& op, const Number& a, const Number& b, F f) {
    return {fmt::format("({} {} {})", a.text, op, b.text), [a, b, f](State& s) -> Whole {
              const Whole left = a.compute(s), right = b.compute(s);
              return f(left, right);
            }};
  }

  Number truth(int depth) {
    if (depth == 0) {
      const std::string name = pick(0, 1) == 0 ? fmt::format("x{}", pick(0, 1)) : fmt::format("b{}", pick(0, 2));
      return named(name);
    }
    switch (pick(0, 8)) {
      case 0: return two("AND", truth(depth - 1), truth(0), [](Whole a, Whole b) { return a & b; });
      case 1: return two("OR", truth(depth - 1), truth(0), [](Whole a, Whole b) { return a | b; });
      case 2: return two("XOR", truth(depth - 1), truth(0), [](Whole a, Whole b) { return a ^ b; });
      case 3: {
        const Kind& kind = anyKind("B");
        const Number of = named(nameOf(kind, "01x"[pick(0, 2)]));
        const std::int64_t bit = pick(0, kind.bits - 1);
        return {fmt::format("{}.{}", of.text, bit), [of, bit](State& s) { return of.compute(s) >> bit & 1; }};
      }
      case 4: {
        const Real a = real(isLongDrawn(), 1);
        const std::int64_t limit = pick(-8, 8);
        return {fmt::format("({} >= {}.5)", a.text, limit),
                [a, limit](State& s) { return a.compute(s) >= (limit < 0 ? limit - 0.5 : limit + 0.5) ? 1 : 0; }};
      }
      case 5: {
        const Text a = words(1), b = words(0);
        return {fmt::format("({} < {})", a.text, b.text),
                [a, b](State& s) { return a.compute(s) < b.compute(s) ? 1 : 0; }};
      }
      case 6: {
        const Kind& kind = anyKind("IBTC");
        const Number a = variable(kind), b = variable(kind), c = variable(kind);
        return {fmt::format("{}({}, {}, {})", "GE", a.text, b.text, c.text), [a, b, c](State& s) {
                  const Whole x = a.compute(s), y = b.compute(s), z = c.compute(s);
                  return x >= y && y >= z ? 1 : 0;
                }};
      }
      default: {
        const Kind& kind = anyKind("IBTC");
        const Number a = number(kind, depth - 1), b = variable(kind);
        switch (pick(0, 3)) {
          case 0: return two("<", a, b, [](Whole x, Whole y) { return x < y ? 1 : 0; });
          case 1: return two(">=", a, b, [](Whole x, Whole y) { return x >= y ? 1 : 0; });
          case 2: return two("<>", a, b, [](Whole x, Whole y) { return x != y ? 1 : 0; });
          default: return two("=", a, b, [](Whole x, Whole y) { return x == y ? 1 : 0; });
        }
      }
    }
  }

  Number chosen(const Kind& kind, int depth) {
    const Number a = variable(kind), b = number(kind, depth - 1), c = variable(kind);
    switch (pick(0, 3)) {
      case 0: {
        const Number which = truth(depth - 1);
        return {fmt::format("SEL({}, {}, {})", which.text, a.text, b.text), [which, a, b](State& s) {
                  const Whole one = which.compute(s), zero = a.compute(s), other = b.compute(s);
                  return one != 0 ? other : zero;
                }};
      }
      case 1:
        return {fmt::format("MAX({}, {}, {})", a.text, b.text, c.text), [a, b, c](State& s) {
                  return std::max({a.compute(s), b.compute(s), c.compute(s)});
                }};
      case 2:
        return {fmt::format("MIN({}, {})", a.text, b.text),
                [a, b](State& s) { return std::min(a.compute(s), b.compute(s)); }};
      default: {
        const Number which = variable(usintKind);
        return {fmt::format("MUX({} MOD 3, {}, {}, {})", which.text, a.text, b.text, c.text),
                [which, a, b, c](State& s) {
                  const Whole values[] = {a.compute(s), b.compute(s), c.compute(s)};
                  return values[static_cast<int>(which.compute(s) % 3)];
                }};
      }
    }
  }

  Number number(const Kind& kind, int depth) {
    if (depth == 0) return kind.sort != 'C' && pick(0, 4) == 0 ? constant(kind) : variable(kind);
    if (pick(0, 4) == 0) return chosen(kind, depth);
    switch (kind.sort) {
      case 'I': return integer(kind, depth);
      case 'B': return bitString(kind, depth);
      case 'T': return duration(kind, depth);
      default: return date(kind);
    }
  }
  Number integer(const Kind& kind, int depth) {
    const Kind* const type = &kind;
    const Number a = variable(kind), b = number(kind, depth - 1);
    switch (pick(0, 8)) {
      case 0: return two("+", a, b, [type](Whole x, Whole y) { return cut(x + y, *type); });
      case 1: return two("-", a, b, [type](Whole x, Whole y) { return cut(x - y, *type); });
      case 2: return two("*", a, b, [type](Whole x, Whole y) { return product(x, y, *type); });
      case 3: {
        const bool isNegative = kind.isSigned && pick(0, 1) == 0;
        return {isNegative ? fmt::format("({} / MIN({}, -1))", a.text, b.text)
                           : fmt::format("({} / MAX({}, 1))", a.text, b.text),
                [a, b, isNegative, type](State& s) {
                  const Whole x = a.compute(s), y = b.compute(s);
                  return cut(x / (isNegative ? std::min<Whole>(y, -1) : std::max<Whole>(y, 1)), *type);
                }};
      }
      case 4: return two("MOD", a, variable(kind), [](Whole x, Whole y) { return y == 0 ? Whole{0} : x % y; });
      case 5: {
        if (!kind.isSigned) return two("+", a, b, [type](Whole x, Whole y) { return cut(x + y, *type); });
        return {fmt::format("ABS({})", b.text), [b, type](State& s) {
                  const Whole x = b.compute(s);
                  return cut(x < 0 ? -x : x, *type);
                }};
      }
      case 6: {
        const Real of = real(isLongDrawn(), 0);
        const char* const from = of.text[0] == 'r' ? "REAL" : "LREAL";
        return {fmt::format("{}_TO_{}({})", from, kind.name, of.text),
                [of, type](State& s) { return nearest(of.compute(s), *type); }};
      }
      case 7: {
        if (pick(0, 1) == 0) {
          const Number of = truth(depth - 1);
          return {fmt::format("BOOL_TO_{}({})", kind.name, of.text), of.compute};
        }
        if (&kind != &intKind && &kind != &dintKind) return converted(kind, depth);
        const Text of = words(1), in = words(0);
        if (pick(0, 1) == 0)
          return {fmt::format("INT_TO_{}(FIND({}, {}))", kind.name, in.text, of.text), [in, of](State& s) -> Whole {
                    const std::string all = in.compute(s), part = of.compute(s);
                    const std::size_t at = part.empty() ? std::string::npos : all.find(part);
                    return at == std::string::npos ? 0 : static_cast<Whole>(at) + 1;
                  }};
        return {fmt::format("INT_TO_{}(LEN({}))", kind.name, of.text),
                [of](State& s) { return static_cast<Whole>(of.compute(s).size()); }};
      }
      default: return converted(kind, depth);
    }
  }
  Number converted(const Kind& kind, int depth) {
    const Kind& from = anyKind(kind.bits == 32 ? "IBT" : "IB");
    const Number of = from.sort == 'T' ? variable(timeKind) : number(from, depth - 1);
    const Kind* const type = &kind;
    const std::string name = from.sort == 'T' ? "TIME" : from.name;
    if (name == kind.name) return of;
    return {fmt::format("{}_TO_{}({})", name, kind.name, of.text),
            [of, type](State& s) { return cut(of.compute(s), *type); }};
  }
  Number bitString(const Kind& kind, int depth) {
    const Kind* const type = &kind;
    const Number a = number(kind, depth - 1), b = variable(kind), count = variable(usintKind);
    const Whole mask = (static_cast<Whole>(1) << kind.bits) - 1;
    const int bits = kind.bits, most = kind.bits + 2;
    const auto shifted = [&](const char* name, auto f) -> Number {
      return {fmt::format("{}({}, {} MOD {})", name, a.text, count.text, most), [a, count, most, f](State& s) {
                const Whole value = a.compute(s);
                return f(value, static_cast<int>(count.compute(s) % most));
              }};
    };
    switch (pick(0, 8)) {
      case 0: return {"NOT " + a.text, [a, mask](State& s) { return mask & ~a.compute(s); }};
      case 1: return two("AND", b, a, [](Whole x, Whole y) { return x & y; });
      case 2: return two("OR", b, a, [](Whole x, Whole y) { return x | y; });
      case 3: return two("XOR", b, a, [](Whole x, Whole y) { return x ^ y; });
      case 4: return shifted("SHL", [bits, mask](Whole x, int n) { return n >= bits ? 0 : (x << n) & mask; });
      case 5: return shifted("SHR", [bits](Whole x, int n) { return n >= bits ? 0 : x >> n; });
      case 6:
        return shifted("ROL",
                       [bits, mask](Whole x, int n) { return ((x << (n % bits)) | (x >> (bits - n % bits))) & mask; });
      case 7:
        return shifted("ROR",
                       [bits, mask](Whole x, int n) { return ((x >> (n % bits)) | (x << (bits - n % bits))) & mask; });
      default: {
        const Kind& from = anyKind("IB");
        const Number of = number(from, depth - 1);
        if (&from == type) return of;
        return {fmt::format("{}_TO_{}({})", from.name, kind.name, of.text),
                [of, type](State& s) { return cut(of.compute(s), *type); }};
      }
    }
  }
  Number duration(const Kind& kind, int depth) {
    const Kind* const type = &kind;
    const Number a = variable(kind), b = number(kind, depth - 1);
    const std::int64_t by = pick(2, 9);
    switch (pick(0, kind.bits == 32 ? 7 : 4)) {
      case 0: return two("+", a, b, [type](Whole x, Whole y) { return cut(x + y, *type); });
      case 1: return two("-", a, b, [type](Whole x, Whole y) { return cut(x - y, *type); });
      case 2: {
        const Number n = variable(anyKind("I").bits < 32 ? intKind : dintKind);
        return two("*", b, n, [type](Whole x, Whole y) { return product(x, y, *type); });
      }
      case 3: return {fmt::format("({} / {})", b.text, by), [b, by](State& s) { return b.compute(s) / by; }};
      case 4: {
        if (kind.bits == 32)
          return {fmt::format("LTIME_TO_TIME({} / LINT#5_000_000_000)", nameOf(kinds[13], '0')),
                  [](State& s) { return s.whole["ltime0"] / 5'000'000'000 / 1'000'000; }};
        const Number of = variable(timeKind);
        return {fmt::format("TIME_TO_LTIME({})", of.text), [of](State& s) { return of.compute(s) * 1'000'000; }};
      }
      case 5:
        return two("-", named("dt0"), named("dtx"), [type](Whole x, Whole y) { return cut((x - y) * 1000, *type); });
      case 6: return two("-", named("tod0"), named("todx"), [type](Whole x, Whole y) { return cut(x - y, *type); });
      default:
        return two("-", named("date0"), named("datex"),
                   [type](Whole x, Whole y) { return cut((x - y) * 1000, *type); });
    }
  }
  Number date(const Kind& kind) {
    const Kind* const type = &kind;
    const std::string name = kind.name;
    const Number t = variable(timeKind), dt = named(pick(0, 1) == 0 ? "dt1" : "dtx");
    if (name == "DATE")
      return {fmt::format("DT_TO_DATE({})", dt.text), [dt](State& s) { return dt.compute(s) / 86400 * 86400; }};
    if (name == "TOD") {
      if (pick(0, 1) == 0) return two("+", variable(kind), t, [type](Whole x, Whole y) { return cut(x + y, *type); });
      return {fmt::format("DT_TO_TOD({})", dt.text), [dt](State& s) { return dt.compute(s) % 86400 * 1000; }};
    }
    switch (pick(0, 2)) {
      case 0: return two("+", variable(kind), t, [type](Whole x, Whole y) { return cut(x + y / 1000, *type); });
      case 1: return two("-", variable(kind), t, [type](Whole x, Whole y) { return cut(x - y / 1000, *type); });
      default:
        return {"CONCAT_DATE_TOD(datex, todx)", [](State& s) { return s.whole["datex"] + s.whole["todx"] / 1000; }};
    }
  }

  Real real(bool isLong, int depth) {
    if (depth == 0) {
      const std::string name = fmt::format("{}{}", isLong ? 'l' : 'r', pick(0, 1));
      return {name, [name](State& s) { return s.real[name]; }};
    }
    const auto rounded = [isLong](auto f) -> std::function<double(State&)> {
      if (isLong) return f;
      return [f](State& s) { return static_cast<double>(static_cast<float>(f(s))); };
    };
    const Real a = real(isLong, 0), b = real(isLong, depth - 1);
    const double by = static_cast<double>(pick(-20, 20)) / 8;
    switch (pick(0, 9)) {
      case 0:
        return {fmt::format("({} + {})", a.text, b.text),
                rounded([a, b](State& s) { return a.compute(s) + b.compute(s); })};
      case 1:
        return {fmt::format("({} - {})", a.text, b.text),
                rounded([a, b](State& s) { return a.compute(s) - b.compute(s); })};
      case 2:
        return {fmt::format("({} * {})", a.text, b.text),
                rounded([a, b](State& s) { return a.compute(s) * b.compute(s); })};
      case 3: {
        const double divisor = static_cast<double>(pick(1, 40)) / 4;
        return {fmt::format("({} / {:.2f})", b.text, divisor),
                rounded([b, divisor](State& s) { return b.compute(s) / divisor; })};
      }
      case 4:
        return {fmt::format("({} * {:.3f})", b.text, by), rounded([b, by](State& s) { return b.compute(s) * by; })};
      case 5:
        return {fmt::format("SQRT(ABS({}))", b.text),
                rounded([b](State& s) { return std::sqrt(std::abs(b.compute(s))); })};
      case 6:
        return {fmt::format("MAX({}, {})", a.text, b.text),
                [a, b](State& s) { return std::max(a.compute(s), b.compute(s)); }};
      case 7: {
        const Kind& from = anyKind("I");
        const Number of = variable(from);
        return {fmt::format("{}_TO_{}({})", from.name, isLong ? "LREAL" : "REAL", of.text), [of, isLong](State& s) {
                  const Whole value = of.compute(s);
                  return isLong ? static_cast<double>(value) : static_cast<double>(static_cast<float>(value));
                }};
      }
      case 8: {
        const Number which = truth(depth - 1);
        return {fmt::format("SEL({}, {}, {})", which.text, a.text, b.text), [which, a, b](State& s) {
                  const Whole one = which.compute(s);
                  const double zero = a.compute(s), other = b.compute(s);
                  return one != 0 ? other : zero;
                }};
      }
      default:
        if (!hasLongReals_) return a;
        if (isLong) {
          const Real of = real(false, 0);
          return {fmt::format("REAL_TO_LREAL({})", of.text), of.compute};
        }
        const Real of = real(true, 0);
        return {fmt::format("LREAL_TO_REAL({})", of.text), rounded([of](State& s) { return of.compute(s); })};
    }
  }

  Text words(int depth) {
    if (depth == 0) {
      static constexpr const char* literals[] = {"ab", "", "bab", "1"};
      if (pick(0, 2) == 0) {
        const std::string literal = literals[pick(0, 3)];
        return {"'" + literal + "'", [literal](State&) { return literal; }};
      }
      const std::string name = pick(0, 1) == 0 ? "w0" : "w1";
      return {name, [name](State& s) { return s.text[name]; }};
    }
    const Text a = words(depth - 1), b = words(0);
    const auto at = static_cast<std::size_t>(pick(0, 5)), count = static_cast<std::size_t>(pick(0, 4));
    switch (pick(0, 4)) {
      case 0:
        return {fmt::format("CONCAT({}, {})", a.text, b.text),
                [a, b](State& s) { return a.compute(s) + b.compute(s); }};
      case 1:
        return {fmt::format("INSERT({}, {}, {})", a.text, b.text, at), [a, b, at](State& s) {
                  const std::string all = a.compute(s);
                  const std::size_t cutAt = std::min(at, all.size());
                  return all.substr(0, cutAt) + b.compute(s) + all.substr(cutAt);
                }};
      case 2:
        return {fmt::format("DELETE({}, {}, {})", a.text, count, at + 1), [a, count, at](State& s) {
                  std::string all = a.compute(s);
                  if (at < all.size()) all.erase(at, count);
                  return all;
                }};
      case 3: {
        const Kind& kind = pick(0, 1) == 0 ? dintKind : usintKind;
        const Number of = variable(kind);
        return {fmt::format("{}_TO_STRING({})", kind.name, of.text),
                [of](State& s) { return std::to_string(static_cast<std::int64_t>(of.compute(s))); }};
      }
      default: {
        const Number of = truth(0);
        return {fmt::format("BOOL_TO_STRING({})", of.text),
                [of](State& s) { return std::string(of.compute(s) != 0 ? "TRUE" : "FALSE"); }};
      }
    }
  }

  void add(Body& into, int depth);
  static std::string textOf(const Body& body) {
    std::string all;
    for (const auto& [line, run] : body) all += line;
    return all;
  }
  static Run runOf(Body body) {
    return [body](State& s) {
      for (const auto& [line, run] : body) run(s);
    };
  }

  bool isLongDrawn() { return hasLongReals_ && pick(0, 1) == 0; }

  std::mt19937_64 random_;
  bool hasLongReals_;
  Body body_;
};

inline void TypeProgram::add(Body& into, int depth) {
  const auto push = [&](std::string line, Run run) { into.emplace_back(std::move(line) + "\n", std::move(run)); };
  const auto inner = [&] {
    Body body;
    add(body, depth - 1);
    return body;
  };
  switch (pick(0, depth == 0 ? 9 : 14)) {
    case 0: {
      const std::string name = truths[pick(0, 2)];
      const Number value = truth(2);
      return push(fmt::format("{} := {};", name, value.text),
                  [name, value](State& s) { s.whole[name] = value.compute(s); });
    }
    case 1: {
      const bool isLong = isLongDrawn();
      const std::string name = (isLong ? longReals : reals)[pick(0, 1)];
      const Real value = real(isLong, 2);
      return push(fmt::format("{} := LIMIT(-1.0E6, {}, 1.0E6);", name, value.text),
                  [name, value](State& s) { s.real[name] = std::min(std::max(value.compute(s), -1.0e6), 1.0e6); });
    }
    case 2: {
      const std::string name = texts[pick(0, 1)];
      const Text value = words(2);
      return push(fmt::format("{} := {};", name, value.text),
                  [name, value](State& s) { s.text[name] = value.compute(s).substr(0, 20); });
    }
    case 3: {
      const Number i = variable(usintKind), value = number(dintKind, 2);
      const std::int64_t column = pick(-1, 1);
      return push(fmt::format("grid[{} MOD 2, {}] := {};", i.text, column, value.text), [i, column, value](State& s) {
        const int row = static_cast<int>(i.compute(s) % 2);
        s.whole[fmt::format("grid[{},{}]", row, column)] = value.compute(s);
      });
    }
    case 4: {
      const Number a = number(dintKind, 1), t = number(timeKind, 1), i = variable(usintKind);
      return push(
          fmt::format("s.in.a := {}; s.in.b := s.in.b + 1; s.t := {}; rows[{} MOD 2] := s;", a.text, t.text, i.text),
          [a, t, i](State& s) {
            s.whole["s.in.a"] = a.compute(s);
            s.whole["s.in.b"] = cut(s.whole["s.in.b"] + 1, usintKind);
            s.whole["s.t"] = t.compute(s);
            const int row = static_cast<int>(i.compute(s) % 2);
            for (const char* const part : {"in.a", "in.b", "t"})
              s.whole[fmt::format("rows[{}].{}", row, part)] = s.whole[fmt::format("s.{}", part)];
          });
    }
    case 5: {
      const Number value = number(intKind, 1);
      return push(fmt::format("sub := LIMIT(-50, {}, 50);", value.text),
                  [value](State& s) { s.whole["sub"] = std::clamp<Whole>(value.compute(s), -50, 50); });
    }
    case 10: {
      const Number first = truth(1), second = truth(1);
      const Body a = inner(), b = inner(), c = inner();
      return push(fmt::format("IF {} THEN\n{}ELSIF {} THEN\n{}ELSE\n{}END_IF;", first.text, textOf(a), second.text,
                              textOf(b), textOf(c)),
                  [first, second, a = runOf(a), b = runOf(b), c = runOf(c)](State& s) {
                    if (first.compute(s) != 0) return a(s);
                    if (second.compute(s) != 0) return b(s);
                    c(s);
                  });
    }
    case 11: {
      const Number selector = variable(pick(0, 1) == 0 ? dintKind : intKind);
      const Body a = inner(), b = inner();
      return push(
          fmt::format("CASE {} MOD 10 OF\n-9..-3, 0:\n{}5, 7..8:\n{}END_CASE;", selector.text, textOf(a), textOf(b)),
          [selector, a = runOf(a), b = runOf(b)](State& s) {
            const int value = static_cast<int>(selector.compute(s) % 10);
            if (value <= -3 || value == 0) return a(s);
            if (value == 5 || value == 7 || value == 8) b(s);
          });
    }
    case 12: {  // downwards, left where the condition holds
      const Number leaves = truth(1);
      const std::int64_t from = pick(-1, 5), by = pick(1, 3);
      Body loop;
      add(loop, 0);
      return push(fmt::format("FOR k := {} TO -2 BY -{} DO\n{}IF {} THEN EXIT; END_IF;\nEND_FOR;", from, by,
                              textOf(loop), leaves.text),
                  [from, by, leaves, loop = runOf(loop)](State& s) {
                    for (s.whole["k"] = from; s.whole["k"] >= -2; s.whole["k"] -= by) {
                      loop(s);
                      if (leaves.compute(s) != 0) break;
                    }
                  });
    }
    case 13: {
      const Number condition = truth(1);
      if (pick(0, 3) != 0) return push(";", [](State&) {});
      return push(fmt::format("IF {} THEN RETURN; END_IF;", condition.text), [condition](State& s) {
        if (condition.compute(s) != 0) throw Returned{};
      });
    }
    case 14: {
      const Number again = truth(1);
      Body loop;
      add(loop, 0);
      return push(
          fmt::format("k := 0;\nREPEAT\nk := k + 1;\n{}UNTIL k >= 4 OR NOT {} END_REPEAT;", textOf(loop), again.text),
          [again, loop = runOf(loop)](State& s) {
            int rounds = 0;
            do {
              s.whole["k"] = ++rounds;
              loop(s);
            } while (rounds < 4 && again.compute(s) != 0);
          });
    }
    default: {
      const Kind& kind = anyKind("IBTC");
      const std::string name = nameOf(kind, "01"[pick(0, 1)]);
      const Number value = number(kind, 2);
      return push(fmt::format("{} := {};", name, value.text),
                  [name, value](State& s) { s.whole[name] = value.compute(s); });
    }
  }
}

}  // namespace rungproof::iec_types
