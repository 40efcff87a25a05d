// DBA003: an absolute access to a data block that covers declared fields in part, or several of different types.
// Tested by its examples and tests/rules/data_block_rules_test.cpp.
#include <fmt/format.h>

#include <algorithm>

#include "analysis/flow/open_blocks.hpp"
#include "analysis/flow/step7_blocks.hpp"
#include "analysis/rule.hpp"
#include "ir/block_map.hpp"
#include "ir/s7300/declarations.hpp"

namespace rungproof {

namespace {

using s7300::TypeKind;

/// A declared value without parts, in bits from the beginning of the block.
struct Leaf {
  TypeKind kind;
  std::uint64_t first, end;
  std::string name;
};

struct BitRange {
  std::uint64_t first, end;
};

void leavesOf(const s7300::Structure& structure, std::uint64_t base, const std::string& path, BitRange range,
              std::vector<Leaf>& leaves);

void leavesOf(const s7300::Type& type, std::uint64_t first, const std::string& path, BitRange range,
              std::vector<Leaf>& leaves) {
  const std::uint64_t size = type.kind == TypeKind::Bool ? 1 : s7300::sizeOf(type) * 8;
  if (first >= range.end || first + size <= range.first) return;
  if (type.structure != nullptr) return leavesOf(*type.structure, first, path, range, leaves);
  if (type.kind != TypeKind::Array || type.element == nullptr) {
    leaves.push_back({type.kind, first, first + size, path});
    return;
  }
  const bool isBits = type.element->kind == TypeKind::Bool;
  const std::uint64_t each = isBits ? 1 : std::max<std::uint64_t>(s7300::sizeOf(*type.element), 1) * 8;
  const std::uint64_t from = range.first > first ? (range.first - first) / each : 0;
  for (std::uint64_t i = from; first + i * each < std::min(range.end, first + size); ++i)
    leavesOf(*type.element, first + i * each, path + "[]", range, leaves);
}

void leavesOf(const s7300::Structure& structure, std::uint64_t base, const std::string& path, BitRange range,
              std::vector<Leaf>& leaves) {
  for (const s7300::Field& field : structure.fields) {
    if (field.byReference || !field.viewOf.empty()) continue;
    leavesOf(field.type, base + field.byte * 8ULL + field.bit, path.empty() ? field.name : path + "." + field.name,
             range, leaves);
  }
}

/// Patterns of bits, parts of which are taken as a matter of course.
bool isBitPattern(TypeKind kind) {
  return kind == TypeKind::Byte || kind == TypeKind::Word || kind == TypeKind::DWord || kind == TypeKind::Char ||
         kind == TypeKind::String || kind == TypeKind::DateAndTime || kind == TypeKind::Pointer ||
         kind == TypeKind::Any || kind == TypeKind::S5Time || kind == TypeKind::Unknown;
}

/// What is odd about an access to these fields, or empty.
std::string oddness(const std::vector<Leaf>& leaves, BitRange range) {
  if (leaves.empty()) return {};
  const auto isCovered = [&](const Leaf& leaf) { return leaf.first >= range.first && leaf.end <= range.end; };
  if (leaves.size() == 1) {
    const Leaf& leaf = leaves[0];
    if (isCovered(leaf) || isBitPattern(leaf.kind)) return {};
    return fmt::format("takes a part of {}", leaf.name);
  }
  for (const Leaf& leaf : leaves) {
    if (!isCovered(leaf)) return fmt::format("takes a part of {} and of {}", leaves[0].name, leaves[1].name);
  }
  const auto other = std::ranges::find_if(leaves, [&](const Leaf& leaf) { return leaf.kind != leaves[0].kind; });
  if (other == leaves.end()) return {};
  return fmt::format("joins {} and {}, which are of different types", leaves[0].name, other->name);
}

void checkDba003(const Facts& facts, FindingSink& sink) {
  const s7300::Declarations* declarations = facts.program().declarations.get();
  if (declarations == nullptr) return;
  eachOwnBlock(facts, [&](std::uint32_t, const Flow& flow) {
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
        std::vector<Leaf> leaves;
        leavesOf(*structure->second, 0, {}, range, leaves);
        const std::string odd = oddness(leaves, range);
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
