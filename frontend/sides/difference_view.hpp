// A difference of programs as text, HTML and JSON. Tested by tests/golden/diff.
#pragma once

#include <string>

#include "frontend/sides/program_difference.hpp"

namespace rungproof {

struct DifferenceStyle {
  Form form = Form::Ladder;
  int width = 120;  ///< columns of text
  bool color = false;
};

std::string differenceText(const Sides& sides, const ProgramDifference& difference, const DifferenceStyle& style);
std::string differencePage(const Sides& sides, const ProgramDifference& difference, const DifferenceStyle& style);
std::string differenceJson(const Sides& sides, const ProgramDifference& difference);
/// "2 networks changed, 1 output can differ".
std::string closingLine(const ProgramDifference& difference);

}  // namespace rungproof
