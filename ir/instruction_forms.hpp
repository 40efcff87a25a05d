// Instructions that belong together: the three ways a contact joins the stack, LD and LDN, S and R. Found once from the
// descriptors (role, type of the operands, relation, negated, immediate); two candidates for one place end the program.
// Tested by tests/ir/role_test.cpp.
#pragma once

#include "ir/desc.hpp"

namespace rungproof {

/// The contact of a bit that joins so (Load, And or Or): LD, AN, OI.
const Desc& bitContact(Role joint, bool negated = false, bool immediate = false);
/// The only instruction of a role that has no further forms: NOT, ALD, LPS, AENO. For = see plainAssign.
const Desc& instructionOf(Role role);
/// = : the assignment to the image.
const Desc& plainAssign();
/// CALL, JMP and other instructions that move the flow.
const Desc& instructionOf(Control control);

/// LDW>= for AW>= with Role::Load, OI for LDI with Role::Or; nullptr if `contact` is none.
const Desc* joinedForm(const Desc& contact, Role joint);
/// LDN for LD, OI for ONI; nullptr if there is none, as for compare contacts.
const Desc* negatedForm(const Desc& contact);
/// R for S, ED for EU, TOF for TON, with the same immediate form (oppositeOf); nullptr if there is none.
const Desc* oppositeForm(const Desc& desc);

}  // namespace rungproof
