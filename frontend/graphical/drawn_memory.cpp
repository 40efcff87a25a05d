// First fit, upwards.
#include "frontend/graphical/drawn_memory.hpp"

#include "frontend/graphical/iec_type.hpp"
#include "ir/desc.hpp"
#include "ir/s7200/cpu.hpp"

namespace rungproof {

DrawnMemory::DrawnMemory(const Program& program) : target_(program.target) {
  usedV_.assign(areaSize(target_, Area::V), false);
  usedSubroutines_.assign(static_cast<std::size_t>(cpuFeatures(target_).subroutines), false);
  const auto note = [&](const Operand& operand) {
    if (operand.kind != OperandKind::Direct) return;
    if (operand.area == Area::T && operand.offset < usedTimers_.size()) usedTimers_[operand.offset] = true;
    reserve(operand);
  };
  for (const Pou& pou : program.pous) {
    const auto number = static_cast<std::size_t>(pou.number);
    if (pou.kind == PouKind::Subroutine && pou.number >= 0 && number < usedSubroutines_.size())
      usedSubroutines_[number] = true;
    for (const Network& network : pou.networks) {
      for (const Instruction& instruction : network.instructions) {
        for (const Operand& operand : instruction.operands) note(operand);
      }
    }
  }
  for (const Symbol& symbol : program.symbols) note(symbol.address);
  for (const DataInit& init : program.data) {
    for (std::size_t i = 0; i < init.bytes.size() && init.offset + i < usedV_.size(); ++i)
      usedV_[init.offset + i] = true;
  }
}

void DrawnMemory::reserve(const Operand& located) {
  if (located.kind != OperandKind::Direct || located.area != Area::V) return;
  const auto length = static_cast<std::uint32_t>(bytes(located.width));
  for (std::uint32_t i = 0; i < length && located.offset + i < usedV_.size(); ++i) usedV_[located.offset + i] = true;
}

std::optional<Operand> DrawnMemory::allocate(IecType type, std::uint32_t stringLength) {
  const Width width = widthOf(type);
  if (type != IecType::String && width == Width::Bit && nextBit_ < 8)
    return direct(Area::V, Width::Bit, bitByte_, nextBit_++);
  const std::uint32_t length = type == IecType::String ? stringLength + 1 : static_cast<std::uint32_t>(bytes(width));
  const std::uint32_t step = length == 1 || type == IecType::String ? 1 : 2;
  for (std::uint32_t at = nextByte_ + nextByte_ % step; at + length <= usedV_.size(); at += step) {
    bool isFree = true;
    for (std::uint32_t i = 0; i < length; ++i) isFree = isFree && !usedV_[at + i];
    if (!isFree) continue;
    for (std::uint32_t i = 0; i < length; ++i) usedV_[at + i] = true;
    while (nextByte_ < usedV_.size() && usedV_[nextByte_]) ++nextByte_;
    if (width == Width::Bit && type != IecType::String) {
      bitByte_ = at;
      nextBit_ = 1;
      return direct(Area::V, Width::Bit, at, 0);
    }
    return direct(Area::V, width, at);
  }
  return std::nullopt;
}

std::optional<int> DrawnMemory::freeTimer(int resolution) {
  for (int number = 0; number < static_cast<int>(usedTimers_.size()); ++number) {
    const auto at = static_cast<std::size_t>(number);
    if (usedTimers_[at] || timerResolution(number) != resolution || timerIsRetentive(number)) continue;
    if (!addressExists(target_, Area::T, Width::Word, static_cast<std::uint32_t>(number), 0)) continue;
    usedTimers_[at] = true;
    return number;
  }
  return std::nullopt;
}

std::optional<DrawnMemory::TimerChoice> DrawnMemory::timerFor(std::int64_t ms) {
  for (const int resolution : {100, 10, 1}) {
    if (ms < 0 || ms % resolution != 0 || ms / resolution > largestPreset) continue;
    if (const auto number = freeTimer(resolution)) return TimerChoice{*number, resolution};
  }
  return std::nullopt;
}

std::optional<int> DrawnMemory::subroutine() {
  for (std::size_t number = 0; number < usedSubroutines_.size(); ++number) {
    if (usedSubroutines_[number]) continue;
    usedSubroutines_[number] = true;
    return static_cast<int>(number);
  }
  return std::nullopt;
}

}  // namespace rungproof
