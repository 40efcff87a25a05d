// Answers are indexed by the rule and the aspect that they are about, so that explanations are looked up and not
// searched for.
#include "analysis/proof/rule_answers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

namespace rungproof {

namespace {

constexpr std::size_t mostHalves = 8;  ///< of a conflict that are shown beside it

std::string helpOf(const RuleQuestion& question, int scans, Shown shown) {
  const Rule& rule = *question.rule;
  const std::string_view advice = rule.tell.advice;
  if (rule.ask.wantsYes) return fmt::format("proved for every run; {}", advice);
  if (isAskedByProve(rule) && shown == Shown::Finding)
    return fmt::format("'rungproof prove --builtin' shows the run{}{}", question.isUsual ? "; " : "",
                       question.isUsual ? advice : std::string_view());
  return fmt::format("seen in scan {} of a run that the engine repeats{}{}", scans, advice.empty() ? "" : "; ", advice);
}

Finding findingAt(const ProofResult& result, Shown shown) {
  const RuleQuestion& question = *result.builtin;
  Finding finding;
  finding.rule = std::string(question.rule->id);
  finding.severity = question.severity();
  finding.message = question.message;
  finding.address = question.address;
  finding.confirmation = Confirmation::Confirmed;
  if (question.place != nullptr) finding.span = question.place->span;
  if (question.other != nullptr)
    finding.related.push_back({question.other->span, std::string(question.rule->tell.otherPlace)});
  finding.help = helpOf(question, result.depth, shown);
  return finding;
}

/// S or R of more than one bit.
bool isRowLatch(const Instruction& instruction) {
  const Role role = roleOf(instruction);
  if ((!isSet(role) && !isReset(role)) || instruction.operands.size() < 2) return false;
  return instruction.operands[1].kind != OperandKind::Constant || instruction.operands[1].value > 1;
}

using ProofRow = std::vector<const ProofResult*>;

/// Answers on bits that belong together: the same instruction wins, or drives them, or one instruction with a count
/// loses against all of them. By the first answer of each group; the answers in a group are ordered by bit.
std::map<const ProofResult*, ProofRow> rowsOf(const ProofRow& results) {
  std::vector<std::size_t> root;
  std::map<std::pair<const Rule*, const Instruction*>, std::size_t> byInstruction;
  const auto find = [&](std::size_t i) {
    while (root[i] != i) i = root[i];
    return i;
  };
  for (std::size_t i = 0; i < results.size(); ++i) {
    root.push_back(i);
    const RuleQuestion& question = *results[i]->builtin;
    const bool isLost = question.other != nullptr && isRowLatch(*question.other);
    for (const Instruction* shared : {question.place, isLost ? question.other : question.place}) {
      const auto [found, isNew] = byInstruction.try_emplace({question.rule, shared}, i);
      const std::size_t a = find(found->second), b = find(i);
      root[std::max(a, b)] = std::min(a, b);
    }
  }
  std::map<const ProofResult*, ProofRow> rows;
  for (std::size_t i = 0; i < results.size(); ++i) rows[results[find(i)]].push_back(results[i]);
  for (auto& [first, row] : rows)
    std::ranges::stable_sort(row, {}, [](const ProofResult* r) { return r->builtin->row.bits.front(); });
  return rows;
}

/// One finding for all of them, at the place of the first bit.
Finding joinedFinding(const ProofRow& group, Shown beside) {
  Finding finding = findingAt(*group.front(), beside);
  const RuleTells& tell = group.front()->builtin->rule->tell;
  BitRow row = group.front()->builtin->row;
  std::set<std::string_view> last;
  std::set<const Instruction*> shown{group.front()->builtin->place};
  finding.related.clear();
  for (const ProofResult* result : group) {
    const RuleQuestion& question = *result->builtin;
    finding.severity = std::max(finding.severity, question.severity());
    row.bits.insert(row.bits.end(), question.row.bits.begin(), question.row.bits.end());
    last.insert(question.place->desc->stl);
    for (const Instruction* half : {question.other, question.place}) {
      if (half != nullptr && shown.insert(half).second && finding.related.size() < mostHalves)
        finding.related.push_back({half->span, std::string(tell.otherPlace)});
    }
  }
  row.order();
  if (tell.bits != nullptr) finding.message = tell.bits(row, last.size() == 1 ? *last.begin() : std::string_view());
  finding.address = row.first();
  return finding;
}

/// The findings of lint by what they are about, so that answers need not look at all of them.
class FindingsByPlace {
 public:
  explicit FindingsByPlace(std::vector<Finding>& findings) : findings_(findings), isDropped_(findings.size()) {
    for (std::size_t i = 0; i < findings.size(); ++i) {
      const Finding& finding = findings[i];
      const std::string rule(finding.rule.view());
      if (finding.confirmation == Confirmation::NotNeeded && !finding.address.empty())
        byAddress_[{rule, std::string(finding.address.view())}].push_back(i);
      byPlace_[{rule, finding.span.file}].emplace(finding.span.offset, i);
    }
  }

