// Indexes of a dialect's instructions, made once.
#include "ir/instruction_table.hpp"

#include <algorithm>

#include "ir/check.hpp"

namespace rungproof {

namespace {

/// What tells the instructions of one role apart.
struct FormKey {
  Role role;
  bool negated, immediate;

  bool fits(const Desc& wanted, const Desc& like) const {
    return wanted.role == role && wanted.negated == negated && wanted.immediate == immediate &&
           wanted.execution == like.execution && wanted.relation == like.relation &&
           wanted.operandCount == like.operandCount &&
           (like.operandCount == 0 || wanted.operands[0].type == like.operands[0].type);
  }
};

const Desc* formLike(std::span<const Desc> rows, const Desc& like, const FormKey& key) {
  const Desc* found = nullptr;
  for (const Desc& desc : rows) {
    if (!key.fits(desc, like)) continue;
    CHECK(found == nullptr, "two instructions for one form");
    found = &desc;
  }
  return found;
}

/// The one instruction that `isWanted`.
template <class Wanted>
const Desc& onlyOne(std::span<const Desc> rows, Wanted isWanted) {
  const Desc* found = nullptr;
  for (const Desc& desc : rows) {
    if (!isWanted(desc)) continue;
    CHECK(found == nullptr, "the instruction is not the only one");
    found = &desc;
  }
  CHECK(found != nullptr, "no such instruction");
  return *found;
}

std::size_t contactRow(Role joint, bool negated, bool immediate) {
  CHECK(isContact(joint), "a contact loads, ANDs or ORs");
  const auto row = static_cast<std::size_t>(joint) - static_cast<std::size_t>(Role::Load);
  return row * 4 + (negated ? 1U : 0U) + (immediate ? 2U : 0U);
}

}  // namespace

InstructionTable::InstructionTable(std::span<const Desc> rows, std::span<const Alias> aliases)
    : rows_(rows), aliases_(aliases), international_(indexBy(&Desc::stl)), german_(indexBy(&Desc::german)) {}

InstructionTable::Index InstructionTable::indexBy(std::string_view Desc::*name) const {
  Index index;
  for (const Desc& desc : rows_) {
    if (!(desc.*name).empty()) index.emplace_back(desc.*name, &desc);
  }
  std::sort(index.begin(), index.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  return index;
}

const Desc* InstructionTable::lookUp(const Index& index, std::string_view name) {
  if (name.empty()) return nullptr;
  // Most entries differ in their first character, which is compared without a call.
  const auto first = static_cast<unsigned char>(name.front());
  const auto isBefore = [first](const auto& entry, std::string_view key) {
    const auto own = static_cast<unsigned char>(entry.first.front());
    return own != first ? own < first : entry.first < key;
  };
  const auto found = std::lower_bound(index.begin(), index.end(), name, isBefore);
  return found != index.end() && found->first == name ? found->second : nullptr;
}

const Desc* InstructionTable::namedGerman(std::string_view mnemonic) const {
  const Desc* desc = lookUp(german_, mnemonic);
  return desc != nullptr ? desc : named(mnemonic);
}

const Desc* InstructionTable::alias(std::string_view mnemonic) const {
  for (const auto& [alias, name] : aliases_) {
    if (alias == mnemonic) return named(name);
  }
  return nullptr;
}

InstructionTable::FormsOfOne InstructionTable::formsOf(const Desc& desc) const {
  FormsOfOne forms;
  if (const std::optional<Role> opposite = oppositeOf(desc.role))
    forms.opposite = formLike(rows_, desc, {*opposite, desc.negated, desc.immediate});
  if (!isContact(desc.role)) {
    const std::string name(desc.stl);
    forms.negated = desc.negated ? named(name.substr(0, name.size() - 1)) : named(name + "N");
    if (forms.negated != nullptr && (isContact(forms.negated->role) || forms.negated->negated == desc.negated))
      forms.negated = nullptr;
    return forms;
  }
  forms.load = formLike(rows_, desc, {Role::Load, desc.negated, desc.immediate});
  forms.conjunction = formLike(rows_, desc, {Role::And, desc.negated, desc.immediate});
  forms.disjunction = formLike(rows_, desc, {Role::Or, desc.negated, desc.immediate});
  forms.negated = formLike(rows_, desc, {desc.role, !desc.negated, desc.immediate});
  CHECK(forms.load != nullptr && forms.conjunction != nullptr && forms.disjunction != nullptr,
        "every contact has three forms");
  return forms;
}

InstructionTable::Forms InstructionTable::makeForms() const {
  Forms forms;
  forms.of.resize(rows_.size());
  for (const Desc& desc : rows_) forms.of[desc.opcode] = formsOf(desc);
  forms.plainAssign = &onlyOne(rows_, [](const Desc& desc) { return isPlainCoil(desc); });
  // An S7-300/400 checks bits with A, O and X, whatever stands before them.
  const bool hasContacts = std::ranges::any_of(rows_, [](const Desc& desc) { return isContact(desc.role); });
  if (!hasContacts) return forms;
  for (const Role joint : {Role::Load, Role::And, Role::Or}) {
    for (const bool negated : {false, true}) {
      for (const bool immediate : {false, true}) {
        forms.bitContacts[contactRow(joint, negated, immediate)] = &onlyOne(rows_, [&](const Desc& desc) {
          return desc.role == joint && desc.execution == Execution::Stack && desc.negated == negated &&
                 desc.immediate == immediate;
        });
      }
    }
  }
  return forms;
}

const Desc& InstructionTable::bitContact(Role joint, bool negated, bool immediate) const {
  const Desc* contact = forms().bitContacts[contactRow(joint, negated, immediate)];
  CHECK(contact != nullptr, "the dialect has contacts");
  return *contact;
}

const Desc& InstructionTable::only(Role role) const {
  return onlyOne(rows_, [&](const Desc& desc) { return desc.role == role; });
}

const Desc& InstructionTable::only(Control control) const {
  return onlyOne(rows_, [&](const Desc& desc) { return desc.control == control; });
}

const Desc* InstructionTable::joinedForm(const Desc& contact, Role joint) const {
  const FormsOfOne& forms = this->forms().of[contact.opcode];
  return joint == Role::Load ? forms.load : joint == Role::And ? forms.conjunction : forms.disjunction;
}

}  // namespace rungproof
