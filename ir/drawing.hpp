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
#include <memory>
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

/// What a box shows that no descriptor knows: a function or a function block of IEC 61131-3 with the pins drawn at it.
struct BoxFace {
  /// A pin with a text beside it.
  struct Pin {
    std::string name;
    std::string text;
    bool isConstant = false;
    Span span{};                                ///< of the text
    std::uint32_t instruction = noInstruction;  ///< as Element::instruction: it reads or writes the value
  };
  std::string name;
  std::string instance;             ///< above the box; empty: a function
  std::vector<std::string> inputs;  ///< of Element::inputs: names of their pins
  std::vector<Pin> left, right;
  std::string output;  ///< name of the pin that a wire leaves; empty: none does
};

struct Element {
  Shape shape = Shape::Rail;
  const Desc* desc = nullptr;
  Operands operands;                    ///< as in the instruction
  std::vector<Wire> inputs;             ///< topmost first
  Span span;                            ///< place in the source
  /// Position in Network::instructions of the instruction that is this element; of a gate, of the last that joins its
  /// inputs. noInstruction: a rail, or not lowered yet.
  std::uint32_t instruction = noInstruction;
  std::shared_ptr<const BoxFace> face{};  ///< of a Box without desc
};

/// Elements in order of execution: an input refers to an earlier element only. One drawing is one network.
struct Drawing {
  std::vector<Element> elements;
  /// IEC 61131-3: elements name variables and parts of instances, and Element::instruction is where the value of the
  /// element lies on the evaluation stack, of a Coil where it is stored.
  bool isOfVariables = false;
};

}  // namespace rungproof
