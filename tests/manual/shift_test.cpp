// Shifts, rotates and SHRB (001:5921-6027). SM1.1 takes the last bit out, SM1.0 tells whether the result is 0.
#include "example.hpp"

namespace rungproof::manual {

TEST(Shift, FillsWithZeroWhateverTheSign) {
  check({
      // Example 001:5972: VW200 = 1110 0010 1010 1101 shifted left by 3; bits out 1, 1, 1.
      {"SLW VW200, 3", "VW200=2#1110001010101101", "VW200=2#0001010101101000 SM1.0=0 SM1.1=1"},
      {"SLB VB0, 1", "VB0=2#01100001", "VB0=2#11000010 SM1.0=0 SM1.1=0"},
      {"SLB VB0, 3", "VB0=2#01100001", "VB0=2#00001000 SM1.0=0 SM1.1=1"},
      {"SLB VB0, VB1", "VB0=2#10000000 VB1=1", "VB0=0 SM1.0=1 SM1.1=1"},
      {"SLD VD0, 4", "VD0=16#18000001", "VD0=16#80000010 SM1.0=0 SM1.1=1"},
      {"SLD VD0, 31", "VD0=16#00000003", "VD0=16#80000000 SM1.0=0 SM1.1=1"},
      {"SLD VD0, 5", "VD0=16#F0000001", "VD0=16#00000020 SM1.0=0 SM1.1=0"},
      {"SRB VB0, 1", "VB0=2#10000110", "VB0=2#01000011 SM1.0=0 SM1.1=0"},
      {"SRB VB0, 2", "VB0=2#10000110", "VB0=2#00100001 SM1.0=0 SM1.1=1"},
      {"SRB VB0, 7", "VB0=2#01000000", "VB0=0 SM1.0=1 SM1.1=1"},
      {"SRW VW0, 4", "VW0=16#F018", "VW0=16#0F01 SM1.0=0 SM1.1=1"},
      {"SRW VW0, 15", "VW0=16#8000", "VW0=16#0001 SM1.0=0 SM1.1=0"},
      {"SRW VW0, 1", "VW0=1", "VW0=0 SM1.0=1 SM1.1=1"},
      {"SRD VD0, 8", "VD0=16#80000180", "VD0=16#00800001 SM1.0=0 SM1.1=1"},
      {"SRD VD0, 31", "VD0=16#C0000000", "VD0=1 SM1.0=0 SM1.1=1"},
      {"SRD AC0, 1", "AC0=2", "AC0=1 SM1.0=0 SM1.1=0"},
      {"SLW VW0, 1", "VW0=16#8000", "VW0=0 SM1.0=1 SM1.1=1"},
      {"SLW VW0, 15", "VW0=16#0003", "VW0=16#8000 SM1.0=0 SM1.1=1"},
  });
}

TEST(Shift, StopsAtTheWidth) {
  // 001:5925: N is cut to the width; the last bit out is then bit 0 to the left, the top bit to the right.
  check({
      {"SLB VB0, 8", "VB0=2#00000001", "VB0=0 SM1.0=1 SM1.1=1"},
      {"SLB VB0, 200", "VB0=2#11111110", "VB0=0 SM1.0=1 SM1.1=0"},
      {"SRB VB0, 255", "VB0=2#10000000", "VB0=0 SM1.0=1 SM1.1=1"},
      {"SLW VW0, 16", "VW0=1", "VW0=0 SM1.0=1 SM1.1=1"},
      {"SLW VW0, 17", "VW0=16#FFFE", "VW0=0 SM1.0=1 SM1.1=0"},
      {"SRW VW0, 16", "VW0=16#8000", "VW0=0 SM1.0=1 SM1.1=1"},
      {"SRW VW0, 100", "VW0=16#7FFF", "VW0=0 SM1.0=1 SM1.1=0"},
      {"SLD VD0, 32", "VD0=1", "VD0=0 SM1.0=1 SM1.1=1"},
      {"SLD VD0, 33", "VD0=16#FFFFFFFE", "VD0=0 SM1.0=1 SM1.1=0"},
      {"SRD VD0, 32", "VD0=16#80000000", "VD0=0 SM1.0=1 SM1.1=1"},
  });
}

TEST(Shift, ByZeroChangesNeitherValueNorLastBit) {
  check({
      {"SLB VB0, 0", "VB0=129", "SM1.0=0"},
      {"SRB VB0, 0", "", "SM1.0=1"},
      {"SLW VW0, VB9", "VW0=16#8001", "SM1.0=0"},
      {"SRW VW0, 0", "VW0=16#8001", "SM1.0=0"},
      {"SLD VD0, 0", "", "SM1.0=1"},
      {"SRD VD0, 0", "VD0=1", "SM1.0=0"},
  });
}

TEST(Rotate, TakesTheBitsThatLeave) {
  check({
      // Example 001:5972: AC0 = 0100 0000 0000 0001 rotated right by 2.
      {"RRW AC0, 2", "AC0=2#0100000000000001", "AC0=2#0101000000000000 SM1.0=0 SM1.1=0"},
      {"RRW VW0, 1", "VW0=2#0100000000000001", "VW0=2#1010000000000000 SM1.0=0 SM1.1=1"},
      {"RRB VB0, 3", "VB0=2#11010110", "VB0=2#11011010 SM1.0=0 SM1.1=1"},
      {"RRB VB0, 1", "VB0=2#00000010", "VB0=2#00000001 SM1.0=0 SM1.1=0"},
      {"RLB VB0, 3", "VB0=2#11010110", "VB0=2#10110110 SM1.0=0 SM1.1=0"},
      {"RLB VB0, 1", "VB0=2#10000000", "VB0=2#00000001 SM1.0=0 SM1.1=1"},
      {"RLW VW0, 4", "VW0=16#F00A", "VW0=16#00AF SM1.0=0 SM1.1=1"},
      {"RLW VW0, 15", "VW0=16#0003", "VW0=16#8001 SM1.0=0 SM1.1=1"},
      {"RLD VD0, 8", "VD0=16#12345678", "VD0=16#34567812 SM1.0=0 SM1.1=0"},
      {"RLD VD0, 1", "VD0=16#80000000", "VD0=1 SM1.0=0 SM1.1=1"},
      {"RRD VD0, 8", "VD0=16#12345681", "VD0=16#81123456 SM1.0=0 SM1.1=1"},
      {"RRD VD0, 4", "VD0=16#80000007", "VD0=16#78000000 SM1.0=0 SM1.1=0"},
  });
}

TEST(Rotate, CountsModuloTheWidth) {
  // 001:5942-5946: a multiple of the width rotates nothing and leaves SM1.1.
  check({
      {"RLB VB0, 0", "VB0=2#10000001", "SM1.0=0"},
      {"RLB VB0, 8", "VB0=2#10000001", "SM1.0=0"},
      {"RLB VB0, 9", "VB0=2#10000001", "VB0=2#00000011 SM1.0=0 SM1.1=1"},
      {"RRB VB0, 16", "VB0=1", "SM1.0=0"},
      {"RRB VB0, 255", "VB0=2#00000001", "VB0=2#00000010 SM1.0=0 SM1.1=0"},
      {"RLW VW0, 16", "VW0=16#8001", "SM1.0=0"},
      {"RRW VW0, 32", "VW0=0", "SM1.0=1"},
      {"RRW VW0, 17", "VW0=1", "VW0=16#8000 SM1.0=0 SM1.1=1"},
      {"RLD VD0, 32", "VD0=16#80000001", "SM1.0=0"},
      {"RRD VD0, 64", "VD0=16#80000001", "SM1.0=0"},
      {"RRD VD0, 33", "VD0=3", "VD0=16#80000001 SM1.0=0 SM1.1=1"},
      {"RLW VW0, 3", "", "SM1.0=1 SM1.1=0"},
      {"RRD VD0, 3", "", "SM1.0=1 SM1.1=0"},
  });
}

TEST(ShiftRegister, ExampleOfTheManual) {
  // 001:6014: S_BIT = V33.4, N = 14: 33.4 + 13 = byte 35, bit 1. A 1 enters at V33.4, V35.1 leaves.
  check({
      {"SHRB I0.3, V33.4, 14", "I0.3=1 VB33=2#10100000 VB34=2#10000001 VB35=2#11111110",
       "VB33=2#01010000 VB34=2#00000011 VB35=2#11111101 SM1.1=1"},
      {"SHRB I0.3, V33.4, 14", "VB33=2#00011111 VB34=0 VB35=2#11111101", "VB33=2#00101111 VB35=2#11111110 SM1.1=0"},
      {"SHRB I0.3, V33.4, -14", "I0.3=1 VB33=2#10100000 VB34=2#10000001 VB35=2#11111101",
       "VB33=2#11010000 VB34=2#11000000 VB35=2#11111110 SM1.1=0"},
      {"SHRB I0.3, V33.4, -14", "VB33=2#00011111 VB35=2#00000010", "VB33=2#00001111 VB35=2#00000001 SM1.1=1"},
  });
}

TEST(ShiftRegister, LengthsAndErrors) {
  check({
      {"SHRB I0.0, M0.0, 1", "I0.0=1", "M0.0=1 SM1.1=0"},
      {"SHRB I0.0, M0.0, 1", "M0.0=1", "M0.0=0 SM1.1=1"},
      {"SHRB I0.0, M0.0, -1", "M0.0=1", "M0.0=0 SM1.1=1"},
      {"SHRB I0.0, M0.0, VB0", "I0.0=1 MB0=2#10001111 VB0=4", "MB0=2#10001111 SM1.1=1"},
      {"SHRB I0.0, M0.0, VB0", "I0.0=1 MB0=2#00001000 VB0=-4", "MB0=2#00001100 SM1.1=0"},
      {"SHRB I0.0, V0.0, 64", "VB0=1 VB7=16#80", "VB0=2 VB7=0 SM1.1=1"},
      {"SHRB M0.7, M0.0, 8", "MB0=16#80", "MB0=1 SM1.1=1"},
      {"SHRB I0.0, M0.0, 0", "I0.0=1 MB0=16#55", "", "0092"},
      {"SHRB I0.0, M0.0, VB0", "I0.0=1 MB0=16#55 VB0=65", "", "0092"},
      {"SHRB I0.0, M0.0, VB0", "I0.0=1 MB0=16#55 VB0=16#80", "", "0092"},
      {"SHRB I0.0, M31.0, 9", "I0.0=1 MB31=16#55", "", "0091"},
      {"SHRB I0.0, M31.0, 8", "I0.0=1 MB31=16#55", "MB31=16#AB SM1.1=0"},
      {"SHRB I0.0, M0.0, *VD0", "VD0=16#FF000000", "", "0006"},
  });
}

}  // namespace rungproof::manual
