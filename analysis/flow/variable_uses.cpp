// A walk over the statements of every block, each name resolved where it stands.
#include "analysis/flow/variable_uses.hpp"

#include <algorithm>
#include <cctype>

#include "analysis/rule.hpp"

namespace rungproof::iec {

bool DeclaredVariable::isRead() const {
  return std::ranges::any_of(uses, [](const VariableUse& use) { return use.reads; });
}
bool DeclaredVariable::isWritten() const {
  return std::ranges::any_of(uses, [](const VariableUse& use) { return use.writes; });
}
bool DeclaredVariable::isCalled() const {
  return std::ranges::any_of(uses, [](const VariableUse& use) { return use.calls; });
}

Finding& reportOn(FindingSink& sink, const DeclaredVariable& row, Span span, std::string message) {
  Finding& finding = sink.report(span, std::move(message));
  finding.address = row.variable->name;
  if (row.block != nullptr) finding.pou = row.block->name;
  return finding;
}

/// Collects the uses in one block, or in the configuration (nullptr).
class VariableUses::Walk {
 public:
  Walk(VariableUses& uses, const BlockSyntax* block) : uses_(uses), block_(block) {}

  void statements(const Statements& list) {
    for (const Statement& one : list) statement(one);
  }

  void read(const Expr& expr) { value(expr); }

  void call(const Expr& call, const Statement* statement) {
    const DeclaredVariable* instance = call.parts.empty() ? nullptr : find(call.parts[0].name);
    const BlockSyntax* callee = nullptr;
    if (instance != nullptr) {
      VariableUse use = useOf(call);
      use.calls = true;
      use.call = statement;
      add(call, use);
      callee = call.parts.size() == 1 ? uses_.blockOf(*instance->variable) : nullptr;
    } else if (call.parts.size() == 1) {
      callee = uses_.blockNamed(call.parts[0].name);
    }
    indices(call);
    std::size_t position = 0;
    for (const Argument& argument : call.arguments) {
      if (argument.value == nullptr) continue;
      const Section section = sectionOf(callee, argument.name, position++);
      const bool isOutput = argument.isOutput || section == Section::Output;
      place(*argument.value, !isOutput, isOutput || section == Section::InOut);
    }
  }

 private:
  static Section sectionOf(const BlockSyntax* callee, const std::string& name, std::size_t position) {
    if (callee == nullptr) return Section::Input;
    std::size_t i = 0;
    for (const VariableSyntax& one : callee->variables) {
      const bool isPin =
          one.section == Section::Input || one.section == Section::InOut || one.section == Section::Output;
      if (!isPin) continue;
      if (name.empty() ? i++ == position : foldedName(one.name) == foldedName(name)) return one.section;
    }
    return Section::Input;
  }

  void statement(const Statement& one) {
    switch (one.kind) {
      case StatementKind::Assign:
        if (one.value != nullptr) value(*one.value);
        if (one.target != nullptr) place(*one.target, false, true, one.value.get());
        break;
      case StatementKind::Call:
        if (one.target != nullptr) call(*one.target, &one);
        break;
      case StatementKind::Line: line(one); return;
      case StatementKind::Jump:
        if (one.value != nullptr) value(*one.value);
        return;
      case StatementKind::Label: return;
      default:
        if (one.target != nullptr) place(*one.target, true, true);  // the counter of FOR
        for (const ExprPtr* part : {&one.value, &one.last, &one.by}) {
          if (*part != nullptr) value(**part);
        }
    }
    for (const Branch& branch : one.branches) {
      if (branch.condition != nullptr) value(*branch.condition);
      for (const CaseLabel& label : branch.labels) {
        if (label.low != nullptr) value(*label.low);
        if (label.high != nullptr) value(*label.high);
      }
      statements(branch.body);
    }
    statements(one.otherwise);
  }

  void line(const Statement& one) {
    const std::string& op = one.line->op;
    const bool isStore = op == "ST", isLatch = op == "S" || op == "R";
    for (const Argument& operand : one.line->operands) {
      if (operand.value == nullptr) continue;
      if (op == "CAL" && operand.value->kind == ExprKind::Call) {
        call(*operand.value, &one);
      } else {
        place(*operand.value, !isStore && !isLatch, isStore || isLatch || operand.isOutput);
      }
    }
  }

  void value(const Expr& expr) {
    if (expr.kind == ExprKind::Path) return place(expr, true, false);
    if (expr.kind == ExprKind::Call) return call(expr, nullptr);
    for (const ExprPtr& operand : expr.operands) {
      if (operand != nullptr) value(*operand);
    }
  }

  /// What a path names; any other expression is read.
  void place(const Expr& path, bool reads, bool writes, const Expr* given = nullptr) {
    if (path.kind != ExprKind::Path) return value(path);
    VariableUse use = useOf(path);
    use.reads = reads;
    use.writes = writes;
    use.value = given;
    add(path, use);
    indices(path);
  }

  void indices(const Expr& path) {
    for (const PathPart& part : path.parts) {
      for (const ExprPtr& index : part.indices) {
        if (index != nullptr) value(*index);
      }
    }
  }

  VariableUse useOf(const Expr& path) const {
    VariableUse use;
    use.block = block_;
    use.span = path.span;
    use.isWhole = path.parts.size() == 1;
    return use;
  }

