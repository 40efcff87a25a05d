// Records instructions as they run. Values are read from the state without disturbing it: a look at an analog input
// through the machine would use up a value of a replayed run.
#include "engine/instruction_recorder.hpp"

#include <algorithm>

namespace rungproof {

namespace {

/// A cell in the state; T and C by width.
std::optional<std::uint64_t> cellAt(const Concrete::Store& store, Area area, std::uint32_t offset, unsigned bit,
                                    Width width, unsigned frame) {
  switch (area) {
    case Area::T:
    case Area::C: {
      const Reg value = area == Area::T ? Reg::TimerCurrent : Reg::CounterCurrent,
                flag = area == Area::T ? Reg::TimerBit : Reg::CounterBit;
      if (offset >= store.count(flag)) return std::nullopt;
      return store.get(width == Width::Bit ? flag : value, offset);
    }
    case Area::HC:
      return offset < store.count(Reg::HscCurrent) ? std::optional<std::uint64_t>(store.get(Reg::HscCurrent, offset))
                                                   : std::nullopt;
    case Area::AC:
      if (offset >= store.count(Reg::Accumulator)) return std::nullopt;
      return store.get(Reg::Accumulator, offset) & Concrete::mask(bits(width));
    case Area::L: offset += frame * frameBytes; break;
    case Area::PI: area = Area::AI; break;  // what was read last
    default: break;
  }
  if (offset + static_cast<std::uint32_t>(bytes(width)) > store.area(area).size()) return std::nullopt;
  return store.load(area, offset * 8 + (width == Width::Bit ? bit : 0), bits(width));
}

}  // namespace

Width operandWidth(const Instruction& instruction, std::size_t index) {
  const Desc& desc = *instruction.desc;
  const bool isTyped = index < desc.operandCount && desc.operands[index].type != Type::Parameter;
  return isTyped ? widthOf(desc.operands[index].type) : instruction.operands[index].width;
}

std::optional<std::uint64_t> operandValue(const Machine<Concrete>& machine, const Instruction& instruction,
                                          std::size_t index, unsigned frame) {
  const Operand& operand = instruction.operands[index];
  const Width width = operandWidth(instruction, index);
  if (operand.kind == OperandKind::Direct)
    return cellAt(machine.store, operand.area, operand.offset, operand.bit, width, frame);
  if (operand.kind != OperandKind::Indirect) return std::nullopt;
  if (operand.reach != nullptr) return std::nullopt;  // registers of an S7-300 decide
  const std::optional<std::uint64_t> target =
      cellAt(machine.store, operand.area, operand.offset, 0, Width::DWord, frame);
  if (!target) return std::nullopt;
  const auto address = static_cast<std::uint32_t>(*target);
  if (!pointer::isLegal(machine.target, address, width)) return std::nullopt;
  return cellAt(machine.store, *pointer::areaOf(address), pointer::offsetOf(address), 0, width, frame);
}

void InstructionRecorder::beginScan(bool isOn) {
  isOn_ = isOn;
  running_ = {};
  for (InstructionRecord& record : records_) record.executions = 0;
}

void InstructionRecorder::before(const Machine<Concrete>& machine, const Instruction& instruction) {
  if (!isOn_) return;
  for (unsigned frame = static_cast<unsigned>(running_.size()); frame-- > machine.frame;)
    finish(running_[frame], machine);
  InstructionRecord& record = records_[instruction.id];
  ++record.executions;
  record.before = machine.stack;
  record.scrActive = machine.scrActive;
  record.read.assign(instruction.operands.size(), std::nullopt);
  for (std::size_t i = 0; i < record.read.size(); ++i)
    record.read[i] = operandValue(machine, instruction, i, machine.frame);
  record.written = record.read;
  running_[machine.frame] = {&instruction, machine.frame};
}

void InstructionRecorder::external(const ExternalSite& site, std::uint64_t value) {
  if (!isOn_ || site.instruction >= records_.size()) return;
  const bool isImmediate = site.kind == External::ImmediateInput;  // whatever area a faulty program names
  if (!isImmediate && site.kind != External::AnalogInput) return;
  for (Running& running : running_) {
    if (running.instruction == nullptr || running.instruction->id != site.instruction) continue;
    InstructionRecord& record = records_[site.instruction];
    for (std::size_t i = 0; i < record.read.size(); ++i) {
      const Operand& operand = running.instruction->operands[i];
      const std::uint32_t index = isImmediate ? operand.offset * 8 + operand.bit : operand.offset;
      const bool isHere = operand.kind == OperandKind::Direct && (isImmediate || operand.area == Area::AI);
      if (isHere && index == site.index) record.read[i] = value;
    }
  }
}

void InstructionRecorder::programEnded(const Machine<Concrete>& machine) {
  if (!isOn_) return;
  for (Running& running : running_) finish(running, machine);
}

void InstructionRecorder::finish(Running& running, const Machine<Concrete>& machine) {
  if (running.instruction == nullptr) return;
  const Instruction& instruction = *running.instruction;
  InstructionRecord& record = records_[instruction.id];
  record.after = machine.stack;
  record.result = machine.evaluation.empty() ? std::nullopt : std::optional<std::uint64_t>(machine.evaluation.back());
  record.eno = machine.store.get(Reg::Eno, 0) != 0;
  for (std::size_t i = 0; i < record.written.size(); ++i) {
    const Operand& operand = instruction.operands[i];
    const bool isAnalogInput = operand.kind == OperandKind::Direct && operand.area == Area::AI;
    record.written[i] = isAnalogInput ? record.read[i] : operandValue(machine, instruction, i, running.frame);
    if (operand.kind == OperandKind::Direct && operand.area == Area::PI) record.read[i] = record.written[i];
  }
  if (!instruction.operands.empty()) {
    const Operand& first = instruction.operands[0];
    const bool isElement = first.kind == OperandKind::Direct && hasBitAndWord(first.area);
    if (isElement)
      record.elementBit =
          cellAt(machine.store, first.area, first.offset, 0, Width::Bit, running.frame).value_or(0) != 0;
  }
  running.instruction = nullptr;
}

}  // namespace rungproof
