// Whether variables of a subrange, an enumeration or a time of day ever hold another value than those of their type:
// what the program writes into them is a constant, or a copy of another such variable. Tested by
// tests/iec/type_limits_test.cpp.
#include "frontend/iec/iec_value_limits.hpp"

#include <algorithm>

namespace rungproof::iec {

namespace {

/// The number that a pattern is for a variable.
std::int64_t numberIn(const ValueLimits& limits, std::uint64_t pattern) {
  const int unused = 64 - limits.width;
  return limits.isSigned ? static_cast<std::int64_t>(pattern << unused) >> unused : static_cast<std::int64_t>(pattern);
}

class LimitCheck {
 public:
  explicit LimitCheck(Program& program) : limits_(program.valueLimits) {}

  void look(const Network& network) {
    for (std::size_t i = 0; i < network.instructions.size(); ++i) {
      const Instruction& one = network.instructions[i];
      for (std::size_t k = 0; k < one.operands.size(); ++k) {
        const Operand& operand = one.operands[k];
        const OperandDesc& desc = one.desc->operands[k];
        if (operand.area != Area::V || operand.kind != OperandKind::Direct || desc.direction == Direction::In) continue;
        const bool isRow = desc.count.operand >= 0;
        const auto bytes = isRow ? static_cast<std::uint32_t>(one.operands[k + 1].value)
                                 : static_cast<std::uint32_t>(std::max(rungproof::bytes(operand.width), 1));
        const bool isPlain = !isRow && one.desc->stl == "STORE" && i > 0;
        if (!isPlain || !takes(operand, network.instructions[i - 1])) lose(operand.offset, bytes);
      }
    }
  }

 private:
  /// Whether a variable has limits and keeps them with what the instruction in front pushes.
  bool takes(const Operand& into, const Instruction& pushed) {
    const auto found = limits_.find(into.offset);
    if (found == limits_.end() || found->second.width != bits(into.width)) return false;
    ValueLimits& limits = found->second;
    const std::string_view name = pushed.desc->stl;
    if (name == "CONST") return limits.hold(numberIn(limits, static_cast<std::uint64_t>(pushed.operands[0].value)));
    if (name != "LOAD") return false;
    const auto source = limits_.find(pushed.operands[0].offset);
    if (source == limits_.end() || pushed.operands[0].width != into.width || source->second.runs != limits.runs)
      return false;
    limits.sources.push_back(source->first);
    return true;
  }

  void lose(std::uint32_t first, std::uint32_t bytes) {
    constexpr std::uint32_t longest = 8;
    for (auto at = limits_.lower_bound(first < longest ? 0 : first - longest);
         at != limits_.end() && at->first < first + bytes; ++at) {
      if (at->first + static_cast<std::uint32_t>(at->second.width / 8) > first) at->second.isKept = false;
    }
  }

  std::map<std::uint32_t, ValueLimits>& limits_;
};

}  // namespace

void findKeptLimits(Program& program, std::span<const std::uint8_t> initial) {
  for (auto& [offset, limits] : program.valueLimits) {
    std::uint64_t pattern = 0;
    for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(limits.width / 8); ++i)
      pattern = pattern << 8 | initial[offset + i];
    limits.isKept = limits.hold(numberIn(limits, pattern));
  }
  LimitCheck check(program);
  bool isWhole = true;
  for (const Pou& pou : program.pous) {
    for (const Network& network : pou.networks) {
      isWhole = isWhole && network.complete;
      check.look(network);
    }
  }
  if (isWhole) return;
  for (auto& [offset, limits] : program.valueLimits) limits.isKept = false;  // what is not read may write anything
}

}  // namespace rungproof::iec
