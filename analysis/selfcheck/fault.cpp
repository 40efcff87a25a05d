// Finds places for faults by the roles of instructions. A contact is "removed" by a contact of the bit that is always
// on: instructions keep their numbers, and the power flow is that of the network without it.
#include "analysis/selfcheck/fault.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "ir/dialect.hpp"

namespace rungproof {

namespace {

constexpr std::int64_t largestPreset = 32767;  // 001:6569

std::string textOf(const Desc& desc, const Operands& operands) {
  std::string text(desc.stl);
  for (std::size_t i = 0; i < operands.size(); ++i) text += (i == 0 ? " " : ", ") + toString(operands[i]);
  return text;
}

class Finder {
 public:
  explicit Finder(const Program& program)
      : program_(program), dialect_(dialectOf(program.target)), instructions_(dialect_.instructions()) {}

  std::vector<Fault> run() {
    for (pou_ = 0; pou_ < program_.pous.size(); ++pou_) {
      const std::vector<Network>& networks = program_.pous[pou_].networks;
      for (network_ = 0; network_ < networks.size(); ++network_) {
        for (index_ = 0; index_ < here().instructions.size(); ++index_) atInstruction();
        if (network_ + 1 < networks.size()) swapWithNext();
      }
      latchOrders();
    }
    return std::move(faults_);
  }

 private:
  const Network& here() const { return program_.pous[pou_].networks[network_]; }
  const Instruction& instruction() const { return here().instructions[index_]; }

  Fault fault(FaultKind kind, std::string text) const {
    Fault result;
    result.kind = kind;
    result.text = std::move(text);
    result.pou = pou_;
    result.network = network_;
    result.instruction = index_;
    return result;
  }
  void replace(FaultKind kind, const Desc& desc, Operands operands, std::string text = {}) {
    const std::string given = textOf(*instruction().desc, instruction().operands);
    Fault result =
        fault(kind, text.empty() ? fmt::format("{} for {}", textOf(desc, operands), given) : std::move(text));
    result.desc = &desc;
    result.operands = std::move(operands);
    faults_.push_back(std::move(result));
  }

  void atInstruction() {
    const Desc& desc = *instruction().desc;
    const Operands& operands = instruction().operands;
    if (const Desc* negated = instructions_.negatedForm(desc)) replace(FaultKind::Polarity, *negated, operands);
    removeContact();
    if (const Desc* opposite = instructions_.oppositeForm(desc)) {
      const FaultKind kind = isLatch(desc.role)  ? FaultKind::SetForReset
                             : isEdge(desc.role) ? FaultKind::Edge
                                                 : FaultKind::TimerKind;
      replace(kind, *opposite, operands);
    }
    preset();
  }

  void removeContact() {
    const Desc& desc = *instruction().desc;
    const Operands always{dialect_.systemBits.alwaysOn.operand()};
    const std::string text = textOf(desc, instruction().operands);
    if (instruction().operands.size() == 1 && isBit(instruction().operands[0], dialect_.systemBits.alwaysOn)) return;
    if (!isContact(desc.role)) return;
    // The first contact of a parallel circuit is cut out of it, that of a series is bridged.
    const bool isParallel =
        desc.role == Role::Or || (desc.role == Role::Load && index_ + 1 < here().instructions.size() &&
                                  roleOf(here().instructions[index_ + 1]) == Role::Or);
    replace(FaultKind::RemovedContact, instructions_.bitContact(desc.role, isParallel), always, text);
  }
  void preset() {
    const Desc& desc = *instruction().desc;
    if (desc.operandCount < 2 || instruction().operands.size() < 2) return;
    if (desc.operands[0].type != Type::Timer && desc.operands[0].type != Type::Counter) return;
    const Operand& given = instruction().operands[1];
    if (given.kind != OperandKind::Constant) return;
    for (const std::int64_t value : {given.value / 2, given.value * 2}) {
      if (value < 1 || value > largestPreset || value == given.value) continue;
      Operands operands = instruction().operands;
      operands[1] = constant(value);
      replace(FaultKind::Preset, desc, std::move(operands));
    }
  }

  static bool hasControl(const Network& network) {
    return std::any_of(network.instructions.begin(), network.instructions.end(),
                       [](const Instruction& i) { return i.desc->control != Control::None; });
  }
  void swapWithNext() {
    const Network& next = program_.pous[pou_].networks[network_ + 1];
    if (here().instructions.empty() || next.instructions.empty() || hasControl(here()) || hasControl(next)) return;
    index_ = 0;
    faults_.push_back(fault(FaultKind::SwappedNetworks,
                            fmt::format("networks {} and {} in the other order", here().number, next.number)));
  }

