// Codes of run-time errors that GERR gives (table C-2, 001:13945-13973, and what the S7-200 SMART adds). Which one it
// gives after several errors stands in no text: proofs take any code, `sim` the error that came last for the first
// time. Tested by tests/smart/error_code_test.cpp.
#pragma once

#include <array>
#include <cstdint>
#include <utility>

#include "ir/desc.hpp"

namespace rungproof {

/// Ranges of codes, first and last.
inline constexpr std::array<std::pair<std::uint16_t, std::uint16_t>, 4> errorCodes = {
    {{0x0001, 0x001C}, {0x0090, 0x0092}, {0x0098, 0x0098}, {0x009A, 0x009B}}};
/// A pointer that is not legal: what stands for a value that is no code.
inline constexpr std::uint16_t badPointerCode = 0x0006;
/// ExternalSite::index of the code.
inline constexpr std::uint32_t errorCodeIndex = 0x6E00;

/// Whether the instruction reads SM4.3, and with it every error of the program, without an operand that says so.
bool readsErrorStatus(const Desc& desc);

}  // namespace rungproof
