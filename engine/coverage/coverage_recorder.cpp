// Values of contacts are noted as they run; coils and boxes look back at those of their conditions.
#include "engine/coverage/coverage_recorder.hpp"

#include <algorithm>
#include <bit>

#include "engine/instruction_recorder.hpp"
#include "ir/iec/expression_role.hpp"
#include "ir/s7300/statement_detail.hpp"

namespace rungproof {

namespace {

/// The number that a constant or a value read stands for, by the type that the instruction gives its operand.
double comparedNumber(const Instruction& instruction, std::size_t index, std::uint64_t value) {
  switch (instruction.desc->operands[index].type) {
    case Type::Int: return static_cast<double>(static_cast<std::int16_t>(value));
    case Type::DInt: return static_cast<double>(static_cast<std::int32_t>(value));
    case Type::Real: return static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(value)));
    default: return static_cast<double>(value & 0xFF);
  }
}

std::uint64_t maskedTo(std::uint64_t value, Width width) { return value & Concrete::mask(bits(width)); }

}  // namespace

bool relates(Relation relation, double left, double right) {
  switch (relation) {
    case Relation::Less: return left < right;
    case Relation::LessEqual: return left <= right;
    case Relation::Equal: return left == right;
    case Relation::GreaterEqual: return left >= right;
    case Relation::Greater: return left > right;
    default: return left != right;
  }
}

CoverageRecorder::CoverageRecorder(const CoverageMap& map)
    : map_(map),
      stamps_(map.leaves().size(), 0),
      values_(map.leaves().size(), 0),
      contacts_(map.leaves().size()),
      networks_(map.networks().size(), false),
      transitions_(map.transitions().size(), false),
      decisions_(map.decisions().size()) {
  for (std::size_t i = 0; i < decisions_.size(); ++i) decisions_[i].shown.resize(map.decisions()[i].leaves.size());
}

void CoverageRecorder::beginScan() {
  ++scan_;
  pending_ = nullptr;
}

void CoverageRecorder::note(std::uint32_t leaf, bool value) {
  values_[leaf] = value ? 1 : 0;
  stamps_[leaf] = scan_;
  bool& seen = contacts_[leaf][value ? 1 : 0];
  if (seen) return;
  seen = true;
  if (map_.leaves()[leaf].kind == LeafKind::Contact) ++news_;
}

bool CoverageRecorder::edgeGate(const Machine<Concrete>& machine, const Instruction& instruction) const {
  if (map_.plan().form() == StatementForm::Accumulators) {
    const bool before = operandValueInFront(machine, instruction, 0).value_or(0) != 0;
    return findsRise(instruction) ? !before : before;
  }
  const bool before = machine.store.get(Reg::EdgeMemory, map_.plan().edge[instruction.id]) != 0;
  const bool isFirst = machine.store.get(Reg::FirstScan, 0) != 0;
  return !isFirst && (roleOf(instruction) == Role::Eu ? !before : before);
}

std::optional<bool> CoverageRecorder::valueInFront(const Machine<Concrete>& machine,
                                                   const Instruction& instruction) const {
  if (instruction.desc->immediate) return std::nullopt;
  if (instruction.desc->execution != Execution::Compare) {
    const std::optional<std::uint64_t> value = operandValueInFront(machine, instruction, 0);
    return value ? std::optional((*value & 1) != 0) : std::nullopt;
  }
  if (instruction.operands.size() != 2 || instruction.desc->operands[0].type == Type::String) return std::nullopt;
  std::array<double, 2> numbers{};
  for (std::size_t i = 0; i < 2; ++i) {
    const Operand& operand = instruction.operands[i];
    const bool isConstant = operand.kind == OperandKind::Constant;
    const std::optional<std::uint64_t> value = isConstant ? std::optional(static_cast<std::uint64_t>(operand.value))
                                                          : operandValueInFront(machine, instruction, i);
    if (!value) return std::nullopt;
    numbers[i] = comparedNumber(instruction, i, *value);
  }
  return relates(instruction.desc->relation, numbers[0], numbers[1]);
}

