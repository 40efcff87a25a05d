// Names for places in structures of an S7-300/400, and what the machine code has in place of a type.
// Tested by tests/mc7/call_recovery_test.cpp.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "frontend/step7/syntax.hpp"
#include "ir/s7300/declaration.hpp"

namespace rungproof::mc7 {

using step7::Size;

/// Of the access to a value that fits an accumulator.
Size sizeOfType(const s7300::Type& type);
/// Complex types, POINTER and ANY.
bool isHandedByPointer(const s7300::Type& type);
/// "T", "C", "DB", "FC", "FB", "SDB" of parameters that are numbers; empty: it is none.
std::string_view numberKind(s7300::TypeKind kind);

/// The name of data in a structure that an access of that size at that place reaches whole: "a.b[2]".
std::optional<std::string> pathAt(const s7300::Structure& structure, Size size, std::uint32_t byte, unsigned bit);
/// The same of a part of any type that begins there, at the outermost level.
const s7300::Field* fieldAt(const s7300::Structure& structure, std::uint32_t byte, unsigned bit);
/// The name of the outermost part that begins at that byte and whose type is wanted: "a.b[2]".
std::optional<std::string> partAt(const s7300::Structure& structure, std::uint32_t byte,
                                  const std::function<bool(const s7300::Type&)>& isWanted);

}  // namespace rungproof::mc7
