// The instructions of a dialect without their meanings: look-ups by mnemonic, and the instructions that belong together
// (the three ways a contact joins the logic, LD and LDN, S and R). A mnemonic is unique within its dialect only; the
// numbers of the instructions (Desc::opcode) are their places in the table. Forms are found once from the descriptors
// (role, type of the operands, relation, negated, immediate); two candidates for one place end the program.
// Tested by tests/ir/role_test.cpp and tests/ir/isa_table_test.cpp.
#pragma once

#include <array>
#include <mutex>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "ir/desc.hpp"

namespace rungproof {

class InstructionTable {
 public:
  /// Another name of an instruction: a misprint of the manual, a name of a ladder box.
  using Alias = std::pair<std::string_view, std::string_view>;
  InstructionTable(std::span<const Desc> rows, std::span<const Alias> aliases);

  std::span<const Desc> all() const { return rows_; }
  /// Exact international mnemonic in capitals ("LDW>="), or nullptr.
  const Desc* named(std::string_view mnemonic) const { return lookUp(international_, mnemonic); }
  /// SIMATIC German mnemonic; falls back to the international one where both sets agree.
  const Desc* namedGerman(std::string_view mnemonic) const;
  /// The instruction that an alias stands for, or nullptr.
  const Desc* alias(std::string_view mnemonic) const;

  /// The contact of a bit that joins so (Load, And or Or): LD, AN, OI.
  const Desc& bitContact(Role joint, bool negated = false, bool immediate = false) const;
  /// The only instruction of a role that has no further forms: NOT, ALD, LPS, AENO. For = see plainAssign.
  const Desc& only(Role role) const;
  /// CALL, JMP and other instructions that move the flow.
  const Desc& only(Control control) const;
  /// = : the assignment to the image.
  const Desc& plainAssign() const { return *forms().plainAssign; }

  /// LDW>= for AW>= with Role::Load, OI for LDI with Role::Or; nullptr if `contact` is none.
  const Desc* joinedForm(const Desc& contact, Role joint) const;
  /// LDN for LD, OI for ONI; nullptr if there is none, as for compare contacts.
  const Desc* negatedForm(const Desc& contact) const { return forms().of[contact.opcode].negated; }
  /// R for S, ED for EU, TOF for TON, with the same immediate form (oppositeOf); nullptr if there is none.
  const Desc* oppositeForm(const Desc& desc) const { return forms().of[desc.opcode].opposite; }

 private:
  /// Mnemonics sorted for binary search, each with its descriptor.
  using Index = std::vector<std::pair<std::string_view, const Desc*>>;
  struct FormsOfOne {
    const Desc* load = nullptr;
    const Desc* conjunction = nullptr;
    const Desc* disjunction = nullptr;
    const Desc* negated = nullptr;
    const Desc* opposite = nullptr;
  };
  struct Forms {
    std::vector<FormsOfOne> of;  ///< by opcode
    std::array<const Desc*, 12> bitContacts{};
    const Desc* plainAssign = nullptr;
  };

  Index indexBy(std::string_view Desc::*name) const;
  static const Desc* lookUp(const Index& index, std::string_view name);
  FormsOfOne formsOf(const Desc& desc) const;
  Forms makeForms() const;
  /// Made when they are asked for the first time: most runs need none.
  const Forms& forms() const {
    std::call_once(formsAreMade_, [&] { forms_ = makeForms(); });
    return forms_;
  }

  std::span<const Desc> rows_;
  std::span<const Alias> aliases_;
  Index international_, german_;
  mutable std::once_flag formsAreMade_;
  mutable Forms forms_;
};

}  // namespace rungproof