void CoverageRecorder::before(const Machine<Concrete>& machine, const Instruction& instruction) {
  if (pending_ != nullptr) finish(machine, &instruction);
  if (!map_.isWatched(instruction.id)) return;
  const int leaf = map_.leafOf(instruction.id);
  if (leaf >= 0) {
    const auto number = static_cast<std::uint32_t>(leaf);
    if (map_.leaves()[number].kind == LeafKind::Edge) {
      note(number, edgeGate(machine, instruction));
      return;
    }
    const bool isPlain = map_.plan().form() != StatementForm::Accumulators &&
                         instruction.desc->execution != Execution::Compare &&
                         instruction.desc->relation == Relation::None;
    if (isPlain) {
      if (const std::optional<bool> value = valueInFront(machine, instruction)) note(number, *value);
      return;
    }
    pending_ = &instruction;
    topBefore_ = machine.stack[0];
    guess_ = map_.plan().form() == StatementForm::Expressions || instruction.operands.empty()
                 ? std::nullopt
                 : valueInFront(machine, instruction);
    return;
  }
  judge(machine, instruction);
}

/// What the contact saw shows in the registers behind it, as long as no interrupt came in between.
void CoverageRecorder::finish(const Machine<Concrete>& machine, const Instruction* next) {
  const Instruction& contact = *std::exchange(pending_, nullptr);
  const auto leaf = static_cast<std::uint32_t>(map_.leafOf(contact.id));
  std::optional<bool> value = guess_;
  const bool isBehind = next == nullptr || next->id == contact.id + 1;
  if (isBehind && map_.plan().form() == StatementForm::Accumulators) {
    value = isComparison(statementRole(contact)) ? machine.step7.rlo : machine.step7.sta;
  } else if (isBehind && map_.plan().form() == StatementForm::Expressions) {
    if (!machine.evaluation.empty()) value = (machine.evaluation.back() & 1) != 0;
  } else if (isBehind) {
    const Role role = roleOf(contact);
    const bool shows = role == Role::Load || topBefore_ == (role == Role::And);
    if (shows) value = machine.stack[0];
  }
  if (value) note(leaf, *value);
}

void CoverageRecorder::external(const ExternalSite& site, std::uint64_t value) {
  if (site.kind != External::ImmediateInput || site.instruction >= map_.program().instructionCount()) return;
  const int leaf = map_.leafOf(site.instruction);
  if (leaf >= 0) note(static_cast<std::uint32_t>(leaf), value != 0);
}

void CoverageRecorder::programEnded(const Machine<Concrete>& machine) {
  if (pending_ != nullptr) finish(machine, nullptr);
}

std::optional<bool> CoverageRecorder::power(const Machine<Concrete>& machine, const Instruction& instruction,
                                            unsigned level) const {
  if (map_.plan().form() == StatementForm::Accumulators) return machine.step7.rlo;
  if (map_.plan().form() == StatementForm::Expressions) {
    const bool hasTruth =
        expressionRole(instruction) == ExpressionRole::StoreBit || instruction.desc->control == Control::Jump;
    if (!hasTruth || machine.evaluation.empty()) return std::nullopt;
    return (machine.evaluation.back() & 1) != 0;
  }
  return machine.scrActive ? std::optional(machine.stack[level]) : std::nullopt;
}

