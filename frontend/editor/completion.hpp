// What may stand at a place: mnemonics of the CPU at the beginning of a line; addresses, symbols, blocks and labels
// that fit an operand behind one; words of the property language in `//@` lines and property files; codes of rules in
// suppressions. Tested by tests/editor/completion_test.cpp.
#pragma once

#include "frontend/editor/checked_document.hpp"

namespace rungproof {

Json completionsAt(const CheckedDocument& document, ClientPlace place);

}  // namespace rungproof
