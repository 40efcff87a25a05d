// Blocks that no file has, of a library: their instances are known by how the project uses them. What it takes of an
// instance is an output, whose type is that of what it is compared with or written to. A call may leave any value in
// each output and in each variable that is given to it by name, because it may be an IN_OUT.
#include "frontend/iec/iec_lowering.hpp"
#include "ir/iec/walk.hpp"

namespace rungproof::iec {

namespace {

class ContractFinder {
 public:
  ContractFinder(const ProjectSyntax& project, SyntaxSink& sink) : project_(project), sink_(sink) {
    for (const BlockSyntax& block : project.blocks) known_.emplace(foldedName(block.name), &block);
    for (const NamedType& type : project.types) types_.insert(foldedName(type.name));
  }

  std::vector<BlockSyntax> run() {
    for (const BlockSyntax& block : project_.blocks) {
      block_ = &block;
      findInstances();
      if (instances_.empty()) continue;
      findResults();
      eachStatementOf(block, [&](const Statement& one, const Statements&, std::size_t) { visit(one); });
    }
    std::vector<BlockSyntax> made;
    for (auto& [folded, contract] : contracts_) {
      if (contract.isCalled) made.push_back(std::move(contract.block));
    }
    return made;
  }

 private:
  struct Contract {
    BlockSyntax block;
    bool isCalled = false;
  };

  bool isUnknown(const TypeSyntax& type) const {
    const std::string folded = foldedName(type.name);
    return type.form == TypeForm::Named && type.low == nullptr && elementaryType(folded) == nullptr &&
           !types_.contains(folded) && !known_.contains(folded);
  }

  void findInstances() {
    instances_.clear();
    const auto add = [&](const VariableSyntax& variable) {
      if (!isUnknown(*variable.type)) return;
      Contract& contract = contracts_[foldedName(variable.type->name)];
      if (contract.block.name.empty()) {
        contract.block.kind = BlockKind::FunctionBlock;
        contract.block.name = variable.type->name;
        contract.block.span = variable.span;
        contract.block.isLibrary = contract.block.isContract = true;
      }
      instances_[foldedName(variable.name)] = &contract;
    };
    for (const VariableSyntax& variable : project_.globals) add(variable);
    for (const VariableSyntax& variable : block_->variables) add(variable);
  }

  /// What a box of a drawing gives has the type of a variable that takes it.
  void findResults() {
    results_.clear();
    eachStatementOf(*block_, [&](const Statement& one, const Statements&, std::size_t) {
      const bool isTaken = one.kind == StatementKind::Assign && one.value->kind == ExprKind::Path &&
                           one.value->parts.size() == 1 && one.value->parts[0].name.starts_with(resultPrefix);
      if (!isTaken) return;
      if (const TypePtr type = typeOf(*one.target)) results_.emplace(one.value->parts[0].name, type);
    });
  }

  static TypePtr named(std::string_view name, Span span) {
    auto made = std::make_shared<TypeSyntax>();
    made->name = name;
    made->span = span;
    return made;
  }

  /// The type of a variable that is written alone, or of a part of a known block.
  TypePtr typeOf(const Expr& expr) const {
    if (expr.kind == ExprKind::Literal) {
      const std::string word = foldedName(expr.text);
      if (!expr.prefix.empty()) return named(expr.prefix == "T" ? "TIME" : expr.prefix, expr.span);
      if (word == "TRUE" || word == "FALSE") return named("BOOL", expr.span);
      return named(expr.text.find('.') != std::string::npos ? "REAL" : "DINT", expr.span);
    }
    if (expr.kind == ExprKind::Unary) return expr.text == "NOT" ? named("BOOL", expr.span) : typeOf(*expr.operands[0]);
    if (expr.kind == ExprKind::Binary) {
      static const std::set<std::string> arithmetic = {"+", "-", "*", "/", "MOD"};
      if (!arithmetic.contains(expr.text)) return named("BOOL", expr.span);
      const TypePtr left = typeOf(*expr.operands[0]);
      return left != nullptr ? left : typeOf(*expr.operands[1]);
    }
    if (expr.kind != ExprKind::Path || expr.parts.size() > 2) return nullptr;
    for (const PathPart& part : expr.parts) {
      if (part.kind != PathPart::Kind::Name) return nullptr;
    }
    if (const auto result = results_.find(expr.parts[0].name); result != results_.end()) return result->second;
    const VariableSyntax* variable = variableNamed(*block_, expr.parts[0].name);
    if (variable == nullptr || expr.parts.size() == 1) return variable != nullptr ? variable->type : nullptr;
    const auto block = known_.find(foldedName(variable->type->name));
    const VariableSyntax* member = block != known_.end() ? variableNamed(*block->second, expr.parts[1].name) : nullptr;
    return member != nullptr ? member->type : nullptr;
  }
  const VariableSyntax* variableNamed(const BlockSyntax& block, const std::string& name) const {
    for (const std::vector<VariableSyntax>* list : {&block.variables, &project_.globals}) {
      for (const VariableSyntax& variable : *list) {
        if (foldedName(variable.name) == foldedName(name)) return &variable;
      }
    }
    return nullptr;
  }