  /// Calls visit(finding, number) for each that the answer is about.
  template <class Visit>
  void forEach(const ProofResult& result, Visit&& visit) {
    if (!result.builtin || result.builtin->place == nullptr) return;
    const std::string rule(result.builtin->rule->id);
    const Span place = result.builtin->place->span;
    std::set<std::size_t> about;
    if (const auto found = byAddress_.find({rule, result.builtin->address}); found != byAddress_.end())
      about.insert(found->second.begin(), found->second.end());
    if (const auto found = byPlace_.find({rule, place.file}); found != byPlace_.end()) {
      const auto end = found->second.lower_bound(place.offset + place.length);
      for (auto at = found->second.lower_bound(place.offset); at != end; ++at) about.insert(at->second);
    }
    for (const std::size_t i : about) {
      if (!isDropped_[i]) visit(findings_[i], i);
    }
  }
  void drop(std::size_t number) { isDropped_[number] = true; }
  /// Leaves those out that were dropped.
  void finish() {
    std::size_t i = 0;
    std::erase_if(findings_, [&](const Finding&) { return isDropped_[i++]; });
  }

 private:
  std::vector<Finding>& findings_;
  std::vector<bool> isDropped_;
  std::map<std::pair<std::string, std::string>, std::vector<std::size_t>> byAddress_;
  std::map<std::pair<std::string, std::uint32_t>, std::multimap<std::uint32_t, std::size_t>> byPlace_;
};

/// A declared property that fails, as a finding at its statement.
std::optional<Finding> brokenProperty(const ProofResult& result, std::span<const Rule* const> rules) {
  const Rule* rule = result.builtin ? nullptr : ruleOf(result, rules);
  if (rule == nullptr) return std::nullopt;
  Finding finding;
  finding.rule = std::string(rule->id);
  finding.severity = rule->severity;
  finding.message = *rule->tell.property(result);
  finding.span = result.property.span;
  finding.help = "'rungproof prove' shows the run";
  finding.confirmation = Confirmation::Confirmed;
  return finding;
}

/// What the answers explain.
class Explained {
 public:
  Explained(const Program& program, const std::vector<ProofResult>& results, std::span<const Rule* const> rules)
      : places_(program), rules_(rules) {
    for (const ProofResult& result : results) {
      if (!result.builtin) continue;
      const RuleQuestion& question = *result.builtin;
      for (const int aspect : {question.aspect, Explanation::any}) {
        Answers& answers = byRule_[{question.rule->id, aspect}];
        if (question.rule->ask.wantsYes && result.outcome == Outcome::Reachable) answers.shown.insert(question.address);
        if (isRefuted(result)) add(question, answers);
      }
    }
  }

  /// A finding of `check`.
  bool operator()(const Finding& finding) const {
    const auto rule = std::ranges::find(rules_, finding.rule, &Rule::id);
    if (rule == rules_.end() || finding.related.size() != 1) return false;
    return std::ranges::any_of((*rule)->explainedBy, [&](const Explanation& explanation) {
      if (explanation.where != Where::RelatedPlace) return false;
      const Answers* answers = find(explanation);
      return answers != nullptr && std::ranges::any_of(answers->places, [&](const Instruction* place) {
               return place->span == finding.related.front().span;
             });
    });
  }

  /// An answer of the prover.
  bool operator()(const RuleQuestion& question) const {
    return std::ranges::any_of(question.rule->explainedBy, [&](const Explanation& explanation) {
      const bool isMeant = explanation.of == Explanation::any || explanation.of == question.aspect;
      return isMeant && explains(explanation, question);
    });
  }

 private:
  /// The unwanted answers about one aspect of one rule.
  struct Answers {
    std::set<const Instruction*> places;
    std::set<const Network*> networks;
    std::set<std::string> addresses;
    std::map<std::pair<const Network*, std::string>, std::uint32_t> last;  ///< largest Instruction::id
    std::set<std::string> shown;                                           ///< addresses with the wanted answer
  };

  void add(const RuleQuestion& question, Answers& answers) {
    answers.addresses.insert(question.address);
    addPlace(question.place, answers);
    for (const AlikePlace& alike : question.alike) addPlace(alike.place, answers);
    if (question.place == nullptr) return;
    std::uint32_t& last = answers.last[{networkOf(question.place), question.address}];
    last = std::max(last, question.place->id);
  }
  void addPlace(const Instruction* place, Answers& answers) {
    if (place == nullptr) return;
    answers.places.insert(place);
    answers.networks.insert(networkOf(place));
  }
  const Network* networkOf(const Instruction* place) const { return places_.at(place->span).network; }

