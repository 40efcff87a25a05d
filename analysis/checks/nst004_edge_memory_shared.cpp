// NST004: the bit in which FP or FN remembers the RLO is used for something else, or does not last.
// Tested by its examples and tests/rules/nesting_rules_test.cpp.
#include <fmt/format.h>

#include <map>

#include "analysis/flow/statement_paths.hpp"
#include "analysis/flow/step7_blocks.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

struct EdgeBit {
  std::uint32_t first;  ///< Instruction::id of FP or FN
  bool isTold = false;
};
using EdgeBits = std::map<std::string, EdgeBit>;

constexpr std::string_view ownBit = "give every FP and FN a bit of its own, in M, in a data block or in static data";

void collectEdges(const Facts& facts, FindingSink& sink, EdgeBits& edges) {
  eachOwnBlock(facts, [&](std::uint32_t block, const Flow& flow) {
    for (const FlowStep& step : flow.steps) {
      const Instruction& instruction = *step.instruction;
      if (statementRole(instruction) != StatementRole::Edge || instruction.operands.empty()) continue;
      const Operand& bit = instruction.operands[0];
      const std::string_view fault = bit.kind != OperandKind::Direct ? ""
                                     : bit.area == Area::L           ? "local data, which is any value at the next run"
                                     : bit.area == Area::I ? "the image of the inputs, which is read anew every scan"
                                                           : "";
      if (!fault.empty()) {
        Finding& finding =
            sink.report(instruction.span, fmt::format("{} keeps its edge in {}", Facts::text(instruction), fault));
        finding.address = toString(bit);
        finding.help = ownBit;
        continue;
      }
      const std::string key = placeKey(facts, block, bit);
      if (key.empty()) continue;
      const auto [place, isNew] = edges.try_emplace(key, EdgeBit{instruction.id});
      if (isNew || place->second.isTold) continue;
      place->second.isTold = true;
      Finding& finding = sink.report(instruction.span, fmt::format("{} keeps its edge in {}, as another one does",
                                                                   Facts::text(instruction), facts.name(bit)));
      finding.address = toString(bit);
      finding.related.push_back({facts.instruction(place->second.first).span, networkText(facts, place->second.first)});
      finding.help = ownBit;
    }
  });
}

/// A statement that gives the bit a value of its own. R makes the next RLO an edge again, which is meant.
bool givesValue(const Instruction& instruction) {
  return statementRole(instruction) != StatementRole::Edge && !isReset(roleOf(instruction));
}

void reportWriter(const Facts& facts, FindingSink& sink, EdgeBit& edge, std::uint32_t writer) {
  if (edge.isTold || !givesValue(facts.instruction(writer)) || facts.calls().isStartUpOnly(facts.blockOf(writer)))
    return;
  edge.isTold = true;
  const Instruction& instruction = facts.instruction(edge.first);
  Finding& finding =
      sink.report(instruction.span, fmt::format("{} keeps its edge in a bit that {} writes too",
                                                Facts::text(instruction), Facts::text(facts.instruction(writer))));
  finding.address = toString(instruction.operands[0]);
  finding.related.push_back({facts.instruction(writer).span, networkText(facts, writer)});
  finding.help = ownBit;
}

void checkNst004(const Facts& facts, FindingSink& sink) {
  EdgeBits edges;
  collectEdges(facts, sink, edges);
  if (edges.empty()) return;
  for (auto& [key, edge] : edges) {
    const Operand& bit = facts.instruction(edge.first).operands[0];
    if (bit.kind != OperandKind::Direct) continue;
    const std::uint32_t cell = facts.index().cells().cell(bit.area, bit.offset, facts.blockOf(edge.first));
    if (cell == facts.index().cells().size()) continue;
    for (const std::uint32_t i : facts.index().at(cell)) {
      const Access& access = facts.access(i);
      const bool isOtherBit = access.width == Width::Bit && access.bit != bit.bit;
      if (access.write && !access.maybe && !isOtherBit) reportWriter(facts, sink, edge, access.instruction);
    }
  }
  eachOwnBlock(facts, [&](std::uint32_t block, const Flow& flow) {
    for (const FlowStep& step : flow.steps) {
      const Instruction& instruction = *step.instruction;
      if ((!isCoil(roleOf(instruction)) && !isSet(roleOf(instruction))) || instruction.operands.empty()) continue;
      if (instruction.operands[0].kind == OperandKind::Direct) continue;
      const auto found = edges.find(placeKey(facts, block, instruction.operands[0]));
      if (found != edges.end()) reportWriter(facts, sink, found->second, instruction.id);
    }
  });
}

}  // namespace

extern constexpr Rule nst004_edge_memory_shared = {
    .id = "NST004",
    .title = "Edge memory shared, written or not lasting",
    .severity = Severity::Warning,
    .needs = Needs::Text,
    .detects =
        "two FP or FN with the same bit; a bit of FP or FN that =, S or a transfer writes too; such a bit in local "
        "data or in the image of the inputs",
    .why = "the edge is the difference between the RLO and that bit: whoever else changes it makes edges or hides them",
    .manual = "002:2477, 002:2705-2706",
    .bad =
        "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\nA I 0.0;\nFP M 1.0;\nS Q 0.0;\nNETWORK\nA I 0.1;\nFP M 1.0;\n"
        "R Q 0.0;\nEND_ORGANIZATION_BLOCK\n",
    .good =
        "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\nA I 0.0;\nFP M 1.0;\nS Q 0.0;\nNETWORK\nA I 0.1;\nFP M 1.1;\n"
        "R Q 0.0;\nEND_ORGANIZATION_BLOCK\n",
    .exampleCpu = "319-3",
    .dialects = dialect::S7300,
    .ofLists = true,
    .check = checkNst004,
};

}  // namespace rungproof
