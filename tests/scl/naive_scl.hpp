// Random programs in SCL and what they mean, said a second time: an interpreter over a tree of its own, which shares
// nothing with the reader. Numbers wrap as the CPU's do; quotients are cut towards zero. Part of tests/scl.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <random>
#include <string>
#include <vector>

namespace rungproof::testscl {

enum class NaiveType { Int, DInt, Bool, Word };

struct NaiveState {
  std::array<std::int32_t, 4> ints{}, dints{};
  std::array<bool, 4> bools{};
  std::array<std::uint16_t, 4> words{};
  std::array<std::int32_t, 5> list{};  ///< ARRAY[-1..3] OF INT
};

/// A value with the width that its type has.
struct NaiveValue {
  NaiveType type = NaiveType::Int;
  std::int64_t number = 0;
};

inline std::int64_t wrapped(NaiveType type, std::int64_t number) {
  switch (type) {
    case NaiveType::Int: return static_cast<std::int16_t>(number);
    case NaiveType::DInt: return static_cast<std::int32_t>(number);
    case NaiveType::Word: return static_cast<std::uint16_t>(number);
    default: return number != 0;
  }
}

class NaiveScl {
 public:
  explicit NaiveScl(std::uint64_t seed) : random_(seed) {}

  NaiveState state;

  /// Statements as text, carried out on the state while they are made.
  std::string program(int count) {
    std::string text;
    for (int i = 0; i < count; ++i) text += statement(3, true);
    return text;
  }

  /// An expression of that type; `value` is what it gives now.
  std::string expression(NaiveType type, int depth, std::int64_t& value) {
    switch (type) {
      case NaiveType::Bool: return truth(depth, value);
      case NaiveType::Word: return word(depth, value);
      default: return number(type, depth, value);
    }
  }

  static std::string declarations() {
    return "VAR_TEMP\n i0 : INT; i1 : INT; i2 : INT; i3 : INT; d0 : DINT; d1 : DINT; d2 : DINT; d3 : DINT;\n"
           " b0 : BOOL; b1 : BOOL; b2 : BOOL; b3 : BOOL; w0 : WORD; w1 : WORD; w2 : WORD; w3 : WORD;\n"
           " list : ARRAY[-1..3] OF INT; k : INT; good : INT; wrong : INT;\nEND_VAR\n";
  }
  /// Assignments of the values that the state holds.
  std::string initial() const {
    std::string text;
    for (std::size_t i = 0; i < 4; ++i) {
      text += "#i" + std::to_string(i) + " := " + std::to_string(state.ints[i]) + ";\n#d" + std::to_string(i) +
              " := " + std::to_string(state.dints[i]) + ";\n#b" + std::to_string(i) +
              (state.bools[i] ? " := TRUE;\n#w" : " := FALSE;\n#w") + std::to_string(i) +
              " := " + std::to_string(state.words[i]) + ";\n";
    }
    for (int i = -1; i <= 3; ++i)
      text +=
          "#list[" + std::to_string(i) + "] := " + std::to_string(state.list[static_cast<std::size_t>(i + 1)]) + ";\n";
    return text;
  }
  /// Counts in #good which variables have the values of the state.
  std::string comparison() const {
    std::string text = "#good := 0;\n";
    const auto compare = [&](const std::string& name, const std::string& value) {
      text += "IF " + name + " = " + value + " THEN #good := #good + 1; END_IF;\n";
    };
    for (std::size_t i = 0; i < 4; ++i) {
      compare("#i" + std::to_string(i), std::to_string(state.ints[i]));
      compare("#d" + std::to_string(i), std::to_string(state.dints[i]));
      compare("#b" + std::to_string(i), state.bools[i] ? "TRUE" : "FALSE");
      compare("#w" + std::to_string(i), std::to_string(state.words[i]));
    }
    for (int i = -1; i <= 3; ++i)
      compare("#list[" + std::to_string(i) + "]", std::to_string(state.list[static_cast<std::size_t>(i + 1)]));
    return text;
  }
  static constexpr int compared = 21;

  void randomState() {
    for (std::size_t i = 0; i < 4; ++i) {
      state.ints[i] = static_cast<std::int16_t>(pick(3) == 0 ? random_() : pick(21) - 10);
      state.dints[i] = pick(3) == 0 ? static_cast<std::int32_t>(random_() >> 1) : pick(2001) - 1000;
      state.bools[i] = pick(2) == 0;
      state.words[i] = static_cast<std::uint16_t>(random_());
    }
    for (std::int32_t& one : state.list) one = pick(100) - 50;
  }

 private:
  int pick(int count) { return static_cast<int>(random_() % static_cast<std::uint64_t>(count)); }
  std::string anyOf(std::initializer_list<const char*> texts) {
    return texts.begin()[pick(static_cast<int>(texts.size()))];
  }

