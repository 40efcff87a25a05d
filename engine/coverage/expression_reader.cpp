// The evaluation stack of IEC 61131-3 as trees. What a statement keeps in a variable without a name (the current result
// of a list, the selector of CASE) is followed through it.
#include <algorithm>
#include <map>
#include <set>

#include "engine/coverage/logic_reader.hpp"

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
    isChart_ = pou.name.find(".(transitions") != std::string::npos;
    constant_ = nullptr;
  }

  void read(const Instruction& instruction, CoveragePlace place) override {
    const std::string_view name = instruction.desc->stl;
    const Instruction* const constant = std::exchange(constant_, nullptr);
    if (isChart_ && program().pous[place.pou].networks[place.network].span.length == 0) return pass(instruction);
    switch (instruction.desc->control) {
      case Control::Jump:
        if (instruction.desc->stack.pops > 0) {
          const LogicNode condition = pop();
          if (!isChart_) decide(instruction, 0, condition, place);
        }
        return;
      case Control::LabelMark: temporaries_.clear(); return;
      case Control::Call: output(instruction, false, place); return;
      case Control::None: break;
      default: return;
    }
    if (name == "LOAD.BIT") {
      const auto kept = temporaries_.find(bitOf(instruction.operands[0]));
      if (!isNamed(instruction.operands[0]) && kept != temporaries_.end()) return push(kept->second);
      return push(leafOf(LeafKind::Contact, instruction, place));
    }
    if (name == "STORE.BIT") return storeBit(instruction, place);
    if (name == "STORE") {
      pop();
      if (!isNamed(instruction.operands[0])) return;
      output(instruction, false, place);
      if (constant != nullptr && words_.contains(instruction.operands[0].offset))
        transition({TransitionKind::StepWord, &instruction,
                    nameOf(instruction.operands[0]) + " -> " + std::to_string(constant->operands[0].value),
                    static_cast<std::uint64_t>(constant->operands[0].value), place});
      return;
    }
    if (name == "CONST") {
      constant_ = &instruction;
      const bool isTruth = instruction.operands[1].value == 1;
      return push(isTruth ? trees().constant(instruction.operands[0].value != 0) : hidden());
    }
    if (instruction.desc->relation != Relation::None) {
      pop();
      pop();
      return push(leafOf(LeafKind::Contact, instruction, place));
    }
    const bool isTruth = !instruction.operands.empty() && instruction.operands[0].value == 1;
    if ((name == "AND" || name == "OR" || name == "XOR") && isTruth) {
      const LogicNode right = pop(), left = pop();
      return push(trees().join(name == "AND" ? LogicOp::And : name == "OR" ? LogicOp::Or : LogicOp::Xor, left, right));
    }
    if (name == "NOT" && isTruth) return push(trees().lnot(pop()));
    if (name == "SEL" && isTruth) {
      const LogicNode one = pop(), zero = pop(), chooses = pop();
      return push(trees().join(LogicOp::Or, trees().join(LogicOp::And, chooses, one),
                               trees().join(LogicOp::And, trees().lnot(chooses), zero)));
    }
    pass(instruction);
  }

 private:
  void push(LogicNode node) { stack_.push_back(node); }
  LogicNode pop() {
    if (stack_.empty()) return hidden();
    const LogicNode node = stack_.back();
    stack_.pop_back();
    return node;
  }
  static std::uint32_t bitOf(const Operand& operand) { return operand.offset * 8 + operand.bit; }
  bool isNamed(const Operand& operand) const { return named_.contains(bitOf(operand)); }
  std::string nameOf(const Operand& operand) const {
    const Symbol* symbol = program().symbolOf(operand);
    return symbol != nullptr ? symbol->name : toString(operand);
  }

  /// Values that no truth value decides.
  void pass(const Instruction& instruction) {
    const std::string_view name = instruction.desc->stl;
    const auto isOneOf = [&](std::initializer_list<std::string_view> list) {
      return std::ranges::find(list, name) != list.end();
    };
    std::size_t pops = 2, pushes = 1;
    if (isOneOf({"LOAD", "LOAD.BIT", "CONST", "READING"})) pops = 0;
    if (isOneOf({"INDEX", "LOAD.ELEMENT", "NEG", "ABS", "NOT", "RESIZE", "TO.REAL", "FROM.REAL", "FUNC.REAL",
                 "NEG.REAL", "ABS.REAL", "STORE", "STORE.BIT", "JMPCN"}))
      pops = 1;
    if (name == "SEL") pops = 3;
    if (isOneOf({"STORE", "STORE.BIT", "STORE.ELEMENT", "JMPCN"})) pushes = 0;
    if (isOneOf({"JMP", "LBL", "CAL", "RET", "PASS"})) pops = pushes = 0;
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
    output(instruction, true, place);
    decide(instruction, 0, condition, place);
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
    std::map<std::uint32_t, std::set<std::int64_t>> stored;
    std::set<std::uint32_t> otherwise, compared;
    for (const Pou& pou : program().pous) {
      for (const Network& network : pou.networks) {
        const std::vector<Instruction>& list = network.instructions;
        for (std::size_t i = 0; i < list.size(); ++i) {
          if (list[i].desc->stl == "STORE" && isNamed(list[i].operands[0])) {
            if (i > 0 && list[i - 1].desc->stl == "CONST")
              stored[list[i].operands[0].offset].insert(list[i - 1].operands[0].value);
            else
              otherwise.insert(list[i].operands[0].offset);
          }
          if (list[i].desc->stl != "LOAD" || i + 1 >= list.size()) continue;
          const bool isSelector = list[i + 1].desc->stl == "STORE" && !isNamed(list[i + 1].operands[0]);
          const bool isCompared =
              i + 2 < list.size() && list[i + 1].desc->stl == "CONST" &&
              (list[i + 2].desc->relation == Relation::Equal || list[i + 2].desc->relation == Relation::NotEqual);
          if (isSelector || isCompared) compared.insert(list[i].operands[0].offset);
        }
      }
    }
    for (const auto& [offset, values] : stored) {
      if (values.size() > 1 && compared.contains(offset) && !otherwise.contains(offset)) words_.insert(offset);
    }
  }

  std::vector<LogicNode> stack_;
  std::map<std::uint32_t, LogicNode> temporaries_;  ///< by bit address
  std::set<std::uint32_t> named_, words_;
  bool isChart_ = false;
  const Instruction* constant_ = nullptr;
};

}  // namespace

std::unique_ptr<LogicReader> expressionReader(CoverageMap& map) { return std::make_unique<ExpressionReader>(map); }

}  // namespace rungproof
