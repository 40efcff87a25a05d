// DBA004: an FB that has moved AR2 or opened another block in DI touches its own data.
// Tested by its examples and tests/rules/data_block_rules_test.cpp.
#include <fmt/format.h>

#include <algorithm>

#include "analysis/flow/open_blocks.hpp"
#include "analysis/flow/step7_blocks.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

/// The operand that is found by AR2 and DI, or nullptr.
const Operand* ownData(const Instruction& instruction) {
  const auto isOwn = [](const Operand& operand) {
    return operand.reach != nullptr && operand.reach->way == Way::Instance;
  };
  for (const Operand& operand : instruction.operands) {
    if (isOwn(operand)) return &operand;
    if (operand.reach != nullptr && operand.reach->way == Way::Pointer && isOwn(operand.reach->pointer))
      return &operand.reach->pointer;
  }
  return nullptr;
}

void checkDba004(const Facts& facts, FindingSink& sink) {
  eachOwnBlock(facts, [&](std::uint32_t, const Flow& flow) {
    if (flow.pou->type != BlockType::Fb) return;
    const OpenStates states = openStates(facts.program(), flow);
    for (std::uint32_t at = 0; at < flow.steps.size(); ++at) {
      if (!states[at] || (!states[at]->isAr2Moved && !states[at]->isDiMoved)) continue;
      const Instruction& instruction = *flow.steps[at].instruction;
      const Operand* own = ownData(instruction);
      if (own == nullptr) continue;
      Finding& finding =
          sink.report(own->span, fmt::format("{} needs {} as the call of {} has set it, but the block has changed it",
                                             Facts::text(instruction),
                                             states[at]->isAr2Moved ? "AR2" : "the DI register", flow.pou->name));
      finding.address = toString(*own);
      finding.help = "save the register in local data before and load it again before own data is used";
      return;  // what follows has the same cause
    }
  });
}

}  // namespace

extern constexpr Rule dba004_instance_register_moved = {
    .id = "DBA004",
    .title = "Own data used after AR2 or DI was changed",
    .severity = Severity::Warning,
    .needs = Needs::Flow,
    .detects =
        "a parameter or static variable of an FB, or a multi-instance call, behind LAR2, +AR2, TAR1 AR2, CAR, OPN DI "
        "or "
        "CDB, where the old value was not put back",
    .why = "own data of an FB is found through DI and AR2: another place is read and written",
    .manual = "002:1434, 002:2834-2861",
    .bad =
        "FUNCTION_BLOCK FB 1\nVAR\nX : INT;\nEND_VAR\nBEGIN\nNETWORK\nL P#4.0;\nLAR2;\nL 5;\nT #X;\n"
        "END_FUNCTION_BLOCK\n",
    .good =
        "FUNCTION_BLOCK FB 1\nVAR\nX : INT;\nEND_VAR\nVAR_TEMP\nKeep : DWORD;\nEND_VAR\nBEGIN\nNETWORK\n"
        "TAR2 #Keep;\nL P#4.0;\nLAR2;\nLAR2 #Keep;\nL 5;\nT #X;\nEND_FUNCTION_BLOCK\n",
    .exampleCpu = "319-3",
    .dialects = dialect::S7300,
    .check = checkDba004,
};

}  // namespace rungproof
