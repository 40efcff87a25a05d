// Power flow in a drawn network: what a recorded scan means for each element. Contacts are judged by the values that
// their instructions saw; wires follow from the elements, as on the screen of the editor in status mode. In an inactive
// SCR segment nothing flows (001:5830). Tested by tests/show/scan_test.cpp.
#pragma once

#include <string>
#include <vector>

#include "engine/instruction_recorder.hpp"
#include "frontend/picture/element_text.hpp"

namespace rungproof {

/// Flow of every element. Elements whose instruction did not run in the scan are off.
std::vector<ElementFlow> elementFlows(const Program& program, const Drawing& drawing, const Network& network,
                                      const InstructionRecorder& recorder);
/// The same where elements name variables of IEC 61131-3.
std::vector<ElementFlow> variableFlows(const Program& program, const Drawing& drawing, const Network& network,
                                       const InstructionRecorder& recorder);

/// Whether any instruction of the network ran.
bool wasExecuted(const Network& network, const InstructionRecorder& recorder);

/// Values of the operands of an instruction as text: what it read, or what it wrote; empty for constants.
std::vector<std::string> valueTexts(const Instruction& instruction, const InstructionRecord& record);

}  // namespace rungproof
