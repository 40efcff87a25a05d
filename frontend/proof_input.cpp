// Options and findings.
#include "frontend/proof_input.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "analysis/proof/proof_watch.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

ProverOptions proverOptionsOf(const Settings& settings) {
  ProverOptions options;
  options.choices = settings.choices();
  options.time.high = static_cast<std::uint32_t>(options.choices.watchdogMs());
  if (const auto range = settings.scanTime()) {
    options.time.low = static_cast<std::uint32_t>(std::max<std::int64_t>(range->low.count() / 1000, 1));
    options.time.high =
        static_cast<std::uint32_t>(std::max<std::int64_t>(range->high.count() / 1000, options.time.low));
  }
  if (const auto timeout = settings.timeout()) options.timeout = static_cast<double>(timeout->count()) / 1e6;
  options.memory = settings.memory().value_or(usualMemoryLimit());
  options.bound = static_cast<int>(settings.number(Opt::Bound, 0));
  options.jobs = static_cast<int>(settings.number(Opt::Jobs, 2));
  options.seed = static_cast<std::uint64_t>(settings.number(Opt::Seed, 1));
  return options;
}

ProverOptions lintProverOptionsOf(const Settings& settings) {
  constexpr std::uint64_t usual = 2ULL << 30;
  ProverOptions options = proverOptionsOf(settings);
  options.explains = false;
  if (!settings.memory()) options.memory = options.memory == 0 ? usual : std::min(options.memory, usual);
  if (const auto budget = settings.budget()) options.total = static_cast<double>(budget->count()) / 1e6;
  return options;
}

namespace {

constexpr std::size_t mostHalves = 8;  ///< of a conflict that are shown beside it

std::string helpOf(const BuiltinCheck& check, int scans) {
  switch (check.kind) {
    case BuiltinKind::TimerReachable:
    case BuiltinKind::TimerResettable: return "proved for every run; look at the input and the preset";
    case BuiltinKind::FlowOn:
    case BuiltinKind::FlowOff:
      return "proved for every run; a contact is missing, of the wrong kind, or at the wrong address";
    case BuiltinKind::LatchDrops:
      return "proved for every run; put the contact that ends it in series behind the holding contact, or mend the "
             "reset";
    case BuiltinKind::ContactMatters: return "proved for every run; remove it, or put it where it is needed";
    case BuiltinKind::StepEntered:
    case BuiltinKind::StepLeft: return "proved for every run; look at the conditions of the transitions";
    case BuiltinKind::CodeRuns:
      return "proved for every run; look at the conditions of the jumps, calls and loops before it";
    case BuiltinKind::CounterReset:
    case BuiltinKind::CountRises:
      return "proved for every run; the last load before the box is the reset or load input (001:3994-4004)";
    case BuiltinKind::TwoWaysOut:
    case BuiltinKind::StepsTogether:
      return fmt::format("seen in scan {} of a run that the engine repeats; make the conditions exclude each other",
                         scans);
    case BuiltinKind::PowerUp:
      return fmt::format("seen in scan {} of a run that the engine repeats; reset the bit that holds it with SM0.1",
                         scans);
    case BuiltinKind::Restart:
      return fmt::format("seen in scan {} of a run that the engine repeats; let the stop reset what starts the machine",
                         scans);
    default:
      return isRuleQuestion(check.kind) ? fmt::format("seen in scan {} of a run that the engine repeats", scans)
                                        : "'rungproof prove --builtin' shows the run";
  }
}

Finding findingAt(const ProofResult& result) {
  const BuiltinCheck& check = *result.builtin;
  Finding finding;
  finding.rule = check.rule;
  const Rule* rule = ruleNamed(finding.rule);
  finding.severity = rule == nullptr ? Severity::Warning : rule->severity;
  finding.message = check.message;
  finding.address = check.address;
  finding.confirmation = Confirmation::Confirmed;
  if (check.place != nullptr) finding.span = check.place->span;
  if (check.other != nullptr) {
    finding.related.push_back({check.other->span, check.kind == BuiltinKind::StackLevels
                                                      ? "the level is used here"
                                                      : "the other half of the conflict"});
  }
  finding.help = helpOf(check, result.depth);
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
  std::map<std::pair<BuiltinKind, const Instruction*>, std::size_t> byInstruction;
  const auto find = [&](std::size_t i) {
    while (root[i] != i) i = root[i];
    return i;
  };
  for (std::size_t i = 0; i < results.size(); ++i) {
    root.push_back(i);
    const BuiltinCheck& check = *results[i]->builtin;
    const bool isLost = check.other != nullptr && isRowLatch(*check.other);
    for (const Instruction* shared : {check.place, isLost ? check.other : check.place}) {
      const auto [found, isNew] = byInstruction.try_emplace({check.kind, shared}, i);
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
Finding joinedFinding(const ProofRow& group) {
  Finding finding = findingAt(*group.front());
  BitRow row = group.front()->builtin->row;
  std::set<std::string_view> last;
  std::set<const Instruction*> shown{group.front()->builtin->place};
  finding.related.clear();
  for (const ProofResult* result : group) {
    const BuiltinCheck& check = *result->builtin;
    row.bits.insert(row.bits.end(), check.row.bits.begin(), check.row.bits.end());
    last.insert(check.place->desc->stl);
    for (const Instruction* half : {check.other, check.place}) {
      if (half != nullptr && shown.insert(half).second && finding.related.size() < mostHalves)
        finding.related.push_back({half->span, "the other half of the conflict"});
    }
  }
  row.order();
  finding.message = group.front()->builtin->kind == BuiltinKind::PowerUp
                        ? powerUpMessage(row)
                        : conflictMessage(row, last.size() == 1 ? *last.begin() : std::string_view());
  finding.address = row.first();
  return finding;
}

}  // namespace

bool isRefuted(const ProofResult& result) {
  return result.builtin && (isWanted(result.builtin->kind) ? result.outcome == Outcome::Unreachable
                                                           : result.outcome == Outcome::Violated);
}

std::vector<Finding> findingsOf(const std::vector<const ProofResult*>& results) {
  ProofRow onBits;
  for (const ProofResult* result : results) {
    if (isRefuted(*result) && !result->builtin->row.empty()) onBits.push_back(result);
  }
  const std::map<const ProofResult*, ProofRow> rows = rowsOf(onBits);
  std::vector<Finding> findings;
  for (const ProofResult* result : results) {
    if (!isRefuted(*result)) continue;
    if (!result->builtin->row.empty()) {
      if (const auto row = rows.find(result); row != rows.end()) findings.push_back(joinedFinding(row->second));
      continue;
    }
    findings.push_back(findingAt(*result));
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

}  // namespace rungproof
