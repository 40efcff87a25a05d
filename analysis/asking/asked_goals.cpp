// Goals, premises, and a run at all.
#include "analysis/asking/asked_goals.hpp"

#include "analysis/encoding/asked_properties.hpp"

namespace rungproof {

std::vector<Property> askedGoals(const PropertySet& set, bool mayEndNoScan) {
  std::vector<Property> goals;
  for (const Property& property : set.properties) {
    if (property.isGoal()) goals.push_back(property);
  }
  const std::size_t declared = goals.size();
  for (std::size_t i = 0; i < declared; ++i) {
    if (auto premise = premiseOf(goals[i])) goals.push_back(std::move(*premise));
  }
  const bool assumes = declared < set.properties.size();
  if (assumes || (declared > 0 && mayEndNoScan)) goals.push_back(someRun());
  return goals;
}

Property someRun() {
  Property property;
  property.kind = PropertyKind::Reach;
  property.name = "a run that comes to the end of a scan";
  ExprNode always;
  always.value = 1;
  property.first.nodes.push_back(always);
  layoutCells(property);
  return property;
}

}  // namespace rungproof
