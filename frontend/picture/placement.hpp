// The layout: nodes to a picture. Columns follow the flow of power from left to right; a node stands in the column
// behind its last input. A chain of first inputs shares a row; every further branch goes to the highest row below it
// that is free over the columns it needs. Branches are placed in the order in which they are executed, so wires never
// cross in a network of series and parallel parts; where they would, the layout gives up with a reason. Tested by
// tests/show/layout_test.cpp.
#pragma once

#include <string>

#include "frontend/picture/plan_nodes.hpp"

namespace rungproof {

/// Columns of a ladder, rails included, and of the last strip of a wrapped one, where the page has them: coils of all
/// networks stand below each other.
inline constexpr int usualWidth = 72;

struct PlacedPicture {
  Picture picture;
  std::string reason;  ///< why there is no picture; empty: there is one
};

/// `page`: columns of the page.
PlacedPicture place(const PlanNodes& plan, int page = usualWidth);

}  // namespace rungproof
