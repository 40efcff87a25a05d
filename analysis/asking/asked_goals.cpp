// Goals, premises, and a run at all.
#include "analysis/asking/asked_goals.hpp"

#include "analysis/encoding/asked_properties.hpp"

namespace rungproof {

std::vector<Property> askedGoals(const PropertySet& set) {
  std::vector<Property> goals;
  for (const Property& property : set.properties) {
    if (property.isGoal()) goals.push_back(property);
  }
  const std::size_t declared = goals.size();
  for (std::size_t i = 0; i < declared; ++i) {
    if (auto premise = premiseOf(goals[i])) goals.push_back(std::move(*premise));
  }
  if (declared < set.properties.size()) goals.push_back(someRun());
  return goals;
}

Property someRun() {
  Property property;
  property.kind = PropertyKind::Reach;
  property.name = "a run that meets the assumptions";
  ExprNode always;
  always.value = 1;
  property.first.nodes.push_back(always);
  layoutCells(property);
  return property;
}

}  // namespace rungproof
