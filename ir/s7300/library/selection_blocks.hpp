// Selection among values of one type. One struct for each block.
#pragma once

#include "ir/machine/instruction_group.hpp"
#include "ir/s7300/library.hpp"
#include "ir/s7300/selection.hpp"

namespace rungproof::s7300::library {

struct Fc22 {
  static constexpr LibraryBlock block = {.type = BlockType::Fc,
                                         .number = 22,
                                         .name = "LIMIT",
                                         .parameters = "MN:ANY IN:ANY MX:ANY|RET_VAL:ANY",
                                         .isBuiltIn = true};
  template <class D>
  static void run(SystemArgs<D>& a) {
    Selection<D>(a).limit();
  }
};

struct Fc25 {
  static constexpr LibraryBlock block = {.type = BlockType::Fc,
                                         .number = 25,
                                         .name = "MAX",
                                         .parameters = "IN1:ANY IN2:ANY IN3:ANY|RET_VAL:ANY",
                                         .isBuiltIn = true};
  template <class D>
  static void run(SystemArgs<D>& a) {
    Selection<D>(a).extreme(false);
  }
};

struct Fc27 {
  static constexpr LibraryBlock block = {.type = BlockType::Fc,
                                         .number = 27,
                                         .name = "MIN",
                                         .parameters = "IN1:ANY IN2:ANY IN3:ANY|RET_VAL:ANY",
                                         .isBuiltIn = true};
  template <class D>
  static void run(SystemArgs<D>& a) {
    Selection<D>(a).extreme(true);
  }
};

struct Fc36 {
  static constexpr LibraryBlock block = {.type = BlockType::Fc,
                                         .number = 36,
                                         .name = "SEL",
                                         .parameters = "G:BOOL IN0:ANY IN1:ANY|RET_VAL:ANY",
                                         .isBuiltIn = true};
  template <class D>
  static void run(SystemArgs<D>& a) {
    Selection<D>(a).select();
  }
};

using SelectionGroup = isa::Group<Fc22, Fc25, Fc27, Fc36>;

}  // namespace rungproof::s7300::library
