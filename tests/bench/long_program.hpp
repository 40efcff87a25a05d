// A long program for measurements. Used by tests/timing/lint_growth_test.cpp, tests/timing and the benchmark.
#pragma once

#include <string>

namespace rungproof::test {

/// A program of about `count` instructions: rungs with branches, timers, moves, comparisons, latches, steps and calls.
inline std::string longProgram(int count) {
  std::string text = "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\n";
  int network = 0;
  for (int i = 0; i < count;) {
    const int k = network % 97;
    const auto bit = [&](const char* area, int n) {
      return std::string(area) + std::to_string(n / 8 % 16) + "." + std::to_string(n % 8);
    };
    text += "Network " + std::to_string(++network) + " // rung\n";
    switch (network % 5) {
      case 0:
        text += "LD " + bit("I", k) + "\nLPS\nA " + bit("M", k) + "\n= " + bit("Q", k) + "\nLRD\nAN " +
                bit("I", k + 1) + "\n= " + bit("M", k + 1) + "\nLPP\nA " + bit("M", k + 2) + "\nS " + bit("M", k + 3) +
                ", 2\n";
        i += 10;
        break;
      case 1:
        text += "LD " + bit("I", k) + "\nO " + bit("Q", k) + "\nAN " + bit("I", k + 2) + "\n= " + bit("Q", k) + "\n";
        i += 4;
        break;
      case 2:
        text += "LD " + bit("I", k) + "\nTON T" + std::to_string(101 + k) + ", +10\nLD T" + std::to_string(101 + k) +
                "\nEU\nMOVW VW" + std::to_string(k * 4) + ", VW" + std::to_string(k * 4 + 400) + "\n+I 5, VW" +
                std::to_string(k * 4 + 400) + "\n";
        i += 6;
        break;
      case 3:
        text += "LDW>= VW" + std::to_string(k * 4 + 400) + ", +100\nAW< VW" + std::to_string(k * 4) + ", +900\nR " +
                bit("M", k + 3) + ", 2\nMOVD &VB" + std::to_string(k * 4) + ", AC1\nMOVW *AC1, VW1000\n";
        i += 5;
        break;
      default:
        text += "LD " + bit("M", k) + "\nLD " + bit("I", k) + "\nA " + bit("I", k + 3) + "\nOLD\nLD " +
                bit("M", k + 4) + "\nCTU C" + std::to_string(k) + ", +20\n";
        i += 6;
        break;
    }
  }
  return text + "END_ORGANIZATION_BLOCK\n";
}

}  // namespace rungproof::test
