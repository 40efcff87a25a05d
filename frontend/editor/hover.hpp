// What the editor shows of the thing below the pointer, as Markdown: the page of an instruction with the limits of the
// CPU, an address with its symbol, its writers and readers, the picture of a network. Tested by
// tests/editor/hover_test.cpp.
#pragma once

#include "frontend/editor/cursor.hpp"

namespace rungproof {

/// Null if there is nothing to say.
Json hoverAt(const CheckedDocument& document, ClientPlace place);

}  // namespace rungproof
