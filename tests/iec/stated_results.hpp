// Statements with the value that the standard gives, worked out by hand: each behind one scan of a program whose
// variable r has the type. They reach every instruction of the machine.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

namespace rungproof::iec_stated {

struct Result {
  std::string type, declarations, statements;
  double value;
};

/// Each value beside each: a bit of the result for every pair of which `op` is true. The last value is NaN where
/// `isReal`.
template <class Holds>
Result comparedWithAll(const std::string& type, const std::string& op, const std::vector<std::string>& literals,
                       const std::vector<double>& values, Holds&& holds) {
  const std::size_t count = values.size();
  std::string statements;
  for (std::size_t i = 0; i < count; ++i) statements += fmt::format("v[{}] := {};\n", i, literals[i]);
  statements += fmt::format(
      "FOR i := 0 TO {0} DO FOR k := 0 TO {0} DO r := r * 2; IF v[i] {1} v[k] THEN r := r + 1; END_IF; END_FOR; "
      "END_FOR;",
      count - 1, op);
  double expected = 0;
  for (const double a : values) {
    for (const double b : values) expected = expected * 2 + (holds(a, b) ? 1 : 0);
  }
  return {"LINT", fmt::format("v : ARRAY [0..{}] OF {}; i, k : INT; zero : {};", count - 1, type, type), statements,
          expected};
}
/// The same for a function of two values: the sum over all pairs, each weighted by its number.
template <class Function>
Result addedUp(const std::string& type, const std::string& function, const std::vector<double>& values, Function&& f) {
  std::string statements;
  for (std::size_t i = 0; i < values.size(); ++i) statements += fmt::format("v[{}] := {:.1f};\n", i, values[i]);
  statements += fmt::format(
      "FOR i := 0 TO {0} DO FOR k := 0 TO {0} DO w := w + 1.0; r := r + {1}(v[i], v[k]) * w; END_FOR; END_FOR;",
      values.size() - 1, function);
  double expected = 0, weight = 0;
  for (const double a : values) {
    for (const double b : values) expected += f(a, b) * ++weight;
  }
  return {type, fmt::format("v : ARRAY [0..{}] OF {}; w : {}; i, k : INT;", values.size() - 1, type, type), statements,
          expected};
}
/// Each value converted; the results are the digits of a number to the base 1000003, as 64 bits hold it.
template <class Convert>
Result convertedAll(const std::string& from, const std::string& to, const std::vector<double>& values,
                    Convert&& convert) {
  std::string statements;
  std::uint64_t expected = 0;
  for (const double value : values) {
    statements += fmt::format("x := {:.1f}; r := r * 1000003 + {}_TO_{}({}_TO_{}(x));\n", value, to, "LINT", from, to);
    expected = expected * 1000003 + static_cast<std::uint64_t>(convert(value));
  }
  // The lower half, which a double holds exactly.
  statements += "r := r MOD 4294967296;";
  const auto whole = static_cast<std::int64_t>(expected);
  return {"LINT", fmt::format("x : {};", from), statements, static_cast<double>(whole % 4294967296)};
}
/// Halves to the even number, and the nearest of what fits.
inline std::int64_t nearest(double value, double low, double high) {
  return static_cast<std::int64_t>(std::min(std::max(std::nearbyint(value), low), high));
}

inline std::vector<Result> plainResults() {
  return {
      {"INT", "a : INT := 100;", "r := SHR(a, 2);", 25},
      {"BOOL", "s : STRING := 'BA'; t : STRING := 'AB';", "r := s < t OR NOT (t < s);", 0},
      {"LREAL", "zero : LREAL; n : LREAL;", "n := zero / zero; r := MAX(1.0, n);", 1},  // 1 < NaN is FALSE
      {"BOOL", "s : STRING := 'AB'; t : STRING := 'AB$00';",
       "r := s < t AND NOT (t < s) AND NOT (s = t) AND NOT (t = s);", 1},
      {"INT", "s : STRING := 'ABCDC'; t : STRING := 'C';", "r := FIND(s, t);", 3},
      {"INT", "a : INT := 7; b : INT;", "r := 1; r := a MOD b; r := r + 5;", 5},  // by the usual reading it is 0
      {"REAL", "a : REAL := 1.5;", "r := -a;", -1.5},
      {"REAL", "a : UDINT := 7;", "r := UDINT_TO_REAL(a);", 7},
      {"REAL", "a : UDINT := 4294967295;", "r := UDINT_TO_REAL(a);", 4294967296.0},
      {"REAL", "a : INT := -7;", "r := INT_TO_REAL(a);", -7},
      // whole numbers
      {"INT", "a : INT := 7;", "r := a - 9;", -2},
      {"INT", "a : INT := -7;", "r := a / 2;", -3},
      {"INT", "a : INT := -7;", "r := a MOD 3;", -1},
      {"UINT", "a : UINT := 65535;", "r := a / 2;", 32767},
      {"UINT", "a : UINT := 65535;", "r := a MOD 10;", 5},
      {"INT", "a : INT := 32767;", "r := a + 1;", -32768},
      {"INT", "a : INT := -32768;", "r := ABS(a);", -32768},
      {"INT", "a : INT := -5;", "r := ABS(a) - (-a);", 0},
      {"INT", "a : INT := -5; b : INT := 3;", "r := MAX(a, b) * 10 + MIN(a, b);", 25},
      {"UINT", "a : UINT := 40000; b : UINT := 3;", "r := MAX(a, b) - MIN(a, b);", 39997},
      {"INT", "a : INT := 5;", "r := LIMIT(10, a, 20) + LIMIT(1, a, 3);", 13},
      {"SINT", "a : INT := 200;", "r := INT_TO_SINT(a);", -56},
      {"UINT", "a : INT := -1;", "r := INT_TO_UINT(a);", 65535},
      {"DINT", "a : SINT := -3;", "r := a;", -3},
      {"UDINT", "a : USINT := 200;", "r := a;", 200},
      {"BOOL", "a : INT := 256;", "r := INT_TO_BOOL(a);", 1},
      {"BOOL", "a : WORD := 256;", "r := WORD_TO_BOOL(a);", 1},
      {"BOOL", "a : INT := -3; b : UINT := 40000;", "r := a < 2 AND b > 3 AND NOT (a >= 0) AND b >= 40000 AND a <= -3;",
       1},
      {"BOOL", "a : INT := 4; b : INT := 4;", "r := a = b AND NOT (a <> b) AND a <= b;", 1},
      // bits
      {"WORD", "a : WORD := 16#F0F0;", "r := (a AND 16#FF00) OR 16#000F;", 0xF00F},
      {"WORD", "a : WORD := 16#F0F0;", "r := NOT (a XOR 16#00FF);", 0x0FF0},
      {"WORD", "a : WORD := 16#8001;", "r := SHL(a, 1) OR SHR(a, 15);", 3},
      {"WORD", "a : WORD := 16#8001;", "r := SHL(a, 16) OR SHR(a, 16);", 0},
      {"WORD", "a : WORD := 16#8001;", "r := ROL(a, 1);", 3},
      {"WORD", "a : WORD := 16#8001;", "r := ROR(a, 17);", 0xC000},
      {"INT", "a : INT := -8;", "r := SHR(a, 1);", -4},
      {"INT", "a : INT := -8;", "r := SHR(a, 20);", -1},
      {"INT", "a : BOOL := TRUE;", "r := SEL(a, 3, 4) * 10 + SEL(NOT a, 3, 4);", 43},
      {"INT", "a : INT := 2;", "r := MUX(a, 5, 6, 7);", 7},
      {"INT", "a : INT := 3;", "r := 9 + MUX(a, 5, 6, 7);", 9},
      {"INT", "a : INT := -1;", "r := 9 + MUX(a, 5, 6, 7);", 9},
      {"INT", "a : INT := 20; v : INT (0..10);", "v := a; r := v;", 20},
      // arrays
      {"INT", "a : ARRAY [2..4] OF INT := [5, 6, 7]; i : INT := 3;", "a[i] := a[i] + 10; r := a[3] + a[i + 1];", 23},
      {"BOOL", "a : ARRAY [0..3] OF BOOL; i : INT := 2;", "a[i] := TRUE; r := a[2] AND NOT a[1] AND a[i];", 1},
      // REAL
      {"REAL", "a : REAL := 1.5;", "r := (a + 2.0) * 3.0 - 1.0;", 9.5},
      {"REAL", "a : REAL := 3.0;", "r := a / 4.0;", 0.75},
      {"REAL", "a : REAL := -1.5;", "r := -a + ABS(a);", 3},
      {"REAL", "a : REAL := 2.25; b : REAL := 1.0;", "r := SQRT(a) + MAX(a, b) + MIN(a, b);", 4.75},
      {"BOOL", "a : REAL := 1.5; b : REAL := 2.0;",
       "r := a < b AND b > a AND a <= 1.5 AND b >= 2.0 AND a <> b AND NOT (a = b);", 1},
      {"BOOL", "a : REAL; n : REAL;", "n := a / a; r := n = n OR n < 1.0 OR n >= 1.0 OR NOT (n <> n);", 0},
      {"DINT", "a : REAL := 2.5; b : REAL := 3.5;", "r := REAL_TO_DINT(a) * 10 + REAL_TO_DINT(b);", 24},
      {"INT", "a : REAL := -2.5; b : REAL := 0.5;", "r := REAL_TO_INT(a) * 10 + REAL_TO_INT(b);", -20},
      {"INT", "a : REAL := -2.7;", "r := DINT_TO_INT(TRUNC(a));", -2},
      {"REAL", "a : INT := -3; u : UDINT := 4294967295;", "r := INT_TO_REAL(a) + UDINT_TO_REAL(u) - 4294967295.0;", 0},
      {"REAL", "u : UDINT := 3000000000;", "r := UDINT_TO_REAL(u);", 3e9},
      {"USINT", "a : REAL := 200.4;", "r := REAL_TO_USINT(a);", 200},
      {"UINT", "a : REAL := 65535.0;", "r := REAL_TO_UINT(a);", 65535},
      // 64 bits
      {"LINT", "a : LINT := 5000000000;", "r := a * 2 + 1;", 10000000001.0},
      {"LINT", "a : LINT := -5000000000;", "r := a / 7 + a MOD 7;", -714285716.0},
      {"BOOL", "a : ULINT := 18446744073709551615;", "r := a > 9223372036854775807 AND a / 2 = 9223372036854775807;",
       1},
      {"LWORD", "a : LWORD := 16#8000_0000_0000_0001;", "r := ROL(a, 1) + SHR(a, 63);", 4},
      {"LREAL", "a : LREAL := 0.1;", "r := (a + 0.2) * 3.0 - 0.25;", (0.1 + 0.2) * 3.0 - 0.25},
      {"LREAL", "a : LREAL := 1.0;", "r := a / 3.0;", 1.0 / 3.0},
      {"LREAL", "a : LREAL := -2.0;", "r := -a + SQRT(ABS(a)) + MAX(a, 1.0) + MIN(a, 1.0);",
       2 + std::sqrt(2.0) + 1 - 2},
      {"LREAL", "a : LREAL := 2.0;", "r := a ** 3.0 + EXPT(a, 0.5);", 8 + std::pow(2.0, 0.5)},
      {"LREAL", "a : LREAL := 1.0;", "r := ATAN2(a, 2.0);", std::atan2(1.0, 2.0)},
      {"BOOL", "a : LREAL := -2.0; b : LREAL := 1.0;",
       "r := a < b AND b > a AND a <= -2.0 AND b >= 1.0 AND a <> b AND NOT (a = b) AND NOT (b < a) AND a < -1.0;", 1},
      {"BOOL", "a : LREAL := 0.0; b : LREAL := -0.0;", "r := a = b AND NOT (b < a) AND NOT (a <> b);", 1},
      {"BOOL", "a : LREAL; n : LREAL;", "n := a / a; r := n = n OR n < 1.0 OR 1.0 < n OR n >= 1.0 OR NOT (n <> n);", 0},
      {"LREAL", "a : INT := -3; b : ULINT := 18446744073709551615;", "r := INT_TO_LREAL(a) + ULINT_TO_LREAL(b);",
       18446744073709551616.0 - 3},
      {"REAL", "a : LINT := 16777217;", "r := LINT_TO_REAL(a);", 16777216},
      {"LREAL", "a : REAL := 0.1;", "r := a;", static_cast<double>(0.1F)},
      {"REAL", "a : LREAL := 0.1;", "r := LREAL_TO_REAL(a);", static_cast<double>(0.1F)},
      {"DINT", "a : LREAL := 2.5; b : LREAL := -3.5;", "r := LREAL_TO_DINT(a) * 10 + LREAL_TO_DINT(b);", 16},
      {"LINT", "a : LREAL := -3.0E15;", "r := LREAL_TO_LINT(a);", -3e15},
      {"USINT", "a : LREAL := 255.0;", "r := LREAL_TO_USINT(a);", 255},
      {"ULINT", "a : LREAL := 1.0E19;", "r := LREAL_TO_ULINT(a);", 1e19},
      {"INT", "a : LREAL := -1.5;", "r := DINT_TO_INT(FLOOR(a)) * 10 + DINT_TO_INT(CEIL(a));", -21},
      // texts
      {"INT", "a : STRING := 'AABAAC'; b : STRING[4];",
       "b := CONCAT(MID(a, 3, 2), 'xyz'); r := FIND(a, 'AAC') * 10 + LEN(b);", 44},
      {"BOOL", "a : STRING := 'AB'; b : STRING := 'ABC';", "r := a < b AND NOT (b < a) AND NOT (a = b) AND a = 'AB';",
       1},
      {"INT", "a : STRING := 'ABC';", "r := LEN(MID(a, 9, 2)) * 100 + LEN(MID(a, 1, 4)) * 10 + FIND(a, '');", 200},
      {"INT", "a : ARRAY [3..5] OF INT := [1, 2, 3]; i : INT;", "FOR i := 3 TO 5 DO r := r * 10 + a[i]; END_FOR;", 123},
      {"INT", "a : ARRAY [0..2] OF INT; i : INT := 3;", "r := 1; r := a[i]; r := 2;", 1},  // the scan ends there
      {"INT", "a : ARRAY [0..2] OF INT; i : INT := -1;", "r := 1; a[i] := 5; r := 2;", 1},
      {"INT", "a : INT := -100; i : INT;", "FOR i := 0 TO 17 DO r := r + SHR(a, i); END_FOR;",
       -100 - 50 - 25 - 13 - 7 - 4 - 2 - 11},
      {"UINT", "a : WORD := 16#8421; i : INT;",
       "FOR i := 0 TO 17 DO r := r XOR WORD_TO_UINT(SHR(a, i)) XOR WORD_TO_UINT(SHL(a, i)); END_FOR;", 33825},
      {"INT", "s, t : STRING[200]; i : INT;",
       "FOR i := 1 TO 150 DO s := CONCAT(s, 'a'); END_FOR; t := MID(s, 140, 11); r := LEN(s) * 10 + LEN(t) - "
       "LEN(LEFT(s, 129));",
       1500 + 140 - 129},
      {"INT", "s : STRING := 'ab$FFc'; t : STRING := 'ab$7Fc';",
       "IF t < s THEN r := 1; END_IF; IF s < t THEN r := r + 2; END_IF; IF s = t THEN r := r + 4; END_IF; r := r + "
       "FIND(s, '$FFc') * 10 + FIND(s, 'c$FF') * 100;",
       31},
      {"INT", "s : STRING := 'abc';",
       "r := LEN(MID(s, -1, 1)) + LEN(MID(s, 1, 0)) + LEN(MID(s, 1, -3)) + LEN(MID(s, 3, 3)) * 10 + LEN(MID(s, 0, 1)) "
       "* 100;",
       10},
      {"INT", "s : STRING[5] := 'abcde';",
       "s := CONCAT(s, 'fgh'); r := LEN(s) * 10 + FIND(s, 'e'); s := 'x'; r := r + LEN(s); IF s = 'x' THEN r := r + "
       "100; END_IF;",
       156},
  };
}

inline const std::vector<Result>& results() {
  static const std::vector<Result> all = [] {
    std::vector<Result> made = plainResults();
    const double nan = std::nan("");
    const std::vector<std::string> literals = {"-2.5", "-0.0", "0.0", "0.5", "2.5", "zero / zero", "1.0 / zero"};
    const std::vector<double> reals = {-2.5, -0.0, 0.0, 0.5, 2.5, nan, INFINITY};
    const std::vector<std::string> whole = {"-300", "-1", "0", "1", "2", "299", "300"},
                                   unsignedOnes = {"0", "1", "2", "127", "128", "254", "255"};
    const std::vector<double> wholes = {-300, -1, 0, 1, 2, 299, 300}, bytes = {0, 1, 2, 127, 128, 254, 255};
    const auto all = [&](const std::string& op, auto&& holds) {
      for (const char* const type : {"REAL", "LREAL"})
        made.push_back(comparedWithAll(type, op, literals, reals, holds));
      made.push_back(comparedWithAll("INT", op, whole, wholes, holds));
      made.push_back(comparedWithAll("USINT", op, unsignedOnes, bytes, holds));
    };
    all("<", [](double a, double b) { return a < b; });
    all("<=", [](double a, double b) { return a <= b; });
    all(">", [](double a, double b) { return a > b; });
    all(">=", [](double a, double b) { return a >= b; });
    all("=", [](double a, double b) { return a == b; });
    all("<>", [](double a, double b) { return a != b; });
    const std::vector<double> few = {-2.5, -1.0, 0.0, 0.5, 2.5};
    for (const char* const type : {"REAL", "LREAL"}) {
      made.push_back(addedUp(type, "MAX", few, [](double a, double b) { return std::max(a, b); }));
      made.push_back(addedUp(type, "MIN", few, [](double a, double b) { return std::min(a, b); }));
    }
    const std::vector<double> numbers = {-1e10, -2147483649.0, -129.0, -128.5, -2.5,  -1.5,  -0.5,  0.0,     0.5, 1.5,
                                         2.5,   126.5,         127.5,  128.0,  254.5, 255.5, 256.0, 70000.0, 1e10};
    const auto convert = [&](const char* to, double low, double high) {
      for (const char* const from : {"REAL", "LREAL"}) {
        std::vector<double> given;
        for (const double number : numbers) given.push_back(from[0] == 'R' ? static_cast<float>(number) : number);
        made.push_back(convertedAll(from, to, given, [&](double value) { return nearest(value, low, high); }));
      }
    };
    convert("SINT", -128, 127);
    convert("USINT", 0, 255);
    convert("INT", -32768, 32767);
    convert("UINT", 0, 65535);
    convert("DINT", -2147483648.0, 2147483647.0);
    convert("UDINT", 0, 4294967295.0);
    return made;
  }();
  return all;
}

inline std::string programOf(const Result& row) {
  return std::string("PROGRAM main VAR r : ") + row.type + "; " + row.declarations + " END_VAR\n" + row.statements +
         "\nEND_PROGRAM\n";
}

}  // namespace rungproof::iec_stated
