// Bitwise logic: patterns of the manual's example (001:5587-5599) and each width with all four input combinations
// side by side, 1100 and 1010, so that AND gives 1000, OR 1110, XOR 0110.
#include "example.hpp"

namespace rungproof::manual {

TEST(Logic, BytesWordsDoubleWords) {
  check({
      {"ANDB VB0, VB1", "VB0=2#11001100 VB1=2#10101010", "VB1=2#10001000 SM1.0=0"},
      {"ORB VB0, VB1", "VB0=2#11001100 VB1=2#10101010", "VB1=2#11101110 SM1.0=0"},
      {"XORB VB0, VB1", "VB0=2#11001100 VB1=2#10101010", "VB1=2#01100110 SM1.0=0"},
      {"ANDW VW0, VW2", "VW0=16#CC0C VW2=16#AA0A", "VW2=16#8808 SM1.0=0"},
      {"ORW VW0, VW2", "VW0=16#CC0C VW2=16#AA0A", "VW2=16#EE0E SM1.0=0"},
      {"XORW VW0, VW2", "VW0=16#CC0C VW2=16#AA0A", "VW2=16#6606 SM1.0=0"},
      {"ANDD VD0, VD4", "VD0=16#CC0C00C0 VD4=16#AA0A00A0", "VD4=16#88080080 SM1.0=0"},
      {"ORD VD0, VD4", "VD0=16#CC0C00C0 VD4=16#AA0A00A0", "VD4=16#EE0E00E0 SM1.0=0"},
      {"XORD VD0, VD4", "VD0=16#CC0C00C0 VD4=16#AA0A00A0", "VD4=16#66060060 SM1.0=0"},
  });
}

TEST(Logic, ZeroResultSetsOnlyTheZeroBit) {
  check({
      {"ANDB 16#F0, VB1", "VB1=16#0F", "VB1=0 SM1.0=1"},
      {"ORB 0, VB1", "VB1=0", "SM1.0=1"},
      {"XORB VB1, VB1", "VB1=16#5A", "VB1=0 SM1.0=1"},
      {"ANDW 16#FF00, MW0", "MW0=16#00FF", "MW0=0 SM1.0=1"},
      {"ORW MW0, MW2", "", "SM1.0=1"},
      {"XORW MW0, MW2", "MW0=16#8001 MW2=16#8001", "MW2=0 SM1.0=1"},
      {"ANDD MD0, MD4", "MD0=16#80000000 MD4=16#7FFFFFFF", "MD4=0 SM1.0=1"},
      {"ORD MD0, MD4", "", "SM1.0=1"},
      {"XORD MD0, MD4", "MD0=16#FFFFFFFF MD4=16#FFFFFFFF", "MD4=0 SM1.0=1"},
      // The highest bit alone is not zero, and there is no sign bit among the flags.
      {"ANDW 16#8000, VW0", "VW0=16#FFFF", "VW0=16#8000 SM1.0=0"},
      {"ORD 16#80000000, VD0", "", "VD0=16#80000000 SM1.0=0"},
      {"XORB 16#80, VB0", "", "VB0=16#80 SM1.0=0"},
  });
}

TEST(Logic, AccumulatorKeepsItsUpperBits) {
  // 001:1344: a byte or word access to AC0 means its low 8 or 16 bits.
  check({
      {"ANDB 16#0F, AC0", "AC0=16#12345678", "AC0=16#12345608 SM1.0=0"},
      {"ORW 16#00FF, AC1", "AC1=16#12345600", "AC1=16#123456FF SM1.0=0"},
      {"XORD AC1, AC0", "AC0=16#0F0F0F0F AC1=16#FFFF0000", "AC0=16#F0F00F0F SM1.0=0"},
  });
}

TEST(Logic, InvertIsTheOnesComplement) {
  check({
      {"INVB VB0", "VB0=2#10100101", "VB0=2#01011010 SM1.0=0"},
      {"INVB VB0", "VB0=255", "VB0=0 SM1.0=1"},
      {"INVB AC0", "AC0=16#FFFFFF00", "AC0=16#FFFFFFFF SM1.0=0"},
      {"INVW VW0", "VW0=16#D795", "VW0=16#286A SM1.0=0"},
      {"INVW VW0", "VW0=16#FFFF", "VW0=0 SM1.0=1"},
      {"INVW VW0", "VW0=16#7FFF", "VW0=16#8000 SM1.0=0"},
      {"INVD VD0", "VD0=16#00FF1234", "VD0=16#FF00EDCB SM1.0=0"},
      {"INVD VD0", "VD0=16#FFFFFFFF", "VD0=0 SM1.0=1"},
      {"INVD AC2", "AC2=16#F0000001", "AC2=16#0FFFFFFE SM1.0=0"},
  });
}

TEST(Logic, BadPointerIsError0006AndWritesNothing) {
  check({
      {"ANDW *VD0, VW8", "VD0=16#FF000000 VW8=16#1234", "", "0006"},
      {"INVB *AC1", "AC1=16#7F000000", "", "0006"},
  });
}

}  // namespace rungproof::manual
