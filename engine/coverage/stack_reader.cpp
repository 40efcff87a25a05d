// The logic stack of an S7-200, level by level as trees (001:2753-2857).
#include <algorithm>
#include <array>

#include "engine/coverage/logic_reader.hpp"
#include "engine/coverage/step_words.hpp"
#include "ir/machine/frame.hpp"

namespace rungproof {

namespace {

class StackReader final : public LogicReader {
 public:
  explicit StackReader(CoverageMap& map) : LogicReader(map) { findStepWords(); }

  void beginBlock(const Pou& pou) override {
    const LogicNode first = pou.kind == PouKind::Subroutine ? trees().constant(true) : hidden();
    stack_.fill(first);
    segment_.clear();
  }

  void read(const Instruction& instruction, CoveragePlace place) override {
    const Desc& desc = *instruction.desc;
    const Role role = roleOf(instruction);
    if (isContact(role)) return contact(instruction, place);
    switch (role) {
      case Role::Not: stack_[0] = trees().lnot(stack_[0]); return;
      case Role::Ald:
      case Role::Old: {
        const LogicNode joined = trees().join(role == Role::Ald ? LogicOp::And : LogicOp::Or, stack_[0], stack_[1]);
        pop();
        stack_[0] = joined;
        return;
      }
      case Role::Lps: push(stack_[0]); return;
      case Role::Lrd: stack_[0] = stack_[1]; return;
      case Role::Lpp: pop(); return;
      case Role::Lds: {
        const std::int64_t level = instruction.operands.empty() ? 0 : instruction.operands[0].value;
        push(stack_[static_cast<std::size_t>(std::clamp<std::int64_t>(level, 0, mostStackLevels - 1))]);
        return;
      }
      case Role::Eu:
      case Role::Ed: {
        const LogicNode input = role == Role::Eu ? stack_[0] : trees().lnot(stack_[0]);
        stack_[0] = trees().join(LogicOp::And, input, leafOf(LeafKind::Edge, instruction, place));
        return;
      }
      case Role::Aeno: stack_[0] = hidden(); return;
      case Role::Nop: return;
      default: break;
    }
    if (desc.control == Control::SubroutineHead || desc.control == Control::InterruptHead ||
        desc.control == Control::MainEnd || desc.execution == Execution::Stack)
      return;
    const bool needsPower = desc.stack.needs > 0;
    output(instruction, needsPower, place);
    for (std::uint8_t level = 0; level < desc.stack.needs && level < mostStackLevels; ++level)
      decide(instruction, level, stack_[level], place);
    steps(instruction, place);
    for (std::uint8_t k = 0; k < desc.stack.pops; ++k) pop();
    const bool setsTop = desc.control == Control::For || desc.control == Control::Next || desc.control == Control::Lscr;
    if (setsTop) stack_[0] = trees().constant(true);
  }

 private:
  void push(LogicNode node) {
    std::copy_backward(stack_.begin(), stack_.end() - 1, stack_.end());
    stack_[0] = node;
  }
  void pop() { std::copy(stack_.begin() + 1, stack_.end(), stack_.begin()); }

  void contact(const Instruction& instruction, CoveragePlace place) {
    const LogicNode leaf = leafOf(LeafKind::Contact, instruction, place, instruction.desc->negated);
    switch (roleOf(instruction)) {
      case Role::Load: push(leaf); return;
      case Role::And: stack_[0] = trees().join(LogicOp::And, stack_[0], leaf); return;
      default: stack_[0] = trees().join(LogicOp::Or, stack_[0], leaf); return;
    }
  }

  void steps(const Instruction& instruction, CoveragePlace place) {
    const Desc& desc = *instruction.desc;
    if (desc.control == Control::Lscr && !instruction.operands.empty()) segment_ = toString(instruction.operands[0]);
    if (desc.control == Control::ScrEnd) segment_.clear();
    if (desc.control == Control::Scrt && !instruction.operands.empty())
      transition({TransitionKind::Scrt, &instruction, segment_ + " -> " + toString(instruction.operands[0]), 0, place});
    const bool isDirect = !instruction.operands.empty() && instruction.operands[0].kind == OperandKind::Direct;
    if (isSet(desc.role) && isDirect && instruction.operands[0].area == Area::S)
      transition({TransitionKind::SetStep, &instruction, "-> " + toString(instruction.operands[0]), 0, place});
    if (const Operand* to = movedConstant(instruction); to != nullptr && words_.contains(*to))
      transition({TransitionKind::StepWord, &instruction, toString(*to) + " -> " + toString(instruction.operands[0]),
                  static_cast<std::uint64_t>(instruction.operands[0].value), place});
  }

  /// Where a move of a constant goes to, or nullptr.
  static const Operand* movedConstant(const Instruction& instruction) {
    if (roleOf(instruction) != Role::Move || instruction.operands.size() < 2) return nullptr;
    const Operand &from = instruction.operands[0], &to = instruction.operands[1];
    const bool isPlace = to.kind == OperandKind::Direct && to.area != Area::AC && to.area != Area::Q;
    return from.kind == OperandKind::Constant && isPlace ? &to : nullptr;
  }

  void findStepWords() {
    for (const Pou& pou : program().pous) {
      for (const Network& network : pou.networks) {
        for (const Instruction& i : network.instructions) {
          const bool equality = i.desc->relation == Relation::Equal || i.desc->relation == Relation::NotEqual;
          if (equality && i.operands.size() == 2 && i.operands[0].kind == OperandKind::Direct &&
              i.operands[1].kind == OperandKind::Constant)
            words_.compares(i.operands[0], i.operands[1].value);
          if (const Operand* to = movedConstant(i))
            words_.moves(*to, i.operands[0].value);
          else
            for (std::size_t k = 0; k < i.operands.size() && k < i.desc->operandCount; ++k) {
              if (i.desc->operands[k].direction != Direction::In && i.operands[k].kind == OperandKind::Direct &&
                  i.operands[k].width != Width::Bit)
                words_.writes(i.operands[k]);
            }
        }
      }
    }
  }

  std::array<LogicNode, mostStackLevels> stack_{};
  std::string segment_;
  StepWords words_;
};

}  // namespace

std::unique_ptr<LogicReader> stackReader(CoverageMap& map) { return std::make_unique<StackReader>(map); }

}  // namespace rungproof
