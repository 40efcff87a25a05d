// Records instructions as they run. Values are read from the state without disturbing it: a look at an analog input
// through the machine would use up a value of a replayed run.
#include "engine/instruction_recorder.hpp"

#include <algorithm>

#include "ir/block_map.hpp"
#include "ir/s7300/block.hpp"

namespace rungproof {

namespace {

/// Whether the store holds all bytes of the width there.
bool isStored(const Concrete::Store& store, Area area, std::uint32_t offset, Width width) {
  const auto length = static_cast<std::uint32_t>(bytes(width));
  if (area == Area::DB) return byteInBlock(offset) + length <= store.blocks().length(blockOfByte(offset));
  return offset + length <= store.area(area).size();
}

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
  if (!isStored(store, area, offset, width)) return std::nullopt;
  return store.load(area, offset * 8 + (width == Width::Bit ? bit : 0), bits(width));
}

/// What a place of an S7-300/400 depends on: the block that runs, or one that called it.
struct Step7View {
  const Activation<Concrete>* running;
  std::uint64_t db, di, ar2;
};

/// The value of an operand that registers of an S7-300/400 lead to, or that lies in the local memory of its blocks;
/// nothing where a pointer stands in memory or names its area itself, and for what no access reaches. `more`: bits
/// within an actual parameter.
std::optional<std::uint64_t> step7Value(const Machine<Concrete>& machine, const Operand& o, Width width,
                                        const Step7View& view, std::uint32_t more) {
  const std::uint32_t own = view.running != nullptr && o.area == Area::L ? view.running->localBase : 0;
  std::uint64_t address = std::uint64_t{o.offset} * 8 + more;
  if (width == Width::Bit) address += o.bit;
  const auto at = [&](std::uint64_t bitAddress, std::uint64_t block) -> std::optional<std::uint64_t> {
    const bool isSplit = width != Width::Bit && bitAddress % 8 != 0;
    if (isSplit || (o.area == Area::DB && (block > lastDataBlock || bitAddress / 8 > 0xFFFF))) return std::nullopt;
    const auto byte = static_cast<std::uint32_t>(bitAddress / 8);
    const std::uint32_t offset = o.area == Area::DB ? dataByte(static_cast<std::uint32_t>(block), byte) : byte;
    return cellAt(machine.store, o.area, offset, static_cast<unsigned>(bitAddress % 8), width, 0);
  };
  if (o.kind == OperandKind::Direct) {
    if (hasBitAndWord(o.area)) return cellAt(machine.store, o.area, o.offset, 0, width, 0);
    if (o.area == Area::DB) return at(byteInBlock(o.offset) * 8ULL + address - o.offset * 8ULL, blockOfByte(o.offset));
    return at(address + own * 8ULL, 0);
  }
  if (o.kind != OperandKind::Indirect || o.reach == nullptr) return std::nullopt;
  const Reach& reach = *o.reach;
  const auto start = [](std::uint64_t pointer) { return pointer & 0x7FFFF; };
  switch (reach.way) {
    case Way::OpenBlock: return at(address, reach.inDi ? view.di : view.db);
    case Way::Instance: return at(address + start(view.ar2), view.di);
    case Way::Register:
      return at(address + own * 8ULL + start(reach.byAr2 ? view.ar2 : machine.step7.ar[0]),
                reach.inDi ? view.di : view.db);
    case Way::Parameter: {
      if (view.running == nullptr || view.running->call == nullptr) return std::nullopt;
      const Operands& given = view.running->call->operands;
      const std::size_t index = (hasInstance(*view.running->pou) ? 2U : 1U) + reach.parameter;
      if (index >= given.size()) return std::nullopt;
      const Step7View caller{view.running->caller, view.running->callerDb, view.running->callerDi,
                             view.running->callerAr2};
      return step7Value(machine, given[index], width, caller, static_cast<std::uint32_t>(address));
    }
    default: return std::nullopt;
  }
}

}  // namespace

Width operandWidth(const Instruction& instruction, std::size_t index) {
  const Desc& desc = *instruction.desc;
  if (index >= desc.operandCount) return instruction.operands[index].width;
  const Type type = desc.operands[index].type;
  const bool isAsWritten = type == Type::Parameter || type == Type::Value;
  return isAsWritten ? instruction.operands[index].width : widthOf(type);
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

std::optional<std::uint64_t> operandValueInFront(const Machine<Concrete>& machine, const Instruction& instruction,
                                                 std::size_t index) {
  const Operand& operand = instruction.operands[index];
  if (machine.plan.form() != StatementForm::Accumulators || !operand.isMemory())
    return operandValue(machine, instruction, index, machine.frame);
  const Step7Registers<Concrete>& now = machine.step7;
  return step7Value(machine, operand, operandWidth(instruction, index), {now.running, now.db, now.di, now.ar[1]}, 0);
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
