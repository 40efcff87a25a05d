// The index finds what the program's own look-up finds: the first block of a number, of subroutines only.
#include "ir/subroutine_index.hpp"

#include <gtest/gtest.h>

namespace rungproof {
namespace {

TEST(SubroutineIndex, FindsTheFirstOfEachNumber) {
  Program program;
  const auto add = [&](PouKind kind, int number, const char* name) {
    Pou pou;
    pou.kind = kind;
    pou.number = number;
    pou.name = name;
    program.pous.push_back(std::move(pou));
  };
  add(PouKind::Main, 1, "main");
  add(PouKind::Subroutine, 7, "first");
  add(PouKind::Interrupt, 8, "interrupt");
  add(PouKind::Subroutine, 7, "twin");
  add(PouKind::Subroutine, 1, "one");
  const SubroutineIndex blocks(program);
  for (const int number : {0, 1, 7, 8}) EXPECT_EQ(blocks[number], program.subroutine(number)) << number;
  ASSERT_NE(blocks[7], nullptr);
  EXPECT_EQ(blocks[7]->name, "first");
  EXPECT_EQ(blocks[8], nullptr);
}

}  // namespace
}  // namespace rungproof
