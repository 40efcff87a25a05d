// Renaming a symbol, a local variable or a label at all of its places. Tested by tests/editor/rename_test.cpp.
#pragma once

#include <variant>

#include "frontend/editor/cursor.hpp"

namespace rungproof {

/// The range of the name at a place, as the client shows it before it asks for the new one; null if nothing there has a
/// name that can be changed.
Json renameRange(const CheckedDocument& document, ClientPlace place);

/// A WorkspaceEdit, or why the name cannot be given.
std::variant<Json, std::string> renameAt(const CheckedDocument& document, ClientPlace place, std::string_view name);

}  // namespace rungproof
