// What an address or a name means in a program of an S7-300/400, for properties, stimuli and command lines:
// I0.0, E0.0, DB10.DBW2, "Motor".list[2].x, Motor.Speed, T5, PIW256. Tested by tests/step7/project_test.cpp.
#pragma once

#include <optional>
#include <string_view>

#include "ir/program.hpp"

namespace rungproof::step7 {

/// An address that no program has to know, in either set of mnemonics: MB100, DB10.DBW2, T5, EW4.
std::optional<rungproof::Operand> addressNamed(std::string_view text);
std::optional<rungproof::Operand> placeNamed(const Program& program, std::string_view text);

}  // namespace rungproof::step7
