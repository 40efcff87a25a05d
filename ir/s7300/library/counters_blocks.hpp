// Counters of IEC 61131-3 (002:2516-2532; general knowledge beyond). One struct for each block.
#pragma once

#include "ir/machine/instruction_group.hpp"
#include "ir/s7300/library.hpp"

namespace rungproof::s7300::library {

// A rising CU adds 1 unless CV = 32767; R sets it to 0.
inline constexpr std::string_view countUp = R"(
      A #R; JC res;
      A #CU; AN #CUO; JCN out;
      L #CV; L 32767; <I; JCN out;
      L #CV; + 1; T #CV; JU out;
res:  L 0; T #CV;
out:  A #CU; = #CUO;
      L #CV; L #PV; >=I; = #Q;
      SET; SAVE; BEU;)";

inline constexpr std::string_view countDown = R"(
      A #LOAD; JC load;
      A #CD; AN #CDO; JCN out;
      L #CV; L -32768; >I; JCN out;
      L #CV; + -1; T #CV; JU out;
load: L #PV; T #CV;
out:  A #CD; = #CDO;
      L #CV; L 0; <=I; = #Q;
      SET; SAVE; BEU;)";

// R before LOAD before counting; both inputs rising at once cancel.
inline constexpr std::string_view countUpDown = R"(
      A #R; JC res;
      A #LOAD; JC load;
      A #CU; AN #CUO; A #CD; AN #CDO; JC out;
      A #CU; AN #CUO; JCN down;
      L #CV; L 32767; <I; JCN out;
      L #CV; + 1; T #CV; JU out;
down: A #CD; AN #CDO; JCN out;
      L #CV; L -32768; >I; JCN out;
      L #CV; + -1; T #CV; JU out;
res:  L 0; T #CV; JU out;
load: L #PV; T #CV;
out:  A #CU; = #CUO;
      A #CD; = #CDO;
      L #CV; L #PV; >=I; = #QU;
      L #CV; L 0; <=I; = #QD;
      SET; SAVE; BEU;)";

struct Sfb0 {
  static constexpr LibraryBlock block = {.type = BlockType::Sfb,
                                         .number = 0,
                                         .name = "CTU",
                                         .parameters = "CU:BOOL R:BOOL PV:INT|Q:BOOL CV:INT||CUO:BOOL",
                                         .statements = countUp};
};

struct Sfb1 {
  static constexpr LibraryBlock block = {.type = BlockType::Sfb,
                                         .number = 1,
                                         .name = "CTD",
                                         .parameters = "CD:BOOL LOAD:BOOL PV:INT|Q:BOOL CV:INT||CDO:BOOL",
                                         .statements = countDown};
};

struct Sfb2 {
  static constexpr LibraryBlock block = {
      .type = BlockType::Sfb,
      .number = 2,
      .name = "CTUD",
      .parameters = "CU:BOOL CD:BOOL R:BOOL LOAD:BOOL PV:INT|QU:BOOL QD:BOOL CV:INT||CUO:BOOL CDO:BOOL",
      .statements = countUpDown};
};

using CountersGroup = isa::Group<Sfb0, Sfb1, Sfb2>;

}  // namespace rungproof::s7300::library
