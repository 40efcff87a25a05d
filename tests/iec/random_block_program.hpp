// Random programs in ST with blocks, own blocks and functions, texts, structures, loops and numbers of 64 bits, each
// beside the same in plain C++ (naive_blocks.hpp). The generator writes each statement as text and as a function.
#pragma once

#include <fmt/format.h>

#include <cstdlib>
#include <functional>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "tests/iec/naive_blocks.hpp"

namespace rungproof::iec_naive {

struct State {
  std::map<std::string, std::int64_t> whole;
  std::map<std::string, double> real;
  std::map<std::string, std::string> text;
  std::map<std::string, OnDelay> onDelays;
  std::map<std::string, Pulse> pulses;
  std::map<std::string, OffDelay> offDelays;
  std::map<std::string, Counter> counters;
  std::map<std::string, Edge> edges;
  std::int64_t now = 0;
};

template <class T>
struct Term {
  std::string text;
  std::function<T(State&)> compute;
};
using Truth = Term<bool>;
using Number = Term<std::int64_t>;
using Real = Term<double>;
using Text = Term<std::string>;

inline std::int64_t plus(std::int64_t a, std::int64_t b) {
  return static_cast<std::int64_t>(static_cast<std::uint64_t>(a) + static_cast<std::uint64_t>(b));
}
inline std::int64_t times(std::int64_t a, std::int64_t b) {
  return static_cast<std::int64_t>(static_cast<std::uint64_t>(a) * static_cast<std::uint64_t>(b));
}

class BlockProgram {
 public:
  explicit BlockProgram(std::uint64_t seed) : random_(seed) {
    for (int i = 0; i < 10; ++i) add(2);
  }

  /// Names of the variables whose values both have at the ends of scans.
  static constexpr const char* inputs[] = {"x0", "x1", "x2"};
  static constexpr const char* truths[] = {"b0",   "b1",   "b2",   "b3",    "t0.Q",  "p0.Q",  "o0.Q", "r0.Q",
                                           "f0.Q", "u0.Q", "d0.Q", "c0.QU", "c0.QD", "s0.Q1", "s1.Q1"};
  static constexpr const char* wholes[] = {"l0",    "l1",    "l2",    "k",     "e",      "n",      "t0.ET",
                                           "p0.ET", "o0.ET", "u0.CV", "d0.CV", "c0.CV",  "m0.sum", "m1.sum",
                                           "m0.n",  "m1.n",  "z.a",   "z.b",   "y[0].a", "y[1].b", "y[2].a"};
  static constexpr const char* reals[] = {"g0", "g1"};
  static constexpr const char* texts[] = {"w0", "w1"};

  std::string text() const {
    std::string statements;
    for (const auto& [line, run] : body_) statements += line;
    return "TYPE pair : STRUCT a : LINT; b : INT; END_STRUCT; hue : (red, green := 5, blue); END_TYPE\n"
           "FUNCTION weigh : LINT VAR_INPUT a : LINT; b : LINT := 3; END_VAR VAR i : LINT; END_VAR\n"
           "FOR i := 1 TO 3 DO weigh := weigh + a; IF weigh > 1000 THEN RETURN; END_IF; END_FOR; weigh := weigh - b; "
           "END_FUNCTION\n"
           "FUNCTION_BLOCK meter VAR_INPUT step : BOOL R_EDGE; by : LINT := 2; END_VAR VAR_OUTPUT sum : LINT; END_VAR "
           "VAR n : INT; END_VAR\n"
           "n := n + 1; IF step THEN sum := sum + by; END_IF; END_FUNCTION_BLOCK\n"
           "PROGRAM main VAR_INPUT x0, x1, x2 : BOOL; END_VAR VAR b0, b1, b2, b3 : BOOL; l0, l1, l2 : LINT; k : INT; "
           "e : hue; n : INT; g0, g1 : LREAL; w0, w1 : STRING[20]; t0 : TON; p0 : TP; o0 : TOF; r0 : R_TRIG; "
           "f0 : F_TRIG; u0 : CTU; d0 : CTD; c0 : CTUD; s0 : SR; s1 : RS; m0, m1 : meter; z : pair; "
           "y : ARRAY [0..2] OF pair; END_VAR\n" +
           statements + "END_PROGRAM\n";
  }
  void scan(State& state) const {
    for (const auto& [line, run] : body_) run(state);
  }
  std::int64_t pick(std::int64_t low, std::int64_t high) {
    return std::uniform_int_distribution<std::int64_t>(low, high)(random_);
  }

