// The flow of a block: its instructions in one row, and who belongs to whom (JMP to LBL, FOR to NEXT, LSCR to
// SCRE, SCRT to its segment). What does not fit together is listed; rules CTL and SCR turn it into findings.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "ir/desc.hpp"
#include "ir/program.hpp"

namespace rungproof {

inline constexpr std::uint32_t noPartner = std::numeric_limits<std::uint32_t>::max();

enum class FlowProblem : std::uint8_t {
  LabelMissing,
  LabelTwice,
  JumpAcrossScr,
  ForWithoutNext,
  NextWithoutFor,
  ForTooDeep,
  LscrWithoutScre,
  ScreWithoutLscr,
  LscrInsideSegment,
  ScrtOutsideSegment,
  EndInsideSegment
};

struct FlowFault {
  FlowProblem problem;
  const Instruction* instruction;
  const Instruction* other = nullptr;  ///< LabelTwice: the first label; JumpAcrossScr: the label
};

/// One instruction with what the walk over it needs.
struct FlowStep {
  const Instruction* instruction;
  std::uint32_t partner;  ///< index in Flow::steps: JMP: its LBL; FOR: its NEXT and back; LSCR: its SCRE and back;
                          ///< SCRT, CSCRE: their LSCR, SCRE
  std::uint32_t network;  ///< index in Pou::networks

  std::uint32_t id() const { return instruction->id; }
};

struct Flow {
  const Pou* pou = nullptr;
  std::vector<FlowStep> steps;
  std::vector<FlowFault> faults;
  std::vector<bool>
      writtenParameters{};  ///< S7-300/400: FCs, by number in Pou::locals (ir/s7300/written_parameters.hpp)
};

/// `isLeftOut`, by Instruction::id (may be empty): instructions that do not run.
Flow flowOf(const Pou& pou, const std::vector<bool>& isLeftOut = {});

}  // namespace rungproof
