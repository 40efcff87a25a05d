// Finds places for faults by the roles of instructions. A contact is "removed" by a contact of the bit that is always
// on: instructions keep their numbers, and the power flow is that of the network without it. In a program of IEC
// 61131-3 a BOOL variable that is read stands for a contact; it is removed by the value that the next AND or OR
// ignores.
#include "analysis/selfcheck/fault.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "ir/dialect.hpp"
#include "ir/iec/cpu.hpp"
#include "ir/iec/expression_role.hpp"
#include "ir/iec/isa.hpp"

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

/// Faults of programs of IEC 61131-3, in the blocks of the project.
class ExpressionFaults {
 public:
  explicit ExpressionFaults(const Program& program) : program_(program) {
    for (const Desc& desc : iecInstructions().all()) {
      Instruction one;
      one.desc = &desc;
      const ExpressionRole role = expressionRole(one);
      if (role == ExpressionRole::Not) not_ = &desc;
      if (role == ExpressionRole::And) and_ = &desc;
      if (role == ExpressionRole::Or) or_ = &desc;
      if (role == ExpressionRole::Constant) constant_ = &desc;
    }
  }

  std::vector<Fault> run() {
    for (pou_ = 0; pou_ < program_.pous.size(); ++pou_) {
      const Pou& pou = program_.pous[pou_];
      if (pou.isBuiltIn) continue;
      for (network_ = 0; network_ < pou.networks.size(); ++network_) {
        code_ = &pou.networks[network_].instructions;
        for (index_ = 0; index_ < code_->size(); ++index_) atInstruction();
        if (network_ + 1 < pou.networks.size()) swapWithNext(pou.networks[network_], pou.networks[network_ + 1]);
      }
    }
    return std::move(faults_);
  }

 private:
  ExpressionRole roleAt(std::size_t i) const {
    return i < code_->size() ? expressionRole((*code_)[i]) : ExpressionRole::Other;
  }
  Fault& fault(FaultKind kind, std::string text, const Desc* desc = nullptr, Operands operands = {}) {
    Fault& made = faults_.emplace_back();
    made.kind = kind;
    made.text = std::move(text);
    made.pou = pou_;
    made.network = network_;
    made.instruction = index_;
    made.desc = desc;
    made.operands = std::move(operands);
    return made;
  }

  void atInstruction() {
    const Instruction& instruction = (*code_)[index_];
    const bool isTruth = isOfTruth(instruction);
    switch (expressionRole(instruction)) {
      case ExpressionRole::LoadBit: contact(instruction); break;
      case ExpressionRole::And:
        if (isTruth) fault(FaultKind::Connective, "OR for AND", or_, instruction.operands);
        break;
      case ExpressionRole::Or:
        if (isTruth) fault(FaultKind::Connective, "AND for OR", and_, instruction.operands);
        break;
      case ExpressionRole::Constant: isTruth ? setForReset(instruction) : number(instruction); break;
      default: break;
    }
  }

