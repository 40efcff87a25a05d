// Tables (001:6256-6511): the tables printed before and after ATT (001:6283-6302), LIFO, FIFO, FILL (001:6400) and FND
// (001:6458-6499); full, empty and too long tables.
#include "example.hpp"

namespace rungproof::manual {
namespace {

const std::string twoEntries = "VW200=6 VW202=2 VW204=5431 VW206=8942";

}  // namespace

TEST(Table, AttAppends) {
  check({
      {"ATT VW100, VW200", "VW100=1234 " + twoEntries, "VW202=3 VW208=1234 SM1.4=0"},
      {"ATT -7, VW200", "VW200=6", "VW202=1 VW204=-7 SM1.4=0"},
      {"ATT VW100, VW200", "VW100=1234 VW200=3 VW202=2", "VW202=3 VW208=1234 SM1.4=0"},
      {"ATT VW100, VW200", "VW100=1234 VW200=2 VW202=2", "SM1.4=1", "SM1.4"},
      {"ATT VW100, VW200", "VW100=1234 VW200=2 VW202=3", "SM1.4=1", "SM1.4"},
      {"ATT VW100, VW200", "VW100=1234", "SM1.4=1", "SM1.4"},  // TL = 0 takes nothing
      {"ATT 5, VW0", "VW0=100 VW2=99", "VW2=100 VW202=5 SM1.4=0"},
      {"ATT 5, VW0", "VW0=101 VW2=100", "SM1.4=0", "0091"},  // at most 100 entries
      {"ATT 5, MW26", "MW26=3 MW28=1", "SM1.4=0", "0091"},   // d1 would be MW32
      {"ATT 5, MW26", "MW26=3", "MW28=1 MW30=5 SM1.4=0"},
      {"ATT 5, *VD0", "VD0=16#080000C8 VW200=2", "VW202=1 VW204=5 SM1.4=0"},
  });
}

TEST(Table, LifoTakesTheNewestEntry) {
  check({
      {"LIFO VW200, VW400", "VW200=6 VW202=3 VW204=5431 VW206=8942 VW208=1234", "VW202=2 VW400=1234 SM1.5=0"},
      {"LIFO VW200, VW400", "VW200=6 VW202=1 VW204=5431 VW206=8942", "VW202=0 VW400=5431 SM1.5=0"},
      {"LIFO VW200, AC0", "AC0=16#AAAA0000 " + twoEntries, "VW202=1 AC0=16#AAAA22EE SM1.5=0"},  // 8942 = 22EE
      {"LIFO VW200, VW400", "VW200=6 VW204=5431", "SM1.5=1", "SM1.5"},
      {"LIFO VW200, AQW0", twoEntries, "VW202=1 AQW0=8942 SM1.5=0"},
      {"LIFO VW0, VW400", "VW0=100 VW2=100 VW202=77", "VW2=99 VW400=77 SM1.5=0"},
      {"LIFO VW0, VW400", "VW0=101 VW2=101", "SM1.5=0", "0091"},
  });
}

TEST(Table, FifoTakesTheOldestAndMovesTheRestUp) {
  check({
      {"FIFO VW200, VW400", "VW200=6 VW202=3 VW204=5431 VW206=8942 VW208=1234",
       "VW202=2 VW204=8942 VW206=1234 VW400=5431 SM1.5=0"},
      {"FIFO VW200, VW400", "VW200=6 VW202=1 VW204=5431 VW206=8942", "VW202=0 VW400=5431 SM1.5=0"},
      {"FIFO VW200, VW400", "VW200=6 VW204=5431 VW400=3", "SM1.5=1", "SM1.5"},
      {"FIFO MW26, VW400", "MW28=2 MW30=5", "SM1.5=0", "0091"},
  });
}

TEST(Table, FillWritesWords) {
  check({
      {"FILL 0, VW200, 10", "VW200=1 VW210=2 VW218=3 VW220=4", "VW200=0 VW210=0 VW218=0"},  // 001:6400: VW200 to VW218
      {"FILL -2, MW0, 2", "", "MW0=16#FFFE MW2=16#FFFE"},
      {"FILL VW0, C10, VB2", "VW0=7 VB2=2", "C.value[10]=7 C.value[11]=7"},
      {"FILL 1, AQW0, 2", "", "AQW0=1 AQW2=1"},
      {"FILL 1, MW30, 2", "", "", "0091"},
      {"FILL 1, MW30, 2", "", "MW30=1", "0091", "block-move-range=up-to-the-end"},
      {"FILL 1, VW0, VB9", "", ""},
      {"FILL 1, VW0, VB9", "", "", "0091", "block-move-zero=error"},
  });
}

TEST(Table, FindReproducesTheExample) {
  // 001:6458-6499: EC at VW202, looking for 3130: found at d2, then from 3 at d4, then from 5 not found: INDX = EC = 6.
  const std::string table =
      "VW202=6 VW204=16#3133 VW206=16#4142 VW208=16#3130 VW210=16#3030 VW212=16#3130 VW214=16#4541 ";
  check({
      {"FND= VW202, 16#3130, AC1", table + "AC1=0", "AC1=2"},
      {"FND= VW202, 16#3130, AC1", table + "AC1=2", "AC1=2"},
      {"FND= VW202, 16#3130, AC1", table + "AC1=3", "AC1=4"},
      {"FND= VW202, 16#3130, AC1", table + "AC1=5", "AC1=6"},
      {"FND= VW202, 16#3130, AC1", table + "AC1=6", "AC1=6"},
      {"FND= VW202, 16#3130, AC1", table + "AC1=9", "AC1=9"},
      {"FND<> VW202, 16#3133, AC1", table + "AC1=0", "AC1=1"},
      {"FND< VW202, 16#3130, VW0", table, "VW0=3"},
      {"FND> VW202, 16#4142, VW0", table, "VW0=5"},
      {"FND> VW202, 16#3133, VW0", table, "VW0=1"},
      {"FND= VW202, 0, VW0", table, "VW0=6"},  // what lies behind the entries does not count
  });
}

TEST(Table, FindComparesSigned) {
  check({
      {"FND< VW0, 0, VW100", "VW0=3 VW2=5 VW4=0 VW6=-1", "VW100=2"},
      {"FND> VW0, -2, VW100", "VW0=3 VW2=-32768 VW4=-2 VW6=-1", "VW100=2"},
      {"FND<> VW0, 5, VW100", "VW0=2 VW2=5 VW4=-5", "VW100=1"},
      {"FND<> VW0, 5, VW100", "VW0=2 VW2=5 VW4=5", "VW100=2"},
      {"FND= VW0, 5, VW100", "VW100=3", "VW100=3"},
      {"FND= VW0, 5, VW300", "VW0=100 VW200=5", "VW300=99"},
      {"FND= VW0, 5, VW300", "VW0=101 VW2=5", "", "0091"},
      {"FND< MW28, 5, VW300", "MW28=2", "", "0091"},
  });
}

TEST(Table, FindAndAttShareOneTable) {
  // 001:6441: FND takes the address of EC, one word further than ATT.
  Plant plant("LD SM0.0; ATT 11, VW200; ATT 22, VW200; FND= VW202, 22, VW0");
  plant.set("VW200=6").scan();
  EXPECT_EQ(plant.value("VW202"), 2U);
  EXPECT_EQ(plant.value("VW0"), 1U);
  EXPECT_TRUE(plant.outside.hazards().empty());
}

}  // namespace rungproof::manual
