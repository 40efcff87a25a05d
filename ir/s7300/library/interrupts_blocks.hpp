// Interrupts: at a time, after a delay, locked. One struct for each block.
#pragma once

#include "ir/machine/instruction_group.hpp"
#include "ir/s7300/library.hpp"

namespace rungproof::s7300::library {

struct Sfc28 {
  static constexpr LibraryBlock block = {.type = BlockType::Sfc,
                                         .number = 28,
                                         .name = "SET_TINT",
                                         .parameters = "OB_NR:INT SDT:DT PERIOD:WORD|RET_VAL:INT",
                                         .isContract = true};
};

struct Sfc29 {
  static constexpr LibraryBlock block = {.type = BlockType::Sfc,
                                         .number = 29,
                                         .name = "CAN_TINT",
                                         .parameters = "OB_NR:INT|RET_VAL:INT",
                                         .isContract = true};
};

struct Sfc30 {
  static constexpr LibraryBlock block = {.type = BlockType::Sfc,
                                         .number = 30,
                                         .name = "ACT_TINT",
                                         .parameters = "OB_NR:INT|RET_VAL:INT",
                                         .isContract = true};
};

struct Sfc31 {
  static constexpr LibraryBlock block = {.type = BlockType::Sfc,
                                         .number = 31,
                                         .name = "QRY_TINT",
                                         .parameters = "OB_NR:INT|RET_VAL:INT STATUS:WORD",
                                         .isContract = true};
};

struct Sfc32 {
  static constexpr LibraryBlock block = {.type = BlockType::Sfc,
                                         .number = 32,
                                         .name = "SRT_DINT",
                                         .parameters = "OB_NR:INT DTIME:TIME SIGN:WORD|RET_VAL:INT",
                                         .isContract = true,
                                         .actsOnCpu = true};
};

struct Sfc33 {
  static constexpr LibraryBlock block = {.type = BlockType::Sfc,
                                         .number = 33,
                                         .name = "CAN_DINT",
                                         .parameters = "OB_NR:INT|RET_VAL:INT",
                                         .isContract = true,
                                         .actsOnCpu = true};
};

struct Sfc34 {
  static constexpr LibraryBlock block = {.type = BlockType::Sfc,
                                         .number = 34,
                                         .name = "QRY_DINT",
                                         .parameters = "OB_NR:INT|RET_VAL:INT STATUS:WORD",
                                         .isContract = true};
};

struct Sfc39 {
  static constexpr LibraryBlock block = {.type = BlockType::Sfc,
                                         .number = 39,
                                         .name = "DIS_IRT",
                                         .parameters = "MODE:BYTE OB_NR:INT|RET_VAL:INT",
                                         .isContract = true,
                                         .actsOnCpu = true};
};

struct Sfc40 {
  static constexpr LibraryBlock block = {.type = BlockType::Sfc,
                                         .number = 40,
                                         .name = "EN_IRT",
                                         .parameters = "MODE:BYTE OB_NR:INT|RET_VAL:INT",
                                         .isContract = true,
                                         .actsOnCpu = true};
};

struct Sfc41 {
  static constexpr LibraryBlock block = {.type = BlockType::Sfc,
                                         .number = 41,
                                         .name = "DIS_AIRT",
                                         .parameters = "|RET_VAL:INT",
                                         .isContract = true,
                                         .actsOnCpu = true};
};

struct Sfc42 {
  static constexpr LibraryBlock block = {.type = BlockType::Sfc,
                                         .number = 42,
                                         .name = "EN_AIRT",
                                         .parameters = "|RET_VAL:INT",
                                         .isContract = true,
                                         .actsOnCpu = true};
};

using InterruptsGroup = isa::Group<Sfc28, Sfc29, Sfc30, Sfc31, Sfc32, Sfc33, Sfc34, Sfc39, Sfc40, Sfc41, Sfc42>;

}  // namespace rungproof::s7300::library
