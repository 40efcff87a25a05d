// Keeps what each instruction saw and did when it ran last in a scan: logic stack and operand values in front of it and
// behind it. Displays of power flow read it. Covered by tests/show/scan_test.cpp.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "engine/instruction_observer.hpp"

namespace rungproof {

struct InstructionRecord {
  unsigned executions = 0;  ///< in the scan; with 0 the rest has no meaning
  std::array<bool, mostStackLevels> before{};
  std::array<bool, mostStackLevels> after{};
  bool scrActive = true;                              ///< outside SCR segments and in active ones
  bool eno = false;                                   ///< behind the instruction
  std::vector<std::optional<std::uint64_t>> read;     ///< operand values in front of it, in the width of their type
  std::vector<std::optional<std::uint64_t>> written;  ///< the same behind it
  bool elementBit = false;              ///< bit of the timer or counter that is the first operand, behind it
  std::optional<std::uint64_t> result;  ///< IEC 61131-3: top of the evaluation stack behind it

  /// Power as boxes and coils see it, at a level of the stack.
  bool powerFlow(std::size_t level = 0) const { return before[level] && scrActive; }
};

class InstructionRecorder final : public InstructionObserver {
 public:
  explicit InstructionRecorder(std::size_t instructions) : records_(instructions) {}

  /// Forgets the scan before; a recorder that is off keeps nothing.
  void beginScan(bool isOn);
  const InstructionRecord& of(const Instruction& instruction) const { return records_[instruction.id]; }

  void before(const Machine<Concrete>& machine, const Instruction& instruction) override;
  void external(const ExternalSite& site, std::uint64_t value) override;
  void programEnded(const Machine<Concrete>& machine) override;

 private:
  /// An instruction that runs, by the local memory it works on: CALL waits for the called block to end.
  struct Running {
    const Instruction* instruction = nullptr;
    unsigned frame = 0;
  };
  void finish(Running& running, const Machine<Concrete>& machine);

  std::vector<InstructionRecord> records_;
  std::array<Running, frameCount> running_{};  ///< by frame
  bool isOn_ = true;
};

/// Value of an operand of an instruction in the state of a machine, by the type that the descriptor gives it
/// (parameters of CALL: as written); nothing for constants, texts, and pointers that lead nowhere. `frame`: local
/// memory in use.
std::optional<std::uint64_t> operandValue(const Machine<Concrete>& machine, const Instruction& instruction,
                                          std::size_t index, unsigned frame);

/// The same in front of the instruction that runs next, whose registers also say where an open data block, an instance
/// or an actual parameter of an S7-300/400 lies.
std::optional<std::uint64_t> operandValueInFront(const Machine<Concrete>& machine, const Instruction& instruction,
                                                 std::size_t index);

/// Width in which the instruction takes its operand.
Width operandWidth(const Instruction& instruction, std::size_t index);

}  // namespace rungproof
