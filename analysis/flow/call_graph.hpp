// Who calls whom: calls of subroutines, attachments of interrupt routines, recursion and nesting depth
// (001:6744-6746, 001:5444). Blocks are indices in Program::pous. Tested by tests/rules/facts_test.cpp.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "ir/machine/plan.hpp"
#include "ir/program.hpp"

namespace rungproof {

inline constexpr std::uint32_t noBlock = std::numeric_limits<std::uint32_t>::max();

struct CallSite {
  const Instruction* instruction;
  std::uint32_t caller;
  std::uint32_t callee;  ///< noBlock: the program text has no such subroutine
};

struct Attachment {
  const Instruction* instruction;
  std::uint32_t block;    ///< that contains the ATCH
  std::uint32_t routine;  ///< interrupt routine, or noBlock
  int number;             ///< of the routine as written
  int event;              ///< -1: not a constant
};

class CallGraph {
 public:
  CallGraph(const Program& program, const Plan& plan);

  std::span<const CallSite> sites() const { return sites_; }
  std::span<const Attachment> attachments() const { return attachments_; }
  /// Indices in sites() of the calls that stand in the block, and of the calls that name it.
  std::span<const std::uint32_t> callsIn(std::uint32_t block) const { return callsIn_[block]; }
  std::span<const std::uint32_t> callsOf(std::uint32_t block) const { return callsOf_[block]; }

  /// The block that a call in that block names; noBlock: none, or the text has no such block.
  std::uint32_t calleeOf(std::uint32_t block, const Instruction& call) const;

  /// A call by which the block reaches itself, or nothing.
  std::optional<std::uint32_t> recursionThrough(std::uint32_t block) const;
  /// Longest chain of calls that starts in the block, in levels; recursion is not counted twice.
  int depthBelow(std::uint32_t block) const { return depth_[block]; }
  /// The call with which that longest chain begins.
  std::optional<std::uint32_t> deepestCall(std::uint32_t block) const;
  bool reachedFromMain(std::uint32_t block) const { return fromMain_[block] != 0; }
  /// Reached from an interrupt routine that is attached somewhere.
  bool reachedFromInterrupt(std::uint32_t block) const { return fromInterrupt_[block] != 0; }
  /// S7-300/400: whether it runs in the start-up alone, in or below OB100 to OB102 and below no other OB.
  bool isStartUpOnly(std::uint32_t block) const { return fromStartUp_[block] != 0 && fromOtherBlocks_[block] == 0; }
  /// Whether anything runs it that the text shows: the main program, an interrupt, an organization block.
  bool mayRun(std::uint32_t block) const {
    return fromMain_[block] + fromInterrupt_[block] + fromStartUp_[block] + fromOtherBlocks_[block] > 0;
  }
  bool isAttached(std::uint32_t block) const { return attached_[block] != 0; }

 private:
  void measure(std::uint32_t block);
  void mark(std::uint32_t root, std::vector<std::uint8_t>& marks) const;

  std::vector<CallSite> sites_;
  std::vector<Attachment> attachments_;
  std::vector<std::vector<std::uint32_t>> callsIn_, callsOf_;
  std::vector<int> depth_;
  std::vector<std::uint32_t> deepest_;
  std::vector<std::uint32_t> recursion_;  ///< by block: a call on a cycle through it, or noBlock
  std::vector<std::uint8_t> fromMain_, fromInterrupt_, attached_, fromStartUp_, fromOtherBlocks_;
};

}  // namespace rungproof
