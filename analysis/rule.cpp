// Look-ups in the table of rules, and the sink that completes findings. Tested by tests/cli/rule_table_test.cpp.
#include "analysis/rule.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include "ir/check.hpp"

namespace rungproof {

namespace {

constexpr std::array groups = {
    RuleGroup{"ADR", "Operands and addresses"},
    RuleGroup{"SYM", "Symbols"},
    RuleGroup{"STK", "Logic stack"},
    RuleGroup{"OUT", "Outputs and latches"},
    RuleGroup{"TIM", "Timers, counters, edges"},
    RuleGroup{"CTL", "Program control"},
    RuleGroup{"SUB", "Subroutines and local data"},
    RuleGroup{"INT", "Interrupts"},
    RuleGroup{"ARI", "Arithmetic and flags"},
    RuleGroup{"PTR", "Pointers, tables, blocks"},
    RuleGroup{"HSP", "Fast counters, pulses, communication, PID"},
    RuleGroup{"SCR", "Sequence control relays"},
    RuleGroup{"LOG", "Logic that cannot mean what it says"},
    RuleGroup{"SAF", "Declared properties and built-in safety templates"},
    RuleGroup{"LIB", "Blocks of libraries and wizards"},
    RuleGroup{"GET", "Requests over Ethernet"},
    RuleGroup{"PRT", "Ports to another CPU"},
    RuleGroup{"NST", "Nesting, logic strings and edges of the S7-300/400"},
    RuleGroup{"S5T", "Timers and counters of the S7-300/400"},
    RuleGroup{"DBA", "Data blocks and address registers of the S7-300/400"},
    RuleGroup{"OBL", "Organization blocks of the S7-300/400"},
    RuleGroup{"IEC", "Programs of IEC 61131-3"},
    RuleGroup{"GRF", "Ladder and FBD drawings"},
    RuleGroup{"STY", "Style"},
    RuleGroup{"SUP", "The tool itself"},
};

constexpr std::size_t pieceLength = 1024;  ///< of what FindingSink keeps

/// What a rule advises, and the block, are often the same text for thousands of findings.
void shareTexts(const Finding& before, Finding& finding) {
  if (finding.help == before.help) finding.help = before.help;
  if (finding.pou == before.pou) finding.pou = before.pou;
}

char upper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

bool sameId(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](char x, char y) { return upper(x) == upper(y); });
}

std::pair<std::uint32_t, std::uint32_t> startOf(Span span) { return {span.file, span.offset}; }

/// Whether a span begins where the one before it ends, or further on.
bool comesAfter(Span before, Span span) {
  return before.file < span.file || (before.file == span.file && before.offset + before.length <= span.offset);
}
bool liesIn(Span outer, Span span) {
  return span.file == outer.file && span.offset >= outer.offset &&
         span.offset + span.length <= outer.offset + outer.length;
}

/// Statement lists in a text do, drawings and XML do not: their elements stand anywhere in the file.
bool holdsItsInstructions(const Network& network) {
  return network.form == Form::Stl &&
         (network.instructions.empty() || liesIn(network.span, network.instructions.front().span));
}

/// Whether blocks and networks stand in the text in the order of the program, as in statement lists.
bool isInOrder(const Program& program) {
  const Span* block = nullptr;
  for (const Pou& pou : program.pous) {
    if (block != nullptr && !comesAfter(*block, pou.span)) return false;
    block = &pou.span;
    const Span* before = nullptr;
    for (const Network& network : pou.networks) {
      if (!holdsItsInstructions(network) || !liesIn(pou.span, network.span)) return false;
      if (before != nullptr && !comesAfter(*before, network.span)) return false;
      before = &network.span;
    }
  }
  return true;
}

}  // namespace

std::span<const RuleGroup> ruleGroups() { return groups; }

const Rule* ruleNamed(std::string_view id) {
  for (const Rule* rule : allRules()) {
    if (sameId(rule->id, id)) return rule;
  }
  return nullptr;
}

std::string_view severityName(Severity severity) {
  switch (severity) {
    case Severity::Error: return "error";
    case Severity::Warning: return "warning";
    default: return "note";
  }
}

Severity severityNamed(std::string_view name) {
  return name == "error" ? Severity::Error : name == "warning" ? Severity::Warning : Severity::Note;
}

