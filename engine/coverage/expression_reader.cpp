// The evaluation stack of IEC 61131-3 as trees. What a statement keeps in a variable without a name (the current result
// of a list, the selector of CASE) is followed through it.
#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "engine/coverage/logic_reader.hpp"
#include "engine/coverage/step_words.hpp"
#include "ir/iec/expression_role.hpp"

namespace rungproof {

namespace {

class ExpressionReader final : public LogicReader {
 public:
  explicit ExpressionReader(CoverageMap& map) : LogicReader(map) {
    for (const Symbol& symbol : program().symbols) {
      const bool isOwn = symbol.address.kind == OperandKind::Direct && symbol.name.find("__") == std::string::npos;
      if (isOwn) named_.insert(bitOf(symbol.address));
    }
    findStepVariables();
  }

  void beginBlock(const Pou& pou) override {
    stack_.clear();
    temporaries_.clear();
    passed_.clear();
    open_.clear();
    isChart_ = pou.name.find(".(transitions") != std::string::npos;
    constant_ = nullptr;
    reading_ = std::nullopt;
    isDead_ = isBehindJump_ = false;
    targets_.clear();
    passedOver_.clear();
  }

  void read(const Instruction& instruction, CoveragePlace place) override {
    if (isDead(instruction)) return;
    const ExpressionRole role = expressionRole(instruction);
    const Instruction* const constant = std::exchange(constant_, nullptr);
    if (isChart_ && program().pous[place.pou].networks[place.network].span.length == 0) return pass(instruction);
    switch (instruction.desc->control) {
      case Control::Jump:
        if (instruction.desc->stack.pops > 0) {
          const LogicNode condition = pop();
          if (!isChart_) decide(instruction, 0, condition, place);
          if (hasContact(condition)) skipsTo(instruction);
        } else if (!open_.empty()) {
          skipsTo(instruction);  // what stands behind it is the other branch
        }
        return;
      case Control::LabelMark:
        temporaries_.clear();
        passed_.insert(instruction.operands[0].value);
        open_.erase(instruction.operands[0].value);
        return;
      case Control::Call: output(instruction, false, place); return;
      case Control::None: break;
      default: return;
    }
    if (role == ExpressionRole::LoadBit) {
      const auto kept = temporaries_.find(bitOf(instruction.operands[0]));
      if (!isNamed(instruction.operands[0]) && kept != temporaries_.end()) return push(kept->second);
      return push(leafOf(LeafKind::Contact, instruction, place));
    }
    if (role == ExpressionRole::StoreBit) return storeBit(instruction, place);
    if (role == ExpressionRole::Store) {
      pop();
      if (!isNamed(instruction.operands[0])) return;
      output(instruction, false, place);
      if (constant != nullptr && words_.contains(instruction.operands[0]))
        transition({TransitionKind::StepWord, &instruction,
                    nameOf(instruction.operands[0]) + " -> " + std::to_string(constant->operands[0].value),
                    static_cast<std::uint64_t>(constant->operands[0].value), place});
      return;
    }
    if (role == ExpressionRole::Constant) {
      constant_ = &instruction;
      return push(isOfTruth(instruction) ? trees().constant(instruction.operands[0].value != 0) : hidden());
    }
    if (instruction.desc->relation != Relation::None) {
      pop();
      pop();
      return push(leafOf(LeafKind::Contact, instruction, place));
    }
    if (!isOfTruth(instruction)) return pass(instruction);
    switch (role) {
      case ExpressionRole::And: return join(LogicOp::And);
      case ExpressionRole::Or: return join(LogicOp::Or);
      case ExpressionRole::Xor: return join(LogicOp::Xor);
      case ExpressionRole::Not: return push(trees().lnot(pop()));
      case ExpressionRole::Select: {
        const LogicNode one = pop(), zero = pop(), chooses = pop();
        return push(trees().join(LogicOp::Or, trees().join(LogicOp::And, chooses, one),
                                 trees().join(LogicOp::And, trees().lnot(chooses), zero)));
      }
      default: return pass(instruction);
    }
  }

 private:
  void push(LogicNode node) { stack_.push_back(node); }
  void join(LogicOp op) {
    const LogicNode right = pop(), left = pop();
    push(trees().join(op, left, right));
  }
  LogicNode pop() {
    if (stack_.empty()) return hidden();
    const LogicNode node = stack_.back();
    stack_.pop_back();
    return node;
  }

  /// Statements for another reading of an open point than the one in force. Behind a reading alone a jump is taken
  /// always or never: in the one case what it passes over is dead, in the other case what stands behind its label, up
  /// to a label that something jumps to.
  bool isDead(const Instruction& instruction) {
    const bool isLabel = instruction.desc->control == Control::LabelMark;
    const bool isJump = instruction.desc->control == Control::Jump;
    const std::int64_t label = isLabel || isJump ? instruction.operands[0].value : 0;
    if (isDead_ && !(isLabel && targets_.contains(label))) return true;
    isDead_ = false;
    const std::optional<bool> reading = std::exchange(reading_, std::nullopt);
    const bool isReached = !std::exchange(isBehindJump_, false);
    if (expressionRole(instruction) == ExpressionRole::Reading) {
      reading_ = choices()[static_cast<Choice>(instruction.operands[0].value)] == instruction.operands[1].value;
    } else if (isLabel) {
      isDead_ = !isReached && passedOver_.contains(label) && !targets_.contains(label);
    } else if (isJump && instruction.desc->stack.pops > 0 && reading == true) {
      passedOver_.insert(label);
    } else if (isJump) {
      targets_.insert(label);
      isBehindJump_ = instruction.desc->stack.pops == 0;
      isDead_ = reading.has_value();
    }
    return false;
  }

