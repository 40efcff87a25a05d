// What a reader looks up again and again, written beside it: the symbol of an address, the address of a symbol, the
// time that a preset stands for. Tested by tests/editor/inlay_hint_test.cpp.
#pragma once

#include "frontend/editor/checked_document.hpp"

namespace rungproof {

/// Hints between two places of the document.
Json inlayHintsIn(const CheckedDocument& document, ClientPlace begin, ClientPlace end);

/// "10 s", if the instruction is a box of an S7-200 timer with a constant preset; otherwise empty.
std::string presetTime(const Instruction& instruction);

}  // namespace rungproof
