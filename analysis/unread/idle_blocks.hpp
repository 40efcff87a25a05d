// Idle data blocks of an S7-300/400: those that no statement can open and no question names. Whatever they hold, a
// proof is the same without them, and need not carry recipes of megabytes from state to state.
// Tested by tests/prover/idle_block_test.cpp.
#pragma once

#include <set>

#include "analysis/property.hpp"
#include "ir/program.hpp"

namespace rungproof {

/// The data blocks that programs and questions may speak of.
class NamedBlocks {
 public:
  void addText(const Program& program);
  void addQuestions(const PropertySet& set);
  /// An address that something else asks for.
  void add(const Operand& operand);

  /// False for all others; none are others where a number that a program computes may open one.
  bool mayOpen(std::uint32_t block) const { return isAny_ || numbers_.contains(block); }

 private:
  void add(const Instruction& instruction);

  std::set<std::uint32_t> numbers_;
  bool isAny_ = false;
};

/// Takes the data blocks out of the program that are not named.
void leaveOutBlocks(Program& program, const NamedBlocks& named);
/// Takes out those that the program cannot open and the questions do not name.
void leaveOutIdleBlocks(Program& program, const PropertySet& set);

}  // namespace rungproof
