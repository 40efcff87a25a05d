// Direct operands and where their values are kept.
#include "engine/cell_value.hpp"

#include "ir/check.hpp"

namespace rungproof {

namespace {
constexpr int analogBits = 16;
}  // namespace

std::uint64_t cellValue(const Concrete::Store& store, const Operand& operand) {
  CHECK(operand.kind == OperandKind::Direct, "only direct operands have a value of their own");
  const std::uint32_t offset = operand.offset;
  switch (operand.area) {
    case Area::T:
      if (offset >= store.count(Reg::TimerBit)) return 0;  // the program does not name it
      return store.get(timerRegister(operand.width), offset);
    case Area::C:
      if (offset >= store.count(Reg::CounterBit)) return 0;
      return store.get(operand.width == Width::Bit ? Reg::CounterBit : Reg::CounterCurrent, offset);
    case Area::PI: return store.load(Area::AI, offset * 8, bits(operand.width));
    case Area::AC: return store.get(Reg::Accumulator, offset) & Concrete::mask(bits(operand.width));
    case Area::HC: return store.get(Reg::HscCurrent, offset);
    case Area::AI:
    case Area::AQ: return store.load(operand.area, offset * 8, analogBits);
    default:
      return store.load(operand.area, offset * 8 + (operand.width == Width::Bit ? operand.bit : 0),
                        bits(operand.width));
  }
}

bool takesCounts(const Concrete::Store& store, const Operand& counter) {
  return counter.offset < store.count(Reg::HscEnabled) && store.get(Reg::HscEnabled, counter.offset) != 0;
}

void setCell(Concrete::Store& store, const Operand& operand, std::uint64_t value) {
  CHECK(operand.kind == OperandKind::Direct, "only direct operands have a value of their own");
  const std::uint32_t offset = operand.offset;
  switch (operand.area) {
    case Area::I: {
      const int width = bits(operand.width);
      if (offset * 8 >= store.count(Reg::PhysicalInput)) {  // of a PROFINET device: no terminal
        return store.save(Area::I, offset * 8 + (width == 1 ? operand.bit : 0), width, value, true);
      }
      if (width == 1) return store.set(Reg::PhysicalInput, offset * 8 + operand.bit, value & 1, true);
      auto& inputs = store.terminals(Reg::PhysicalInput);
      for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(width) / 8 && offset + i < inputs.size(); ++i)
        inputs[offset + i] = static_cast<std::uint8_t>(value >> (static_cast<std::uint32_t>(width) - 8 * (i + 1)));
      return;
    }
    case Area::PI: return store.save(Area::AI, offset * 8, bits(operand.width), value, true);
    case Area::T:
      if (offset >= store.count(Reg::TimerBit)) return;
      return store.set(timerRegister(operand.width), offset, value, true);
    case Area::C:
      if (offset >= store.count(Reg::CounterBit)) return;
      return store.set(operand.width == Width::Bit ? Reg::CounterBit : Reg::CounterCurrent, offset, value, true);
    case Area::AC: return store.set(Reg::Accumulator, offset, value, true);
    case Area::HC: return store.set(Reg::HscCurrent, offset, value, true);
    case Area::AI:
    case Area::AQ: return store.save(operand.area, offset * 8, analogBits, value, true);
    default:
      return store.save(operand.area, offset * 8 + (operand.width == Width::Bit ? operand.bit : 0), bits(operand.width),
                        value, true);
  }
}

}  // namespace rungproof
