// ARI005: a contact on SM1.0 to SM1.7 that does not belong to the last instruction which sets status bits. Loads,
// contacts and moves leave the bits alone (s7200 E8). Tested by its examples and tests/rules/data_rules_test.cpp.
#include <fmt/format.h>

#include <array>

#include "analysis/flow/facts.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

void checkStatusFlags(FindingSink& sink, const Flow& flow) {
  const Instruction* last = nullptr;           // that set any status bit, or a call
  std::array<const Instruction*, 8> setter{};  // of each bit
  for (const FlowStep& step : flow.steps) {
    const Instruction& instruction = *step.instruction;
    for (const Operand& o : instruction.operands) {
      if (o.kind != OperandKind::Direct || o.area != Area::SM || o.width != Width::Bit || o.offset != 1 || o.bit > 7)
        continue;
      const Instruction* own = setter[o.bit];
      const bool isFresh = own != nullptr && own == last;
      if (isFresh || instruction.desc->execution == Execution::Coil) continue;
      const std::string name = toString(o);
      Finding& finding = sink.report(
          o.span,
          last == nullptr ? fmt::format("{} reads {}, but no instruction before it in {} sets status bits",
                                        Facts::text(instruction), name, flow.pou->name)
          : own == nullptr
              ? fmt::format("{} reads {}, which {} does not set", Facts::text(instruction), name, Facts::text(*last))
              : fmt::format("{} reads {}, but {} has run since {} set it", Facts::text(instruction), name,
                            Facts::text(*last), Facts::text(*own)));
      finding.address = name;
      if (last != nullptr)
        finding.related.push_back({last->span, "the last instruction before it that sets status bits"});
      if (own != nullptr) finding.related.push_back({own->span, fmt::format("{} was set here", name)});
      finding.help = "read the status bit directly behind the instruction that it is about";
    }
    const StatusBits affects = instruction.desc->affects;
    if (affects == 0) continue;
    last = &instruction;
    for (int bit = 0; bit < 8; ++bit) {
      if ((affects >> bit & 1) != 0) setter[static_cast<std::size_t>(bit)] = &instruction;
    }
  }
}

void checkAri005(const Facts& facts, FindingSink& sink) {
  const std::vector<Flow>& flows = facts.plan().flows;
  for (std::uint32_t block = 0; block < flows.size(); ++block) {
    if (!facts.hasUnreadCode(block)) checkStatusFlags(sink, flows[block]);
  }
}

}  // namespace

extern constexpr Rule ari005_status_flag_stale = {
    .id = "ARI005",
    .title = "Status flag is stale",
    .severity = Severity::Warning,
    .needs = Needs::Flow,
    .detects =
        "SM1.0-SM1.7 read although the last instruction before it that sets status bits does not set this one, or none "
        "does",
    .why = "the bits keep the result of an earlier instruction until one that affects them runs",
    .manual = "001:4814-4827, 001:14063-14073",
    .bad = "Network 1\nLD SM0.0\n/I VW0, VW2\nANDW VW4, VW6\nNetwork 2\nLD SM1.3\n= Q0.0\n",
    .good = "Network 1\nLD SM0.0\n/I VW0, VW2\nNetwork 2\nLD SM1.3\n= Q0.0\n",
    .falsePositives = "a bit that the instruction between does not touch and that is read late on purpose",
    .peers = "CP7 (nearest)",
    .dialects = dialect::S7200,
    .check = checkAri005,
};

}  // namespace rungproof
