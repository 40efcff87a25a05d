// Names that the editor of the S7-200 SMART writes instead of special memory and I/O addresses, so that its exports
// can be read without a symbol table. A symbol of the user with the same name wins.
// Tested by tests/reader/resolve_test.cpp.
#pragma once

#include <optional>
#include <string_view>

#include "ir/operand.hpp"

namespace rungproof {

/// Address of a system name such as Always_On (SM0.0) or CPU_Input3 (I0.3); nothing if there is none.
std::optional<Operand> systemSymbol(std::string_view name);

}  // namespace rungproof
