// A network as it is drawn: elements joined by power flow, before it becomes stack instructions or after it was
// recovered from them. The readers of graphical files build one and have it lowered; STL networks are raised to one
// to be shown or converted. An element is an instruction of the table, so nothing about instructions is said twice.
//
// Both directions between drawings and instructions: analysis/drawing/lower.hpp and analysis/drawing/raise.hpp.
//
// Ladder and FBD are two ways of drawing the same structure: a Contact with one input stands in series with what is on
// its left, an Or joins branches, an And is the FBD gate. A Rail is power itself (ladder) or the constant 1 (FBD).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ir/program.hpp"

namespace rungproof {

/// A power input of an element: the element that feeds it, and whether a negation circle sits on the pin.
struct Wire {
  std::uint32_t from = 0;  ///< index of an earlier element
  bool negated = false;
};

enum class Shape : std::uint8_t {
  Rail,     ///< no inputs; output 1
  Contact,  ///< one input; output: input and what the contact finds. desc: the load form (LD, LDN, LDI, LDW>=); for
            ///< EU, ED, NOT the instruction itself, which transforms its input
  And,      ///< two inputs or more; no desc
  Or,       ///< two inputs or more; no desc
  Box,      ///< an instruction with power inputs in the manual's order, top first (EN; or IN; or CU, CD, R; S, R);
            ///< output: ENO where desc->eno, the power output where the box has one (SR, RS, IEC boxes), else none.
            ///< CALL: behind EN one input for each parameter operand of kind Missing, in order (001:6805-6809)
  Coil      ///< one input, no output: =, S, R, their immediate forms, and JMP, END, SCRT, CRET and the like; also the
            ///< headings without input LBL, LSCR, SCRE, NEXT
};

inline constexpr std::uint32_t noInstruction = 0xFFFFFFFF;

struct Element {
  Shape shape = Shape::Rail;
  const Desc* desc = nullptr;
  Operands operands;         ///< as in the instruction
  std::vector<Wire> inputs;  ///< topmost first
  Span span;                 ///< place in the source
  /// Position in Network::instructions of the instruction that is this element; of a gate, of the last that joins its
  /// inputs. noInstruction: a rail, or not lowered yet.
  std::uint32_t instruction = noInstruction;
};

/// Elements in order of execution: an input refers to an earlier element only. One drawing is one network.
struct Drawing {
  std::vector<Element> elements;
};

}  // namespace rungproof
