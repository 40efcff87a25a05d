// Programs of IEC 61131-3 on both engines: random ones in ST, blocks of the standard, and those of the corpus.
// RUNGPROOF_SEED chooses other programs, RUNGPROOF_PROGRAMS how many.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "tests/compiled/engine_pair.hpp"
#include "tests/iec/iec_run.hpp"
#include "tests/iec/random_iec_program.hpp"
#include "tests/iec/random_library_program.hpp"
#include "tests/iec/random_type_program.hpp"
#include "tests/program_run.hpp"

namespace rungproof::test {
namespace {

PairOutcome bothEngines(const Program& program, std::uint64_t seed) {
  RandomSource inputs(seed);
  return runBoth(program, inputs, {.scans = 60});
}

TEST(IecPrograms, RandomOnesAgree) {
  const char* const asked = std::getenv("RUNGPROOF_PROGRAMS");
  const std::uint64_t count = asked == nullptr ? 150 : std::strtoull(asked, nullptr, 10), seed = testSeed();
  std::uint64_t compiled = 0, scans = 0;
  for (std::uint64_t i = 0; i < count; ++i) {
    const iec_random::IecProgram made(seed + i);
    const PairOutcome outcome = bothEngines(readIecText(made.text()), seed + i);
    ASSERT_EQ(outcome.difference, "") << "seed " << seed + i << "\n" << made.text();
    compiled += outcome.compiled;
    scans += static_cast<std::uint64_t>(outcome.scans);
  }
  EXPECT_GE(compiled * 2, scans) << "half of the scans run as machine code";
}

TEST(IecPrograms, AllTypesAndBlocksAgree) {
  const char* const asked = std::getenv("RUNGPROOF_PROGRAMS");
  const std::uint64_t count = asked == nullptr ? 40 : std::strtoull(asked, nullptr, 10), seed = testSeed();
  for (std::uint64_t i = 0; i < count; ++i) {
    for (const std::string& text :
         {iec_types::TypeProgram(seed + i).text(), iec_naive::LibraryProgram(seed + i).text()})
      ASSERT_EQ(bothEngines(readIecText(text), seed + i).difference, "") << "seed " << seed + i << "\n" << text;
  }
}

TEST(IecPrograms, ThoseOfTheCorpusAgree) {
  std::uint64_t compiled = 0, programs = 0;
  for (const auto& entry : std::filesystem::directory_iterator(std::string(RUNGPROOF_SOURCE_DIR) + "/corpus/iec")) {
    if (entry.path().extension() == ".prop" || entry.path().stem() == "errors") continue;
    const Program program = readText(entry.path().filename().string(), contentOf(entry.path()));
    SCOPED_TRACE(entry.path().string());
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      const PairOutcome outcome = bothEngines(program, seed);
      ASSERT_EQ(outcome.difference, "") << "seed " << seed;
      compiled += outcome.compiled > 0 ? 1 : 0;
    }
    programs += 3;
  }
  EXPECT_GE(compiled * 10, programs * 9) << "nearly all of them run as machine code";
}

TEST(IecPrograms, NumbersOf64BitsAgree) {
  const std::string text = iecProgram(
      "VAR_INPUT x, y : LINT; u, v : ULINT; n : UINT; END_VAR VAR a, b, c, d : LINT; e, f, g : ULINT; w : LWORD; "
      "p, q, r, s : BOOL; t : LTIME; i : DINT; END_VAR",
      "a := a + x; b := x - y; c := x * y; e := u * v; f := f + n; g := u - v; w := ROL(w XOR 16#8000_0000_0000_0001, "
      "n);\n"
      "p := x >= 5_000_000_000; q := x < y; r := u < v; s := x = y OR u > 9_223_372_036_854_775_807;\n"
      "IF y <> 0 THEN d := x / y + x MOD y; END_IF; IF v <> 0 THEN g := u / v + u MOD v; END_IF;\n"
      "w := SHL(w, n) OR SHR(w, n); t := t + LT#3us; i := LINT_TO_DINT(x) + ULINT_TO_DINT(SHR(u, 32));\n"
      "c := MAX(c, MIN(a, -5_000_000_000)); IF x < 0 THEN b := -b; END_IF; b := ABS(b) + SHR(x, 3);");
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const PairOutcome outcome = bothEngines(readIecText(text), seed);
    EXPECT_EQ(outcome.difference, "") << seed;
    EXPECT_GT(outcome.compiled, 20U);
  }
}

/// What no machine code computes: scans that meet it are left to the reference engine.
TEST(IecPrograms, LongTypesAndTextsAgree) {
  const std::string text = iecProgram(
      "VAR_INPUT x : LINT; i : INT; up : BOOL; END_VAR VAR a : ARRAY [0..7] OF LINT; l : LREAL; r : REAL; "
      "t : LTIME; s : STRING[12]; n : INT; q : BOOL; w : LWORD; c : CTU; d : TON; e : R_TRIG; END_VAR",
      "a[i MOD 8] := x + a[(i + 3) MOD 8]; IF up THEN l := l + 0.1; END_IF; r := REAL#0.5 * r + 1.0;\n"
      "t := t + LT#3us; s := CONCAT(s, 'ab'); IF LEN(s) > 8 THEN s := RIGHT(s, 3); END_IF; n := FIND(s, 'ba');\n"
      "w := ROL(w XOR 16#8000_0000_0000_0001, n + 3); c(CU := up, R := i = 3, PV := 5); d(IN := up, PT := T#25ms);\n"
      "e(CLK := up); q := e.Q AND (x > 3 OR a[n MOD 8] < 0);");
  for (std::uint64_t seed = 1; seed <= 20; ++seed)
    EXPECT_EQ(bothEngines(readIecText(text), seed).difference, "") << seed;
}

}  // namespace
}  // namespace rungproof::test
