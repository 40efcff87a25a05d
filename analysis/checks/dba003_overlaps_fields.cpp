// DBA003: an absolute access to a data block that covers declared fields in part, or several of different types.
// Tested by its examples and tests/rules/data_block_rules_test.cpp.
#include <fmt/format.h>

#include <algorithm>

#include "analysis/flow/declared_value.hpp"
#include "analysis/flow/open_blocks.hpp"
#include "analysis/flow/step7_blocks.hpp"
#include "analysis/rule.hpp"
#include "ir/block_map.hpp"

namespace rungproof {

namespace {

using s7300::TypeKind;

/// Patterns of bits, parts of which are taken as a matter of course.
bool isBitPattern(TypeKind kind) {
  return kind == TypeKind::Byte || kind == TypeKind::Word || kind == TypeKind::DWord || kind == TypeKind::Char ||
         kind == TypeKind::String || kind == TypeKind::DateAndTime || kind == TypeKind::Pointer ||
         kind == TypeKind::Any || kind == TypeKind::S5Time || kind == TypeKind::Unknown;
}

/// What is odd about an access to these fields, or empty.
std::string oddness(const std::vector<DeclaredValue>& leaves, BitRange range) {
  if (leaves.empty()) return {};
  const auto isCovered = [&](const DeclaredValue& leaf) { return leaf.first >= range.first && leaf.end <= range.end; };
  if (leaves.size() == 1) {
    const DeclaredValue& leaf = leaves[0];
    if (isCovered(leaf) || isBitPattern(leaf.kind)) return {};
    return fmt::format("takes a part of {}", leaf.name);
  }
  for (const DeclaredValue& leaf : leaves) {
    if (!isCovered(leaf)) return fmt::format("takes a part of {} and of {}", leaves[0].name, leaves[1].name);
  }
  const auto other =
      std::ranges::find_if(leaves, [&](const DeclaredValue& leaf) { return leaf.kind != leaves[0].kind; });
  if (other == leaves.end()) return {};
  return fmt::format("joins {} and {}, which are of different types", leaves[0].name, other->name);
}

void checkDba003(const Facts& facts, FindingSink& sink) {
  const s7300::Declarations* declarations = facts.program().declarations.get();
  if (declarations == nullptr) return;
  eachReadStretch(facts, [&](std::uint32_t, const Flow& flow) {
    const OpenStates states = openStates(facts.program(), flow);
    for (std::uint32_t at = 0; at < flow.steps.size(); ++at) {
      if (!states[at]) continue;
      const Instruction& instruction = *flow.steps[at].instruction;
      eachDataOperand(facts.program(), instruction, [&](const Operand& operand, bool) {
        const bool inOpen = operand.reach != nullptr && operand.reach->way == Way::OpenBlock;
        if ((!isFullAddress(operand) || !operand.text.empty()) && !inOpen) return;
        const OpenBlock& open = inOpen && operand.reach->inDi ? states[at]->di : states[at]->db;
        if (inOpen && open.by != openedHere) return;
        const std::uint32_t number = inOpen ? open.number : blockOfByte(operand.offset);
        const auto structure = declarations->dataBlocks.find(number);
        if (structure == declarations->dataBlocks.end()) return;
        const std::uint64_t first =
            byteInBlock(operand.offset) * 8ULL + (operand.width == Width::Bit ? operand.bit : 0);
        const BitRange range{first, first + static_cast<std::uint64_t>(bits(operand.width))};
        const std::string odd = oddness(valuesIn(*structure->second, range), range);
        if (odd.empty()) return;
        Finding& finding = sink.report(operand.span, fmt::format("{} of DB{} {}", toString(operand), number, odd));
        finding.address = toString(operand);
        finding.help = "name the field, or correct the address";
      });
    }
  });
}

}  // namespace

extern constexpr Rule dba003_overlaps_fields = {
    .id = "DBA003",
    .title = "Absolute access across declared fields",
    .severity = Severity::Warning,
    .needs = Needs::Flow,
    .detects =
        "a byte, word or double word of a data block, or a bit, that covers a number only in part, parts of two "
        "fields, or several fields of different types",
    .why = "the declaration has moved since the address was written, or the address is wrong",
    .manual = "002:673-679",
    .bad =
        "DATA_BLOCK DB 1\nSTRUCT\nA : INT;\nB : INT;\nEND_STRUCT;\nBEGIN\nEND_DATA_BLOCK\nORGANIZATION_BLOCK OB 1\n"
        "BEGIN\nNETWORK\nL DB1.DBW 1;\nT QW 0;\nEND_ORGANIZATION_BLOCK\n",
    .good =
        "DATA_BLOCK DB 1\nSTRUCT\nA : INT;\nB : INT;\nEND_STRUCT;\nBEGIN\nEND_DATA_BLOCK\nORGANIZATION_BLOCK OB 1\n"
        "BEGIN\nNETWORK\nL DB1.DBW 2;\nT QW 0;\nEND_ORGANIZATION_BLOCK\n",
    .exampleCpu = "319-3",
    .falsePositives = "blocks that are copied as a whole by double words",
    .dialects = dialect::S7300,
    .check = checkDba003,
};

}  // namespace rungproof
