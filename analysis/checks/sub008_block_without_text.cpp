// SUB008: a called block that no file holds and no library of the manual brings. Its calls say what it may write.
// Tested by its examples and tests/smart/contract_test.cpp.
#include "analysis/rule.hpp"
#include "analysis/unread/hidden_blocks.hpp"

namespace rungproof {

namespace {

void checkSub008(const Facts& facts, FindingSink& sink) {
  for (const MissingBlock& block : missingBlocks(facts)) {
    Finding& finding = sink.report(block.firstCall->span, missingText(block));
    finding.address = block.name;
    finding.help =
        "give the file of the block, or the folder of the whole project; 'missing-blocks = anything' proves nothing "
        "beside it";
  }
}

}  // namespace

extern constexpr Rule sub008_block_without_text = {
    .id = "SUB008",
    .title = "Called block is in no file",
    .severity = Severity::Note,
    .needs = Needs::Text,
    .detects =
        "a call with parameters of a subroutine whose number no file holds and that is none of the known library "
        "blocks",
    .why =
        "what the block does is not in the text: proofs take the places that its calls give it to write as any value, "
        "and assume that it writes no others",
    .manual = "001:6815, 001:6823",
    .bad =
        "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1\nLD SM0.0\nCALL SBR21, I0.0, VW10, "
        "M0.0\nEND_ORGANIZATION_BLOCK\n",
    .good =
        "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1\nLD SM0.0\nCALL MBUS_SLAVE, M0.0, "
        "VB10\nEND_ORGANIZATION_BLOCK\n",
    .falsePositives = "the block stands in a file that was not given",
    .dialects = dialect::S7200,
    .check = checkSub008,
};

}  // namespace rungproof
