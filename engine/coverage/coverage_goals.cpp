// In the order of the program, measure by measure.
#include "engine/coverage/coverage_goals.hpp"

namespace rungproof {

std::string_view measureWord(Measure measure) {
  switch (measure) {
    case Measure::Networks: return "networks";
    case Measure::Contacts: return "contacts";
    case Measure::Transitions: return "transitions";
    case Measure::Mcdc: break;
  }
  return "mcdc";
}

std::string_view measureText(Measure measure) {
  return measure == Measure::Mcdc ? "MC/DC pairs" : measureWord(measure);
}

std::vector<CoverageItem> coverageItems(const CoverageRecorder& recorder) {
  const CoverageMap& map = recorder.map();
  std::vector<CoverageItem> items;
  const auto add = [&](Measure measure, std::size_t index, bool isCovered) {
    CoverageItem& item = items.emplace_back(CoverageItem{{measure, index}, isCovered, {}});
    if (!isCovered) item.open.push_back(item.first);
  };
  const auto addBoth = [&](CoverageGoal first, bool isCovered, const auto& isSeen) {
    CoverageItem& item = items.emplace_back(CoverageItem{first, isCovered, {}});
    for (const bool value : {false, true}) {
      first.value = value;
      if (!isCovered && !isSeen(value)) item.open.push_back(first);
    }
  };
  for (std::size_t i = 0; i < map.networks().size(); ++i) add(Measure::Networks, i, recorder.networkReached(i));
  for (std::size_t i = 0; i < map.leaves().size(); ++i) {
    if (map.leaves()[i].kind != LeafKind::Contact) continue;
    const auto isSeen = [&](bool value) { return recorder.contactSeen(i, value); };
    addBoth({Measure::Contacts, i}, isSeen(false) && isSeen(true), isSeen);
  }
  for (std::size_t i = 0; i < map.transitions().size(); ++i) add(Measure::Transitions, i, recorder.transitionTaken(i));
  for (std::size_t d = 0; d < map.decisions().size(); ++d) {
    const std::vector<std::uint32_t>& leaves = map.decisions()[d].leaves;
    for (std::size_t i = 0; i < leaves.size(); ++i) {
      if (map.leaves()[leaves[i]].kind != LeafKind::Contact) continue;
      const bool isCovered = recorder.pair(d, i) != PairState::None;
      addBoth({Measure::Mcdc, d, i}, isCovered, [&](bool value) { return recorder.conditionDecided(d, i, value); });
      // Beside an exclusive OR it may have decided as both, and both times the same.
      if (!isCovered && items.back().open.empty())
        items.back().open.push_back({Measure::Mcdc, d, i, !recorder.outcomeDecided(d, i, true), true});
    }
  }
  return items;
}

std::vector<CoverageGoal> openGoals(const CoverageRecorder& recorder, const std::set<Measure>& measures) {
  std::vector<CoverageGoal> goals;
  for (const CoverageItem& item : coverageItems(recorder)) {
    if (measures.contains(item.first.measure)) goals.insert(goals.end(), item.open.begin(), item.open.end());
  }
  return goals;
}

}  // namespace rungproof
