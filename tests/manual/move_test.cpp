// Moves (001:5601-5683), immediate byte moves (001:5622-5646), block moves (001:5648-5683) and SWAP (001:6031-6065).
#include "example.hpp"

namespace rungproof::manual {

TEST(Move, CopiesBitsAndNoFlags) {
  check({
      {"MOVB VB50, AC0", "VB50=16#A5 AC0=16#11223344", "AC0=16#112233A5"},
      {"MOVB 255, QB0", "", "QB0=255"},
      {"MOVB AC0, VB0", "AC0=16#11223344", "VB0=16#44"},
      {"MOVW VW100, VW102", "VW100=16#8001", "VW102=16#8001"},
      {"MOVW -2, AC1", "AC1=16#77770000", "AC1=16#7777FFFE"},
      {"MOVW 500, AQW4", "", "AQW4=500"},
      {"MOVW T37, VW0", "T.value[37]=1234 T[37]=1", "VW0=1234"},
      {"MOVW 77, C5", "C[5]=1", "C.value[5]=77"},
      {"MOVD VD0, VD4", "VD0=16#12345678", "VD4=16#12345678"},
      {"MOVD HC0, MD0", "HC[0]=16#89ABCDEF", "MD0=16#89ABCDEF"},
      {"MOVD 16#FFFFFFFF, LD60", "", "LD60=16#FFFFFFFF"},
      {"MOVR VD0, VD4", "VD0=-2.5", "VD4=-2.5"},
      {"MOVR 1.5, AC3", "AC3=16#FFFFFFFF", "AC3=1.5"},
      {"MOVR AC0, VD8", "AC0=16#7F800001", "VD8=16#7F800001"},  // bits, no arithmetic: even an illegal number
  });
}

TEST(Move, ByteOrderPutsTheHighByteFirst) {
  check({
      {"MOVW VW50, VW60", "VB50=16#D6 VB51=16#C3", "VB60=16#D6 VB61=16#C3"},
      {"MOVD 16#01020304, VD0", "", "VB0=1 VB1=2 VB2=3 VB3=4"},
      {"MOVW 16#0102, VW1", "", "VB1=1 VB2=2"},
  });
}

TEST(Move, PointersReachEveryAreaByTheirOwnStep) {
  // 001:1470-1478: one byte per step, 2 for the next word or current value.
  check({
      {"MOVD &VB200, AC1; MOVW *AC1, AC0", "VW200=16#1234 AC0=16#99990000", "AC1=16#080000C8 AC0=16#99991234"},
      {"MOVD &VB200, VD0; +D 2, VD0; MOVW *VD0, VW4", "VW202=16#5678",
       "VD0=16#080000CA VW4=16#5678 SM1.0=0 SM1.1=0 SM1.2=0"},
      {"MOVD &T37, AC1; +D 2, AC1; MOVW *AC1, VW0", "T.value[38]=321",
       "AC1=16#0900004C VW0=321 SM1.0=0 SM1.1=0 SM1.2=0"},
      {"MOVD &C0, VD8; MOVW 5, *VD8", "", "VD8=16#0A000000 C.value[0]=5"},
      {"MOVD &MB3, AC2; MOVB 7, *AC2", "", "AC2=16#04000003 MB3=7"},
  });
}

TEST(Move, BadPointersAreError0006) {
  check({
      {"MOVW *AC1, VW0", "AC1=16#FF000000 VW0=5", "", "0006"},
      {"MOVB VB0, *VD4", "VD4=16#0800FFFF", "", "0006"},  // beyond V
      {"MOVD VD0, *VD8", "VD8=16#0800280C", "", "0006"},  // VD10252 of 10240 bytes
      {"MOVD VD0, *VD8", "VD0=1 VD8=16#080027FC", "VD10236=1"},
      {"MOVB *VD8, VB0", "VD8=16#0900004A", "", "0006"},  // a timer is a word
  });
}

TEST(MoveImmediate, ReadPassesTheImageByAndWriteGoesToBoth) {
  Plant read("LD SM0.0; BIR IB0, VB0; BIR *VD4, VB1");
  read.set("VD4=1 IB0=0");  // pointer to IB1
  for (const std::uint32_t bit : {0U, 3U, 7U, 9U}) read.outside.values[{External::ImmediateInput, bit}] = 1;
  read.scan();
  EXPECT_EQ(read.value("VB0"), 0b10001001U);
  EXPECT_EQ(read.value("VB1"), 0b00000010U);
  EXPECT_EQ(read.value("IB0"), 0U) << "the image keeps its value (001:5626)";
  EXPECT_TRUE(read.outside.hazards().empty());
  check({
      {"BIW VB0, QB1", "VB0=16#83", "QB1=16#83 output[8]=1 output[9]=1 output[15]=1"},
      {"BIW 0, QB0", "QB0=16#FF output[1]=1 output[7]=1", "QB0=0 output[1]=0 output[7]=0"},
      {"BIW 1, *VD4", "VD4=16#01000002", "QB2=1 output[16]=1"},
      {"BIW 1, *VD4", "VD4=16#05000002", "", "0006"},
      {"BIR *VD4, VB0", "VD4=16#01000002", "", "0006"},
  });
}

TEST(BlockMove, CopiesElements) {
  check({
      // Example 001:5675: VB20 to VB23 = 30 31 32 33 go to VB100 to VB103.
      {"BMB VB20, VB100, 4", "VB20=30 VB21=31 VB22=32 VB23=33 VB24=34", "VB100=30 VB101=31 VB102=32 VB103=33"},
      {"BMB VB0, MB0, VB9", "VB0=1 VB1=2 VB9=1", "MB0=1"},
      {"BMW VW0, VW10, 2", "VW0=16#0102 VW2=16#0304 VW4=16#0506", "VW10=16#0102 VW12=16#0304"},
      {"BMW T37, VW0, 2", "T.value[37]=11 T.value[38]=12 T.value[39]=13", "VW0=11 VW2=12"},
      {"BMW VW0, C1, 2", "VW0=11 VW2=12", "C.value[1]=11 C.value[2]=12"},
      {"BMW VW0, AQW0, 2", "VW0=11 VW2=12", "AQW0=11 AQW2=12"},
      {"BMD VD0, VD20, 3", "VD0=16#01020304 VD4=5 VD8=6 VD12=7", "VD20=16#01020304 VD24=5 VD28=6"},
      {"BMD VD0, VD2, 1", "VD0=16#01020304", "VD2=16#01020304"},
      {"BMD *VD0, VD100, 1", "VD0=16#08000014 VD20=9", "VD100=9"},
  });
}

TEST(BlockMove, OverlapIsAscendingOrBuffered) {
  check({
      {"BMB VB0, VB1, 3", "VB0=1 VB1=2 VB2=3 VB3=4", "VB1=1 VB2=1 VB3=1"},
      {"BMB VB0, VB1, 3", "VB0=1 VB1=2 VB2=3 VB3=4", "VB1=1 VB2=2 VB3=3", "", "block-move-overlap=buffered"},
      {"BMB VB1, VB0, 3", "VB0=1 VB1=2 VB2=3 VB3=4", "VB0=2 VB1=3 VB2=4"},
      {"BMW VW0, VW2, 2", "VW0=1 VW2=2 VW4=3", "VW2=1 VW4=1"},
      {"BMD VD0, VD4, 2", "VD0=1 VD4=2 VD8=3", "VD4=1 VD8=2", "", "block-move-overlap=buffered"},
  });
}

TEST(BlockMove, CountsAndRanges) {
  check({
      {"BMB VB0, VB100, VB50", "VB0=1", ""},
      {"BMB VB0, VB100, VB50", "VB0=1", "", "0091", "block-move-zero=error"},
      {"BMB VB0, MB30, 3", "VB0=1 VB1=2 VB2=3", "", "0091"},
      {"BMB VB0, MB30, 3", "VB0=1 VB1=2 VB2=3", "MB30=1 MB31=2", "0091", "block-move-range=up-to-the-end"},
      {"BMB VB0, MB30, 2", "VB0=1 VB1=2", "MB30=1 MB31=2"},
      {"BMW MW30, VW0, 2", "MW30=5", "", "0091"},
      {"BMD VD0, MD28, 2", "VD0=1", "", "0091"},
      {"BMW T255, VW0, 2", "T.value[255]=7", "", "0091"},
      {"BMB VB0, VB1000, 255", "VB0=1 VB254=2 VB255=3", "VB1000=1 VB1254=2"},
  });
}

TEST(Swap, ExchangesTheBytesOfAWord) {
  check({
      {"SWAP VW50", "VW50=16#D6C3", "VW50=16#C3D6"},  // example 001:6056
      {"SWAP AC0", "AC0=16#12345678", "AC0=16#12347856"},
      {"SWAP VW0", "VW0=16#00FF", "VW0=16#FF00"},
      {"SWAP *VD0", "VD0=16#08000008 VW8=16#0102", "VW8=16#0201"},
      {"SWAP *VD0", "VD0=16#FF000008", "", "0006"},
  });
}

}  // namespace rungproof::manual