  static std::uint32_t bitOf(const Operand& operand) { return operand.offset * 8 + operand.bit; }
  bool isNamed(const Operand& operand) const { return named_.contains(bitOf(operand)); }
  std::string nameOf(const Operand& operand) const {
    const Symbol* symbol = program().symbolOf(operand);
    return symbol != nullptr ? symbol->name : toString(operand);
  }

  /// Values that no truth value decides.
  void pass(const Instruction& instruction) {
    const auto [pops, pushes] = stackUse(instruction);
    for (std::size_t i = 0; i < pops; ++i) pop();
    for (std::size_t i = 0; i < pushes; ++i) push(hidden());
  }

  void storeBit(const Instruction& instruction, CoveragePlace place) {
    const LogicNode condition = pop();
    const Operand& to = instruction.operands[0];
    if (isChart_) {
      // A transition: whether it fires is kept in a variable without a name, behind the line of its statement.
      if (isNamed(to)) return;
      temporaries_[bitOf(to)] = condition;
      output(instruction, true, place);
      decide(instruction, 0, condition, place);
      transition({TransitionKind::Chart, &instruction, statementLine(instruction), 0, place});
      return;
    }
    if (!isNamed(to)) {
      temporaries_[bitOf(to)] = condition;
      return;
    }
    // The value is the power flow of a coil, unless the flow decides whether the statement runs: then 0 is a value as
    // any other. A constant hangs on nothing.
    const bool isCoil = open_.empty() && !trees().leavesOf(condition).empty();
    output(instruction, isCoil, place);
    decide(instruction, 0, condition, place);
  }

  bool hasContact(LogicNode condition) {
    return std::ranges::any_of(trees().leavesOf(condition), [&](std::uint32_t leaf) { return isContactLeaf(leaf); });
  }
  /// From here on statements run only where the jump is not taken, up to its label.
  void skipsTo(const Instruction& jump) {
    const std::int64_t label = jump.operands[0].value;
    if (!passed_.contains(label)) open_.insert(label);
  }

  std::string statementLine(const Instruction& instruction) const {
    std::string line;
    for (const char c : program().sources->text(instruction.span)) {
      const bool isBlank = c == ' ' || c == '\n' || c == '\r' || c == '\t';
      if (!isBlank || (!line.empty() && line.back() != ' ')) line += isBlank ? ' ' : c;
      if (line.size() > 120) break;
    }
    return line;
  }

  /// Numbers to which only constants are stored, two at least, and which are compared with constants or select a CASE.
  void findStepVariables() {
    for (const Pou& pou : program().pous) {
      for (const Network& network : pou.networks) {
        const std::vector<Instruction>& list = network.instructions;
        const auto isRole = [&](std::size_t at, ExpressionRole role) {
          return at < list.size() && expressionRole(list[at]) == role;
        };
        for (std::size_t i = 0; i < list.size(); ++i) {
          if (isRole(i, ExpressionRole::Store) && isNamed(list[i].operands[0])) {
            if (i > 0 && isRole(i - 1, ExpressionRole::Constant))
              words_.moves(list[i].operands[0], list[i - 1].operands[0].value);
            else
              words_.writes(list[i].operands[0]);
          }
          if (!isRole(i, ExpressionRole::Load)) continue;
          const bool isSelector = isRole(i + 1, ExpressionRole::Store) && !isNamed(list[i + 1].operands[0]);
          const bool isCompared =
              i + 2 < list.size() && isRole(i + 1, ExpressionRole::Constant) &&
              (list[i + 2].desc->relation == Relation::Equal || list[i + 2].desc->relation == Relation::NotEqual);
          if (isSelector || isCompared) words_.selects(list[i].operands[0]);
        }
      }
    }
  }

  std::vector<LogicNode> stack_;
  std::map<std::uint32_t, LogicNode> temporaries_;  ///< by bit address
  std::set<std::uint32_t> named_;
  StepWords words_;
  std::set<std::int64_t> passed_, open_;  ///< labels of the block: those seen, and those that a condition jumps to
  bool isChart_ = false;
  const Instruction* constant_ = nullptr;
  std::optional<bool> reading_{};  ///< whether the reading that was asked for just now is in force
  bool isDead_ = false, isBehindJump_ = false;
  std::set<std::int64_t> targets_;     ///< labels that something jumps to
  std::set<std::int64_t> passedOver_;  ///< labels to which a jump never goes as its reading is in force
};

}  // namespace

std::unique_ptr<LogicReader> expressionReader(CoverageMap& map) { return std::make_unique<ExpressionReader>(map); }

}  // namespace rungproof
