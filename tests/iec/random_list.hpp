// Random lists of IL beside plain C++: each line is written as text and as what it does to an accumulator, so that
// nothing of reader, lowering and engine is shared. Numbers wrap at 16 bits after each operator.
#pragma once

#include <fmt/format.h>

#include <functional>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "tests/iec/iec_run.hpp"

namespace rungproof::iec_list {

struct Accumulators {
  std::map<std::string, std::int64_t> variables;
  std::vector<std::int64_t> stack = {0};  ///< the current one last, before it those that wait for a parenthesis

  std::int64_t& current() { return stack.back(); }
};

struct ListCode {
  std::string text;
  std::function<void(Accumulators&)> run;
  int target = -1;  ///< of a jump: the line that follows if `isTaken`
  std::function<bool(Accumulators&)> isTaken{};
};

inline std::int64_t asInt(std::int64_t value) {
  return static_cast<std::int16_t>(static_cast<std::uint64_t>(value) & 0xFFFF);
}

class RandomList {
 public:
  explicit RandomList(std::uint64_t seed) : random_(seed) {
    for (int i = 0; i < 6; ++i) {
      if (pick(0, 2) == 0)
        numbers();
      else
        truths(pick(0, 3) == 0);
    }
  }

  std::string text() const {
    std::string lines;
    for (const ListCode& line : lines_) lines += line.text + "\n";
    return iecProgram("VAR_INPUT x0, x1 : INT; y0, y1 : BOOL; END_VAR VAR i0, i1, i2 : INT; b0, b1, b2 : BOOL; END_VAR",
                      lines);
  }
  void scan(Accumulators& state) const {
    for (std::size_t at = 0; at < lines_.size();) {
      const ListCode& line = lines_[at];
      if (line.isTaken && line.isTaken(state)) {
        at = static_cast<std::size_t>(line.target);
        continue;
      }
      if (line.run) line.run(state);
      ++at;
    }
  }
  std::int64_t pick(std::int64_t low, std::int64_t high) {
    return std::uniform_int_distribution<std::int64_t>(low, high)(random_);
  }

 private:
  std::string truth() { return pick(0, 1) == 0 ? fmt::format("y{}", pick(0, 1)) : fmt::format("b{}", pick(0, 2)); }
  std::string number() { return pick(0, 1) == 0 ? fmt::format("x{}", pick(0, 1)) : fmt::format("i{}", pick(0, 2)); }
  void add(std::string text, std::function<void(Accumulators&)> run) {
    lines_.push_back({std::move(text), std::move(run)});
  }

  using Combine = std::function<std::int64_t(std::int64_t, std::int64_t)>;
  static const std::vector<std::pair<std::string, Combine>>& truthOperators() {
    static const std::vector<std::pair<std::string, Combine>> all = {
        {"AND", [](auto a, auto b) { return a & b; }},
        {"OR", [](auto a, auto b) { return a | b; }},
        {"XOR", [](auto a, auto b) { return a ^ b; }},
        {"EQ", [](auto a, auto b) { return a == b ? 1 : 0; }},
        {"NE", [](auto a, auto b) { return a != b ? 1 : 0; }}};
    return all;
  }
  static const std::vector<std::pair<std::string, Combine>>& numberOperators() {
    static const std::vector<std::pair<std::string, Combine>> all = {
        {"ADD", [](auto a, auto b) { return asInt(a + b); }},
        {"SUB", [](auto a, auto b) { return asInt(a - b); }},
        {"MUL", [](auto a, auto b) { return asInt(a * b); }}};
    return all;
  }
  static const std::vector<std::pair<std::string, Combine>>& comparisons() {
    static const std::vector<std::pair<std::string, Combine>> all = {
        {"GT", [](auto a, auto b) { return a > b ? 1 : 0; }},  {"GE", [](auto a, auto b) { return a >= b ? 1 : 0; }},
        {"EQ", [](auto a, auto b) { return a == b ? 1 : 0; }}, {"NE", [](auto a, auto b) { return a != b ? 1 : 0; }},
        {"LE", [](auto a, auto b) { return a <= b ? 1 : 0; }}, {"LT", [](auto a, auto b) { return a < b ? 1 : 0; }}};
    return all;
  }
  template <class Table>
  const std::pair<std::string, Combine>& oneOf(const Table& table) {
    return table[static_cast<std::size_t>(pick(0, static_cast<std::int64_t>(table.size()) - 1))];
  }

