// Statements with the value that the standard gives, worked out by hand: each behind one scan of a program whose
// variable r has the type. They reach every instruction of the machine.
#pragma once

#include <cmath>
#include <string>
#include <vector>

namespace rungproof::iec_stated {

struct Result {
  const char* type;
  const char* declarations;
  const char* statements;
  double value;
};

inline const std::vector<Result>& results() {
  static const std::vector<Result> all = {
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
  };
  return all;
}

inline std::string programOf(const Result& row) {
  return std::string("PROGRAM main VAR r : ") + row.type + "; " + row.declarations + " END_VAR\n" + row.statements +
         "\nEND_PROGRAM\n";
}

}  // namespace rungproof::iec_stated