  std::string number(NaiveType type, int depth, std::int64_t& value) {
    const bool isWide = type == NaiveType::DInt;
    if (depth == 0 || pick(5) == 0) {
      const auto i = static_cast<std::size_t>(pick(4));
      switch (pick(isWide ? 4 : 3)) {
        case 0: value = pick(200) - 100; return value < 0 ? "(" + std::to_string(value) + ")" : std::to_string(value);
        case 1:
          if (!isWide) {
            const int at = pick(5);
            value = state.list[static_cast<std::size_t>(at)];
            return "#list[" + std::to_string(at - 1) + "]";
          }
          value = state.ints[i];  // widened
          return "#i" + std::to_string(i);
        case 2: value = isWide ? state.dints[i] : state.ints[i]; return (isWide ? "#d" : "#i") + std::to_string(i);
        default: value = state.dints[i]; return "#d" + std::to_string(i);
      }
    }
    std::int64_t left = 0, right = 0;
    switch (pick(8)) {
      case 0: {
        const std::string inner = typed(type, depth - 1, left);
        value = wrapped(type, -left);
        return "-(" + inner + ")";
      }
      case 1: {
        const std::string inner = typed(type, depth - 1, left);
        value = wrapped(type, left < 0 ? -left : left);
        return "ABS(" + inner + ")";
      }
      case 2: {
        const std::string a = typed(type, depth - 1, left), b = typed(type, depth - 1, right);
        const bool isMost = pick(2) == 0;
        value = isMost ? std::max(left, right) : std::min(left, right);
        return (isMost ? "MAX(" : "MIN(") + a + ", " + b + ")";
      }
      case 3: {
        std::int64_t chooses = 0;
        const std::string c = truth(depth - 1, chooses), a = typed(type, depth - 1, left),
                          b = typed(type, depth - 1, right);
        value = chooses != 0 ? right : left;
        return "SEL(G := " + c + ", IN0 := " + a + ", IN1 := " + b + ")";
      }
      case 4: {  // a divisor that is not 0
        const std::string a = typed(type, depth - 1, left);
        right = pick(2) == 0 ? pick(9) + 1 : -(pick(9) + 1);
        const bool isRemainder = pick(2) == 0;
        value = wrapped(type, isRemainder ? left % right : left / right);
        const std::string b = right < 0 ? "(" + std::to_string(right) + ")" : std::to_string(right);
        return "(" + a + (isRemainder ? " MOD " : anyOf({" / ", " DIV "})) + b + ")";
      }
      default: {
        const std::string a = typed(type, depth - 1, left), b = typed(type, depth - 1, right);
        const int op = pick(3);
        value = wrapped(type, op == 0 ? left + right : op == 1 ? left - right : left * right);
        return "(" + a + (op == 0 ? " + " : op == 1 ? " - " : " * ") + b + ")";
      }
    }
  }
  /// Of exactly that type, so that what is computed with it has the width.
  std::string typed(NaiveType type, int depth, std::int64_t& value) {
    if (type == NaiveType::Int) {
      const std::string text = number(type, depth, value);
      return text;
    }
    std::int64_t inner = 0;
    const std::string text = number(type, depth, inner);
    value = wrapped(type, inner + 0);
    return "(" + text + " + DINT#0)";
  }

  std::string word(int depth, std::int64_t& value) {
    if (depth == 0 || pick(4) == 0) {
      const auto i = static_cast<std::size_t>(pick(4));
      if (pick(3) == 0) {
        value = pick(65536);
        char text[16];
        std::snprintf(text, sizeof text, "W#16#%04X", static_cast<unsigned>(value));
        return text;
      }
      value = state.words[i];
      return "#w" + std::to_string(i);
    }
    std::int64_t left = 0, right = 0;
    const std::string a = word(depth - 1, left);
    switch (pick(5)) {
      case 0: value = wrapped(NaiveType::Word, ~left); return "NOT (" + a + ")";
      case 1: {
        const int n = pick(16);
        const int kind = pick(4);
        const auto v = static_cast<std::uint32_t>(left);
        const std::uint32_t turned = kind == 0   ? v << n
                                     : kind == 1 ? v >> n
                                     : kind == 2 ? v << n | v >> ((16 - n) & 31)
                                                 : v >> n | v << ((16 - n) & 31);
        value = wrapped(NaiveType::Word, turned);
        return std::string(kind == 0   ? "SHL"
                           : kind == 1 ? "SHR"
                           : kind == 2 ? "ROL"
                                       : "ROR") +
               "(IN := " + a + ", N := " + std::to_string(n) + ")";
      }
      default: {
        const std::string b = word(depth - 1, right);
        const int op = pick(3);
        value = op == 0 ? left & right : op == 1 ? left | right : left ^ right;
        return "(" + a + (op == 0 ? " AND " : op == 1 ? " OR " : " XOR ") + b + ")";
      }
    }
  }

