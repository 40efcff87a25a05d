// NST006: a caller reads BR behind a call, and the called block can end without having set it.
// Tested by its examples and tests/rules/nesting_rules_test.cpp.
#include <fmt/format.h>

#include "analysis/flow/logic_string.hpp"
#include "analysis/flow/step7_blocks.hpp"
#include "analysis/rule.hpp"
#include "ir/s7300/block.hpp"

namespace rungproof {

namespace {

bool readsBr(const Instruction& instruction) {
  const StatementRole role = statementRole(instruction);
  if (role == StatementRole::JumpByBr) return true;
  const bool isScan = role == StatementRole::AndScan || role == StatementRole::OrScan || role == StatementRole::XorScan;
  return isScan && !instruction.operands.empty() && instruction.operands[0].kind == OperandKind::Constant &&
         instruction.operands[0].text == "BR";
}

/// The statement that reads BR first behind the call, along the text; nullptr if something sets it before.
const Instruction* readerBehind(const Flow& flow, std::uint32_t call) {
  for (std::uint32_t at = call + 1; at < flow.steps.size(); ++at) {
    const Instruction& instruction = *flow.steps[at].instruction;
    if (readsBr(instruction)) return &instruction;
    const StatementRole role = statementRole(instruction);
    const bool isNeutral = role == StatementRole::Nothing || instruction.desc->control == Control::LabelMark;
    if (!isNeutral) return nullptr;
  }
  return nullptr;
}

/// Whether a run of the block can end with the BR of its caller.
class BrAtEnd {
 public:
  explicit BrAtEnd(const Facts& facts) : facts_(facts), known_(facts.program().pous.size(), 2) {}

  bool mayBeForeign(std::uint32_t block) {
    std::uint8_t& answer = known_[block];
    if (answer != 2) return answer != 0;
    answer = 0;  // of a block that calls itself the other ends decide
    const Flow& flow = facts_.plan().flows[block];
    const Pou& pou = *flow.pou;
    const bool isSystem = pou.type == BlockType::Sfc || pou.type == BlockType::Sfb;
    if (isSystem || pou.protectedBlock || facts_.hasUnreadCode(block) || isLibraryText(facts_.program(), pou))
      return false;
    const auto end = logicStates(flow).back();
    // What a called block leaves in BR counts as set: which call was the last one is not followed.
    const bool isForeign = end && (end->brMaker & byCaller) != 0;
    known_[block] = isForeign ? 1 : 0;
    return isForeign;
  }

 private:
  const Facts& facts_;
  std::vector<std::uint8_t> known_;
};

void checkNst006(const Facts& facts, FindingSink& sink) {
  BrAtEnd ends(facts);
  std::vector<std::uint8_t> isTold(facts.program().pous.size(), 0);
  for (const CallSite& call : facts.calls().sites()) {
    if (call.callee == noBlock || isTold[call.callee] != 0 || !ends.mayBeForeign(call.callee)) continue;
    const Instruction* reader = readerBehind(facts.plan().flows[call.caller], facts.place(call.instruction->id).step);
    if (reader == nullptr) continue;
    isTold[call.callee] = 1;
    Finding& finding =
        sink.report(reader->span, fmt::format("{} reads BR behind the call of {}, which can end without having set it",
                                              Facts::text(*reader), facts.program().pous[call.callee].name));
    finding.related.push_back({call.instruction->span, "the call"});
    finding.related.push_back({facts.program().pous[call.callee].networks.back().instructions.empty()
                                   ? call.instruction->span
                                   : facts.program().pous[call.callee].networks.back().instructions.back().span,
                               "the end of the block"});
    finding.help = "set BR before every end of the block: SET; SAVE where all is well, CLR; SAVE for an error";
  }
}

}  // namespace

extern constexpr Rule nst006_br_undefined = {
    .id = "NST006",
    .title = "BR undefined at the end of a block",
    .severity = Severity::Warning,
    .needs = Needs::Flow,
    .detects =
        "A BR, JBI or JNBI right behind a call, as the ENO of a box is made, of a block with a path on which nothing "
        "sets BR",
    .why = "the caller takes what BR was before the call for the answer of the block; ENO of its box is that bit",
    .manual = "002:297-305, 003:1205",
    .bad =
        "FUNCTION FC 1 : VOID\nBEGIN\nNETWORK\nA I 0.0;\n= Q 0.0;\nEND_FUNCTION\nORGANIZATION_BLOCK OB 1\nBEGIN\n"
        "NETWORK\nA I 1.0;\nJNB _001;\nCALL FC 1;\n_001: A BR;\n= Q 1.0;\nEND_ORGANIZATION_BLOCK\n",
    .good =
        "FUNCTION FC 1 : VOID\nBEGIN\nNETWORK\nA I 0.0;\n= Q 0.0;\nSET;\nSAVE;\nEND_FUNCTION\nORGANIZATION_BLOCK "
        "OB 1\nBEGIN\nNETWORK\nA I 1.0;\nJNB _001;\nCALL FC 1;\n_001: A BR;\n= Q 1.0;\nEND_ORGANIZATION_BLOCK\n",
    .exampleCpu = "319-3",
    .dialects = dialect::S7300,
    .ofLists = true,
    .check = checkNst006,
};

}  // namespace rungproof