std::string_view needsName(Needs needs) {
  switch (needs) {
    case Needs::Text: return "T";
    case Needs::Flow: return "F";
    case Needs::FlowThenSolver: return "F>Z";
    default: return "Z";
  }
}

PlaceIndex::PlaceIndex(const Program& program) : isInOrder_(isInOrder(program)) {
  for (const Pou& pou : program.pous) pous_.push_back({pou.span, {&pou, nullptr}});
  if (!isInOrder_) listNetworks(program);
  const auto byPlace = [](const Entry& a, const Entry& b) { return startOf(a.span) < startOf(b.span); };
  for (std::vector<Entry>* entries : {&pous_, &networks_}) {
    if (!std::ranges::is_sorted(*entries, byPlace)) std::ranges::sort(*entries, byPlace);
  }
}

void PlaceIndex::listNetworks(const Program& program) {
  for (const Pou& pou : program.pous) {
    for (const Network& network : pou.networks) {
      networks_.push_back({network.span, {&pou, &network}});
      if (holdsItsInstructions(network)) continue;
      for (const Instruction& instruction : network.instructions)
        networks_.push_back({instruction.span, {&pou, &network}});
    }
  }
}

const PlaceIndex::Entry* PlaceIndex::containing(const std::vector<Entry>& entries, Span span) {
  const auto after =
      std::ranges::upper_bound(entries, startOf(span), {}, [](const Entry& entry) { return startOf(entry.span); });
  return after != entries.begin() && span.beginsIn((after - 1)->span) ? &*(after - 1) : nullptr;
}

ProgramPlace PlaceIndex::at(Span span) const {
  if (const Entry* entry = containing(networks_, span)) return entry->place;
  const Entry* const entry = containing(pous_, span);
  if (entry == nullptr || !isInOrder_) return entry == nullptr ? ProgramPlace{} : entry->place;
  const std::vector<Network>& networks = entry->place.pou->networks;
  const auto after = std::ranges::upper_bound(networks, startOf(span), {},
                                              [](const Network& network) { return startOf(network.span); });
  const bool isInNetwork = after != networks.begin() && span.beginsIn((after - 1)->span);
  return {entry->place.pou, isInNetwork ? &*(after - 1) : nullptr};
}

void PlaceIndex::complete(Finding& finding) const {
  if (!finding.pou.empty()) return;
  const ProgramPlace place = at(finding.span);
  if (place.pou != nullptr) finding.pou = place.pou->name;
  if (place.network != nullptr && finding.network == 0) finding.network = place.network->number;
}

Finding& FindingSink::report(Span span, std::string message) {
  CHECK(rule_ != nullptr, "a finding needs a rule that speaks");
  if (pieces_.empty() || pieces_.back().size() == pieceLength) pieces_.emplace_back().reserve(pieceLength);
  std::vector<Finding>& piece = pieces_.back();
  if (piece.size() > 1) shareTexts(piece[piece.size() - 2], piece.back());
  Finding& finding = piece.emplace_back();
  finding.rule = rule_->id;
  finding.severity = rule_->severity;
  finding.refused = rule_->refuses;
  finding.message = std::move(message);
  finding.span = span;
  if (rule_->needs == Needs::FlowThenSolver) finding.confirmation = Confirmation::Unconfirmed;
  places_.complete(finding);
  return finding;
}

std::vector<Finding> FindingSink::take() {
  std::vector<Finding> taken;
  taken.reserve(pieces_.empty() ? 0 : (pieces_.size() - 1) * pieceLength + pieces_.back().size());
  for (std::vector<Finding>& piece : pieces_) {
    std::ranges::move(piece, std::back_inserter(taken));
    piece = {};
  }
  pieces_.clear();
  return taken;
}

int FindingSink::option(std::string_view name) const {
  CHECK(rule_ != nullptr, "an option needs a rule that asks");
  for (const RuleOption& option : rule_->options) {
    if (option.name != name) continue;
    const auto found = settings_.find(std::string(rule_->id) + "." + std::string(name));
    return found == settings_.end() ? option.initial : found->second;
  }
  CHECK(false, "the rule has no such option");
  return 0;
}

}  // namespace rungproof
