// The clock of the CPU. One struct for each block.
#pragma once

#include "ir/machine/instruction_group.hpp"
#include "ir/s7300/date_functions.hpp"
#include "ir/s7300/library.hpp"

namespace rungproof::s7300::library {

struct Sfc0 {
  static constexpr LibraryBlock block = {
      .type = BlockType::Sfc, .number = 0, .name = "SET_CLK", .parameters = "PDT:DT|RET_VAL:INT", .isBuiltIn = true};
  template <class D>
  static void run(SystemArgs<D>& a) {
    DateFunctions<D>(a).setClock();
  }
};

struct Sfc1 {
  static constexpr LibraryBlock block = {.type = BlockType::Sfc,
                                         .number = 1,
                                         .name = "READ_CLK",
                                         .parameters = "|RET_VAL:INT CDT:DT",
                                         .isBuiltIn = true,
                                         .readsClock = true};
  template <class D>
  static void run(SystemArgs<D>& a) {
    DateFunctions<D>(a).readClock();
  }
};

struct Sfc64 {
  static constexpr LibraryBlock block = {.type = BlockType::Sfc,
                                         .number = 64,
                                         .name = "TIME_TCK",
                                         .parameters = "|RET_VAL:TIME",
                                         .isBuiltIn = true,
                                         .readsClock = true};
  template <class D>
  static void run(SystemArgs<D>& a) {
    DateFunctions<D>(a).systemTime();
  }
};

using ClockGroup = isa::Group<Sfc0, Sfc1, Sfc64>;

}  // namespace rungproof::s7300::library