  /// Whether its rungs can be told from each other: where no load begins them, the network is one.
  static bool hasRungs(const Network& network) {
    return std::ranges::any_of(network.instructions, [](const Instruction& i) { return roleOf(i) == Role::Load; });
  }
  /// An S and an R of one bit, each behind a rung of its own.
  void latchOrders() {
    struct Latch {
      std::uint32_t network, instruction;
    };
    std::vector<Latch> found;
    const std::vector<Network>& networks = program_.pous[pou_].networks;
    for (std::uint32_t n = 0; n < networks.size(); ++n) {
      for (std::uint32_t i = 0; i < networks[n].instructions.size(); ++i) {
        const Desc& desc = *networks[n].instructions[i].desc;
        const bool isPlainLatch = (isSet(desc.role) || isReset(desc.role)) && !desc.immediate;
        if (isPlainLatch && !networks[n].instructions[i].operands.empty()) found.push_back({n, i});
      }
    }
    const auto at = [&](const Latch& l) -> const Instruction& {
      return networks[l.network].instructions[l.instruction];
    };
    for (std::size_t a = 0; a < found.size(); ++a) {
      for (std::size_t b = a + 1; b < found.size(); ++b) {
        const Instruction &first = at(found[a]), &second = at(found[b]);
        if (first.desc == second.desc || toString(first.operands[0]) != toString(second.operands[0])) continue;
        if (found[a].network == found[b].network && !hasRungs(networks[found[a].network])) continue;
        network_ = found[a].network;
        index_ = found[a].instruction;
        Fault result = fault(FaultKind::LatchOrder,
                             fmt::format("rungs of {} and {} in the other order", textOf(*first.desc, first.operands),
                                         textOf(*second.desc, second.operands)));
        result.otherNetwork = found[b].network;
        result.otherInstruction = found[b].instruction;
        faults_.push_back(std::move(result));
      }
    }
  }

  const Program& program_;
  const Dialect& dialect_;
  const InstructionTable& instructions_;
  std::uint32_t pou_ = 0, network_ = 0, index_ = 0;
  std::vector<Fault> faults_;
};

/// The instructions of the rung around one of them: from the load that begins it to the last output before the next
/// one.
std::pair<std::size_t, std::size_t> rungAround(const std::vector<Instruction>& instructions, std::size_t at) {
  const auto isOutput = [&](std::size_t i) {
    return isPlainCoil(*instructions[i].desc) || instructions[i].desc->execution == Execution::Conditional;
  };
  std::size_t begin = at, end = at + 1;
  while (begin > 0 && !(roleOf(instructions[begin]) == Role::Load && isOutput(begin - 1))) --begin;
  while (end < instructions.size() && roleOf(instructions[end]) != Role::Load) ++end;
  return {begin, end};
}

void exchangeRungs(Pou& pou, const Fault& fault) {
  std::vector<Instruction>&first = pou.networks[fault.network].instructions,
  &second = pou.networks[fault.otherNetwork].instructions;
  const auto [aBegin, aEnd] = rungAround(first, fault.instruction);
  const auto [bBegin, bEnd] = rungAround(second, fault.otherInstruction);
  if (fault.network == fault.otherNetwork && aEnd > bBegin) {
    // One rung drives both: the outputs change places.
    std::swap(first[fault.instruction], second[fault.otherInstruction]);
    return;
  }
  const auto at = [](std::vector<Instruction>& list, std::size_t i) {
    return list.begin() + static_cast<std::ptrdiff_t>(i);
  };
  const std::vector<Instruction> a(at(first, aBegin), at(first, aEnd)), b(at(second, bBegin), at(second, bEnd));
  second.erase(at(second, bBegin), at(second, bEnd));
  second.insert(at(second, bBegin), a.begin(), a.end());
  first.erase(at(first, aBegin), at(first, aEnd));
  first.insert(at(first, aBegin), b.begin(), b.end());
}

}  // namespace

std::string_view faultKindName(FaultKind kind) {
  switch (kind) {
    case FaultKind::Polarity: return "contact polarity";
    case FaultKind::RemovedContact: return "removed contact";
    case FaultKind::SetForReset: return "set for reset";
    case FaultKind::LatchOrder: return "order of set and reset";
    case FaultKind::Edge: return "edge";
    case FaultKind::TimerKind: return "timer kind";
    case FaultKind::Preset: return "preset";
    case FaultKind::SwappedNetworks: return "swapped networks";
  }
  return {};
}

std::vector<Fault> faultsOf(const Program& program) { return Finder(program).run(); }

Program planted(const Program& program, const Fault& fault) {
  Program changed = program;
  Pou& pou = changed.pous[fault.pou];
  if (fault.kind == FaultKind::SwappedNetworks) {
    std::swap(pou.networks[fault.network].instructions, pou.networks[fault.network + 1].instructions);
  } else if (fault.kind == FaultKind::LatchOrder) {
    exchangeRungs(pou, fault);
  } else {
    Instruction& instruction = pou.networks[fault.network].instructions[fault.instruction];
    instruction.desc = fault.desc;
    instruction.operands = fault.operands;
  }
  return changed;
}

}  // namespace rungproof
