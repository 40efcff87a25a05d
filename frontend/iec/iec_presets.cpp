// Timers whose PT is not the same in all calls: what becomes of one that has ended and then gets a longer PT is a
// reading (Choice::IecTimerDone).
#include "frontend/iec/iec_lowering.hpp"
#include "ir/iec/walk.hpp"

namespace rungproof::iec {

namespace {

constexpr std::string_view presetName = "PT";

/// The name of what is called, without those of the instances around it.
std::string lastName(const std::vector<PathPart>& parts, std::size_t count) {
  for (std::size_t i = std::min(count, parts.size()); i-- > 0;) {
    if (parts[i].kind == PathPart::Kind::Name) return foldedName(parts[i].name);
  }
  return {};
}

bool namesTimer(const TypeSyntax* type) {
  const std::string name = type != nullptr ? foldedName(type->name) : "";
  return name == "TON" || name == "TOF" || name == "TP";
}

}  // namespace

/// Looks at all calls and assignments of the project. Timers of one name are taken for one.
void Lowering::findChangingPresets() {
  std::map<std::string, std::set<std::int64_t>> given;
  const auto give = [&](const std::string& timer, const Expr* value) {
    const auto known = value != nullptr ? types_.integer(*value) : std::nullopt;
    if (!known)
      changingPresets_.insert(timer);
    else if (given[timer].insert(*known).second && given[timer].size() > 1)
      changingPresets_.insert(timer);
  };
  const BlockSyntax* inside = nullptr;
  /// Instead of a constant of the block its value.
  const auto valueOf = [&](const Expr* value) {
    if (inside == nullptr || value == nullptr || value->kind != ExprKind::Path || value->parts.size() != 1)
      return value;
    for (const VariableSyntax& variable : inside->variables) {
      const bool isMeant = variable.isConstant && foldedName(variable.name) == foldedName(value->parts[0].name);
      if (isMeant && variable.initial != nullptr && variable.initial->value != nullptr)
        return static_cast<const Expr*>(variable.initial->value.get());
    }
    return value;
  };
  const auto call = [&](const Expr& expr) {
    const std::string timer = lastName(expr.parts, expr.parts.size());
    std::size_t position = 0;
    for (const Argument& argument : expr.arguments) {
      const bool isSecond = argument.name.empty() && position++ == 1;
      if (isSecond || foldedName(argument.name) == presetName) give(timer, valueOf(argument.value.get()));
    }
  };
  const auto assigned = [&](const Expr& target, const Expr* value) {
    if (target.parts.size() > 1 && lastName(target.parts, target.parts.size()) == presetName)
      give(lastName(target.parts, target.parts.size() - 1), valueOf(value));
  };
  const auto declared = [&](const VariableSyntax& variable) {
    anyPresetMayChange_ =
        anyPresetMayChange_ || (variable.section == Section::InOut && namesTimer(variable.type.get()));
    if (variable.initial == nullptr) return;
    for (const auto& [field, value] : variable.initial->fields) {
      if (foldedName(field) == presetName) give(foldedName(variable.name), value.value.get());
    }
  };
  for (const VariableSyntax& variable : project_.globals) declared(variable);
  for (const BlockSyntax& block : project_.blocks) {
    if (block.isLibrary) continue;
    inside = &block;
    for (const VariableSyntax& variable : block.variables) declared(variable);
    eachStatementOf(block, [&](const Statement& one, const Statements&, std::size_t) {
      if (one.kind == StatementKind::Call) call(*one.target);
      if (one.kind == StatementKind::Assign) assigned(*one.target, one.value.get());
      if (one.line == nullptr) return;
      for (const Argument& operand : one.line->operands) {
        if (operand.value == nullptr) continue;
        if (operand.value->kind == ExprKind::Call) call(*operand.value);
        if (operand.value->kind != ExprKind::Path) continue;
        if (one.line->op == presetName) give(lastName(operand.value->parts, operand.value->parts.size()), nullptr);
        if (one.line->op == "ST") assigned(*operand.value, nullptr);
      }
    });
  }
  inside = nullptr;
  for (const AccessSyntax& access : project_.accesses) assigned(*access.path, nullptr);
  for (const Directive& directive : project_.directives)
    anyPresetMayChange_ = anyPresetMayChange_ || foldedName(directive.text).find(".PT") != std::string::npos;
}

bool Lowering::mayChangePreset(const BlockInstance& timer) const {
  const std::string path = foldedName(timer.path);
  const std::string name = path.substr(path.rfind('.') + 1);
  return anyPresetMayChange_ || changingPresets_.contains(name.substr(0, name.find('[')));
}

}  // namespace rungproof::iec
