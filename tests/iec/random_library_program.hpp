// Random programs that call the rest of the standard's blocks, counters of every type, and own blocks with IN_OUT,
// nested instances, EN and RETURN, each beside the same in plain C++ (naive_blocks.hpp, naive_library.hpp).
#pragma once

#include <fmt/format.h>

#include <functional>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "tests/iec/naive_blocks.hpp"
#include "tests/iec/naive_library.hpp"
#include "tests/iec/naive_types.hpp"

namespace rungproof::iec_naive {

struct LibraryState {
  std::map<std::string, iec_types::Whole> whole;
  std::map<std::string, float> real;
  std::map<std::string, Edge> edges;  ///< of blocks and of the inputs of counters
  std::map<std::string, OnDelay> delays;
  Semaphore semaphore;
  Hysteresis hysteresis;
  Integral integral;
  Derivative derivative;
  Pid pid;
  Ramp ramp;
  std::int64_t now = 0;
};

/// The types in which counters come.
inline constexpr const char* counterTypes[] = {"INT", "DINT", "UDINT", "UINT", "LINT", "ULINT"};

class LibraryProgram {
 public:
  explicit LibraryProgram(std::uint64_t seed) : random_(seed) {
    for (int i = 0; i < 9; ++i) add();
  }

  static constexpr const char* inputs[] = {"x0", "x1", "x2"};
  static constexpr const char *realInputs[] = {"a0", "a1"}, *reals[] = {"it.XOUT", "de.XOUT", "pi.XOUT", "ra.XOUT"};
  static std::vector<std::pair<std::string, int>> wholes() {
    std::vector<std::pair<std::string, int>> all = {
        {"b0", 1},  {"b1", 1},        {"se.BUSY", 1},   {"hy.Q", 1},    {"it.Q", 1},     {"ra.BUSY", 1},
        {"v0", 32}, {"v1", 32},       {"tw.calls", 16}, {"tw.late", 1}, {"tw.d.ET", 32}, {"many[0].Q", 1},
        {"ok", 1},  {"many[1].Q", 1}, {"many[2].Q", 1}, {"tw.by", 32}};
    for (const char* const type : counterTypes) {
      const int bits = type[0] == 'L' || std::string(type) == "ULINT"        ? 64
                       : std::string(type).find("DINT") != std::string::npos ? 32
                                                                             : 16;
      for (const char* const part : {"up_{}.CV", "down_{}.CV", "both_{}.CV"})
        all.emplace_back(fmt::format(fmt::runtime(part), type), bits);
      for (const char* const part : {"up_{}.Q", "down_{}.Q", "both_{}.QU", "both_{}.QD"})
        all.emplace_back(fmt::format(fmt::runtime(part), type), 1);
    }
    return all;
  }

  std::string text() const {
    std::string declared;
    for (const char* const type : counterTypes)
      declared += fmt::format("up_{0} : CTU_{0}; down_{0} : CTD_{0}; both_{0} : CTUD_{0}; ", type);
    std::string statements;
    for (const auto& [line, run] : body_) statements += line;
    return "FUNCTION_BLOCK twist VAR_INPUT on : BOOL; by : DINT := 3; END_VAR VAR_OUTPUT late : BOOL; END_VAR\n"
           "VAR_IN_OUT z : DINT; END_VAR VAR calls : INT; d : TON; END_VAR VAR_TEMP t : DINT; END_VAR\n"
           "calls := calls + 1; t := t + by; d(IN := on, PT := T#30ms, Q => late);\n"
           "IF NOT on THEN RETURN; END_IF; z := z + t; END_FUNCTION_BLOCK\n"
           "PROGRAM main VAR_INPUT x0, x1, x2 : BOOL; a0, a1 : REAL; END_VAR VAR b0, b1, ok : BOOL; v0, v1 : DINT; se "
           ": SEMA; "
           "hy : HYSTERESIS; it : INTEGRAL; de : DERIVATIVE; pi : PID; ra : RAMP; tw : twist; many : ARRAY [0..2] OF "
           "R_TRIG; " +
           declared + "END_VAR\n" + statements + "END_PROGRAM\n";
  }
  void scan(LibraryState& state) const {
    for (const auto& [line, run] : body_) run(state);
  }
  std::int64_t pick(std::int64_t low, std::int64_t high) {
    return std::uniform_int_distribution<std::int64_t>(low, high)(random_);
  }

 private:
  using Run = std::function<void(LibraryState&)>;
  struct Truth {
    std::string text;
    std::function<bool(LibraryState&)> compute;
  };
  struct Real {
    std::string text;
    std::function<float(LibraryState&)> compute;
  };