 private:
  using Run = std::function<void(State&)>;
  using Body = std::vector<std::pair<std::string, Run>>;

  Truth variable() {
    static constexpr const char* names[] = {"x0",   "x1",   "x2",   "b0",   "b1",   "b2",    "b3",    "t0.Q", "p0.Q",
                                            "o0.Q", "r0.Q", "f0.Q", "u0.Q", "d0.Q", "c0.QU", "s0.Q1", "s1.Q1"};
    const std::string name = names[pick(0, std::size(names) - 1)];
    return {name, [name](State& s) { return s.whole[name] != 0; }};
  }
  Truth truth(int depth) {
    if (depth == 0) return variable();
    const Truth a = truth(depth - 1), b = truth(depth - 1);
    switch (pick(0, 7)) {
      case 0: return {"NOT " + a.text, [a](State& s) { return !a.compute(s); }};
      case 1:
        return {fmt::format("({} AND {})", a.text, b.text), [a, b](State& s) { return a.compute(s) && b.compute(s); }};
      case 2:
        return {fmt::format("({} OR {})", a.text, b.text), [a, b](State& s) { return a.compute(s) || b.compute(s); }};
      case 3:
        return {fmt::format("({} XOR {})", a.text, b.text), [a, b](State& s) { return a.compute(s) != b.compute(s); }};
      case 4: {
        const Number x = number(1), y = number(1);
        return {fmt::format("({} < {})", x.text, y.text), [x, y](State& s) { return x.compute(s) < y.compute(s); }};
      }
      case 5: {
        const Real x = real(1), y = real(1);
        return {fmt::format("({} <= {})", x.text, y.text), [x, y](State& s) { return x.compute(s) <= y.compute(s); }};
      }
      case 6: {
        const Text x = words(1), y = words(0);
        return {fmt::format("({} = {})", x.text, y.text), [x, y](State& s) { return x.compute(s) == y.compute(s); }};
      }
      default: {
        const std::int64_t ms = pick(0, 80);
        return {fmt::format("(t0.ET >= T#{}ms)", ms), [ms](State& s) { return s.whole["t0.ET"] >= ms; }};
      }
    }
  }

  Number number(int depth) {
    if (depth == 0) {
      if (pick(0, 3) == 0) {
        const std::int64_t value = pick(0, 2) == 0 ? pick(3'000'000'000, 9'000'000'000) : pick(0, 50);
        return {fmt::format("LINT#{}", value), [value](State&) { return value; }};
      }
      static constexpr const char* names[] = {"l0", "l1", "l2", "m0.sum", "m1.sum", "z.a", "y[1].a"};
      const std::string name = names[pick(0, std::size(names) - 1)];
      return {name, [name](State& s) { return s.whole[name]; }};
    }
    const Number a = number(depth - 1), b = number(depth - 1);
    switch (pick(0, 8)) {
      case 0:
        return {fmt::format("({} + {})", a.text, b.text),
                [a, b](State& s) { return plus(a.compute(s), b.compute(s)); }};
      case 1:
        return {fmt::format("({} - {})", a.text, b.text),
                [a, b](State& s) { return plus(a.compute(s), times(b.compute(s), -1)); }};
      case 2:
        return {fmt::format("({} * {})", a.text, b.text),
                [a, b](State& s) { return times(a.compute(s), b.compute(s)); }};
      case 3: {
        const std::int64_t by = pick(2, 9);
        return {fmt::format("({} / {})", a.text, by), [a, by](State& s) { return a.compute(s) / by; }};
      }
      case 4: {
        const std::int64_t by = pick(2, 9);
        return {fmt::format("({} MOD {})", a.text, by), [a, by](State& s) { return a.compute(s) % by; }};
      }
      case 5: {
        const Number c = number(0);
        return {fmt::format("weigh({}, {})", a.text, c.text), [a, c](State& s) {
                  const std::int64_t first = a.compute(s), second = c.compute(s);
                  std::int64_t sum = 0;
                  for (int i = 0; i < 3; ++i) {
                    sum = plus(sum, first);
                    if (sum > 1000) return sum;
                  }
                  return plus(sum, times(second, -1));
                }};
      }
      case 6: {
        const Text w = words(1);
        return {fmt::format("INT_TO_LINT(LEN({}))", w.text),
                [w](State& s) { return static_cast<std::int64_t>(w.compute(s).size()); }};
      }
      case 7:
        return {fmt::format("MAX({}, {})", a.text, b.text),
                [a, b](State& s) { return std::max(a.compute(s), b.compute(s)); }};
      default: {
        const Truth which = truth(0);
        return {fmt::format("SEL({}, {}, {})", which.text, a.text, b.text), [which, a, b](State& s) {
                  const bool one = which.compute(s);
                  const std::int64_t x = a.compute(s), y = b.compute(s);
                  return one ? y : x;
                }};
      }
    }
  }