  DeclaredVariable* find(const std::string& name) const {
    const auto own = uses_.byName_.find({block_, foldedName(name)});
    const auto found = own != uses_.byName_.end() ? own : uses_.byName_.find({nullptr, foldedName(name)});
    return found == uses_.byName_.end() ? nullptr : &uses_.rows_[found->second];
  }

  void add(const Expr& path, const VariableUse& use) {
    if (path.parts.empty()) return;
    DeclaredVariable* row = find(path.parts[0].name);
    if (row == nullptr) return;
    row->uses.push_back(use);
    if (row->variable->section != Section::External) return;
    const auto global = uses_.byName_.find({nullptr, foldedName(row->variable->name)});
    if (global != uses_.byName_.end()) uses_.rows_[global->second].uses.push_back(use);
  }

  VariableUses& uses_;
  const BlockSyntax* block_;
};

VariableUses::VariableUses(const ProjectSyntax& project) : project_(project) {
  for (const BlockSyntax& block : project.blocks) blocks_.emplace(foldedName(block.name), &block);
  for (const NamedType& type : project.types) types_.emplace(foldedName(type.name), &type);
  const auto declare = [&](const BlockSyntax* block, const VariableSyntax& variable) {
    const bool isHidden = variable.type != nullptr && variable.type->name.starts_with("__");  // steps of a chart
    if (isHidden || variable.name.starts_with("__")) return;
    if (byName_.emplace(Key{block, foldedName(variable.name)}, rows_.size()).second)
      rows_.push_back({block, &variable, {}});
  };
  eachOwnBlock(project, [&](const BlockSyntax& block) {
    for (const VariableSyntax& variable : block.variables) declare(&block, variable);
  });
  for (const VariableSyntax& variable : project.globals) declare(nullptr, variable);
  eachOwnBlock(project, [&](const BlockSyntax& block) {
    Walk(*this, &block).statements(block.body);
    for (const ActionSyntax& action : block.actions) Walk(*this, &block).statements(action.body);
  });
  for (const InstanceSyntax& instance : project.instances) {
    if (instance.connections != nullptr) Walk(*this, nullptr).call(*instance.connections, nullptr);
  }
  for (const TaskSyntax& task : project.tasks) {
    if (task.single != nullptr) Walk(*this, nullptr).read(*task.single);
  }
}

const DeclaredVariable* VariableUses::find(const BlockSyntax& block, std::string_view name) const {
  const auto own = byName_.find({&block, foldedName(name)});
  const auto found = own != byName_.end() ? own : byName_.find({nullptr, foldedName(name)});
  return found == byName_.end() ? nullptr : &rows_[found->second];
}

const BlockSyntax* VariableUses::blockNamed(std::string_view name) const {
  const auto found = blocks_.find(foldedName(name));
  return found == blocks_.end() ? nullptr : found->second;
}

const BlockSyntax* VariableUses::blockOf(const VariableSyntax& variable) const {
  if (variable.type == nullptr || variable.type->form != TypeForm::Named) return nullptr;
  const BlockSyntax* block = blockNamed(variable.type->name);
  return block != nullptr && block->kind == BlockKind::FunctionBlock ? block : nullptr;
}

const TypeSyntax* VariableUses::typeBehind(const TypeSyntax& type) const {
  constexpr int mostNames = 20;  // of types that name each other
  const TypeSyntax* at = &type;
  for (int i = 0; i < mostNames && at != nullptr && at->form == TypeForm::Named; ++i) {
    const auto found = types_.find(foldedName(at->name));
    at = found == types_.end() ? nullptr : found->second->type.get();
  }
  return at;
}

std::string VariableUses::elementaryTypeOf(const BlockSyntax& block, const Expr& path) const {
  if (path.kind != ExprKind::Path || path.parts.empty()) return {};
  const DeclaredVariable* row = find(block, path.parts[0].name);
  const TypeSyntax* type = row == nullptr ? nullptr : row->variable->type.get();
  for (std::size_t i = 1; i < path.parts.size() && type != nullptr; ++i) {
    const PathPart& part = path.parts[i];
    const BlockSyntax* instance = type->form == TypeForm::Named ? blockNamed(type->name) : nullptr;
    const TypeSyntax* behind = typeBehind(*type);
    const std::vector<VariableSyntax>* fields = instance != nullptr ? &instance->variables
                                                : behind != nullptr ? &behind->fields
                                                                    : nullptr;
    type = nullptr;
    if (part.kind == PathPart::Kind::Index && behind != nullptr) type = behind->element.get();
    if (part.kind != PathPart::Kind::Name || fields == nullptr) continue;
    for (const VariableSyntax& field : *fields) {
      if (foldedName(field.name) == foldedName(part.name)) type = field.type.get();
    }
  }
  for (int i = 0; type != nullptr && type->form == TypeForm::Named; ++i) {
    const auto found = types_.find(foldedName(type->name));
    if (found == types_.end() || i > 20) return foldedName(type->name);
    type = found->second->type.get();
  }
  return {};
}

bool VariableUses::isAskedFor(const VariableSyntax& variable) const {
  const auto isPart = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
  const std::string name = foldedName(variable.name);
  return std::ranges::any_of(project_.directives, [&](const Directive& directive) {
    const std::string text = foldedName(directive.text);
    for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name, at + 1)) {
      const std::size_t end = at + name.size();
      if ((at == 0 || !isPart(text[at - 1])) && (end == text.size() || !isPart(text[end]))) return true;
    }
    return false;
  });
}

}  // namespace rungproof::iec