  void pin(Contract& contract, const std::string& name, const TypePtr& type, Span span) {
    if (name.empty() || foldedName(name) == "EN" || foldedName(name) == "ENO") return;
    for (VariableSyntax& variable : contract.block.variables) {
      if (foldedName(variable.name) != foldedName(name)) continue;
      if (variable.type == nullptr) variable.type = type;
      return;
    }
    VariableSyntax made;
    made.name = name;
    made.section = Section::Output;
    made.type = type;
    made.span = span;
    contract.block.variables.push_back(std::move(made));
  }

  /// What the value of an expression is wanted as.
  void take(const Expr& expr, const TypePtr& wanted) {
    switch (expr.kind) {
      case ExprKind::Path: {
        for (const PathPart& part : expr.parts) {
          for (const ExprPtr& index : part.indices) take(*index, named("DINT", expr.span));
        }
        const auto instance = instances_.find(foldedName(expr.parts[0].name));
        if (instance != instances_.end() && expr.parts.size() == 2 && expr.parts[1].kind == PathPart::Kind::Name)
          pin(*instance->second, expr.parts[1].name, wanted, expr.span);
        return;
      }
      case ExprKind::Unary:
        return take(*expr.operands[0], expr.text == "NOT" && wanted == nullptr ? named("BOOL", expr.span) : wanted);
      case ExprKind::Binary: {
        static const std::set<std::string> comparisons = {"=", "<>", "<", ">", "<=", ">="};
        static const std::set<std::string> logic = {"AND", "OR", "XOR", "AND_THEN", "OR_ELSE"};
        for (std::size_t i = 0; i < 2; ++i) {
          TypePtr inner = wanted;
          if (comparisons.contains(expr.text)) inner = typeOf(*expr.operands[1 - i]);
          if (inner == nullptr && logic.contains(expr.text)) inner = named("BOOL", expr.span);
          if (inner == nullptr) inner = typeOf(*expr.operands[1 - i]);
          take(*expr.operands[i], inner);
        }
        return;
      }
      case ExprKind::Call: return call(expr, wanted);
      default: return;
    }
  }

  void call(const Expr& expr, const TypePtr& wanted) {
    const std::string name = foldedName(expr.parts[0].name);
    const bool isMethod = expr.parts.size() == 2 && expr.parts[1].kind == PathPart::Kind::Name;
    const auto instance = expr.parts.size() == 1 || isMethod ? instances_.find(name) : instances_.end();
    if (instance != instances_.end()) {
      Contract& contract = *instance->second;
      if (isMethod) pin(contract, expr.parts[1].name, wanted, expr.span);  // its result is like an output
      if (!std::exchange(contract.isCalled, true))
        sink_.report(
            Syntax::IecTaken, expr.span,
            fmt::format("{} is in no file: what its calls may write is any value", excerpt(contract.block.name)));
      for (const Argument& argument : expr.arguments) {
        if (argument.value == nullptr) continue;
        if (argument.isOutput) {
          pin(contract, argument.name, typeOf(*argument.value), argument.span);
        } else {
          take(*argument.value, nullptr);
        }
      }
      return;
    }
    const VariableSyntax* variable = variableNamed(*block_, expr.parts[0].name);
    const auto block = known_.find(variable != nullptr ? foldedName(variable->type->name) : name);
    for (const Argument& argument : expr.arguments) {
      if (argument.value == nullptr) continue;
      const VariableSyntax* formal =
          block != known_.end() && !argument.name.empty() ? variableNamed(*block->second, argument.name) : nullptr;
      take(*argument.value, formal != nullptr ? formal->type : block == known_.end() ? wanted : nullptr);
    }
  }

  void visit(const Statement& one) {
    const TypePtr boolean = named("BOOL", one.span);
    switch (one.kind) {
      case StatementKind::Assign: {
        const TypePtr type = typeOf(*one.target);
        take(*one.value, type);
        return take(*one.target, typeOf(*one.value));
      }
      case StatementKind::While:
      case StatementKind::Repeat:
      case StatementKind::Jump:
        if (one.value != nullptr) take(*one.value, boolean);
        return;
      default: break;
    }
    for (const Branch& branch : one.branches) {
      if (branch.condition != nullptr) take(*branch.condition, boolean);
    }
    for (const ExprPtr* part : {&one.target, &one.value, &one.last, &one.by}) {
      if (*part != nullptr) take(**part, nullptr);
    }
    if (one.line == nullptr) return;
    for (const Argument& operand : one.line->operands) {
      if (operand.value == nullptr) continue;
      if (operand.value->kind == ExprKind::Call) {
        call(*operand.value, nullptr);
      } else {
        take(*operand.value, boolean);
      }
    }
  }

