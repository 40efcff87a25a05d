// Which block each instruction of a program belongs to. Blocks stand one behind the other in the numbers of their
// instructions, so that a mark for every 64th instruction tells nearly all. Tested by tests/rules/facts_test.cpp.
#pragma once

#include <cstdint>
#include <vector>

#include "ir/machine/plan.hpp"

namespace rungproof {

class BlockRow {
 public:
  explicit BlockRow(const Plan& plan) {
    std::uint32_t next = 0;
    for (std::uint32_t block = 0; block < plan.flows.size(); ++block) {
      firsts_.push_back(next);
      next += static_cast<std::uint32_t>(plan.flows[block].steps.size());
      while (marks_.size() * markEvery < next) marks_.push_back(block);
    }
    firsts_.push_back(next);
  }

  /// Index in Program::pous of the block of the instruction with that id.
  std::uint32_t operator[](std::uint32_t id) const {
    std::uint32_t block = marks_[id / markEvery];
    while (firsts_[block + 1] <= id) ++block;
    return block;
  }
  /// Id of the first instruction of a block.
  std::uint32_t first(std::uint32_t block) const { return firsts_[block]; }
  std::uint32_t instructionCount() const { return firsts_.back(); }

 private:
  static constexpr std::uint32_t markEvery = 64;
  std::vector<std::uint32_t> marks_;   ///< block of each markEvery-th instruction
  std::vector<std::uint32_t> firsts_;  ///< by block; one more at the end
};

}  // namespace rungproof
