// The page of an instruction, from its descriptor: mnemonics, operands with their areas and ranges, effect on the
// stack.
#pragma once

#include <string>

#include "frontend/files/json.hpp"
#include "frontend/text/excerpt.hpp"
#include "ir/desc.hpp"

namespace rungproof {

std::string instructionPage(const Desc& desc, const Paint& paint);
Json instructionJson(const Desc& desc);
/// "I, Q, V, constant": the areas and forms of an operand.
std::string formsText(Forms forms);

}  // namespace rungproof