  Truth truth() {
    static constexpr const char* names[] = {"x0", "x1",      "x2",   "x0",      "x1",        "b0",
                                            "b1", "se.BUSY", "hy.Q", "tw.late", "many[1].Q", "up_DINT.Q"};
    const std::string name = names[pick(0, std::size(names) - 1)];
    const bool isNegated = pick(0, 3) == 0;
    return {isNegated ? "NOT " + name : name,
            [name, isNegated](LibraryState& s) { return (s.whole[name] != 0) != isNegated; }};
  }
  Real real() {
    static constexpr const char* names[] = {"a0", "a1", "ra.XOUT"};
    if (pick(0, 4) == 0) {
      const float value = static_cast<float>(pick(-40, 40)) / 4;
      return {fmt::format("{:.2f}", value), [value](LibraryState&) { return value; }};
    }
    const std::string name = names[pick(0, 2)];
    return {name, [name](LibraryState& s) { return s.real[name]; }};
  }
  void push(std::string line, Run run) { body_.emplace_back(std::move(line) + "\n", std::move(run)); }

  /// Whether the input rises: the memory of each input is an edge of its own.
  static bool rises(LibraryState& s, const std::string& input, bool value) {
    Edge& edge = s.edges[input];
    edge.rising(value);
    return edge.q;
  }

  void counter() {
    const std::string type = counterTypes[pick(0, std::size(counterTypes) - 1)];
    const Truth a = truth(), b = truth(), c = truth(), d = truth();
    const bool isSigned = type[0] != 'U';
    const std::int64_t pv = pick(0, 3) == 0 ? (isSigned ? -pick(1, 3) : 40000) : pick(0, 4);
    switch (pick(0, 2)) {
      case 0: {
        const std::string name = "up_" + type;
        return push(fmt::format("{}(CU := {}, R := {}, PV := {}, Q => b0);", name, a.text, b.text, pv),
                    [=](LibraryState& s) {
                      const bool up = a.compute(s), reset = b.compute(s), isEdge = rises(s, name, up);
                      iec_types::Whole& cv = s.whole[name + ".CV"];
                      if (reset)
                        cv = 0;
                      else if (isEdge && cv < pv)
                        ++cv;
                      s.whole["b0"] = s.whole[name + ".Q"] = cv >= pv ? 1 : 0;
                    });
      }
      case 1: {
        const std::string name = "down_" + type;
        return push(fmt::format("{}(CD := {}, LD := {}, PV := {});", name, a.text, b.text, pv), [=](LibraryState& s) {
          const bool down = a.compute(s), loads = b.compute(s), isEdge = rises(s, name, down);
          iec_types::Whole& cv = s.whole[name + ".CV"];
          if (loads)
            cv = pv;
          else if (isEdge && cv > 0)
            --cv;
          s.whole[name + ".Q"] = cv <= 0 ? 1 : 0;
        });
      }
      default: {
        const std::string name = "both_" + type;
        return push(fmt::format("{}(CU := {}, CD := {}, R := {}, LD := {}, PV := {});", name, a.text, b.text, c.text,
                                d.text, pv),
                    [=](LibraryState& s) {
                      const bool up = a.compute(s), down = b.compute(s), reset = c.compute(s), loads = d.compute(s);
                      const bool goesUp = rises(s, name + "+", up), goesDown = rises(s, name + "-", down);
                      iec_types::Whole& cv = s.whole[name + ".CV"];
                      if (reset)
                        cv = 0;
                      else if (loads)
                        cv = pv;
                      else if (goesUp && !goesDown && cv < pv)
                        ++cv;
                      else if (goesDown && !goesUp && cv > 0)
                        --cv;
                      s.whole[name + ".QU"] = cv >= pv ? 1 : 0;
                      s.whole[name + ".QD"] = cv <= 0 ? 1 : 0;
                    });
      }
    }
  }

