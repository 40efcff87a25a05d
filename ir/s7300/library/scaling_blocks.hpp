// Analog values. One struct for each block.
#pragma once

#include "ir/machine/instruction_group.hpp"
#include "ir/s7300/library.hpp"

namespace rungproof::s7300::library {

// ((IN - k1) / (27648 - k1)) * (HI_LIM - LO_LIM) + LO_LIM, each step a REAL, with k1 = -27648 or 0 (002:2625-2647).
// General knowledge: beyond the range OUT is the limit, RET_VAL W#16#8 and ENO 0.
inline constexpr std::string_view scale = R"(
VAR_TEMP
  k1 : REAL;
  span : REAL;
  x : REAL;
END_VAR
BEGIN
NETWORK
      A #BIPOLAR; JC both;
      L 0.0; T #k1; JU go;
both: L -2.7648e+004; T #k1;
go:   L 2.7648e+004; L #k1; -R; T #span;
      L #IN; ITD; DTR; T #x;
      L 2.7648e+004; >R; JC high;
      L #x; L #k1; <R; JC low;
      L #x; L #k1; -R; L #span; /R; T #x;
      L #HI_LIM; L #LO_LIM; -R; L #x; *R; L #LO_LIM; +R; T #OUT;
      L 0; T #RET_VAL;
      SET; SAVE; BEU;
high: L #HI_LIM; T #OUT; JU out;
low:  L #LO_LIM; T #OUT;
out:  L 8; T #RET_VAL;
      CLR; SAVE; BEU;)";

// ((IN - LO_LIM) / (HI_LIM - LO_LIM)) * (27648 - k1) + k1, each step a REAL (002:2649-2651). How it rounds is not
// stated: to the nearest number, or to the other one beside it. General knowledge: beyond the limits as FC 105.
inline constexpr std::string_view unscale = R"(
VAR_TEMP
  k1 : REAL;
  span : REAL;
  x : REAL;
  near : DINT;
  down : DINT;
  other : BOOL;
END_VAR
BEGIN
NETWORK
      A #BIPOLAR; JC both;
      L 0.0; T #k1; JU go;
both: L -2.7648e+004; T #k1;
go:   L #IN; L #HI_LIM; >R; JC high;
      L #IN; L #LO_LIM; <R; JC low;
      L #HI_LIM; L #LO_LIM; -R; T #span;
      L #IN; L #LO_LIM; -R; L #span; /R; T #x;
      L 2.7648e+004; L #k1; -R; L #x; *R; L #k1; +R; T #x;
      RND; T #near;
      AN #other; JC give;
      L #x; RND-; T #down; L #x; RND+; L #down; +D; L #near; -D; T #near;
give: L #near; T #OUT;
      L 0; T #RET_VAL;
      SET; SAVE; BEU;
high: L 27648; T #OUT; JU out;
low:  L #k1; RND; T #OUT;
out:  L 8; T #RET_VAL;
      CLR; SAVE; BEU;)";

struct Fc105 {
  static constexpr LibraryBlock block = {
      .type = BlockType::Fc,
      .number = 105,
      .name = "SCALE",
      .parameters = "IN:INT HI_LIM:REAL LO_LIM:REAL BIPOLAR:BOOL|RET_VAL:WORD OUT:REAL",
      .statements = scale};
};

struct Fc106 {
  static constexpr LibraryBlock block = {
      .type = BlockType::Fc,
      .number = 106,
      .name = "UNSCALE",
      .parameters = "IN:REAL HI_LIM:REAL LO_LIM:REAL BIPOLAR:BOOL|RET_VAL:WORD OUT:INT",
      .statements = unscale};
};

using ScalingGroup = isa::Group<Fc105, Fc106>;

}  // namespace rungproof::s7300::library