  const Answers* find(const Explanation& explanation) const {
    const auto found = byRule_.find({explanation.rule, explanation.aspect});
    return found == byRule_.end() ? nullptr : &found->second;
  }
  bool explains(const Explanation& explanation, const RuleQuestion& question) const {
    const Answers* answers = find(explanation);
    if (explanation.where == Where::NotShown) return answers == nullptr || !answers->shown.contains(question.address);
    if (answers == nullptr || question.place == nullptr) return false;
    const ProgramPlace place = places_.at(question.place->span);
    switch (explanation.where) {
      case Where::SamePlace: return answers->places.contains(question.place);
      case Where::SameNetwork: return answers->networks.contains(place.network);
      case Where::NetworkBefore:
        return place.network != &place.pou->networks.front() && answers->networks.contains(place.network - 1);
      case Where::SameAddress: return answers->addresses.contains(question.address);
      case Where::LaterInNetwork: {
        const auto last = answers->last.find({place.network, question.address});
        return last != answers->last.end() && last->second > question.place->id;
      }
      default: return false;
    }
  }

  const PlaceIndex places_;
  const std::span<const Rule* const> rules_;
  std::map<std::pair<std::string_view, int>, Answers> byRule_;
};

}  // namespace

bool isRefuted(const ProofResult& result) {
  return result.builtin &&
         result.outcome == (result.builtin->rule->ask.wantsYes ? Outcome::Unreachable : Outcome::Violated);
}

std::vector<Finding> findingsOf(const std::vector<const ProofResult*>& results, Shown shown) {
  ProofRow onBits;
  for (const ProofResult* result : results) {
    if (isRefuted(*result) && !result->builtin->row.empty()) onBits.push_back(result);
  }
  const std::map<const ProofResult*, ProofRow> rows = rowsOf(onBits);
  std::vector<Finding> findings;
  for (const ProofResult* result : results) {
    if (!isRefuted(*result)) continue;
    if (!result->builtin->row.empty()) {
      if (const auto row = rows.find(result); row != rows.end()) findings.push_back(joinedFinding(row->second, shown));
      continue;
    }
    findings.push_back(findingAt(*result, shown));
    const Finding first = findings.back();
    for (const AlikePlace& alike : result->builtin->alike) {
      findings.push_back(first);
      findings.back().message = alike.message;
      findings.back().address = alike.address;
      findings.back().span = alike.place->span;
    }
  }
  return findings;
}

const Rule* ruleOf(const ProofResult& result, std::span<const Rule* const> rules) {
  std::vector<const Rule*> speaking;
  for (const Rule* rule : rules) {
    if (rule->tell.property != nullptr && rule->tell.property(result)) speaking.push_back(rule);
  }
  for (const Rule* rule : speaking) {
    const bool isExplained = std::ranges::any_of(rule->explainedBy, [&](const Explanation& explanation) {
      return explanation.where == Where::SameProperty &&
             std::ranges::find(speaking, explanation.rule, &Rule::id) != speaking.end();
    });
    if (!isExplained) return rule;
  }
  return nullptr;
}

std::string violationText(const ProofResult& result) {
  return fmt::format("the property '{}' is violated after {} scans", result.property.name, result.depth);
}

void settle(const Program& program, const std::vector<ProofResult>& results, std::span<const Rule* const> rules,
            const std::function<bool(std::string_view)>& isSelected, std::vector<Finding>& findings) {
  const Explained isExplained(program, results, rules);
  std::erase_if(findings, [&](const Finding& finding) { return isExplained(finding); });
  FindingsByPlace known(findings);
  std::vector<const ProofResult*> news;
  std::vector<Finding> broken;
  for (const ProofResult& result : results) {
    if (!result.builtin) {
      std::optional<Finding> finding = brokenProperty(result, rules);
      if (finding && isSelected(finding->rule)) broken.push_back(std::move(*finding));
      continue;
    }
    const RuleQuestion& question = *result.builtin;
    const bool isBad = isRefuted(result);
    const bool isDismissed = result.outcome == (question.rule->ask.wantsYes ? Outcome::Reachable : Outcome::Proved);
    bool isKnown = false;
    known.forEach(result, [&](Finding& finding, std::size_t number) {
      isKnown = true;
      if (finding.confirmation != Confirmation::Unconfirmed) return;
      if (isBad) finding.confirmation = Confirmation::Confirmed;
      if (!isBad && isDismissed) known.drop(number);
    });
    const bool isNew = isBad && !isKnown && !question.message.empty() && isSelected(question.rule->id);
    if (isNew && !question.rule->ask.onlySettles && !isExplained(question)) news.push_back(&result);
  }
  known.finish();
  std::ranges::move(broken, std::back_inserter(findings));
  // Of several answers of one rule at one place the first speaks.
  std::set<std::tuple<std::string, std::uint32_t, std::uint32_t>> said;
  for (Finding& finding : findingsOf(news, Shown::Finding)) {
    if (said.emplace(finding.rule, finding.span.file, finding.span.offset).second)
      findings.push_back(std::move(finding));
  }
}

}  // namespace rungproof
