// Pieces of STEP 7 text that stand in attributes of SimaticML: operands, constants, types. They are read as in a source
// and get the place of the element that holds them. Part of frontend/flgnet.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "frontend/step7/syntax.hpp"

namespace rungproof::flgnet {

/// "M0.0", "DB10.DBW 2", "S5T#2S", "W#16#FF"; nothing if the text is no operand.
std::optional<step7::Operand> operandFrom(std::string_view text, Span span);
/// A constant as SimaticML writes it, "5" of a DInt as L#5; nothing if it is none of that type.
std::optional<step7::Operand> constantFrom(std::string_view type, std::string_view text, Span span);
/// "Int", "Array[0..9] of Bool", "\"Recipe\""; nullptr if the text is no type.
std::shared_ptr<const step7::TypeSyntax> typeFrom(std::string_view text, Span span);
/// "a.b[2]" behind a name, as steps.
std::optional<std::vector<step7::PathStep>> pathFrom(std::string_view text, Span span);

}  // namespace rungproof::flgnet