  void open(const std::string& op, const std::string& first) {
    add(op + "( " + first, [first](Accumulators& a) { a.stack.push_back(a.variables[first]); });
  }
  void close(const Combine& combine, bool negates = false) {
    add(")", [combine, negates](Accumulators& a) {
      const std::int64_t inner = negates ? 1 - a.current() : a.current();
      a.stack.pop_back();
      a.current() = combine(a.current(), inner);
    });
  }

  /// Lines that combine the current truth value.
  void truthLines(int count, int depth) {
    for (int i = 0; i < count; ++i) {
      const auto& [op, combine] = oneOf(truthOperators());
      const bool mayNegate = op == "AND" || op == "OR" || op == "XOR";
      const bool negates = mayNegate && pick(0, 2) == 0;
      const std::string name = truth();
      if (pick(0, 6) == 0) {
        add("NOT", [](Accumulators& a) { a.current() = 1 - a.current(); });
      } else if (depth < 3 && pick(0, 3) == 0) {
        open(op + (negates ? "N" : ""), name);
        truthLines(static_cast<int>(pick(0, 2)), depth + 1);
        close(combine, negates);
      } else if (negates) {
        add(op + "N " + name,
            [name, combine = combine](Accumulators& a) { a.current() = combine(a.current(), 1 - a.variables[name]); });
      } else {
        add(op + " " + name,
            [name, combine = combine](Accumulators& a) { a.current() = combine(a.current(), a.variables[name]); });
      }
    }
  }
  void storeTruth() {
    const std::string target = fmt::format("b{}", pick(0, 2));
    switch (pick(0, 3)) {
      case 0: return add("ST " + target, [target](Accumulators& a) { a.variables[target] = a.current(); });
      case 1: return add("STN " + target, [target](Accumulators& a) { a.variables[target] = 1 - a.current(); });
      case 2:
        return add("S " + target, [target](Accumulators& a) {
          if (a.current() != 0) a.variables[target] = 1;
        });
      default:
        return add("R " + target, [target](Accumulators& a) {
          if (a.current() != 0) a.variables[target] = 0;
        });
    }
  }
  /// A truth value that is computed and stored; with a jump over other lines, behind which it is still current.
  void truths(bool jumps) {
    const std::string name = truth();
    const bool negates = pick(0, 1) == 0;
    add(std::string(negates ? "LDN " : "LD ") + name,
        [name, negates](Accumulators& a) { a.current() = negates ? 1 - a.variables[name] : a.variables[name]; });
    truthLines(static_cast<int>(pick(0, 4)), 0);
    storeTruth();
    if (!jumps) return storeTruth();
    const bool whenFalse = pick(0, 1) == 0;
    const std::string label = fmt::format("L{}", lines_.size());
    const std::size_t jump = lines_.size();
    lines_.push_back({fmt::format("JMPC{} {}", whenFalse ? "N" : "", label), {}, -1, [whenFalse](Accumulators& a) {
                        return (a.current() != 0) != whenFalse;
                      }});
    truthLines(static_cast<int>(pick(0, 2)), 0);
    storeTruth();
    lines_[jump].target = static_cast<int>(lines_.size());
    add(label + ":", {});
    storeTruth();
  }

  void numbers() {
    const std::string name = number();
    add("LD " + name, [name](Accumulators& a) { a.current() = a.variables[name]; });
    numberLines(static_cast<int>(pick(0, 4)), 0);
    if (pick(0, 1) == 0) {
      const std::string target = fmt::format("i{}", pick(0, 2));
      add("ST " + target, [target](Accumulators& a) { a.variables[target] = a.current(); });
      numberLines(1, 0);
    }
    const std::string limit = number();
    const auto& [op, compare] = oneOf(comparisons());
    add(op + " " + limit,
        [limit, compare = compare](Accumulators& a) { a.current() = compare(a.current(), a.variables[limit]); });
    truthLines(static_cast<int>(pick(0, 2)), 0);
    storeTruth();
  }
  void numberLines(int count, int depth) {
    for (int i = 0; i < count; ++i) {
      const auto& [op, combine] = oneOf(numberOperators());
      if (depth < 3 && pick(0, 2) == 0) {
        open(op, number());
        numberLines(static_cast<int>(pick(0, 2)), depth + 1);
        close(combine);
      } else if (pick(0, 2) == 0) {
        const std::int64_t value = pick(-300, 300);
        add(fmt::format("{} {}", op, value),
            [value, combine = combine](Accumulators& a) { a.current() = combine(a.current(), value); });
      } else {
        const std::string name = number();
        add(op + " " + name,
            [name, combine = combine](Accumulators& a) { a.current() = combine(a.current(), a.variables[name]); });
      }
    }
  }

  std::mt19937_64 random_;
  std::vector<ListCode> lines_;
};

}  // namespace rungproof::iec_list
