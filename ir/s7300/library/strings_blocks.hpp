// Strings. Which characters numbers have in a STRING is not stated (FC 5, 16, 30, 37 to 39). One struct for each block.
#pragma once

#include "ir/machine/instruction_group.hpp"
#include "ir/s7300/library.hpp"
#include "ir/s7300/string_functions.hpp"

namespace rungproof::s7300::library {

struct Fc2 {
  static constexpr LibraryBlock block = {.type = BlockType::Fc,
                                         .number = 2,
                                         .name = "CONCAT",
                                         .parameters = "IN1:STRING IN2:STRING|RET_VAL:STRING",
                                         .isBuiltIn = true};
  template <class D>
  static void run(SystemArgs<D>& a) {
    StringFunctions<D>(a).concatenate();
  }
};

struct Fc4 {
  static constexpr LibraryBlock block = {.type = BlockType::Fc,
                                         .number = 4,
                                         .name = "DELETE",
                                         .parameters = "IN:STRING L:INT P:INT|RET_VAL:STRING",
                                         .isBuiltIn = true};
  template <class D>
  static void run(SystemArgs<D>& a) {
    StringFunctions<D>(a).cut();
  }
};

struct Fc5 {
  static constexpr LibraryBlock block = {.type = BlockType::Fc,
                                         .number = 5,
                                         .name = "DI_STRNG",
                                         .parameters = "I:DINT|RET_VAL:STRING",
                                         .isBuiltIn = true,
                                         .isContract = true};
};

struct Fc10 {
  static constexpr LibraryBlock block = {.type = BlockType::Fc,
                                         .number = 10,
                                         .name = "EQ_STRNG",
                                         .parameters = "S1:STRING S2:STRING|RET_VAL:BOOL",
                                         .isBuiltIn = true};
  template <class D>
  static void run(SystemArgs<D>& a) {
    StringFunctions<D>(a).compare(true, false, false);
  }
};

struct Fc11 {
  static constexpr LibraryBlock block = {.type = BlockType::Fc,
                                         .number = 11,
                                         .name = "FIND",
                                         .parameters = "IN1:STRING IN2:STRING|RET_VAL:INT",
                                         .isBuiltIn = true};
  template <class D>
  static void run(SystemArgs<D>& a) {
    StringFunctions<D>(a).find();
  }
};

struct Fc13 {
  static constexpr LibraryBlock block = {.type = BlockType::Fc,
                                         .number = 13,
                                         .name = "GE_STRNG",
                                         .parameters = "S1:STRING S2:STRING|RET_VAL:BOOL",
                                         .isBuiltIn = true};
  template <class D>
  static void run(SystemArgs<D>& a) {
    StringFunctions<D>(a).compare(true, false, true);
  }
};

struct Fc15 {
  static constexpr LibraryBlock block = {.type = BlockType::Fc,
                                         .number = 15,
                                         .name = "GT_STRNG",
                                         .parameters = "S1:STRING S2:STRING|RET_VAL:BOOL",
                                         .isBuiltIn = true};
  template <class D>
  static void run(SystemArgs<D>& a) {
    StringFunctions<D>(a).compare(false, false, true);
  }
};

struct Fc16 {
  static constexpr LibraryBlock block = {.type = BlockType::Fc,
                                         .number = 16,
                                         .name = "I_STRNG",
                                         .parameters = "I:INT|RET_VAL:STRING",
                                         .isBuiltIn = true,
                                         .isContract = true};
};

struct Fc17 {
  static constexpr LibraryBlock block = {.type = BlockType::Fc,
                                         .number = 17,
                                         .name = "INSERT",
                                         .parameters = "IN1:STRING IN2:STRING P:INT|RET_VAL:STRING",
                                         .isBuiltIn = true};
  template <class D>
  static void run(SystemArgs<D>& a) {
    StringFunctions<D>(a).insert();
  }
};

struct Fc19 {
  static constexpr LibraryBlock block = {.type = BlockType::Fc,
                                         .number = 19,
                                         .name = "LE_STRNG",
                                         .parameters = "S1:STRING S2:STRING|RET_VAL:BOOL",
                                         .isBuiltIn = true};
  template <class D>
  static void run(SystemArgs<D>& a) {
    StringFunctions<D>(a).compare(true, true, false);
  }
};

struct Fc20 {
  static constexpr LibraryBlock block = {.type = BlockType::Fc,
                                         .number = 20,
                                         .name = "LEFT",
                                         .parameters = "IN:STRING L:INT|RET_VAL:STRING",
                                         .isBuiltIn = true};
  template <class D>
  static void run(SystemArgs<D>& a) {
    StringFunctions<D>(a).left();
  }
};

struct Fc21 {
  static constexpr LibraryBlock block = {
      .type = BlockType::Fc, .number = 21, .name = "LEN", .parameters = "S:STRING|RET_VAL:INT", .isBuiltIn = true};
  template <class D>
  static void run(SystemArgs<D>& a) {
    StringFunctions<D>(a).length();
  }
};

struct Fc24 {
  static constexpr LibraryBlock block = {.type = BlockType::Fc,
                                         .number = 24,
                                         .name = "LT_STRNG",
                                         .parameters = "S1:STRING S2:STRING|RET_VAL:BOOL",
                                         .isBuiltIn = true};
  template <class D>
  static void run(SystemArgs<D>& a) {
    StringFunctions<D>(a).compare(false, true, false);
  }
};

struct Fc26 {
  static constexpr LibraryBlock block = {.type = BlockType::Fc,
                                         .number = 26,
                                         .name = "MID",
                                         .parameters = "IN:STRING L:INT P:INT|RET_VAL:STRING",
                                         .isBuiltIn = true};
  template <class D>
  static void run(SystemArgs<D>& a) {
    StringFunctions<D>(a).middle();
  }
};

struct Fc29 {
  static constexpr LibraryBlock block = {.type = BlockType::Fc,
                                         .number = 29,
                                         .name = "NE_STRNG",
                                         .parameters = "S1:STRING S2:STRING|RET_VAL:BOOL",
                                         .isBuiltIn = true};
  template <class D>
  static void run(SystemArgs<D>& a) {
    StringFunctions<D>(a).compare(false, true, true);
  }
};

struct Fc30 {
  static constexpr LibraryBlock block = {.type = BlockType::Fc,
                                         .number = 30,
                                         .name = "R_STRNG",
                                         .parameters = "IN:REAL|RET_VAL:STRING",
                                         .isBuiltIn = true,
                                         .isContract = true};
};

struct Fc31 {
  static constexpr LibraryBlock block = {.type = BlockType::Fc,
                                         .number = 31,
                                         .name = "REPLACE",
                                         .parameters = "IN1:STRING IN2:STRING L:INT P:INT|RET_VAL:STRING",
                                         .isBuiltIn = true};
  template <class D>
  static void run(SystemArgs<D>& a) {
    StringFunctions<D>(a).replace();
  }
};

struct Fc32 {
  static constexpr LibraryBlock block = {.type = BlockType::Fc,
                                         .number = 32,
                                         .name = "RIGHT",
                                         .parameters = "IN:STRING L:INT|RET_VAL:STRING",
                                         .isBuiltIn = true};
  template <class D>
  static void run(SystemArgs<D>& a) {
    StringFunctions<D>(a).right();
  }
};

struct Fc37 {
  static constexpr LibraryBlock block = {.type = BlockType::Fc,
                                         .number = 37,
                                         .name = "STRNG_DI",
                                         .parameters = "S:STRING|RET_VAL:DINT",
                                         .isBuiltIn = true,
                                         .isContract = true};
};

struct Fc38 {
  static constexpr LibraryBlock block = {.type = BlockType::Fc,
                                         .number = 38,
                                         .name = "STRNG_I",
                                         .parameters = "S:STRING|RET_VAL:INT",
                                         .isBuiltIn = true,
                                         .isContract = true};
};

struct Fc39 {
  static constexpr LibraryBlock block = {.type = BlockType::Fc,
                                         .number = 39,
                                         .name = "STRNG_R",
                                         .parameters = "S:STRING|RET_VAL:REAL",
                                         .isBuiltIn = true,
                                         .isContract = true};
};

using StringsGroup = isa::Group<Fc2, Fc4, Fc5, Fc10, Fc11, Fc13, Fc15, Fc16, Fc17, Fc19, Fc20, Fc21, Fc24, Fc26, Fc29,
                                Fc30, Fc31, Fc32, Fc37, Fc38, Fc39>;

}  // namespace rungproof::s7300::library
