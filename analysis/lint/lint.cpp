// Running rules over a program.
#include "analysis/lint/lint.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "analysis/flow/step7_blocks.hpp"

namespace rungproof {

namespace {

/// Length of the longest prefix in the list that fits the id, or -1.
int longestMatch(const std::vector<std::string>& prefixes, std::string_view id) {
  int longest = -1;
  for (const std::string& prefix : prefixes) {
    const int length = prefix == "ALL" ? 0 : static_cast<int>(prefix.size());
    if (length > longest && (length == 0 || id.starts_with(prefix))) longest = length;
  }
  return longest;
}

void letSpeak(const Facts& facts, const RuleSelection& selection, std::span<const Rule* const> rules,
              FindingSink& sink) {
  for (const Rule* rule : rules) {
    if (rule->check == nullptr || !selection.includes(*rule) || !knows(*rule, facts.target())) continue;
    if (facts.hasUnreadFrame() && !rule->standsAlone) continue;
    sink.begin(*rule);
    rule->check(facts, sink);
  }
}

/// A message that begins with an instruction of SCL begins with the text that it was made of.
void nameAsWritten(const Program& program, const Network& network, Finding& finding) {
  const std::string message(finding.message.view());
  for (const Instruction& instruction : network.instructions) {
    if (!finding.span.beginsIn(instruction.span)) continue;
    for (const std::string& name : {Facts::text(instruction), std::string(instruction.desc->stl)}) {
      if (name.empty() || !message.starts_with(name + " ")) continue;
      finding.message = fmt::format("'{}'{}", Facts::text(program, instruction), message.substr(name.size()));
      return;
    }
  }
}

/// Of a body in SCL: rules about the way in which a statement list is written have no subject, no fix of an instruction
/// fits the text, and no mnemonic stands in it.
void speakOfStructuredText(const Program& program, std::vector<Finding>& findings) {
  std::vector<const Pou*> blocks;
  for (const Pou& pou : program.pous) {
    if (std::ranges::any_of(pou.networks, &Network::isStructured)) blocks.push_back(&pou);
  }
  if (blocks.empty()) return;
  std::erase_if(findings, [&](Finding& finding) {
    const auto block = std::ranges::find_if(blocks, [&](const Pou* pou) { return finding.span.beginsIn(pou->span); });
    if (block == blocks.end()) return false;
    const auto network =
        std::ranges::find_if((*block)->networks, [&](const Network& each) { return finding.span.beginsIn(each.span); });
    const bool isOfDeclaration = network == (*block)->networks.end();
    if (!isOfDeclaration && !network->isStructured) return false;
    const Rule* rule = ruleNamed(finding.rule.view());
    if (rule != nullptr && rule->ofLists) return true;
    if (isOfDeclaration) return false;
    finding.fix = {};
    nameAsWritten(program, *network, finding);
    return false;
  });
}

/// What is to be said about the texts of library blocks is not the program's business.
std::vector<Finding> ownFindings(const Program& program, FindingSink& sink) {
  std::vector<Finding> findings = sink.take();
  std::vector<bool> isLibraryFile(program.sources->size(), false);
  for (const Pou& pou : program.pous) {
    if (isLibraryText(program, pou)) isLibraryFile[pou.span.file] = true;
  }
  std::erase_if(findings, [&](const Finding& finding) {
    return finding.span.file < isLibraryFile.size() && isLibraryFile[finding.span.file];
  });
  speakOfStructuredText(program, findings);
  return findings;
}

}  // namespace

bool RuleSelection::includes(std::string_view id, bool onByDefault) const {
  const int selected = longestMatch(select_, id);
  const int ignored = longestMatch(ignore_, id);
  if (select_.empty()) return onByDefault && ignored < 0;
  return selected > ignored;
}

std::vector<Finding> runRules(const Facts& facts, const RuleSelection& selection, const RuleSettings& settings,
                              std::span<const Rule* const> rules) {
  FindingSink sink(facts.program(), settings);
  letSpeak(facts, selection, rules, sink);
  return ownFindings(facts.program(), sink);
}

std::vector<Finding> runRules(const Program& program, std::span<const ExternalRange> externals,
                              const Surroundings& around, const RuleSelection& selection,
                              const RuleSettings& settings) {
  FindingSink sink(program, settings);
  letSpeak(Facts(program, externals, around), selection, allRules(), sink);
  return ownFindings(program, sink);
}

}  // namespace rungproof