void CoverageRecorder::judge(const Machine<Concrete>& machine, const Instruction& instruction) {
  const auto [first, count] = map_.decisionsOf(instruction.id);
  if (const int network = map_.networkOf(instruction.id);
      network >= 0 && !networks_[static_cast<std::size_t>(network)]) {
    bool isReached = map_.isUnconditional(instruction.id);
    const unsigned levels = map_.plan().form() == StatementForm::Rungs ? instruction.desc->stack.needs : 1U;
    for (unsigned level = 0; level < levels && !isReached; ++level)
      isReached = power(machine, instruction, level).value_or(false);
    if (isReached) {
      networks_[static_cast<std::size_t>(network)] = true;
      ++news_;
    }
  }
  if (const int transition = map_.transitionOf(instruction.id);
      transition >= 0 && !transitions_[static_cast<std::size_t>(transition)]) {
    const StepTransition& step = map_.transitions()[static_cast<std::size_t>(transition)];
    const bool hasPower = map_.isUnconditional(instruction.id) || power(machine, instruction, 0).value_or(false);
    bool isTaken = hasPower;
    if (isTaken && step.kind == TransitionKind::SetStep)
      isTaken = operandValueInFront(machine, instruction, 0).value_or(1) == 0;
    if (isTaken && step.kind == TransitionKind::StepWord) {
      const std::size_t to = instruction.operands.size() - 1;
      const std::optional<std::uint64_t> old = operandValueInFront(machine, instruction, to);
      isTaken = old && *old != maskedTo(step.value, operandWidth(instruction, to));
    }
    if (isTaken) {
      transitions_[static_cast<std::size_t>(transition)] = true;
      ++news_;
    }
  }
  for (std::size_t d = first; d < first + count; ++d) {
    const Decision& decision = map_.decisions()[d];
    const std::optional<bool> outcome = power(machine, instruction, decision.level);
    if (!outcome) continue;
    key_.assign((decision.leaves.size() + 7) / 8, '\0');
    bool isKnown = true;
    for (std::size_t i = 0; i < decision.leaves.size() && isKnown; ++i) {
      const std::uint32_t leaf = decision.leaves[i];
      isKnown = stamps_[leaf] == scan_;
      if (values_[leaf] != 0) key_[i / 8] = static_cast<char>(key_[i / 8] | 1 << (i % 8));
    }
    if (isKnown) noteDecision(d, key_, *outcome);
  }
}

void CoverageRecorder::noteDecision(std::size_t index, const std::string& key, bool outcome) {
  Seen& seen = decisions_[index];
  if (seen.outcomes.contains(key)) return;
  const Decision& decision = map_.decisions()[index];
  const auto bitOf = [](const std::string& from, std::size_t i) { return (from[i / 8] >> (i % 8) & 1) != 0; };
  std::size_t flipped = decision.leaves.size();
  PlainLogic logic;
  const auto outcomeOf = [&] {
    return map_.trees().evaluate(decision.condition, logic, [&](std::uint32_t leaf) {
      const auto i =
          static_cast<std::size_t>(std::ranges::lower_bound(decision.leaves, leaf) - decision.leaves.begin());
      return bitOf(key, i) != (i == flipped);
    });
  };
  if (outcomeOf() != outcome) return;
  seen.outcomes.emplace(key, outcome);
  for (std::size_t i = 0; i < decision.leaves.size(); ++i) {
    if (map_.leaves()[decision.leaves[i]].kind != LeafKind::Contact) continue;
    flipped = i;
    if (outcomeOf() == outcome) continue;
    Shown& shown = seen.shown[i];
    bool& decides = shown.decides[bitOf(key, i) ? 1 : 0][outcome ? 1 : 0];
    if (!decides) ++news_;
    decides = true;
    std::string other = key;
    other[i / 8] = static_cast<char>(other[i / 8] ^ 1 << (i % 8));
    shown.isUnique = shown.isUnique || seen.outcomes.contains(other);
  }
}

PairState CoverageRecorder::pair(std::size_t decision, std::size_t condition) const {
  const Shown& shown = decisions_[decision].shown[condition];
  if (shown.isUnique) return PairState::Unique;
  const auto& d = shown.decides;
  return (d[0][0] && d[1][1]) || (d[0][1] && d[1][0]) ? PairState::Masking : PairState::None;
}

void CoverageRecorder::add(const CoverageRecorder& other) {
  for (std::size_t i = 0; i < contacts_.size(); ++i) {
    for (std::size_t k = 0; k < 2; ++k) {
      if (contacts_[i][k] || !other.contacts_[i][k]) continue;
      contacts_[i][k] = true;
      if (map_.leaves()[i].kind == LeafKind::Contact) ++news_;
    }
  }
  const auto addAll = [&](std::vector<bool>& mine, const std::vector<bool>& others) {
    for (std::size_t i = 0; i < mine.size(); ++i) {
      if (mine[i] || !others[i]) continue;
      mine[i] = true;
      ++news_;
    }
  };
  addAll(networks_, other.networks_);
  addAll(transitions_, other.transitions_);
  for (std::size_t d = 0; d < decisions_.size(); ++d) {
    for (const auto& [key, outcome] : other.decisions_[d].outcomes) noteDecision(d, key, outcome);
  }
}

}  // namespace rungproof
