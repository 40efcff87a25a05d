// From a drawing to stack instructions: contacts in series and parallel to LD, A, O, ALD, OLD, branches to LPS, LRD,
// LPP, inputs of boxes to stack levels (first input deepest), ENO chains to AENO. What does not fit the nine levels,
// or branches in a way that the stack cannot follow, passes through bits in L60.0 to L63.7, which are set aside for
// the editor (001:1362-1364); flow inputs of CALL always do (001:6809, 001:10223-10238).
//
// The result does exactly what the drawing does when its elements are executed one after the other. A drawing that
// cannot be expressed is refused with a reason. Tested by tests/drawing/lower_test.cpp and round_trip_test.cpp.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "ir/drawing.hpp"
#include "ir/program.hpp"

namespace rungproof {

/// A set of the 32 bits L60.0 (bit 0) to L63.7 (bit 31).
using EditorBits = std::uint32_t;
constexpr EditorBits editorBit(unsigned byte, unsigned bit) { return 1U << ((byte - 60) * 8 + bit); }
/// Bits of L60 to L63 that operands of the block name: not free for lowering its drawings.
EditorBits editorBitsUsed(const Pou& pou);
EditorBits editorBitsUsed(const Drawing& drawing);

/// Why a drawing could not be lowered: the element concerned and one sentence for a finding.
struct LoweringFault {
  std::uint32_t element = 0;
  std::string message;
};

struct Lowered {
  std::vector<Instruction> instructions;     ///< without ids; operands keep their spans
  std::vector<std::uint32_t> instructionOf;  ///< by element: Element::instruction
  std::optional<LoweringFault> fault;        ///< then there are no instructions
  bool usesEditorBits = false;               ///< passes values through L60 to L63 other than for CALL
};

/// `taken`: bits of L60-L63 that must not be used.
Lowered lower(const Drawing& drawing, EditorBits taken = 0);

/// Lowers into a network: sets its instructions and its drawing. A fault leaves the network as it was.
std::optional<LoweringFault> lowerInto(Network& network, Drawing drawing, EditorBits taken = 0);

}  // namespace rungproof
