// A difference of programs as text, HTML, SVG and JSON. Tested by tests/golden/diff.
#pragma once

#include <string>

#include "frontend/picture/network_view.hpp"
#include "frontend/sides/program_difference.hpp"

namespace rungproof {

struct DifferenceStyle {
  Form form = Form::Ladder;
  int width = 120;  ///< columns of text
  bool color = false;
};

std::string differenceText(const Sides& sides, const ProgramDifference& difference, const DifferenceStyle& style);
/// As a page and as one picture: difference_page.cpp.
std::string differencePage(const Sides& sides, const ProgramDifference& difference, const DifferenceStyle& style);
std::string differencePicture(const Sides& sides, const ProgramDifference& difference, const DifferenceStyle& style);
std::string differenceJson(const Sides& sides, const ProgramDifference& difference);
/// With which values the programs begin, where that differs.
std::vector<std::string> valueLines(const ProgramDifference& difference);
/// "2 networks changed, 1 output can differ".
std::string closingLine(const ProgramDifference& difference);

/// "MAIN, Network 2  Lamp: changed".
std::string changeHeading(const Sides& sides, const NetworkPair& pair);
/// "OLD  press.awl:12".
std::string sideHeading(const Sides& sides, const NetworkPair& pair, bool isOld);
/// A network as wide as half a page.
NetworkView changedView(const Program& program, const NetworkRef& where, const DifferenceStyle& style);
/// What a change can influence; of outputs with their verdict.
struct InfluenceLine {
  std::string text;
  std::optional<Equality> verdict;
};
std::vector<InfluenceLine> influenceLines(const NetworkChange& change);

}  // namespace rungproof
