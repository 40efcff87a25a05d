// A long program of the S7-300/400 for measurements: FCs and FBs with instances, symbolic data blocks, S5 timers, boxes
// as the compiler writes them, pointers and calls. Used by the benchmark and tests/timing.
#pragma once

#include <fmt/format.h>

#include <string>

namespace rungproof::test {

struct Step7Size {
  int blocks = 200;      ///< FC and FB in turn, all called by OB1
  int statements = 100;  ///< in each of them, about
  int dataBlocks = 100;  ///< global ones; instances come on top
  int unusedBytes = 0;   ///< of an array in each of the global ones that no statement names
};

namespace step7_bench {

inline std::string data(int number, int unusedBytes) {
  std::string text =
      fmt::format("DATA_BLOCK DB {}\nTITLE = values of unit {}\nVERSION : 0.1\nSTRUCT\n", number, number);
  for (int i = 0; i < 8; ++i)
    text += fmt::format("  On{} : BOOL ; //state {}\n  Value{} : INT := {} ;\n", i, i, i, i * 7);
  text +=
      "  Limit : STRUCT\n    Low : REAL := 1.5;\n    High : REAL := 9.5;\n  END_STRUCT ;\n  List : ARRAY [1 .. 20] OF "
      "INT ;\n";
  if (unusedBytes > 0) text += fmt::format("  Spare : ARRAY [1 .. {}] OF BYTE ;\n", unusedBytes);
  return text + "END_STRUCT ;\nBEGIN\n  Value3 := 99;\nEND_DATA_BLOCK\n";
}

/// About 20 statements.
inline std::string networks(int block, int round, int dataBlock, bool isFb) {
  const int m = (block * 5 + round) % 4000;
  const int timer = (block * 5 + round) % 2000;
  const std::string edge = isFb ? "#Edge" : fmt::format("M {}.7", 4000 + m);
  return fmt::format(
      "NETWORK\nTITLE = part {}\n//what the part is for\n      A(;\n      O I {}.0;\n      O DB{}.DBX {}.0;\n      );\n"
      "      AN I {}.1;\n      FP {};\n      S M {}.0;\n      A I {}.2;\n      R M {}.0;\n"
      "NETWORK\nTITLE = time\n      A M {}.0;\n      L S5T#{}S;\n      SD T {};\n      NOP 0;\n      A T {};\n      = "
      "#Done;\n"
      "NETWORK\nTITLE = sum\n      A #Start;\n      JNB _{:02}1;\n      L DB{}.DBW {};\n      L #Number;\n      +I;\n"
      "      T DB{}.DBW {};\n      AN OV;\n      SAVE;\n      CLR;\n_{:02}1: A BR;\n      = M {}.1;\n",
      round, m % 100, dataBlock, round % 8 * 4, m % 100, edge, m, m % 100, m, m, round + 1, timer, timer, round,
      dataBlock, 2 + round % 8 * 4, dataBlock, 2 + (round + 1) % 8 * 4, round, m);
}

}  // namespace step7_bench

inline std::string step7Program(const Step7Size& size = {}) {
  std::string text, calls;
  for (int i = 1; i <= size.dataBlocks; ++i) text += step7_bench::data(i, size.unusedBytes);
  for (int i = 1; i <= size.blocks; ++i) {
    const bool isFb = i % 2 == 0;
    const int dataBlock = 1 + i % size.dataBlocks;
    text += fmt::format(
        "{} {}{}\nTITLE = unit {}\nVERSION : 0.1\nVAR_INPUT\n  Start : BOOL ;\n  Number : INT ;\nEND_VAR\n"
        "VAR_OUTPUT\n  Done : BOOL ;\nEND_VAR\n",
        isFb ? "FUNCTION_BLOCK FB" : "FUNCTION FC", i, isFb ? "" : " : VOID", i);
    if (isFb) text += "VAR\n  Edge : BOOL ;\n  Count : INT ;\nEND_VAR\n";
    text += "VAR_TEMP\n  Help : INT ;\nEND_VAR\nBEGIN\n";
    for (int round = 0; round * 29 < size.statements; ++round) text += step7_bench::networks(i, round, dataBlock, isFb);
    text += isFb ? "END_FUNCTION_BLOCK\n" : "END_FUNCTION\n";
    if (isFb) text += fmt::format("DATA_BLOCK DB {}\n FB {}\nBEGIN\nEND_DATA_BLOCK\n", 1000 + i, i);
    calls += fmt::format(
        "NETWORK\n      CALL {} {}{} (\n           Start := I {}.0,\n           Number := MW {},\n"
        "           Done := Q {}.{});\n",
        isFb ? "FB" : "FC", i, isFb ? fmt::format(" , DB {}", 1000 + i) : "", i % 100, 200 + i % 100 * 2, i / 8, i % 8);
  }
  return text + "ORGANIZATION_BLOCK OB 1\nTITLE = cycle\nVERSION : 0.1\nBEGIN\n" + calls + "END_ORGANIZATION_BLOCK\n";
}

}  // namespace rungproof::test
