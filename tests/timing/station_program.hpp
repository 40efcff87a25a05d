// A program as a works has it: many subroutines, one for each station, with parameters, titles and comments.
#pragma once

#include <fmt/format.h>

#include <string>

namespace rungproof::test {

inline std::string bitOf(const char* area, int n) { return fmt::format("{}{}.{}", area, n / 8 % 16, n % 8); }

/// The network with that number of a station; a fifth of the networks counts, compares, latches ... in turn.
inline std::string stationNetwork(int number, int station) {
  const int k = (number + station * 7) % 97, speed = k * 4 + 400;
  const std::string sensor = bitOf("I", k), lamp = bitOf("Q", k), flag = bitOf("M", k);
  std::string text = fmt::format("Network {} // part {} of station {}\n", number, number, station);
  if (number % 3 == 0) text += fmt::format("// The pump runs while the tank of part {} is not full.\n", number);
  switch (number % 5) {
    case 0: return text + fmt::format("LD #start\nA {}\n= #valve\nLD {}\n= {}\n", sensor, bitOf("I", k + 1), lamp);
    case 1: return text + fmt::format("LD {}\nO {}\nAN {}\n= {}\n", sensor, lamp, bitOf("I", k + 2), lamp);
    case 2:
      return text +
             fmt::format("LD {}\nTON T{}, +10\nLD T{}\nEU\nMOVW #level, VW{}\n", sensor, 101 + k, 101 + k, speed);
    case 3:
      return text +
             fmt::format("LDW>= VW{}, +100\nAW< #level, +900\nS {}, 1\nR {}, 1\n", speed, flag, bitOf("M", k + 1));
    default:
      return text + fmt::format("LD {}\nLD {}\nA {}\nOLD\nINCW #sum\nMOVB MB{}, VB{}\n", flag, sensor,
                                bitOf("I", k + 3), k % 16, 2000 + k);
  }
}

/// 60 stations, each with so many times five networks, which are 24 instructions.
inline std::string stationProgram(int fives) {
  constexpr int stations = 60;
  std::string text = "ORGANIZATION_BLOCK MAIN:OB1\nTITLE=Main of the plant\nBEGIN\n";
  for (int s = 0; s < stations; ++s)
    text += fmt::format(
        "Network {} // call of station {}\n// Station {} is run in each scan.\nLD SM0.0\n"
        "CALL SBR{}, {}, VW{}, VW{}, {}\n",
        s + 1, s, s, s, bitOf("I", s), s * 10, s * 10 + 2, bitOf("Q", s));
  text += "END_ORGANIZATION_BLOCK\n";
  for (int s = 0; s < stations; ++s) {
    text += fmt::format(
        "SUBROUTINE_BLOCK Station{}:SBR{}\nTITLE=Station {}\nVAR_INPUT\nstart:BOOL; // starts it\n"
        "level:WORD; // of the tank\nEND_VAR\nVAR_IN_OUT\nsum:WORD; // of all\nEND_VAR\n"
        "VAR_OUTPUT\nvalve:BOOL; // to the drive\nEND_VAR\nBEGIN\n",
        s, s, s);
    for (int n = 1; n <= 5 * fives; ++n) text += stationNetwork(n, s);
    text += "END_SUBROUTINE_BLOCK\n";
  }
  return text;
}

}  // namespace rungproof::test
