// The drawing of a network that `rungproof show` makes. Tested by tests/editor/hover_test.cpp.
#pragma once

#include "frontend/editor/checked_document.hpp"

namespace rungproof {

struct EditorPicture {
  std::string heading;  ///< "MAIN, Network 3"
  std::string text, svg;
};
EditorPicture pictureOf(const CheckedDocument& document, const Pou& pou, const Network& network,
                         Form form = Form::Ladder);

}  // namespace rungproof
