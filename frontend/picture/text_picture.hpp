// A picture as lines of text: box-drawing characters, or plain ASCII. Wires with power are heavy (═ in ASCII '='),
// closed contacts are filled; on a terminal both are green as well. Tested by tests/show/rendering_test.cpp.
#pragma once

#include <string>
#include <vector>

#include "frontend/picture/picture.hpp"

namespace rungproof {

struct TextStyle {
  bool ascii = false;
  bool color = false;
};

/// One string for each row, without blanks at its end.
std::vector<std::string> textLines(const Picture& picture, const TextStyle& style);

}  // namespace rungproof