  void contact(const Instruction& instruction) {
    const Symbol* symbol = program_.symbolOf(instruction.operands[0]);
    if (symbol == nullptr || symbol->name.find("__") != std::string::npos) return;  // made, and not written
    fault(FaultKind::Polarity, fmt::format("NOT {0} for {0}", symbol->name), not_, {constant(1)}).isInserted = true;
    if (const std::optional<bool> ignored = ignoredValue())
      fault(FaultKind::RemovedContact, symbol->name, constant_, {constant(*ignored ? 1 : 0), constant(1)});
  }
  /// What the operation that takes the value ignores: AND TRUE, OR FALSE; nothing where none takes it.
  std::optional<bool> ignoredValue() const {
    bool isNegated = false;
    std::size_t above = 0;  // values on the value that is followed
    for (std::size_t i = index_ + 1; i < code_->size(); ++i) {
      const Instruction& next = (*code_)[i];
      const StackUse use = stackUse(next);
      if (above >= use.pops && next.desc->control == Control::None) {
        above += use.pushes - use.pops;
        continue;
      }
      const ExpressionRole role = roleAt(i);
      if (role == ExpressionRole::Not) isNegated = !isNegated;
      if (role == ExpressionRole::And || role == ExpressionRole::Or) return (role == ExpressionRole::And) != isNegated;
      if (role != ExpressionRole::Not) return std::nullopt;
    }
    return std::nullopt;
  }
  /// TRUE or FALSE that is assigned as it is.
  void setForReset(const Instruction& instruction) {
    if (roleAt(index_ + 1) != ExpressionRole::StoreBit) return;
    const Symbol* symbol = program_.symbolOf((*code_)[index_ + 1].operands[0]);
    if (symbol == nullptr || symbol->name.find("__") != std::string::npos) return;
    const bool isSet = instruction.operands[0].value != 0;
    fault(FaultKind::SetForReset,
          fmt::format("{0} := {1} for {0} := {2}", symbol->name, isSet ? "FALSE" : "TRUE", isSet ? "TRUE" : "FALSE"),
          constant_, {constant(isSet ? 0 : 1), constant(1)});
  }
  /// Presets, limits, steps and other numbers.
  void number(const Instruction& instruction) {
    const std::int64_t given = instruction.operands[0].value, width = instruction.operands[1].value;
    if (given < 2 || width > 32) return;
    for (const std::int64_t value : {given / 2, given * 2}) {
      if (value >= std::int64_t{1} << (width - 1)) continue;
      fault(FaultKind::Preset, fmt::format("{} for {}", value, given), constant_, {constant(value), constant(width)});
    }
  }
  void swapWithNext(const Network& one, const Network& next) {
    const auto isPlain = [](const Network& network) {
      return !network.instructions.empty() && std::ranges::all_of(network.instructions, [](const Instruction& i) {
        return i.desc->control == Control::None || i.desc->control == Control::Call;
      });
    };
    if (!isPlain(one) || !isPlain(next)) return;
    index_ = 0;
    fault(FaultKind::SwappedNetworks, fmt::format("statements {} and {} in the other order", one.number, next.number));
  }

  const Program& program_;
  const Desc *not_ = nullptr, *and_ = nullptr, *or_ = nullptr, *constant_ = nullptr;
  std::uint32_t pou_ = 0, network_ = 0, index_ = 0;
  const std::vector<Instruction>* code_ = nullptr;
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

/// Clocks stand still where no number of the program tells more; another number may ask for more.
void letClocksRun(Program& program) {
  for (Pou& pou : program.pous) {
    for (Network& network : pou.networks) {
      for (Instruction& instruction : network.instructions) {
        if (expressionRole(instruction) == ExpressionRole::PassTime) instruction.operands[2] = constant(0x7FFFFFFF);
      }
    }
  }
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
    case FaultKind::Connective: return "connective";
  }
  return {};
}

std::vector<Fault> faultsOf(const Program& program) {
  return formOf(program.target) == StatementForm::Expressions ? ExpressionFaults(program).run() : Finder(program).run();
}

Program planted(const Program& program, const Fault& fault) {
  Program changed = program;
  Pou& pou = changed.pous[fault.pou];
  if (fault.kind == FaultKind::SwappedNetworks) {
    std::swap(pou.networks[fault.network].instructions, pou.networks[fault.network + 1].instructions);
  } else if (fault.kind == FaultKind::LatchOrder) {
    exchangeRungs(pou, fault);
  } else if (fault.isInserted) {
    std::vector<Instruction>& instructions = pou.networks[fault.network].instructions;
    Instruction made = instructions[fault.instruction];
    made.desc = fault.desc;
    made.operands = fault.operands;
    instructions.insert(instructions.begin() + fault.instruction + 1, std::move(made));
  } else {
    Instruction& instruction = pou.networks[fault.network].instructions[fault.instruction];
    instruction.desc = fault.desc;
    instruction.operands = fault.operands;
    if (expressionRole(instruction) == ExpressionRole::Constant && !isOfTruth(instruction)) letClocksRun(changed);
  }
  return changed;
}

}  // namespace rungproof
