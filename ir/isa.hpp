// The instruction table without the meanings: look-ups by mnemonic and by number. Meanings are in ir/isa/*.hpp
// and reach the rest only through a domain's dispatch table (ir/dispatch.hpp).
#pragma once

#include <span>
#include <string_view>

#include "ir/desc.hpp"

namespace rungproof {

/// All instructions in the order of ir/isa_list.hpp; opcode is the index.
std::span<const Desc> instructionTable();
/// Exact international mnemonic in capitals ("LDW>="), or nullptr.
const Desc* instructionNamed(std::string_view mnemonic);
/// SIMATIC German mnemonic; falls back to the international one where both sets agree.
const Desc* instructionNamedGerman(std::string_view mnemonic);
/// Names that the manual's own examples misprint or take from the ladder boxes (MOV_B, STRCPY, S_R ...), or nullptr.
const Desc* instructionAlias(std::string_view mnemonic);

}  // namespace rungproof