  Real real(int depth) {
    if (depth == 0) {
      const std::string name = pick(0, 1) == 0 ? "g0" : "g1";
      return {name, [name](State& s) { return s.real[name]; }};
    }
    const Real a = real(depth - 1);
    const double by = std::strtod(fmt::format("{:.3f}", static_cast<double>(pick(-20, 20)) / 8 + 0.1).c_str(), nullptr);
    switch (pick(0, 4)) {
      case 0: return {fmt::format("({} + {:.3f})", a.text, by), [a, by](State& s) { return a.compute(s) + by; }};
      case 1: return {fmt::format("({} * {:.3f})", a.text, by), [a, by](State& s) { return a.compute(s) * by; }};
      case 2: return {"(-" + a.text + ")", [a](State& s) { return -a.compute(s); }};
      case 3: return {"MIN(" + a.text + ", 1000.0)", [a](State& s) { return std::min(a.compute(s), 1000.0); }};
      default: {
        const Truth which = truth(0);
        return {fmt::format("SEL({}, {}, 0.5)", which.text, a.text), [which, a](State& s) {
                  const bool one = which.compute(s);
                  const double x = a.compute(s);
                  return one ? 0.5 : x;
                }};
      }
    }
  }

  Text words(int depth) {
    if (depth == 0) {
      switch (pick(0, 3)) {
        case 0: return {"'ab'", [](State&) { return std::string("ab"); }};
        case 1: return {"''", [](State&) { return std::string(); }};
        default: {
          const std::string name = pick(0, 1) == 0 ? "w0" : "w1";
          return {name, [name](State& s) { return s.text[name]; }};
        }
      }
    }
    const Text a = words(depth - 1), b = words(depth - 1);
    const auto count = static_cast<std::size_t>(pick(0, 6));
    switch (pick(0, 4)) {
      case 0:
        return {fmt::format("CONCAT({}, {})", a.text, b.text),
                [a, b](State& s) { return a.compute(s) + b.compute(s); }};
      case 1:
        return {fmt::format("LEFT({}, {})", a.text, count),
                [a, count](State& s) { return a.compute(s).substr(0, count); }};
      case 2:
        return {fmt::format("RIGHT({}, {})", a.text, count), [a, count](State& s) {
                  const std::string all = a.compute(s);
                  return all.size() <= count ? all : all.substr(all.size() - count);
                }};
      case 3: {
        const auto at = static_cast<std::size_t>(pick(1, 5));
        return {fmt::format("MID({}, {}, {})", a.text, count, at), [a, count, at](State& s) {
                  const std::string all = a.compute(s);
                  return at > all.size() ? std::string() : all.substr(at - 1, count);
                }};
      }
      default: {
        const auto at = static_cast<std::size_t>(pick(1, 4));
        return {fmt::format("REPLACE({}, {}, {}, {})", a.text, b.text, count, at), [a, b, count, at](State& s) {
                  const std::string all = a.compute(s), what = b.compute(s);
                  const std::string rest = at - 1 + count < all.size() ? all.substr(at - 1 + count) : "";
                  return all.substr(0, std::min(at - 1, all.size())) + what + rest;
                }};
      }
    }
  }