  const ProjectSyntax& project_;
  SyntaxSink& sink_;
  std::map<std::string, const BlockSyntax*> known_;
  std::set<std::string> types_;
  std::map<std::string, Contract> contracts_;  ///< by the name of the block
  const BlockSyntax* block_ = nullptr;
  std::map<std::string, TypePtr> results_;      ///< of the block at hand: by variables of results
  std::map<std::string, Contract*> instances_;  ///< that the block at hand may name
};

}  // namespace

void addContracts(Program& program, ProjectSyntax& project) {
  SyntaxSink sink(program, project.blocks.empty() ? 0 : project.blocks[0].span.file);
  for (BlockSyntax& made : ContractFinder(project, sink).run()) {
    // A pin whose type nothing tells stays unknown: what uses it is not covered.
    std::erase_if(made.variables, [](const VariableSyntax& pin) { return pin.type == nullptr; });
    project.blocks.push_back(std::move(made));
  }
}

/// The instance of a block in no file, one of whose methods is called; nullptr: it is no such call.
BlockInstance* Lowering::contractOfMethod(Scope& scope, const Expr& call) {
  if (call.parts.size() != 2 || call.parts[1].kind != PathPart::Kind::Name) return nullptr;
  const std::string folded = foldedName(call.parts[0].name);
  BlockInstance* owner = nullptr;
  const Variable* variable = scope.inOuts.contains(folded) ? nullptr : find(scope, folded, owner);
  BlockInstance* instance = variable != nullptr ? variable->instance : nullptr;
  return instance != nullptr && instance->block->isContract ? instance : nullptr;
}

/// A call of a method that was left out, of another instance or of the block itself.
void Lowering::refuseMethod(Scope& scope, const Expr& call) {
  const bool isOwn =
      scope.self != nullptr && std::ranges::any_of(scope.self->block->actions, [&](const ActionSyntax& action) {
        return foldedName(action.name) == foldedName(call.parts[0].name);
      });
  if (isOwn || call.parts.size() != 1) refuse(call.span, "methods are not modelled", Syntax::IecNotModelled);
}

/// The result of a method that no file has, which is any value.
const Variable& Lowering::resultOfMethod(BlockInstance& instance, const Expr& call) {
  const auto result = instance.names.find(foldedName(call.parts[1].name));
  if (result == instance.names.end() || !result->second.type->isValue())
    refuse(call.span, fmt::format("which type the result of {}.{} has is not known", excerpt(call.parts[0].name),
                                  excerpt(call.parts[1].name)));
  return result->second;
}

/// After the call every output, and every variable that was given, has any value.
void Lowering::callContract(Scope& scope, BlockInstance& instance, const Expr& call) {
  instance.isCalled = true;
  madeBlocks_.insert(instance.block);
  const auto leaveAny = [&](const Type& type, std::uint32_t offset) {
    if (type.bytes == 0) return;
    if (type.width == 1) {
      emitPlace("ANY", type, offset);
    } else {
      emit("ANY");
      last().operands.push_back(direct(Area::V, Width::Byte, offset));
      last().operands.push_back(rungproof::constant(type.bytes));
    }
    for (std::uint32_t i = 0; i < type.bytes; ++i) noteWritten(offset + i);
    if (!shared_.empty()) writeThrough(offset);
  };
  for (const VariableSyntax& declared : instance.block->variables) {
    const auto variable = instance.names.find(foldedName(declared.name));
    if (variable != instance.names.end()) leaveAny(*variable->second.type, variable->second.offset);
  }
  for (const Argument& argument : call.arguments) {
    if (argument.isOutput || argument.value->kind != ExprKind::Path || foldedName(argument.name) == "EN") continue;
    const Reference given = reference(scope, *argument.value, true);
    const bool isFixed = given.type == nullptr || given.constant || given.bit;
    const bool isInput =
        given.declared != nullptr && (given.declared->isConstant || given.declared->section == Section::Input ||
                                      foldedName(given.declared->address).starts_with("%I"));
    if (isFixed || isInput) continue;
    if (given.instance != nullptr || given.type->bytes == 0)
      refuse(argument.span, "an instance given to a block that no file has is not modelled", Syntax::IecNotModelled);
    if (!given.indices.empty())
      refuse(argument.span, "a computed element given to a block that no file has is not modelled",
             Syntax::IecNotModelled);
    leaveAny(*given.type, given.offset);
  }
}

}  // namespace rungproof::iec
