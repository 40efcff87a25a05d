// One program as code: runs the scan's program over the recording domain.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "engine/compiled/code.hpp"
#include "engine/concrete.hpp"

namespace rungproof::compiled {

/// Time of an instruction by Instruction::id, 10 ns: without and with power flow.
using InstructionTimes = std::vector<std::array<std::uint32_t, 2>>;

/// The program of a scan after the first one, or of any scan together with what its timers do before and behind it.
enum class Extent : std::uint8_t { Program, WholeScan };

/// `model`: a state of the program with the readings in force.
Code recorded(const Plan& plan, const Concrete::Store& model, const InstructionTimes& times, bool countsTime,
              Extent extent = Extent::Program);

}  // namespace rungproof::compiled
