// Operands of SimaticML: <Access> by its scope, <Address>, <Indirect>, <Instance>, names by their components. Drawn
// networks and statement lists use the same. Part of frontend/flgnet. Tested by tests/step7/drawing_test.cpp,
// statement_list_xml_test.cpp.
#pragma once

#include <cstdint>
#include <optional>
#include <pugixml.hpp>
#include <string_view>

#include "frontend/step7/syntax.hpp"

namespace rungproof::flgnet {

/// The operand of an <Access>; nothing if it cannot be read.
std::optional<step7::Operand> accessFrom(const pugi::xml_node& access, Span span);

/// The block that OPN and block parameters name: an address of DB, DI, FC or FB without a place in it, or through a
/// pointer. Nothing if the access names none.
std::optional<step7::Operand> blockFrom(const pugi::xml_node& access, Span span);

/// The data that an <Instance> names: a data block, or a local name.
std::optional<step7::Operand> instanceFrom(const pugi::xml_node& instance, Span span);

/// A whole number without a sign; nothing if anything else stands there.
std::optional<std::uint32_t> numberIn(std::string_view text);

}  // namespace rungproof::flgnet
