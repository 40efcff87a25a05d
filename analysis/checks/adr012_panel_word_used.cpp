// ADR012: a word that a panel or a network partner sets, and that the program uses for itself: it writes computed
// values there and reads them back, or one of its own words reaches into it. Defaults of the first scan, limits, bits
// that are acknowledged and values that are only shown are no finding. Tested by its examples and
// tests/rules/panel_rules_test.cpp.
#include <fmt/format.h>

#include "analysis/flow/facts.hpp"
#include "analysis/panel/panel_words.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

std::string panelNameOf(const Facts& facts, const Operand& address, const PanelWord& panel) {
  return panel.name.empty() ? facts.name(address) : fmt::format("{} ({})", toString(address), panel.name);
}

void relate(Finding& finding, const PanelWord& panel) {
  if (panel.declared.length > 0) finding.related.push_back({panel.declared, "the word is declared here"});
}

void checkAdr012(const Facts& facts, FindingSink& sink) {
  const std::vector<PanelWord> words = panelWords(facts);
  const PanelConflicts conflicts = panelConflicts(facts, words);
  for (const SharedWord& word : conflicts.shared) {
    Finding& finding = sink.report(
        word.writer->span, fmt::format("{} writes {}, which is set from outside the program", Facts::text(*word.writer),
                                       panelNameOf(facts, word.address, *word.panel)));
    finding.address = toString(word.address);
    if (word.reader != word.writer) finding.related.push_back({word.reader->span, "the value is used here"});
    relate(finding, *word.panel);
    finding.help =
        "calculate in memory of the program's own, and leave the word to the panel; if the panel only shows it, take "
        "it out of the declaration or mark its tag as read-only";
  }
  for (const CrossingWord& word : conflicts.crossing) {
    const Instruction& instruction = facts.instruction(word.use->instruction);
    Finding& finding = sink.report(
        instruction.operands[word.use->operand].span,
        fmt::format("{} in {} reaches into {}, which is set from outside the program", accessName(*word.use),
                    Facts::text(instruction), panelNameOf(facts, word.address, *word.panel)));
    finding.address = toString(word.address);
    relate(finding, *word.panel);
    finding.help = "give both sides the same address and width, or the program's word another place (001:1272-1277)";
  }
}

}  // namespace

extern constexpr Rule adr012_panel_word_used = {
    .id = "ADR012",
    .title = "Panel's word used by the program",
    .severity = Severity::Warning,
    .needs = Needs::Text,
    .detects =
        "a word that a panel sets (declared external, in the tag list of --tags, or said so by the symbol table) and "
        "that the program also writes and reads as its own; such a word of which the program has written a part in "
        "every scan before it reads it; a word of the program that shares bytes with such a word",
    .why =
        "panel and program overwrite each other: the operator's value lasts until the next scan, or a calculation goes "
        "on with it",
    .manual = "001:7043, 001:1272-1277",
    .bad = "//@ external VW100\nNetwork 1\nLD SM0.0\nMOVW AIW0, VW100\n+I +5, VW100\nMOVW VW100, VW200\n",
    .good = "//@ external VW100\nNetwork 1\nLD SM0.0\nMOVW AIW0, VW202\n+I VW100, VW202\nMOVW VW202, VW200\n",
    .falsePositives =
        "a value that the panel only shows and that is declared as external: declare what is written from outside, "
        "mark the tag as read-only",
    .dialects = dialect::S7200,
    .check = checkAdr012,
};

}  // namespace rungproof