  std::string truth(int depth, std::int64_t& value) {
    if (depth == 0 || pick(5) == 0) {
      const auto i = static_cast<std::size_t>(pick(4));
      if (pick(5) == 0) {
        value = pick(2);
        return value != 0 ? "TRUE" : "FALSE";
      }
      value = state.bools[i];
      return "#b" + std::to_string(i);
    }
    std::int64_t left = 0, right = 0;
    switch (pick(6)) {
      case 0: {
        const std::string inner = truth(depth - 1, left);
        value = left == 0;
        return "NOT (" + inner + ")";
      }
      case 1:
      case 2: {
        const NaiveType type = pick(2) == 0 ? NaiveType::Int : pick(2) == 0 ? NaiveType::DInt : NaiveType::Word;
        std::string a, b;
        if (type == NaiveType::Word) {
          a = word(depth - 1, left);
          b = word(depth - 1, right);
        } else {
          a = typed(type, depth - 1, left);
          b = typed(type, depth - 1, right);
        }
        const int op = pick(6);
        const bool results[] = {left == right, left != right, left<right, left> right, left <= right, left >= right};
        constexpr const char* signs[] = {" = ", " <> ", " < ", " > ", " <= ", " >= "};
        value = results[op];
        return "(" + a + signs[op] + b + ")";
      }
      default: {
        const std::string a = truth(depth - 1, left), b = truth(depth - 1, right);
        const int op = pick(5);
        const bool l = left != 0, r = right != 0;
        value = op == 0 ? l && r : op == 1 ? l || r : op == 2 ? l != r : op == 3 ? l == r : l != r;
        constexpr const char* signs[] = {" AND ", " OR ", " XOR ", " = ", " <> "};
        return "(" + a + signs[op] + b + ")";
      }
    }
  }

  /// `runs`: whether the statement is carried out; otherwise it is text alone.
  std::string statement(int depth, bool runs) {
    const NaiveState before = state;
    std::string text = made(depth, runs);
    if (!runs) state = before;
    return text;
  }
  std::string block(int depth, bool runs) {
    std::string text;
    for (int i = pick(3) + 1; i > 0; --i) text += statement(depth, runs);
    return text;
  }
  std::string made(int depth, bool runs) {
    const int kind = depth == 0 ? 0 : pick(8);
    std::int64_t value = 0;
    if (kind == 5) {
      const std::string condition = truth(2, value);
      const std::string first = block(depth - 1, runs && value != 0);
      if (pick(2) == 0) return "IF " + condition + " THEN\n" + first + "END_IF;\n";
      std::string text = "IF " + condition + " THEN\n" + first;
      if (runs && value != 0) return text + "ELSE\n" + block(depth - 1, false) + "END_IF;\n";
      return text + "ELSE\n" + block(depth - 1, runs) + "END_IF;\n";
    }
    if (kind == 6) {
      const std::string selector = number(NaiveType::Int, 1, value);
      const int first = pick(20) - 10;
      const bool isFirst = value == first || (value >= first + 2 && value <= first + 4);
      std::string text = "CASE " + selector + " OF\n " + std::to_string(first) + ", " + std::to_string(first + 2) +
                         ".." + std::to_string(first + 4) + ":\n" + block(depth - 1, runs && isFirst);
      text += "ELSE\n" + block(depth - 1, runs && !isFirst);
      return text + "END_CASE;\n";
    }
    if (kind == 7) {  // adds up numbers and fills the list; the body writes none of what it reads
      const int first = pick(3) - 1, last = first + pick(5 - (first + 1)), by = pick(2) + 1;
      const auto i = static_cast<std::size_t>(pick(4));
      std::string text = "FOR #k := " + std::to_string(first) + " TO " + std::to_string(last) + " BY " +
                         std::to_string(by) + " DO\n #i" + std::to_string(i) + " := #i" + std::to_string(i) +
                         " + #k;\n #list[#k] := #i" + std::to_string(i) + ";\nEND_FOR;\n";
      for (int k = first; k <= last; k += by) {
        state.ints[i] = static_cast<std::int32_t>(wrapped(NaiveType::Int, state.ints[i] + k));
        state.list[static_cast<std::size_t>(k + 1)] = state.ints[i];
      }
      return text;
    }
    const auto i = static_cast<std::size_t>(pick(4));
    switch (pick(4)) {
      case 0: {
        const std::string text = number(NaiveType::Int, 3, value);
        state.ints[i] = static_cast<std::int32_t>(value);
        return "#i" + std::to_string(i) + " := " + text + ";\n";
      }
      case 1: {
        const std::string text = typed(NaiveType::DInt, 3, value);
        state.dints[i] = static_cast<std::int32_t>(value);
        return "#d" + std::to_string(i) + " := " + text + ";\n";
      }
      case 2: {
        const std::string text = truth(3, value);
        state.bools[i] = value != 0;
        return "#b" + std::to_string(i) + " := " + text + ";\n";
      }
      default: {
        const std::string text = word(3, value);
        state.words[i] = static_cast<std::uint16_t>(value);
        return "#w" + std::to_string(i) + " := " + text + ";\n";
      }
    }
  }

  std::mt19937_64 random_;
};

}  // namespace rungproof::testscl
