// A ring buffer of an S7-300: an FB writes into its own array through a pointer that it makes of the array's place, a
// position and AR2, so that it may be an instance within another.
#pragma once

#include <fmt/format.h>

#include <string>

namespace rungproof::test {

/// The blocks around OB1, which calls FB 2 with DB 1: two rings of `places` numbers, written where I0.0 and I0.1 rise.
/// In DB 1 the position of the first ring stands in DBW 8, that of the second in DBW 18 + 2 * places.
inline std::string ringsInTwoInstances(int places) {
  return fmt::format(
      "FUNCTION_BLOCK FB 1\nVAR_INPUT\n put : BOOL;\n value : INT;\nEND_VAR\nVAR_OUTPUT\n newest : INT;\nEND_VAR\n"
      "VAR\n edge : BOOL;\n pos : INT;\n liste : ARRAY [0 .. {0}] OF INT;\nEND_VAR\nBEGIN\nNETWORK\n"
      "A #put; FP #edge; NOT; JC ende;\n"
      "L #pos; SLW 4; LAR1 P##liste; +AR1; TAR2; +AR1; L #value; T W [AR1,P#0.0];\n"
      "L #pos; + 1; T #pos; L {1}; <I; JC ende; L 0; T #pos;\n"
      "ende: L #value; T #newest;\nEND_FUNCTION_BLOCK\n"
      "FUNCTION_BLOCK FB 2\nVAR\n a : FB 1;\n b : FB 1;\nEND_VAR\nBEGIN\nNETWORK\n"
      "CALL #a ( put := I 0.0 , value := MW 10 , newest := MW 20 );\n"
      "CALL #b ( put := I 0.1 , value := MW 12 , newest := MW 22 );\nEND_FUNCTION_BLOCK\n"
      "DATA_BLOCK DB 1\nFB 2\nBEGIN\nEND_DATA_BLOCK\n",
      places - 1, places);
}

}  // namespace rungproof::test
