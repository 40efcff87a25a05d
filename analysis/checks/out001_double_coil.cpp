// OUT001: two coils on one bit. Both run in one scan unless jumps, steps or conditional calls keep them apart; where
// that cannot be excluded the finding is unconfirmed until the prover has seen both run.
// Tested by its examples and tests/rules/output_rules_test.cpp.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "analysis/asking/asking.hpp"
#include "analysis/flow/facts.hpp"
#include "analysis/flow/step7_blocks.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

constexpr std::size_t mostRelated = 8;

/// Whether the instruction runs in every scan.
bool runsAlways(const Facts& facts, std::uint32_t id) {
  const ExecutionPoint& point = facts.execution().at(id);
  return point.isReachable && !point.isSkipped && facts.execution().runs(facts.blockOf(id)) == Runs::Once;
}

/// Whether jumps and block ends let a scan run one of them at most.
bool excludeEachOther(const Facts& facts, std::span<const std::uint32_t> coils) {
  for (std::size_t i = 0; i < std::min(coils.size(), mostRelated); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if (mayRunInOneScan(facts, coils[i], coils[k])) return false;
    }
  }
  return coils.size() <= mostRelated;
}

void checkOut001(const Facts& facts, FindingSink& sink) {
  std::vector<bool> isIdle;  // by block
  for (std::uint32_t block = 0; block < facts.program().pous.size(); ++block)
    isIdle.push_back(facts.execution().runs(block) == Runs::Never || facts.calls().isStartUpOnly(block));
  std::vector<std::uint32_t> coils;
  for (std::uint32_t key = 0; key < facts.bits().size(); ++key) {
    if (facts.bits().at(key).size() < 2) continue;
    coils.clear();
    for (const std::uint32_t i : facts.bits().at(key)) {
      const Access& access = facts.access(i);
      const std::uint32_t id = access.instruction;
      if (access.area != Area::L && isCoil(facts.roleAt(id)) && !isIdle[facts.blockOf(id)] &&
          facts.execution().at(id).isReachable)
        coils.push_back(id);
    }
    if (coils.size() < 2 || (facts.form() == StatementForm::Accumulators && excludeEachOther(facts, coils))) continue;
    const Instruction& second = facts.instruction(coils[1]);
    const std::string bit = facts.bitName(key);
    Finding& finding = sink.report(
        second.span, fmt::format("{} is driven by {} coils; the last one that runs in a scan wins", bit, coils.size()));
    finding.address = toString(second.operands[0]);
    finding.help = "join the conditions in front of one coil, or use S and R";
    for (std::size_t i = 0; i < std::min(coils.size(), mostRelated + 1); ++i) {
      if (i == 1) continue;
      finding.related.push_back({facts.instruction(coils[i]).span,
                                 fmt::format("coil of {} in {}, network {}", bit, facts.pouOf(coils[i]).name,
                                             facts.networkOf(coils[i]).number)});
    }
    const auto certain =
        std::count_if(coils.begin(), coils.end(), [&](std::uint32_t id) { return runsAlways(facts, id); });
    if (certain >= 2) finding.confirmation = Confirmation::NotNeeded;
  }
}

void askOut001(Asking& asking) {
  Graph& graph = asking.graph();
  std::map<Place, std::map<std::uint32_t, std::pair<const Instruction*, Graph::Bool>>> coils;  // by Instruction::id
  for (const BitWrite& write : asking.encoding().bitWrites()) {
    if (write.instruction == nullptr || !isCoil(roleOf(*write.instruction)) || write.place.area == Area::L) continue;
    auto& runs = coils[write.place]
                     .try_emplace(write.instruction->id, write.instruction, graph.constant(false))
                     .first->second.second;
    runs = graph.lor(runs, {write.guard});
  }
  for (const auto& [place, list] : coils) {
    if (list.size() < 2) continue;
    Graph::Bool some = graph.constant(false), two = some;
    for (const auto& [id, coil] : list) {
      two = graph.lor(two, graph.land(some, coil.second));
      some = graph.lor(some, coil.second);
    }
    const std::string name = nameOf(place);
    asking.ask({.name = fmt::format("two coils of {} run in one scan", name),
                .message = fmt::format("{} is driven by {} coils", name, list.size()),
                .address = name,
                .place = std::next(list.begin())->second.first,
                .bad = two.node});
  }
}

}  // namespace

extern constexpr Rule out001_double_coil = {
    .id = "OUT001",
    .title = "Double coil",
    .severity = Severity::Warning,
    .needs = Needs::FlowThenSolver,
    .detects = "two or more = (or =I) on the same bit whose networks can run in the same scan",
    .why =
        "outputs leave only at the end of the scan, so the last coil wins and the others do nothing; the manual never "
        "warns of it",
    .manual = "001:1254, 001:2777",
    .bad = "Network 1\nLD I0.0\n= Q0.0\nNetwork 2\nLD I0.1\n= Q0.0\n",
    .good = "Network 1\nLD I0.0\nO I0.1\n= Q0.0\n",
    .falsePositives =
        "coils in code of which only one part runs per scan (jumps, steps, conditional calls): the prover drops them, "
        "lint alone "
        "marks them unconfirmed",
    .peers = "SA0004; CP12; Rockwell duplicate destructive bit; Omron duplicate outputs",
    .check = checkOut001,
    .ask = {.in = asked::Lint, .turn = 70, .cost = 2, .onlySettles = true, .program = askOut001},
};

}  // namespace rungproof
