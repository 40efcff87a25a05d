// Borders: an operand that ends with the last byte of its area is legal, one byte further it is error 0091
// (001:13968). V of the CPU 226 ends at VB10239 (001:2688). Also N and format bytes that are no constants.
#include "example.hpp"

namespace rungproof::manual {

TEST(Border, StringsAtTheEndOfV) {
  check({
      {"SCPY VB0, VB10236", "VB0=3 VB1=65 VB2=66 VB3=67", "VB10236=3 VB10237=65 VB10238=66 VB10239=67"},
      {"SCPY VB0, VB10237", "VB0=3 VB1=65 VB2=66 VB3=67", "", "0091"},
      {"SCPY VB10237, VB0", "VB10237=2 VB10238=65 VB10239=66", "VB0=2 VB1=65 VB2=66"},
      {"SCPY VB10238, VB0", "VB10238=2 VB10239=65", "", "0091"},
      {"SCPY \"AB\", VB10237", "", "VB10237=2 VB10238=65 VB10239=66"},
      {"SCPY \"AB\", VB10238", "", "", "0091"},
      {"SCAT VB0, VB10236", "VB0=1 VB1=66 VB10236=2 VB10237=65 VB10238=65", "VB10236=3 VB10239=66"},
      {"SCAT VB0, VB10237", "VB0=1 VB1=66 VB10237=2 VB10238=65 VB10239=65", "", "0091"},
      {"SCAT VB10238, VB0", "VB10238=1 VB10239=66 VB0=1 VB1=65", "VB0=2 VB2=66"},
      {"SCAT VB10239, VB0", "VB10239=1 VB0=1 VB1=65", "", "0091"},
      {"SCAT VB0, VB10239", "VB10239=1", "", "0091"},
      {"SSCPY VB0, 1, 2, VB10237", "VB0=2 VB1=65 VB2=66", "VB10237=2 VB10238=65 VB10239=66"},
      {"SSCPY VB0, 1, 2, VB10238", "VB0=2 VB1=65 VB2=66", "", "0091"},
      {"SSCPY VB10237, 2, 1, VB0", "VB10237=2 VB10238=65 VB10239=66", "VB0=1 VB1=66"},
      {"SSCPY VB10238, 2, 1, VB0", "VB10238=2 VB10239=65", "", "0091"},
      {"SFND VB10237, VB0, VB50", "VB10237=2 VB10238=65 VB10239=66 VB0=1 VB1=66 VB50=1", "VB50=2"},
      {"SFND VB10238, VB0, VB50", "VB10238=2 VB10239=66 VB0=1 VB1=66 VB50=1", "", "0091"},
      {"SFND VB0, VB10238, VB50", "VB10238=1 VB10239=66 VB0=2 VB1=65 VB2=66 VB50=1", "VB50=2"},
      {"SFND VB0, VB10239, VB50", "VB10239=1 VB0=2 VB1=65 VB2=66 VB50=1", "", "0091"},
      {"CFND VB10237, VB0, VB50", "VB10237=2 VB10238=65 VB10239=66 VB0=1 VB1=66 VB50=1", "VB50=2"},
      {"CFND VB10238, VB0, VB50", "VB10238=2 VB10239=66 VB0=1 VB1=66 VB50=1", "", "0091"},
      {"CFND VB0, VB10238, VB50", "VB10238=1 VB10239=66 VB0=2 VB1=65 VB2=66 VB50=1", "VB50=2"},
      {"CFND VB0, VB10239, VB50", "VB10239=1 VB0=2 VB1=65 VB2=66 VB50=1", "", "0091"},
  });
}

TEST(Border, BlocksAtTheEndOfV) {
  check({
      {"BMB VB10238, VB0, 2", "VB10238=1 VB10239=2", "VB0=1 VB1=2"},
      {"BMB VB10239, VB0, 2", "VB10239=1", "", "0091"},
      {"BMB VB0, VB10238, 2", "VB0=1 VB1=2", "VB10238=1 VB10239=2"},
      {"BMB VB0, VB10239, 2", "VB0=1", "", "0091"},
      {"BMW VW10236, VW0, 2", "VW10236=1 VW10238=2", "VW0=1 VW2=2"},
      {"BMW VW10238, VW0, 2", "VW10238=1", "", "0091"},
      {"BMW VW0, VW10236, 2", "VW0=1 VW2=2", "VW10236=1 VW10238=2"},
      {"BMW VW0, VW10238, 2", "VW0=1", "", "0091"},
      {"BMD VD10232, VD0, 2", "VD10232=1 VD10236=2", "VD0=1 VD4=2"},
      {"BMD VD10236, VD0, 2", "VD10236=1", "", "0091"},
      {"BMD VD0, VD10232, 2", "VD0=1 VD4=2", "VD10232=1 VD10236=2"},
      {"BMD VD0, VD10236, 2", "VD0=1", "", "0091"},
      {"BMW VW0, VW100, VB50", "VW0=1", ""},
      {"BMD VD0, VD100, VB50", "VD0=1", ""},
      {"BMW VW0, VW100, VB50", "VW0=1", "", "0091", "block-move-zero=error"},
      {"BMD VD0, VD100, VB50", "VD0=1", "", "0091", "block-move-zero=error"},
      {"BMB VB0, VB100, 7", "VB0=1 VB1=2 VB2=3 VB3=4 VB4=5 VB5=6 VB6=7 VB7=8",
       "VB100=1 VB101=2 VB102=3 VB103=4 VB104=5 VB105=6 VB106=7"},
      {"FILL 5, VW10236, 2", "", "VW10236=5 VW10238=5"},
      {"FILL 5, VW10238, 2", "", "", "0091"},
      {"FILL 5, VW0, 6", "", "VW0=5 VW2=5 VW4=5 VW6=5 VW8=5 VW10=5"},
  });
}

TEST(Border, TablesAtTheEndOfV) {
  // TL, EC, then the entries; FND starts at EC (001:6441).
  check({
      {"LIFO VW10234, VW0", "VW10234=1 VW10236=1 VW10238=7", "VW10236=0 VW0=7 SM1.5=0"},
      {"LIFO VW10236, VW0", "VW10236=1 VW10238=1", "SM1.5=0", "0091"},
      {"FIFO VW10234, VW0", "VW10234=1 VW10236=1 VW10238=7", "VW10236=0 VW0=7 SM1.5=0"},
      {"FIFO VW10236, VW0", "VW10236=1 VW10238=1", "SM1.5=0", "0091"},
      {"FIFO VW0, VW400", "VW0=100 VW2=100 VW4=8 VW6=9 VW202=77", "VW2=99 VW4=9 VW6=0 VW200=77 VW400=8 SM1.5=0"},
      {"FND= VW10236, 7, VW0", "VW10236=1 VW10238=7", "VW0=0"},
      {"FND= VW10238, 7, VW0", "VW10238=1", "", "0091"},
      {"FND<> VW10236, 7, VW0", "VW10236=1 VW10238=8", "VW0=0"},
      {"FND<> VW10238, 7, VW0", "VW10238=1", "", "0091"},
      {"FND< VW10236, 7, VW0", "VW10236=1 VW10238=6", "VW0=0"},
      {"FND< VW10238, 7, VW0", "VW10238=1", "", "0091"},
      {"FND> VW10236, 7, VW0", "VW10236=1 VW10238=8", "VW0=0"},
      {"FND> VW10238, 7, VW0", "VW10238=1", "", "0091"},
  });
}

/// What FND finds in a table of six from every start, also behind its end.
TEST(Border, FindFromEveryStart) {
  const std::string table = "VW0=6 VW2=4 VW4=-4 VW6=5 VW8=3 VW10=5 VW12=4 ";
  const auto finds = [&](const std::string& statement, const std::vector<int>& found) {
    for (std::size_t start = 0; start < found.size(); ++start) {
      check(Example{statement + ", VW400", table + "VW400=" + std::to_string(start),
                    "VW400=" + std::to_string(found[start])});
    }
  };
  finds("FND= VW0, 5", {2, 2, 2, 4, 4, 6, 6});
  finds("FND<> VW0, 5", {0, 1, 3, 3, 5, 5, 6});
  finds("FND< VW0, 4", {1, 1, 3, 3, 6, 6, 6});
  finds("FND> VW0, 4", {2, 2, 2, 4, 4, 6, 6});
  for (const char* statement : {"FND= VW0, 5", "FND<> VW0, 5", "FND< VW0, 4", "FND> VW0, 4"}) {
    check({{std::string(statement) + ", VW400", "VW0=101 VW2=5", "", "0091"},
           {std::string(statement) + ", VW400", "VW0=0 VW400=0", ""}});
  }
}

TEST(Border, CountOfShiftsFromMemory) {
  check({
      {"SRB VB0, VB9", "VB0=2#10000110 VB9=2", "VB0=2#00100001 SM1.0=0 SM1.1=1"},
      {"SLB VB0, VB9", "VB0=2#01100001 VB9=3", "VB0=2#00001000 SM1.0=0 SM1.1=1"},
      {"SRW VW0, VB9", "VW0=16#F018 VB9=4", "VW0=16#0F01 SM1.0=0 SM1.1=1"},
      {"SLW VW0, VB9", "VW0=2#1110001010101101 VB9=3", "VW0=2#0001010101101000 SM1.0=0 SM1.1=1"},
      {"SRD VD0, VB9", "VD0=16#80000180 VB9=8", "VD0=16#00800001 SM1.0=0 SM1.1=1"},
      {"SLD VD0, VB9", "VD0=16#18000001 VB9=4", "VD0=16#80000010 SM1.0=0 SM1.1=1"},
      {"RRB VB0, VB9", "VB0=2#11010110 VB9=3", "VB0=2#11011010 SM1.0=0 SM1.1=1"},
      {"RLB VB0, VB9", "VB0=2#11010110 VB9=3", "VB0=2#10110110 SM1.0=0 SM1.1=0"},
      {"RRW VW0, VB9", "VW0=2#0100000000000001 VB9=2", "VW0=2#0101000000000000 SM1.0=0 SM1.1=0"},
      {"RLW VW0, VB9", "VW0=16#F00A VB9=4", "VW0=16#00AF SM1.0=0 SM1.1=1"},
      {"RRD VD0, VB9", "VD0=16#12345681 VB9=8", "VD0=16#81123456 SM1.0=0 SM1.1=1"},
      {"RLD VD0, VB9", "VD0=16#12345678 VB9=8", "VD0=16#34567812 SM1.0=0 SM1.1=0"},
  });
}

TEST(Border, FormatFromMemory) {
  // Bits 2-0 places behind the point, bit 3 comma, upper half the size for REAL (001:3655). Right-aligned text.
  check({
      {"ITA VW0, VB10, VB2", "VW0=12 VB2=3", "VB10=32 VB11=32 VB12=32 VB13=48 VB14=46 VB15=48 VB16=49 VB17=50"},
      {"ITA VW0, VB10, VB2", "VW0=-1 VB2=9", "VB10=32 VB11=32 VB12=32 VB13=32 VB14=45 VB15=48 VB16=44 VB17=49"},
      {"ITS VW0, VB2, VB10", "VW0=12 VB2=3", "VB10=8 VB11=32 VB12=32 VB13=32 VB14=48 VB15=46 VB16=48 VB17=49 VB18=50"},
      {"ITS VW0, VB2, VB10", "VW0=-1 VB2=9", "VB10=8 VB11=32 VB12=32 VB13=32 VB14=32 VB15=45 VB16=48 VB17=44 VB18=49"},
      {"DTS VD0, VB5, VB10", "VD0=-70000 VB5=0",
       "VB10=12 VB11=32 VB12=32 VB13=32 VB14=32 VB15=32 VB16=32 VB17=45 VB18=55 VB19=48 VB20=48 VB21=48 VB22=48"},
      {"DTS VD0, VB5, VB10", "VD0=1 VB5=12",
       "VB10=12 VB11=32 VB12=32 VB13=32 VB14=32 VB15=32 VB16=32 VB17=48 VB18=44 VB19=48 VB20=48 VB21=48 VB22=49"},
      {"RTA VD0, VB10, VB5", "VD0=1.5 VB5=16#51", "VB10=32 VB11=32 VB12=49 VB13=46 VB14=53"},
      {"RTA VD0, VB10, VB5", "VD0=-2.0 VB5=16#68", "VB10=32 VB11=32 VB12=32 VB13=32 VB14=45 VB15=50"},
      {"RTS VD0, VB5, VB10", "VD0=1.5 VB5=16#51", "VB10=5 VB11=32 VB12=32 VB13=49 VB14=46 VB15=53"},
      {"RTS VD0, VB5, VB10", "VD0=-0.25 VB5=16#7A", "VB10=7 VB11=32 VB12=32 VB13=45 VB14=48 VB15=44 VB16=50 VB17=53"},
  });
}

}  // namespace rungproof::manual
