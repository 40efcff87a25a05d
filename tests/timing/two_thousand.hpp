// Programs of ten instructions over and over; on that of 2,000 the bars of an engineer's patience stand.
#pragma once

#include <fmt/format.h>

#include <string>

namespace rungproof::test {

/// A rung with a branch and a coil, a timer with an edge, a move and an addition, ten instructions in turn.
inline std::string tenInstructions(int times) {
  std::string text = "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\n";
  for (int i = 0; i < times; ++i) {
    const std::string bit = std::to_string(i / 8 % 16) + "." + std::to_string(i % 8);
    const std::string word = std::to_string(i % 200 * 2);
    text += fmt::format("Network {} // rung\nLD I{}\nO Q{}\nAN M{}\n= Q{}\n", 2 * i + 1, bit, bit, bit, bit);
    text += fmt::format("Network {} // delay\nLD Q{}\nTON T{}, +10\nLD T{}\nEU\nMOVW VW{}, VW1000\n+I 5, VW{}\n",
                        2 * i + 2, bit, 101 + i % 100, 101 + i % 100, word, word);
  }
  return text + "END_ORGANIZATION_BLOCK\n";
}
inline std::string twoThousandInstructions() { return tenInstructions(200); }

}  // namespace rungproof::test
