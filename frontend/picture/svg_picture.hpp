// A picture as SVG, in the look of the editor: thin black wires on white, blue where power flows. A fragment stands in
// a page with others; the page brings the style sheet once. Tested by tests/show/rendering_test.cpp.
#pragma once

#include <string>
#include <string_view>

#include "frontend/picture/picture.hpp"

namespace rungproof {

/// SVG user units (about a pixel) of a cell.
inline constexpr int svgCellWidth = 8, svgRowHeight = 18;

/// Rules for the classes of fragments; to stand in a <style> element.
std::string_view svgStyle();

/// Appends the elements of the picture, its left upper corner at (x, y).
void appendSvg(std::string& svg, const Picture& picture, int x, int y);

/// Appends a line of text; `className` may be empty.
void appendSvgText(std::string& svg, int x, int y, std::string_view text, std::string_view className);

}  // namespace rungproof