  void add(int depth) { add(body_, depth); }
  void add(Body& into, int depth) {
    const auto push = [&](std::string line, Run run) { into.emplace_back(std::move(line) + "\n", std::move(run)); };
    switch (pick(0, depth == 0 ? 9 : 13)) {
      case 0: {
        const std::string name = fmt::format("b{}", pick(0, 3));
        const Truth value = truth(2);
        return push(fmt::format("{} := {};", name, value.text),
                    [name, value](State& s) { s.whole[name] = value.compute(s) ? 1 : 0; });
      }
      case 1: {
        const std::string name = fmt::format("l{}", pick(0, 2));
        const Number value = number(2);
        return push(fmt::format("{} := {};", name, value.text),
                    [name, value](State& s) { s.whole[name] = value.compute(s); });
      }
      case 2: {
        const std::string name = pick(0, 1) == 0 ? "g0" : "g1";
        const Real value = real(2);
        return push(fmt::format("{} := {};", name, value.text),
                    [name, value](State& s) { s.real[name] = value.compute(s); });
      }
      case 3: {
        const std::string name = pick(0, 1) == 0 ? "w0" : "w1";
        const Text value = words(2);
        return push(fmt::format("{} := {};", name, value.text),
                    [name, value](State& s) { s.text[name] = value.compute(s).substr(0, 20); });
      }
      case 4:
      case 5: return timer(push);
      case 6:
      case 7: return counter(push);
      case 8: {
        const bool isFirst = pick(0, 1) == 0;
        const std::string name = isFirst ? "m0" : "m1";
        const Truth step = truth(1);
        const Number by = number(0);
        const bool gives = pick(0, 2) > 0;
        return push(gives ? fmt::format("{}(step := {}, by := {});", name, step.text, by.text)
                          : fmt::format("{}(step := {});", name, step.text),
                    [name, step, by, gives](State& s) {
                      const bool on = step.compute(s);
                      if (gives) s.whole[name + ".by"] = by.compute(s);
                      Edge& edge = s.edges[name];
                      edge.rising(on);
                      s.whole[name + ".n"] = static_cast<std::int16_t>(s.whole[name + ".n"] + 1);
                      if (edge.q) s.whole[name + ".sum"] = plus(s.whole[name + ".sum"], s.whole[name + ".by"]);
                    });
      }
      case 9: {
        const std::int64_t at = pick(0, 2);
        const Number value = number(1);
        const std::string element = fmt::format("y[{}]", at);
        return push(
            fmt::format("z.a := {}; z.b := z.b + 1; k := {}; y[k] := z; e := SEL(z.b > 3, red, blue);", value.text, at),
            [value, at, element](State& s) {
              s.whole["z.a"] = value.compute(s);
              s.whole["z.b"] = static_cast<std::int16_t>(s.whole["z.b"] + 1);
              s.whole["k"] = at;
              s.whole[element + ".a"] = s.whole["z.a"];
              s.whole[element + ".b"] = s.whole["z.b"];
              s.whole["e"] = s.whole["z.b"] > 3 ? 6 : 0;
            });
      }
      case 10: {
        const Truth condition = truth(1);
        Body yes, no;
        add(yes, depth - 1);
        add(no, depth - 1);
        return push(fmt::format("IF {} THEN\n{}ELSE\n{}END_IF;", condition.text, yes[0].first, no[0].first),
                    [condition, yes, no](State& s) { condition.compute(s) ? yes[0].second(s) : no[0].second(s); });
      }
      case 11: {  // five rounds, of which the even ones are left early
        Body loop;
        add(loop, 0);
        const std::string counter = pick(0, 1) == 0 ? "n" : "n";
        return push(
            fmt::format("{0} := 0;\nWHILE TRUE DO\n{0} := {0} + 1; IF {0} > 5 THEN EXIT; END_IF; IF {0} MOD 2 = 0 "
                        "THEN CONTINUE; END_IF;\n{1}END_WHILE;",
                        counter, loop[0].first),
            [loop](State& s) {
              for (int i = 1; i <= 5; i += 2) loop[0].second(s);
              s.whole["n"] = 6;
            });
      }
      case 12: {  // two rounds
        Body loop;
        add(loop, 0);
        return push(fmt::format("n := 0;\nREPEAT\nn := n + 1;\n{}UNTIL n >= 2 END_REPEAT;", loop[0].first),
                    [loop](State& s) {
                      loop[0].second(s);
                      loop[0].second(s);
                      s.whole["n"] = 2;
                    });
      }
      default: {
        Body first, rest;
        add(first, depth - 1);
        add(rest, depth - 1);
        return push(fmt::format("CASE e OF\nred:\n{}green, hue#blue:\n{}END_CASE;", first[0].first, rest[0].first),
                    [first, rest](State& s) { s.whole["e"] == 0 ? first[0].second(s) : rest[0].second(s); });
      }
    }
  }

