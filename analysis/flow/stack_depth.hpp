// The logic stack followed through a block without running it: which load each level comes from, what pops find, and
// what is known about the power flow at each instruction. One pass in program order over each block; labels take
// what is common to their jumps. The stack is not cleared between networks (a network is only a divider, 001:2232),
// so levels of earlier networks stay below and are marked as such.
//
// Nine levels, on the S7-200 SMART 32: 001:2759, 001:2870. A called block starts with 1, 0, 0, ... (001:6765); LSCR
// replaces the top (001:5809); after FOR and NEXT the top is 1 (001:5770). Tested by tests/rules/stack_depth_test.cpp.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "ir/machine/plan.hpp"
#include "ir/program.hpp"

namespace rungproof {

/// What is known about a bit or about the power flow. Several may hold.
using Condition = std::uint8_t;
namespace condition {
inline constexpr Condition Always = 1;         ///< 1 in every scan (SM0.0)
inline constexpr Condition Never = 2;          ///< 0 in every scan
inline constexpr Condition FirstScan = 4;      ///< 1 at most in the first scan after the change to RUN (SM0.1)
inline constexpr Condition Pulse = 8;          ///< 1 for one scan at a time (EU, ED, SM0.1)
inline constexpr Condition ByArithmetic = 16;  ///< takes part: a status bit SM1.0-SM1.7
inline constexpr Condition NotFirstScan = 32;  ///< 0 at most in the first scan: the inverse of FirstScan
inline constexpr Condition Pause = 64;         ///< 0 for one scan at a time: the inverse of Pulse
}  // namespace condition

enum class StackFaultKind : std::uint8_t {
  TooDeep,    ///< a level was pushed out of the bottom and is used later; other: the use
  FromBelow,  ///< a level that the network did not load; other: the load it comes from, if any
  LrdWithoutLps,
  LppWithoutLps,
  LpsNotPopped,   ///< LPS still open at the end of its network
  Covered,        ///< LRD or LPP meets a level pushed after the LPS; other: the load of that level
  LoadUnused,     ///< nothing ever uses the loaded value
  TooFewInputs,   ///< a box needs `needed` levels and finds `found`
  TooManyInputs,  ///< an unused level lies below the inputs of a box; other: its load
  LdsBeyond,      ///< LDS copies level `needed`, only `found` are filled
  AenoWithoutBox
};

struct StackFault {
  StackFaultKind kind;
  const Instruction* instruction;
  const Instruction* other = nullptr;
  int found = 0;
  int needed = 0;
};

/// What the run learned about one instruction.
struct StackPoint {
  Condition flow = 0;       ///< of the top of the stack in front of the instruction
  std::uint8_t levels = 0;  ///< levels that its network has loaded, 0-255
  /// Instruction::id of the load or operation that made the top.
  std::uint32_t source = noSource;

  static constexpr std::uint32_t noSource = std::numeric_limits<std::uint32_t>::max();  ///< the system's, or unknown
};

/// Bits known to be conditions, keyed by bitKey().
using KnownBits = std::unordered_map<std::uint32_t, Condition>;
constexpr std::uint32_t bitKey(Area area, std::uint32_t offset, unsigned bit) {
  return static_cast<std::uint32_t>(area) << 24 | offset << 3 | bit;
}

/// The run over all blocks.
class StackRun {
 public:
  StackRun(const Program& program, const Plan& plan, const KnownBits& known);

  std::span<const StackFault> faults() const { return faults_; }
  const StackPoint& at(std::uint32_t instruction) const { return points_[instruction]; }
  /// Conditions of the inputs of a box with several, top first; empty for other instructions.
  std::span<const Condition> inputs(std::uint32_t instruction) const {
    const auto found = inputs_.find(instruction);
    return found == inputs_.end() ? std::span<const Condition>() : std::span<const Condition>(found->second);
  }

 private:
  std::vector<StackFault> faults_;
  std::vector<StackPoint> points_;
  std::unordered_map<std::uint32_t, std::vector<Condition>> inputs_;
};

/// Condition of a contact on that bit: SM0.0, SM0.1 and bits in `known`.
Condition conditionOf(const Operand& bit, bool negated, const KnownBits& known);
Condition conjunction(Condition a, Condition b);
Condition disjunction(Condition a, Condition b);
Condition negation(Condition a);

}  // namespace rungproof
