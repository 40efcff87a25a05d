// SFC bodies of PLCopen TC6 XML to charts: the lines between steps and transitions, with their divergences and
// convergences, become the steps in front of and behind each transition. Tested by tests/iec/chart_xml_test.cpp.
#pragma once

#include <pugixml.hpp>

#include "frontend/graphical/drawn_model.hpp"
#include "frontend/iec/iec_chart.hpp"

namespace rungproof::iec {

/// What the reader of a file does for its charts.
class PlcopenBodies {
 public:
  virtual ~PlcopenBodies() = default;
  virtual Span placeOf(const pugi::xml_node& node) const = 0;
  virtual void report(const pugi::xml_node& node, Syntax code, std::string message) = 0;
  /// The statements of a body with one language; what they need beside becomes a variable of the block.
  virtual Statements statementsOf(const pugi::xml_node& body, BlockSyntax& block) = 0;
  /// The expression that is all of the text of an element; nullptr with an error.
  virtual ExprPtr expressionOf(const pugi::xml_node& node) = 0;
  /// The expression of an attribute.
  virtual ExprPtr expressionOf(const std::string& text, const pugi::xml_node& at) = 0;
  /// The elements of LD and FBD in a body, and their statements.
  virtual DrawnNetwork networkOf(const pugi::xml_node& body) = 0;
  virtual Statements statementsOf(const DrawnNetwork& network, BlockSyntax& block) = 0;
};

/// `sfc`: the element <SFC>; `pou`: the block, which holds the named actions and transitions.
ChartSyntax readPlcopenChart(PlcopenBodies& bodies, const pugi::xml_node& sfc, const pugi::xml_node& pou,
                             BlockSyntax& block);

}  // namespace rungproof::iec