  void regulation() {
    const Truth a = truth(), b = truth();
    const Real x = real(), y = real();
    const std::int64_t cycle = pick(1, 50);
    switch (pick(0, 4)) {
      case 0: {
        const float width = static_cast<float>(pick(0, 8)) / 4;
        return push(fmt::format("hy(XIN1 := {}, XIN2 := {}, EPS := {:.2f});", x.text, y.text, width),
                    [=](LibraryState& s) {
                      const float value = x.compute(s), limit = y.compute(s);
                      s.hysteresis.call(value, limit, width);
                      s.whole["hy.Q"] = s.hysteresis.q ? 1 : 0;
                    });
      }
      case 1:
        return push(fmt::format("it(RUN := {}, R1 := {}, XIN := {}, X0 := {}, CYCLE := T#{}ms);", a.text, b.text,
                                x.text, y.text, cycle),
                    [=](LibraryState& s) {
                      const bool run = a.compute(s), reset = b.compute(s);
                      const float in = x.compute(s), start = y.compute(s);
                      s.integral.call(run, reset, in, start, cycle);
                      s.whole["it.Q"] = s.integral.q ? 1 : 0;
                      s.real["it.XOUT"] = s.integral.out;
                    });
      case 2:
        return push(fmt::format("de(RUN := {}, XIN := {}, CYCLE := T#{}ms);", a.text, x.text, cycle),
                    [=](LibraryState& s) {
                      const bool run = a.compute(s);
                      s.derivative.call(run, x.compute(s), cycle);
                      s.real["de.XOUT"] = s.derivative.out;
                    });
      case 3: {
        const float gain = static_cast<float>(pick(-8, 8)) / 4, reset = static_cast<float>(pick(1, 20)) / 2;
        return push(fmt::format("pi(AUTO := {}, PV := {}, SP := {}, X0 := 1.5, KP := {:.2f}, TR := {:.2f}, TD := 0.25, "
                                "CYCLE := T#{}ms);",
                                a.text, x.text, y.text, gain, reset, cycle),
                    [=](LibraryState& s) {
                      const bool isAutomatic = a.compute(s);
                      const float value = x.compute(s), wanted = y.compute(s);
                      s.pid.call({isAutomatic, value, wanted, 1.5F, gain, reset, 0.25F, cycle});
                      s.real["pi.XOUT"] = s.pid.out;
                    });
      }
      default: {
        const std::int64_t duration = pick(1, 200);
        return push(fmt::format("ra(RUN := {}, X0 := {}, X1 := {}, TR := T#{}ms, CYCLE := T#{}ms);", a.text, x.text,
                                y.text, duration, cycle),
                    [=](LibraryState& s) {
                      const bool run = a.compute(s);
                      const float start = x.compute(s), end = y.compute(s);
                      s.ramp.call(run, start, end, duration, cycle);
                      s.whole["ra.BUSY"] = s.ramp.isBusy ? 1 : 0;
                      s.real["ra.XOUT"] = s.ramp.out;
                    });
      }
    }
  }

  /// What a call of `twist` does to the variable that stands for z.
  static void twist(LibraryState& s, bool on, const std::string& z) {
    s.whole["tw.calls"] = iec_types::cut(s.whole["tw.calls"] + 1, iec_types::intKind);
    OnDelay& delay = s.delays["tw"];
    delay.call(on, 30, s.now);
    s.whole["tw.d.ET"] = delay.et;
    s.whole["tw.late"] = delay.q ? 1 : 0;
    if (on) s.whole[z] = iec_types::cut(s.whole[z] + s.whole["tw.by"], iec_types::dintKind);
  }

  void add() {
    const Truth a = truth(), b = truth();
    switch (pick(0, 8)) {
      case 0:
      case 1:
      case 2: return counter();
      case 3:
      case 4: return regulation();
      case 5:
        return push(fmt::format("se(CLAIM := {}, RELEASE := {});", a.text, b.text), [=](LibraryState& s) {
          const bool claim = a.compute(s);
          s.semaphore.call(claim, b.compute(s));
          s.whole["se.BUSY"] = s.semaphore.isTaken ? 1 : 0;
        });
      case 6: {
        const std::int64_t at = pick(0, 2);
        const std::string name = fmt::format("many[{}]", at);
        return push(fmt::format("{}(CLK := {}); b1 := {}.Q XOR {};", name, a.text, name, b.text), [=](LibraryState& s) {
          s.whole[name + ".Q"] = rises(s, name, a.compute(s)) ? 1 : 0;
          s.whole["b1"] = (s.whole[name + ".Q"] != 0) != b.compute(s) ? 1 : 0;
        });
      }
      case 7: {
        const std::string z = pick(0, 1) == 0 ? "v0" : "v1";
        const bool gives = pick(0, 1) == 0;
        const std::int64_t by = pick(-5, 5);
        return push(gives ? fmt::format("tw(on := {}, by := {}, z := {});", a.text, by, z)
                          : fmt::format("tw(on := {}, z := {});", a.text, z),
                    [=](LibraryState& s) {
                      const bool on = a.compute(s);
                      if (gives) s.whole["tw.by"] = by;
                      twist(s, on, z);
                    });
      }
      default:
        return push(fmt::format("tw(EN := {}, on := {}, z := v1, ENO => ok);", a.text, b.text), [=](LibraryState& s) {
          const bool runs = a.compute(s);
          if (runs) twist(s, b.compute(s), "v1");
          s.whole["ok"] = runs ? 1 : 0;
        });
    }
  }

  std::mt19937_64 random_;
  std::vector<std::pair<std::string, Run>> body_;
};

}  // namespace rungproof::iec_naive
