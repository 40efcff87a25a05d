// Bytes of the start information, most significant first.
#include "engine/block_start.hpp"

#include <algorithm>
#include <utility>

#include "ir/s7200/event.hpp"
#include "ir/s7300/block.hpp"
#include "ir/s7300/pointer_code.hpp"

namespace rungproof {

namespace {

constexpr std::uint32_t priorityByte = 2, firstByte = 6, timeByte = 12, startBytes = 20;
constexpr std::uint32_t longestInt = 32767;

/// Byte `byte` of a value of `count` bytes that begins at byte `first`; nothing: it lies elsewhere.
std::optional<std::uint8_t> part(std::uint64_t value, std::uint32_t first, std::uint32_t count, std::uint32_t byte) {
  if (byte < first || byte >= first + count) return std::nullopt;
  return static_cast<std::uint8_t>(value >> 8 * (first + count - 1 - byte));
}

/// Whether the operand of OB1, or a pointer in it, may lead into the bytes of local data that a run determines.
bool mayReach(const Operand& operand, bool isCall) {
  const bool isLocal = operand.area == Area::L;
  if (operand.reach != nullptr) {
    const Way way = operand.reach->way;
    if (isLocal && (way == Way::PointerTo || way == Way::Pointer || way == Way::Register)) return true;
    if (mayReach(operand.reach->pointer, isCall)) return true;
  }
  if (!isLocal || operand.kind != OperandKind::Direct) return false;
  const std::uint32_t size = isCall ? startBytes : static_cast<std::uint32_t>(std::max(bytes(operand.width), 1));
  return operand.offset < startBytes && operand.offset + size > firstByte;
}

/// A pointer constant into local data, own (L) or of the caller (V), such as P#L 6.0.
bool isLocalPointer(const Operand& operand) {
  const auto code = static_cast<std::uint64_t>(operand.value) >> 24 & 0xFF;
  constexpr std::uint64_t crossing = 0x80;
  return operand.kind == OperandKind::Constant && (code == (crossing | static_cast<std::uint64_t>(PointerArea::L)) ||
                                                   code == (crossing | static_cast<std::uint64_t>(PointerArea::V)));
}

}  // namespace

void BlockStart::scanEnded(std::uint32_t lengthMs) {
  previous_ = static_cast<std::uint16_t>(std::min(lengthMs, longestInt));
  shortest_ = std::exchange(hasScan_, true) ? std::min(shortest_, previous_) : previous_;
  longest_ = std::max(longest_, previous_);
}

std::optional<std::uint8_t> BlockStart::byteOf(int block, std::uint32_t byte, const Concrete::Store& store,
                                               const RealTimeClock& clock, std::uint64_t nowMs) const {
  if (byte >= timeByte && byte < startBytes) return clock.dateAndTime(nowMs)[byte - timeByte];
  if (block == 1) {
    const std::uint64_t times = static_cast<std::uint64_t>(previous_) << 32 | std::uint64_t{shortest_} << 16 | longest_;
    return part(times, firstByte, 6, byte);
  }
  const int event = eventOfBlock(block);
  if (event < 0) return std::nullopt;
  if (byte == priorityByte) return static_cast<std::uint8_t>(priorityOf(event));
  if (isDelayEvent(event)) return part(delays_[static_cast<std::uint32_t>(event - firstDelayEvent)], 8, 4, byte);
  if (!isCyclicEvent(event)) return std::nullopt;
  const TimedRegisters registers = timedRegisters(static_cast<std::uint32_t>(timerOfEvent(event)));
  if (const auto phase = part(0, firstByte, 2, byte)) return phase;  // it comes first when its period has passed
  return part(std::min<std::uint64_t>(store.get(registers.period, registers.at), longestInt), 10, 2, byte);
}

bool mayReadStartOfMain(const Plan& plan) {
  if (!plan.dialect().run.startsBlocks) return false;
  return std::ranges::any_of(plan.flows, [&](const Flow& flow) {
    const bool isMain = flow.pou->number == blockNumber(BlockType::Ob, 1);
    return std::ranges::any_of(flow.steps, [&](const FlowStep& step) {
      const bool isCall = step.instruction->desc->control == Control::BlockCall;
      return std::ranges::any_of(step.instruction->operands, [&](const Operand& o) {
        return isLocalPointer(o) || (isMain && mayReach(o, isCall));
      });
    });
  });
}

}  // namespace rungproof
