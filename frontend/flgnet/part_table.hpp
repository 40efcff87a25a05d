// What the parts of SimaticML networks are: a box of ladder and FBD of the S7-300/400 with its type, an element of bit
// logic, a comparison, an IEC block. Pins as the editor names them (general knowledge). A part that stands in none of
// the tables is not known. Compared with the table of boxes by tests/step7/drawing_test.cpp.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "ir/s7300/fbd_box.hpp"

namespace rungproof::flgnet {

/// Elements that work on the flow.
enum class Element : std::uint8_t {
  None,
  Contact,      ///< in, operand
  EdgeContact,  ///< in, operand, bit
  Not,          ///< in
  EdgeBox,      ///< in, bit
  And,          ///< in1 ...
  Or,
  Xor,
  Coil,  ///< in, operand
  SetCoil,
  ResetCoil,
  EdgeCoil,  ///< in, operand, bit
  SetReset,  ///< s, r1, operand: reset wins
  ResetSet,  ///< r, s1, operand: set wins
  Jump,      ///< in, label
  JumpNot,
  Return
};

struct ElementPart {
  std::string_view part;
  Element element;
  std::string_view box;    ///< its row in the table of boxes
  bool isFalling = false;  ///< of an edge
};
std::span<const ElementPart> elementParts();
const ElementPart* elementPart(std::string_view part);

/// A box with a type: "Add" of "Int" is ADD_I; "Convert" of "Int>DInt" is I_DI.
struct BoxPart {
  std::string_view part, type, box;
};
std::span<const BoxPart> boxParts();
/// nullptr: no such part, or not of that type.
const s7300::FbdBox* boxOf(std::string_view part, std::string_view type);
bool isBoxPart(std::string_view part);

/// "==", ">=" for Eq, Ge; empty: no comparison.
std::string_view relationOf(std::string_view part);
/// "I", "D", "R" of the types that are compared; empty: another type.
std::string_view compareSuffix(std::string_view type);
/// "SFB 4" for TON; empty: no IEC block.
std::string_view iecBlock(std::string_view part);
/// The pins of an IEC block that the flow takes where none is named: "in" and "q", "cu" and "qu".
std::string_view iecFlowInput(std::string_view part);
std::string_view iecFlowOutput(std::string_view part);

}  // namespace rungproof::flgnet
