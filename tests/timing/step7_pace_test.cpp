// What a program of the S7-300/400 costs beside its S7-200 twin: statements per second of the engine.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <functional>

#include "engine/simulator.hpp"
#include "frontend/input/project.hpp"
#include "tests/machine_pace.hpp"

namespace rungproof {
namespace {

struct Rungs {
  std::string s7200, step7;
};

/// A latch, a branch and a set coil over changing addresses, and the same work with words: move, add, count, compare.
/// `word`: an operand of 16 bits by its byte in a row of 800.
Rungs rungsOf(int first, int count, const std::function<std::string(int)>& word) {
  const auto bit = [](const char* area, int n) { return fmt::format("{}{}.{}", area, n / 8, n % 8); };
  Rungs text;
  for (int k = first; k < first + count; ++k) {
    const std::string in = bit("I", k % 64), own = bit("M", k % 200), lock = bit("I", (k * 7 + 3) % 64),
                      out = bit("Q", k % 64), set = bit("M", 200 + k % 40), other = bit("M", k * 11 % 200);
    const int from = k % 400 * 2, to = (k + 1) % 400 * 2, sum = (k + 9) % 400 * 2;
    text.s7200 += fmt::format(
        "Network {}\nLD {}\nO {}\nAN {}\n= {}\nLD {}\nA {}\nLDN {}\nOLD\n= {}\nS {}, 1\n"
        "LD SM0.0\nMOVW VW{}, VW{}\n+I 3, VW{}\nINCW VW{}\nLDW>= VW{}, 100\n= M30.0\n",
        k - first + 1, in, own, lock, own, own, in, other, out, set, from, to, sum, to, sum);
    text.step7 += fmt::format(
        "NETWORK\n      A(;\n      O {};\n      O {};\n      );\n      AN {};\n      = {};\n      A {};\n      A {};\n"
        "      O;\n      AN {};\n      = {};\n      S {};\n      L {};\n      T {};\n      L {};\n      + 3;\n"
        "      T {};\n      L {};\n      + 1;\n      T {};\n      L {};\n      L 100;\n      >=I;\n"
        "      = M 30.0;\n",
        in, own, lock, own, own, in, other, out, set, word(from), word(to), word(sum), word(sum), word(to), word(to),
        word(sum));
  }
  return text;
}
std::string inMemory(int byte) { return fmt::format("MW {}", 100 + byte); }

/// A thousand rungs in blocks: 50 subroutines; 200 functions over 100 data blocks.
Rungs plantOf() {
  constexpr int subroutines = 50, functions = 200, blocks = 100;
  Rungs text;
  std::string main7200 = "Network 1\nLD SM0.0\n", main7, bodies7200;
  for (int k = 0; k < subroutines; ++k) {
    main7200 += fmt::format("CALL SBR{}\n", k);
    bodies7200 += fmt::format("SUBROUTINE_BLOCK SBR_{0}:SBR{0}\nBEGIN\n", k) + rungsOf(20 * k, 20, inMemory).s7200 +
                  "END_SUBROUTINE_BLOCK\n";
  }
  text.s7200 = "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\n" + main7200 + "END_ORGANIZATION_BLOCK\n" + bodies7200;
  for (int k = 1; k <= blocks; ++k) {
    text.step7 +=
        fmt::format("DATA_BLOCK DB {}\nSTRUCT\n a : ARRAY [0 .. 399] OF INT;\nEND_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n", k);
  }
  for (int k = 0; k < functions; ++k) {
    const auto inBlock = [&](int byte) { return fmt::format("DB{}.DBW {}", k % blocks + 1, byte); };
    text.step7 +=
        fmt::format("FUNCTION FC {} : VOID\nBEGIN\n", k + 1) + rungsOf(5 * k, 5, inBlock).step7 + "END_FUNCTION\n";
    main7 += fmt::format("CALL FC {};\n", k + 1);
  }
  text.step7 += "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n" + main7 + "END_ORGANIZATION_BLOCK\n";
  return text;
}

/// Both as the blocks that run in every scan.
Rungs mainOf(const Rungs& text) {
  return {"ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\n" + text.s7200 + "END_ORGANIZATION_BLOCK\n",
          "ORGANIZATION_BLOCK OB 1\nBEGIN\n" + text.step7 + "END_ORGANIZATION_BLOCK\n"};
}

/// A block that adds and compares, called `calls` times: with local data and parameters in a subroutine, with
/// an instance each in a function block.
Rungs callsOf(int calls) {
  Rungs text;
  std::string main7200, main7, instances;
  for (int k = 0; k < calls; ++k) {
    const std::string in = fmt::format("{}.{}", k / 8 % 8, k % 8);
    main7200 +=
        fmt::format("Network {}\nLD SM0.0\nCALL SBR0, I{}, VW{}, Q{}, VW{}\n", k + 1, in, 2 * k, in, 400 + 2 * k);
    main7 += fmt::format("NETWORK\nCALL FB 1 , DB {} ( x := I {} , n := MW {} , q := Q {} , s := MW {} );\n", k + 1, in,
                         100 + 2 * k, in, 500 + 2 * k);
    instances += fmt::format("DATA_BLOCK DB {}\nFB 1\nBEGIN\nEND_DATA_BLOCK\n", k + 1);
  }
  text.s7200 =
      "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\n" + main7200 +
      "END_ORGANIZATION_BLOCK\nSUBROUTINE_BLOCK SBR_0:SBR0\nVAR_INPUT\nx : BOOL;\nn : INT;\nEND_VAR\nVAR_OUTPUT\n"
      "q : BOOL;\ns : INT;\nEND_VAR\nVAR\nw : INT;\nEND_VAR\nBEGIN\nNetwork 1\nLD L0.0\nAN M0.0\n= L5.0\n"
      "Network 2\nLD SM0.0\nMOVW LW1, LW6\n+I 3, LW6\nLDW>= LW6, 100\nO L0.0\n= L3.0\nLD SM0.0\nMOVW LW6, LW4\n"
      "END_SUBROUTINE_BLOCK\n";
  text.step7 =
      "FUNCTION_BLOCK FB 1\nVAR_INPUT\n x : BOOL;\n n : INT;\nEND_VAR\nVAR_OUTPUT\n q : BOOL;\n s : INT;\nEND_VAR\n"
      "VAR_TEMP\n e : BOOL;\n w : INT;\nEND_VAR\nBEGIN\nNETWORK\nA #x;\nAN M 0.0;\n= #e;\nL #n;\n+ 3;\nT #w;\n"
      "L #w;\nL 100;\n>=I;\nO #x;\n= #q;\nL #w;\nT #s;\nEND_FUNCTION_BLOCK\n" +
      instances + "ORGANIZATION_BLOCK OB 1\nBEGIN\n" + main7 + "END_ORGANIZATION_BLOCK\n";
  return text;
}

/// Machine code and the reference engine come to the same memory.
void expectSameMemory(const Program& program) {
  Concrete::Store stores[2];
  for (const EngineKind kind : {EngineKind::Reference, EngineKind::Compiled}) {
    SimulatorOptions options;
    options.engine = kind;
    Simulator simulator(program, options);
    for (std::uint64_t scan = 0; scan < 20; ++scan) {
      simulator.write(direct(Area::I, Width::DWord, 0), scan * 0x9E3779B9 & 0xFFFFFFFF);
      simulator.write(direct(Area::I, Width::DWord, 4), scan * 0x85EBCA6B & 0xFFFFFFFF);
      simulator.scan();
    }
    EXPECT_EQ(simulator.compiledScans(), kind == EngineKind::Compiled ? 19U : 0U);
    stores[kind == EngineKind::Compiled ? 1 : 0] = simulator.store();
  }
  EXPECT_TRUE(stores[0] == stores[1]);
}

/// Statements per second of a quiet machine; `statements`: those of a scan.
double statementsPerSecond(const std::string& text, std::size_t statements) {
  const Program program = readText("pace.awl", text);
  for (const Finding& finding : program.findings) EXPECT_NE(finding.severity, Severity::Error) << finding.message;
  expectSameMemory(program);
  constexpr int scans = 400;
  std::uint64_t inputs = 0x123456789ABCDEFULL;
  Simulator simulator(program);
  const double seconds = test::quietSeconds(
      [&] {
        for (int scan = 0; scan < scans; ++scan) {
          inputs = inputs * 6364136223846793005ULL + 1442695040888963407ULL;
          simulator.write(direct(Area::I, Width::DWord, 0), inputs >> 32);
          simulator.write(direct(Area::I, Width::DWord, 4), inputs & 0xFFFFFFFF);
          simulator.scan();
        }
      },
      0, 7);
  EXPECT_TRUE(simulator.isRunning());
  EXPECT_GT(simulator.compiledScans(), 0U);
  return static_cast<double>(statements == 0 ? program.instructionCount() : statements) * scans / seconds;
}

void expectHalf(const Rungs& text, std::size_t s7200Statements, std::size_t step7Statements) {
  const double s7200 = statementsPerSecond(text.s7200, s7200Statements),
               step7 = statementsPerSecond(text.step7, step7Statements);
  std::printf("%.1f of %.1f million statements per second: %.2f\n", step7 / 1e6, s7200 / 1e6, step7 / s7200);
  EXPECT_GE(step7, s7200 / 2);
}

TEST(Step7Pace, TheEngineRunsHalfAsManyStatementsPerSecond) { expectHalf(mainOf(rungsOf(0, 60, inMemory)), 0, 0); }

TEST(Step7Pace, SoItDoesInTwoHundredBlocks) { expectHalf(plantOf(), 0, 0); }

TEST(Step7Pace, SoItDoesInBlocksThatAreCalled) {
  constexpr std::size_t calls = 100;
  expectHalf(callsOf(calls), calls * (2 + 11), calls * (1 + 13));
}

}  // namespace
}  // namespace rungproof
