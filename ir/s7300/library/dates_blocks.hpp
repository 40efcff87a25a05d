// Dates and times. One struct for each block.
#pragma once

#include "ir/machine/instruction_group.hpp"
#include "ir/s7300/date_functions.hpp"
#include "ir/s7300/library.hpp"

namespace rungproof::s7300::library {

struct Fc1 {
  static constexpr LibraryBlock block = {.type = BlockType::Fc,
                                         .number = 1,
                                         .name = "AD_DT_TM",
                                         .parameters = "T:DT D:TIME|RET_VAL:DT",
                                         .isBuiltIn = true};
  template <class D>
  static void run(SystemArgs<D>& a) {
    DateFunctions<D>(a).addTime(false);
  }
};

struct Fc3 {
  static constexpr LibraryBlock block = {.type = BlockType::Fc,
                                         .number = 3,
                                         .name = "D_TOD_DT",
                                         .parameters = "IN1:DATE IN2:TOD|RET_VAL:DT",
                                         .isBuiltIn = true};
  template <class D>
  static void run(SystemArgs<D>& a) {
    DateFunctions<D>(a).fromDateAndTime();
  }
};

struct Fc6 {
  static constexpr LibraryBlock block = {
      .type = BlockType::Fc, .number = 6, .name = "DT_DATE", .parameters = "IN:DT|RET_VAL:DATE", .isBuiltIn = true};
  template <class D>
  static void run(SystemArgs<D>& a) {
    DateFunctions<D>(a).date();
  }
};

struct Fc7 {
  static constexpr LibraryBlock block = {
      .type = BlockType::Fc, .number = 7, .name = "DT_DAY", .parameters = "IN:DT|RET_VAL:INT", .isBuiltIn = true};
  template <class D>
  static void run(SystemArgs<D>& a) {
    DateFunctions<D>(a).weekday();
  }
};

struct Fc8 {
  static constexpr LibraryBlock block = {
      .type = BlockType::Fc, .number = 8, .name = "DT_TOD", .parameters = "IN:DT|RET_VAL:TOD", .isBuiltIn = true};
  template <class D>
  static void run(SystemArgs<D>& a) {
    DateFunctions<D>(a).timeOfDay();
  }
};

struct Fc9 {
  static constexpr LibraryBlock block = {.type = BlockType::Fc,
                                         .number = 9,
                                         .name = "EQ_DT",
                                         .parameters = "DT1:DT DT2:DT|RET_VAL:BOOL",
                                         .isBuiltIn = true};
  template <class D>
  static void run(SystemArgs<D>& a) {
    DateFunctions<D>(a).compare(true, false, false);
  }
};

struct Fc12 {
  static constexpr LibraryBlock block = {.type = BlockType::Fc,
                                         .number = 12,
                                         .name = "GE_DT",
                                         .parameters = "DT1:DT DT2:DT|RET_VAL:BOOL",
                                         .isBuiltIn = true};
  template <class D>
  static void run(SystemArgs<D>& a) {
    DateFunctions<D>(a).compare(true, false, true);
  }
};

struct Fc14 {
  static constexpr LibraryBlock block = {.type = BlockType::Fc,
                                         .number = 14,
                                         .name = "GT_DT",
                                         .parameters = "DT1:DT DT2:DT|RET_VAL:BOOL",
                                         .isBuiltIn = true};
  template <class D>
  static void run(SystemArgs<D>& a) {
    DateFunctions<D>(a).compare(false, false, true);
  }
};

struct Fc18 {
  static constexpr LibraryBlock block = {.type = BlockType::Fc,
                                         .number = 18,
                                         .name = "LE_DT",
                                         .parameters = "DT1:DT DT2:DT|RET_VAL:BOOL",
                                         .isBuiltIn = true};
  template <class D>
  static void run(SystemArgs<D>& a) {
    DateFunctions<D>(a).compare(true, true, false);
  }
};

struct Fc23 {
  static constexpr LibraryBlock block = {.type = BlockType::Fc,
                                         .number = 23,
                                         .name = "LT_DT",
                                         .parameters = "DT1:DT DT2:DT|RET_VAL:BOOL",
                                         .isBuiltIn = true};
  template <class D>
  static void run(SystemArgs<D>& a) {
    DateFunctions<D>(a).compare(false, true, false);
  }
};

struct Fc28 {
  static constexpr LibraryBlock block = {.type = BlockType::Fc,
                                         .number = 28,
                                         .name = "NE_DT",
                                         .parameters = "DT1:DT DT2:DT|RET_VAL:BOOL",
                                         .isBuiltIn = true};
  template <class D>
  static void run(SystemArgs<D>& a) {
    DateFunctions<D>(a).compare(false, true, true);
  }
};

struct Fc33 {
  static constexpr LibraryBlock block = {.type = BlockType::Fc,
                                         .number = 33,
                                         .name = "S5TI_TIM",
                                         .parameters = "IN:S5TIME|RET_VAL:TIME",
                                         .isBuiltIn = true};
  template <class D>
  static void run(SystemArgs<D>& a) {
    DateFunctions<D>(a).timeOfS5Time();
  }
};

struct Fc34 {
  static constexpr LibraryBlock block = {.type = BlockType::Fc,
                                         .number = 34,
                                         .name = "SB_DT_DT",
                                         .parameters = "DT1:DT DT2:DT|RET_VAL:TIME",
                                         .isBuiltIn = true};
  template <class D>
  static void run(SystemArgs<D>& a) {
    DateFunctions<D>(a).difference();
  }
};

struct Fc35 {
  static constexpr LibraryBlock block = {.type = BlockType::Fc,
                                         .number = 35,
                                         .name = "SB_DT_TM",
                                         .parameters = "T:DT D:TIME|RET_VAL:DT",
                                         .isBuiltIn = true};
  template <class D>
  static void run(SystemArgs<D>& a) {
    DateFunctions<D>(a).addTime(true);
  }
};

struct Fc40 {
  static constexpr LibraryBlock block = {.type = BlockType::Fc,
                                         .number = 40,
                                         .name = "TIM_S5TI",
                                         .parameters = "IN:TIME|RET_VAL:S5TIME",
                                         .isBuiltIn = true};
  template <class D>
  static void run(SystemArgs<D>& a) {
    DateFunctions<D>(a).s5TimeOfTime();
  }
};

using DatesGroup = isa::Group<Fc1, Fc3, Fc6, Fc7, Fc8, Fc9, Fc12, Fc14, Fc18, Fc23, Fc28, Fc33, Fc34, Fc35, Fc40>;

}  // namespace rungproof::s7300::library