  template <class Push>
  void timer(Push&& push) {
    const Truth in = truth(1);
    const std::int64_t fixed = pick(0, 90);
    const bool isFixed = pick(0, 1) == 0;
    const Term<std::int64_t> preset{isFixed ? fmt::format("T#{}ms", fixed) : fmt::format("T#1ms * (k + {})", fixed),
                                    [fixed, isFixed](State& s) { return isFixed ? fixed : s.whole["k"] + fixed; }};
    const auto line = [&](const char* name) {
      return fmt::format("{}(IN := {}, PT := {});", name, in.text, preset.text);
    };
    const auto run = [in, preset](auto State::*list, std::string name) {
      return [in, preset, list, name](State& s) {
        const bool on = in.compute(s);
        auto& block = (s.*list)[name];
        block.call(on, preset.compute(s), s.now);
        s.whole[name + ".Q"] = block.q ? 1 : 0;
        s.whole[name + ".ET"] = block.et;
      };
    };
    switch (pick(0, 2)) {
      case 0: return push(line("t0"), run(&State::onDelays, "t0"));
      case 1: return push(line("p0"), run(&State::pulses, "p0"));
      default: return push(line("o0"), run(&State::offDelays, "o0"));
    }
  }

  template <class Push>
  void counter(Push&& push) {
    const Truth a = truth(1), b = truth(0), c = truth(0), d = truth(0);
    const std::int64_t pv = pick(-1, 4);
    switch (pick(0, 6)) {
      case 0:
        return push(fmt::format("u0(CU := {}, R := {}, PV := {});", a.text, b.text, pv), [a, b, pv](State& s) {
          Counter& block = s.counters["u0"];
          const bool up = a.compute(s);
          block.countUp(up, b.compute(s), pv);
          s.whole["u0.Q"] = block.qu;
          s.whole["u0.CV"] = block.cv;
        });
      case 1:
        return push(fmt::format("d0(CD := {}, LD := {}, PV := {});", a.text, b.text, pv), [a, b, pv](State& s) {
          Counter& block = s.counters["d0"];
          const bool down = a.compute(s);
          block.countDown(down, b.compute(s), pv);
          s.whole["d0.Q"] = block.qd;
          s.whole["d0.CV"] = block.cv;
        });
      case 2:
        return push(
            fmt::format("c0(CU := {}, CD := {}, R := {}, LD := {}, PV := {});", a.text, b.text, c.text, d.text, pv),
            [a, b, c, d, pv](State& s) {
              Counter& block = s.counters["c0"];
              const bool up = a.compute(s), down = b.compute(s), r = c.compute(s);
              block.countBoth(up, down, r, d.compute(s), pv);
              s.whole["c0.QU"] = block.qu;
              s.whole["c0.QD"] = block.qd;
              s.whole["c0.CV"] = block.cv;
            });
      case 3:
      case 4: {
        const bool rises = pick(0, 1) == 0;
        return push(fmt::format("{}(CLK := {});", rises ? "r0" : "f0", a.text), [a, rises](State& s) {
          Edge& block = s.edges[rises ? "r0" : "f0"];
          const bool on = a.compute(s);
          rises ? block.rising(on) : block.falling(on);
          s.whole[rises ? "r0.Q" : "f0.Q"] = block.q;
        });
      }
      case 5:
        return push(fmt::format("s0(S1 := {}, R := {});", a.text, b.text), [a, b](State& s) {
          const bool set = a.compute(s), reset = b.compute(s);
          s.whole["s0.Q1"] = set || (!reset && s.whole["s0.Q1"] != 0);
        });
      default:
        return push(fmt::format("s1(S := {}, R1 := {});", a.text, b.text), [a, b](State& s) {
          const bool set = a.compute(s), reset = b.compute(s);
          s.whole["s1.Q1"] = !reset && (set || s.whole["s1.Q1"] != 0);
        });
    }
  }

  std::mt19937_64 random_;
  Body body_;
};

}  // namespace rungproof::iec_naive
