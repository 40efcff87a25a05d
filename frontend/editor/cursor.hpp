// What stands at a place of a document: an instruction, one of its operands, the heading of a network, an address in a
// property, a row of a symbol table. Tested through tests/editor/hover_test.cpp and navigation_test.cpp.
#pragma once

#include <optional>
#include <string_view>

#include "frontend/editor/checked_document.hpp"

namespace rungproof {

struct Cursor {
  const Pou* pou = nullptr;
  const Network* network = nullptr;
  const Instruction* instruction = nullptr;
  std::optional<Operand> operand;  ///< of the instruction, of a property, or the address of the symbol's row
  int operandIndex = -1;           ///< in the instruction
  bool isMnemonic = false;
  bool isHeading = false;  ///< the line on which the network begins
  Span span;               ///< of what was found

  bool isNothing() const { return !operand && !isMnemonic && !isHeading; }
  /// Subroutine, Interrupt or Label if the operand is the number of one.
  std::optional<Type> routine() const;
};

Cursor cursorAt(const CheckedDocument& document, std::uint32_t offset);

/// S7-300/400: the parameter or variable of its block that #name means, or nullptr.
const LocalVariable* localAt(const CheckedDocument& document, const Cursor& cursor);
/// What the block does with the local data that the operand is.
std::vector<const Access*> usesOfLocal(const CheckedDocument& document, const Cursor& cursor);

/// Label, Subroutine or Interrupt if that operand of the instruction is the number of one.
std::optional<Type> routineType(const Instruction& instruction, std::size_t operand);

}  // namespace rungproof
