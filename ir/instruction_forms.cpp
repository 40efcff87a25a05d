// Finds the forms of every instruction once, by opcode.
#include "ir/instruction_forms.hpp"

#include <vector>

#include "ir/check.hpp"
#include "ir/isa.hpp"

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

const Desc* formLike(const Desc& like, const FormKey& key) {
  const Desc* found = nullptr;
  for (const Desc& desc : instructionTable()) {
    if (!key.fits(desc, like)) continue;
    CHECK(found == nullptr, "two instructions for one form");
    found = &desc;
  }
  return found;
}

struct InstructionForms {
  const Desc* load = nullptr;
  const Desc* conjunction = nullptr;
  const Desc* disjunction = nullptr;
  const Desc* negated = nullptr;
  const Desc* opposite = nullptr;
};

std::vector<InstructionForms> makeForms() {
  std::vector<InstructionForms> table(instructionTable().size());
  for (const Desc& desc : instructionTable()) {
    InstructionForms& forms = table[desc.opcode];
    if (const std::optional<Role> opposite = oppositeOf(desc.role))
      forms.opposite = formLike(desc, {*opposite, desc.negated, desc.immediate});
    if (!isContact(desc.role)) continue;
    forms.load = formLike(desc, {Role::Load, desc.negated, desc.immediate});
    forms.conjunction = formLike(desc, {Role::And, desc.negated, desc.immediate});
    forms.disjunction = formLike(desc, {Role::Or, desc.negated, desc.immediate});
    forms.negated = formLike(desc, {desc.role, !desc.negated, desc.immediate});
    CHECK(forms.load != nullptr && forms.conjunction != nullptr && forms.disjunction != nullptr,
          "every contact has three forms");
  }
  return table;
}

const InstructionForms& formsOf(const Desc& desc) {
  static const std::vector<InstructionForms> table = makeForms();
  return table[desc.opcode];
}

/// The one instruction that `isWanted`.
template <class Wanted>
const Desc& onlyOne(Wanted isWanted) {
  const Desc* found = nullptr;
  for (const Desc& desc : instructionTable()) {
    if (!isWanted(desc)) continue;
    CHECK(found == nullptr, "the instruction is not the only one");
    found = &desc;
  }
  CHECK(found != nullptr, "no such instruction");
  return *found;
}

}  // namespace

const Desc& bitContact(Role joint, bool negated, bool immediate) {
  static const std::vector<const Desc*> table = [] {
    std::vector<const Desc*> rows;
    for (const Role role : {Role::Load, Role::And, Role::Or}) {
      for (int form = 0; form < 4; ++form) {
        rows.push_back(&onlyOne([&](const Desc& desc) {
          return desc.role == role && desc.execution == Execution::Stack && desc.negated == ((form & 1) != 0) &&
                 desc.immediate == ((form & 2) != 0);
        }));
      }
    }
    return rows;
  }();
  CHECK(isContact(joint), "a contact loads, ANDs or ORs");
  const auto row = static_cast<std::size_t>(joint) - static_cast<std::size_t>(Role::Load);
  return *table[row * 4 + (negated ? 1U : 0U) + (immediate ? 2U : 0U)];
}

const Desc& instructionOf(Role role) {
  return onlyOne([&](const Desc& desc) { return desc.role == role; });
}

const Desc& plainAssign() {
  static const Desc& assign = onlyOne([](const Desc& desc) { return isPlainCoil(desc); });
  return assign;
}

const Desc& instructionOf(Control control) {
  return onlyOne([&](const Desc& desc) { return desc.control == control; });
}

const Desc* joinedForm(const Desc& contact, Role joint) {
  const InstructionForms& forms = formsOf(contact);
  return joint == Role::Load ? forms.load : joint == Role::And ? forms.conjunction : forms.disjunction;
}

const Desc* negatedForm(const Desc& contact) { return formsOf(contact).negated; }

const Desc* oppositeForm(const Desc& desc) { return formsOf(desc).opposite; }

}  // namespace rungproof
