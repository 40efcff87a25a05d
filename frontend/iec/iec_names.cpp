// Names of the variables for properties, traces and people: "T1.Q", "Values[3]", with the program in front where two
// programs have the same name, and the address of located ones.
#include "frontend/iec/iec_lowering.hpp"

namespace rungproof::iec {

void Lowering::nameValue(const std::string& name, const Type& type, std::uint32_t offset, const std::string& alias) {
  if (type.kind == Kind::Array) {
    const std::uint32_t size = type.element->bytes;
    if (size == 0 || type.bytes / size > 4096) return;
    std::vector<std::int64_t> at;
    for (const auto& [low, high] : type.bounds) at.push_back(low);
    for (std::uint32_t place = 0; place < type.bytes; place += size) {
      std::string index;
      for (const std::int64_t i : at) index += fmt::format("{}{}", index.empty() ? "" : ",", i);
      nameValue(fmt::format("{}[{}]", name, index), *type.element, offset + place, fmt::format("{}[{}]", alias, index));
      for (std::size_t d = at.size(); d-- > 0;) {
        if (++at[d] <= type.bounds[d].second) break;
        at[d] = type.bounds[d].first;
      }
    }
    return;
  }
  if (type.kind == Kind::Struct) {
    for (const Field& field : type.fields)
      nameValue(name + "." + field.name, *field.type, offset + field.offset, alias + "." + field.name);
    return;
  }
  if (isText(&type)) return nameText(name, type, offset, alias);
  if (!type.isValue()) return;
  const Operand place = direct(Area::V, widthOfBits(type.width), offset);
  program_.symbols.push_back({name, place, "", {}});
  if (alias != name) program_.symbols.push_back({alias, place, "", {}});
  program_.valueTypes[offset] = type.kind == Kind::Real ? ValueType::Real
                                : type.isSigned         ? ValueType::Signed
                                                        : ValueType::Unsigned;
  if (const std::optional<ValueLimits> limits = limitsOf(type)) program_.valueLimits[offset] = *limits;
}

/// A text is known by its length; one that is free by its characters too, so that runs can show and repeat it.
void Lowering::nameText(const std::string& name, const Type& type, std::uint32_t offset, const std::string& alias) {
  const Type& byte = *elementaryType("USINT");
  nameValue(name + ".length", byte, offset, alias + ".length");
  const bool isFree = isFreed(offset);
  for (std::uint32_t i = 1; isFree && i < type.bytes; ++i)
    nameValue(fmt::format("{}[{}]", name, i), byte, offset + i, fmt::format("{}[{}]", alias, i));
}

void Lowering::nameVariable(const std::string& name, const Variable& variable, const std::string& alias) {
  if (variable.type == nullptr || variable.constant || variable.declared == nullptr) return;
  const auto members = [&](const BlockInstance& instance, const std::string& at, const std::string& other) {
    for (const VariableSyntax& member : instance.block->variables) {
      const auto found = instance.names.find(foldedName(member.name));
      if (found == instance.names.end() || member.section == Section::External || member.section == Section::InOut)
        continue;
      if (instance.block->isLibrary && instance.block->name == "__STEP" && member.section != Section::Output) continue;
      Variable seen = found->second;
      seen.offset = instance.placeFromOutside(found->first);
      nameVariable(at + "." + member.name, seen, other + "." + member.name);
    }
  };
  if (variable.instance != nullptr) return members(*variable.instance, name, alias);
  if (!variable.elements.empty()) {
    const std::int64_t low = variable.type->bounds[0].first;
    for (std::size_t i = 0; i < variable.elements.size(); ++i) {
      const std::string index = fmt::format("[{}]", low + static_cast<std::int64_t>(i));
      members(*variable.elements[i], name + index, alias + index);
    }
    return;
  }
  nameValue(name, *variable.type, variable.offset, alias);
}

void Lowering::nameVariables() {
  std::map<std::string, int> uses;
  for (const auto& [name, variable] : globals_) ++uses[name];
  for (const BlockInstance* program : programs_) {
    for (const VariableSyntax& variable : program->block->variables) {
      if (variable.section != Section::External) ++uses[foldedName(variable.name)];
    }
  }
  for (const VariableSyntax& variable : project_.globals) {
    const auto found = globals_.find(foldedName(variable.name));
    if (found != globals_.end()) nameVariable(variable.name, found->second, variable.name);
  }
  for (const BlockInstance* program : programs_) {
    for (const VariableSyntax& variable : program->block->variables) {
      const auto found = program->names.find(foldedName(variable.name));
      if (found == program->names.end() || variable.section == Section::External) continue;
      const std::string full = program->path + "." + variable.name;
      Variable seen = found->second;
      seen.offset = program->placeFromOutside(found->first);
      nameVariable(uses[foldedName(variable.name)] > 1 ? full : variable.name, seen, full);
    }
  }
  for (const auto& [name, function] : functions_) {
    for (const VariableSyntax& variable : function->block->variables) {
      const auto found = function->names.find(foldedName(variable.name));
      const std::string full = function->path + "." + variable.name;
      if (found != function->names.end() && variable.section != Section::External && variable.section != Section::InOut)
        nameVariable(full, found->second, full);
    }
  }
  for (const auto& [name, offset] : addressNames_) {
    const auto found = std::ranges::find(program_.symbols, offset, [](const Symbol& s) { return s.address.offset; });
    if (found == program_.symbols.end()) continue;
    const Operand place = found->address;
    program_.symbols.push_back({name, place, "", {}});
  }
}

/// Instructions name the variables, not their places.
void Lowering::nameOperands() {
  std::map<std::uint32_t, const Symbol*> first;
  for (const Symbol& symbol : program_.symbols) first.emplace(symbol.address.offset, &symbol);
  const auto give = [&](Operand& operand) {
    const auto symbol = first.find(operand.offset);
    if (operand.kind != OperandKind::Direct || symbol == first.end()) return;
    const auto meant = program_.valueTypes.find(operand.offset);
    if (meant == program_.valueTypes.end()) return;
    operand.text = symbol->second->name;
    operand.form = operand.width == Width::Bit          ? ConstantForm::Boolean
                   : meant->second == ValueType::Real   ? ConstantForm::Real
                   : meant->second == ValueType::Signed ? ConstantForm::SignedDecimal
                                                        : ConstantForm::Hex;
  };
  for (Pou& pou : program_.pous) {
    for (Network& network : pou.networks) {
      for (Instruction& instruction : network.instructions) {
        for (Operand& operand : instruction.operands) give(operand);
      }
    }
  }
  for (Symbol& symbol : program_.symbols) give(symbol.address);
}

}  // namespace rungproof::iec
