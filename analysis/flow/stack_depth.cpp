// The run: a stack of entries without a bottom, on which every entry remembers where it came from.
#include "analysis/flow/stack_depth.hpp"

#include <algorithm>

#include "ir/s7200/cpu.hpp"

namespace rungproof {

namespace {

/// Where the one may be 1 at most, the other may be 0 at most.
constexpr Condition atMostOn = condition::FirstScan | condition::Pulse;
constexpr Condition atMostOff = condition::NotFirstScan | condition::Pause;
static_assert(condition::NotFirstScan == condition::FirstScan << 3 && condition::Pause == condition::Pulse << 3);

}  // namespace

Condition conjunction(Condition a, Condition b) {
  Condition result = (a | b) & static_cast<Condition>(~(condition::Always | atMostOff));
  if ((a & b & condition::Always) != 0) result |= condition::Always;
  if ((a & condition::Always) != 0) return static_cast<Condition>(result | (b & atMostOff));
  if ((b & condition::Always) != 0) return static_cast<Condition>(result | (a & atMostOff));
  return static_cast<Condition>(result | (a & b & atMostOff));
}

Condition disjunction(Condition a, Condition b) {
  if ((a & condition::Never) != 0) return b;
  if ((b & condition::Never) != 0) return a;
  Condition result = a & b;
  if (((a | b) & condition::Always) != 0) result |= condition::Always;
  return static_cast<Condition>(result | ((a | b) & (condition::ByArithmetic | atMostOff)));
}

Condition negation(Condition a) {
  Condition result = a & condition::ByArithmetic;
  if ((a & condition::Always) != 0) result |= condition::Never;
  if ((a & condition::Never) != 0) result |= condition::Always;
  return static_cast<Condition>(result | (a & atMostOn) << 3 | (a & atMostOff) >> 3);
}

Condition conditionOf(const Operand& bit, bool negated, const KnownBits& known) {
  if (bit.kind != OperandKind::Direct) return 0;
  Condition result = 0;
  if (bit.area == Area::SM && bit.offset == 0) {
    if (bit.bit == 0) result = condition::Always;
    if (bit.bit >= 1 && bit.bit <= 3) result = condition::FirstScan | condition::Pulse;
  } else if (bit.area == Area::SM && bit.offset == 1) {
    result = condition::ByArithmetic;
  } else if (!known.empty()) {
    const auto found = known.find(bitKey(bit.area, bit.offset, bit.bit));
    if (found != known.end()) result = found->second;
  }
  return negated ? negation(result) : result;
}

namespace {

enum class Given : std::uint8_t { No, BlockEntry, Loop, Segment };

struct Entry {
  const Instruction* by = nullptr;      ///< load, or operation that made the value
  const Instruction* lostAt = nullptr;  ///< push that moved the entry out of the bottom
  Condition flow = 0;
  Given given = Given::No;
  bool isRead = false;
};

/// An LPS that waits for its LPP, with the size of the stack right after it.
struct Bracket {
  std::size_t size;
  const Instruction* by;
};

class Run {
 public:
  using Inputs = std::unordered_map<std::uint32_t, std::vector<Condition>>;
  Run(const Target& target, const KnownBits& known, std::vector<StackFault>& faults, std::vector<StackPoint>& points,
      Inputs& inputs)
      : levels_(static_cast<std::size_t>(cpuFeatures(target).stackLevels)),
        known_(known),
        faults_(faults),
        points_(points),
        inputs_(inputs) {}

  void block(const Flow& flow) {
    entries_.clear();
    brackets_.clear();
    own_ = flowsFrom_ = foreignBrackets_ = 0;
    inSegment_ = false;
    targets_.assign(flow.steps.size(), 0);
    for (const FlowStep& step : flow.steps) {
      if (step.instruction->desc->control == Control::Jump && step.partner != noPartner) targets_[step.partner] = 1;
    }
    if (flow.pou->kind != PouKind::Main) give(Given::BlockEntry, condition::Always);
    std::uint32_t network = noPartner;
    for (std::uint32_t i = 0; i < flow.steps.size(); ++i) {
      if (flow.steps[i].network != network) {
        endNetwork();
        network = flow.steps[i].network;
      }
      step(*flow.steps[i].instruction, targets_[i] != 0);
    }
    endNetwork();
    for (const Entry& entry : entries_) {
      const bool isLoad = entry.by != nullptr && isLogic(roleOf(*entry.by));
      if (isLoad && !entry.isRead) fault(StackFaultKind::LoadUnused, *entry.by);
    }
  }

 private:
  std::size_t size() const { return entries_.size(); }
  std::size_t ownLevels() const { return size() - own_; }
  Entry* level(std::size_t k) { return k < size() ? &entries_[size() - 1 - k] : nullptr; }
  bool isOwn(std::size_t k) const { return k < ownLevels(); }
  Condition flowOf(std::size_t k) {
    const Entry* entry = level(k);
    return entry == nullptr || size() - 1 - k < flowsFrom_ ? 0 : entry->flow;
  }
  void fault(StackFaultKind kind, const Instruction& at, const Instruction* other = nullptr, int found = 0,
             int needed = 0) {
    faults_.push_back({kind, &at, other, found, needed});
  }

  void endNetwork() {
    for (const Bracket& bracket : brackets_) fault(StackFaultKind::LpsNotPopped, *bracket.by);
    foreignBrackets_ += brackets_.size();
    brackets_.clear();
    own_ = size();
    isReported_ = hasBox_ = false;
  }

  void give(Given given, Condition flow) {
    Entry entry;
    entry.given = given;
    entry.flow = flow;
    entry.isRead = true;
    entries_.push_back(entry);
  }
  void giveTop(Given given, Condition flow) {
    if (entries_.empty()) return give(given, flow);
    Entry& top = entries_.back();
    top = Entry{};
    top.given = given;
    top.flow = flow;
    top.isRead = true;
    flowsFrom_ = std::min(flowsFrom_, size() - 1);
  }

  void push(const Instruction& by, Condition flow) {
    Entry entry;
    entry.by = &by;
    entry.flow = inSegment_ ? static_cast<Condition>(flow & ~condition::Always) : flow;
    entries_.push_back(entry);
    flowsFrom_ = std::min(flowsFrom_, size() - 1);
    if (size() <= levels_) return;
    Entry& lost = entries_[size() - 1 - levels_];
    if (lost.lostAt == nullptr) lost.lostAt = &by;
  }

  /// Marks level k as used by `at` and reports where it comes from if that is not this network.
  void use(std::size_t k, const Instruction& at) {
    Entry* entry = level(k);
    if (entry == nullptr) return fromBelow(at, nullptr);
    entry->isRead = true;
    if (entry->lostAt != nullptr) {
      fault(StackFaultKind::TooDeep, *entry->lostAt, &at);
      entry->lostAt = nullptr;
    }
    if (!isOwn(k) && entry->given == Given::No) fromBelow(at, entry->by);
  }
  void fromBelow(const Instruction& at, const Instruction* load) {
    if (!isReported_) fault(StackFaultKind::FromBelow, at, load);
    isReported_ = true;
  }
  /// After an operation the top belongs to this network.
  void adopt() { own_ = std::min(own_, size() == 0 ? 0 : size() - 1); }

  void change(const Instruction& by, Condition flow) {
    use(0, by);
    if (entries_.empty()) push(by, 0);
    Entry& top = entries_.back();
    const bool isRead = top.isRead && top.given != Given::No;
    top.flow = flow;
    top.given = Given::No;
    top.by = &by;
    top.isRead = isRead;
    flowsFrom_ = std::min(flowsFrom_, size() - 1);
    adopt();
  }

  /// ALD, OLD: two levels become one.
  void combine(const Instruction& by, bool isAnd) {
    const Condition flow = isAnd ? conjunction(flowOf(0), flowOf(1)) : disjunction(flowOf(0), flowOf(1));
    use(0, by);
    use(1, by);
    if (size() >= 2) entries_.pop_back();
    if (entries_.empty()) push(by, 0);
    Entry& top = entries_.back();
    top = Entry{};
    top.by = &by;
    top.flow = flow;
    flowsFrom_ = std::min(flowsFrom_, size() - 1);
    adopt();
    if (!brackets_.empty() && size() < brackets_.back().size) brackets_.pop_back();
  }

  void pushCopy(const Instruction& at) {
    use(0, at);
    const Condition flow = flowOf(0);
    adopt();
    push(at, flow);
    entries_.back().isRead = true;
    brackets_.push_back({size(), &at});
  }

  void readOrPop(const Instruction& at, bool isPop) {
    if (brackets_.empty()) {
      if (foreignBrackets_ > 0) {
        fromBelow(at, nullptr);
        if (isPop) --foreignBrackets_;
      } else {
        fault(isPop ? StackFaultKind::LppWithoutLps : StackFaultKind::LrdWithoutLps, at);
      }
    } else {
      const std::size_t bracket = brackets_.back().size;
      if (size() > bracket) {
        fault(StackFaultKind::Covered, at, entries_[bracket].by);
        entries_.resize(bracket);
      }
      if (isPop) brackets_.pop_back();
    }
    use(1, at);
    if (size() < 2) return;
    if (isPop) {
      entries_.pop_back();
    } else {
      const Entry below = entries_[size() - 2];
      entries_.back().flow = size() - 2 < flowsFrom_ ? 0 : below.flow;
      entries_.back().isRead = true;
    }
    adopt();
  }

  void loadLevel(const Instruction& at) {
    const auto n = at.operands.empty() ? 0
                                       : static_cast<std::size_t>(std::clamp<std::int64_t>(
                                             at.operands[0].value, 0, static_cast<std::int64_t>(levels_) - 1));
    Entry* entry = level(n);
    if (entry == nullptr || (!isOwn(n) && entry->given == Given::No)) {
      fault(StackFaultKind::LdsBeyond, at, nullptr, static_cast<int>(ownLevels()), static_cast<int>(n));
    } else {
      use(n, at);
    }
    push(at, flowOf(n));
    entries_.back().isRead = true;
  }

  /// A box that takes its lower inputs from the stack (001:3994-4004).
  void boxInputs(const Instruction& at, std::size_t needed) {
    std::size_t found = 0;
    std::vector<Condition>& conditions = inputs_[at.id];
    for (std::size_t k = 0; k < needed; ++k) conditions.push_back(flowOf(k));
    for (std::size_t k = 0; k < needed; ++k) {
      Entry* entry = level(k);
      const bool isForeign = entry != nullptr && !isOwn(k);
      const bool isLeftover = isForeign && (entry->given == Given::BlockEntry || entry->given == Given::Loop ||
                                            (entry->given == Given::No && entry->isRead));
      if (entry == nullptr || isLeftover) break;
      use(k, at);
      ++found;
    }
    if (found < needed) {
      isReported_ = true;
      return fault(StackFaultKind::TooFewInputs, at, nullptr, static_cast<int>(found), static_cast<int>(needed));
    }
    Entry* below = level(needed);
    if (below == nullptr || !isOwn(needed) || below->isRead || below->given != Given::No) return;
    fault(StackFaultKind::TooManyInputs, at, below->by, static_cast<int>(needed) + 1, static_cast<int>(needed));
    below->isRead = true;
  }

  /// Everything below a label comes from elsewhere on one of its paths.
  void join() { own_ = flowsFrom_ = size(); }

  void step(const Instruction& at, bool isTarget) {
    if (isTarget) join();
    const Desc& desc = *at.desc;
    points_[at.id] = {
        flowOf(0), static_cast<std::uint8_t>(std::min<std::size_t>(ownLevels(), 255)),
        entries_.empty() || entries_.back().by == nullptr ? StackPoint::noSource : entries_.back().by->id};
    const auto contact = [&] {
      return at.operands.empty() || desc.execution == Execution::Compare
                 ? Condition{0}
                 : conditionOf(at.operands[0], desc.negated, known_);
    };
    switch (desc.role) {
      case Role::Load: return push(at, contact());
      case Role::And: return change(at, conjunction(flowOf(0), contact()));
      case Role::Or: return change(at, disjunction(flowOf(0), contact()));
      case Role::Not: return change(at, negation(flowOf(0)));
      case Role::Eu:
      case Role::Ed: return change(at, static_cast<Condition>(condition::Pulse | (flowOf(0) & condition::FirstScan)));
      case Role::Ald: return combine(at, true);
      case Role::Old: return combine(at, false);
      case Role::Lps: return pushCopy(at);
      case Role::Lrd: return readOrPop(at, false);
      case Role::Lpp: return readOrPop(at, true);
      case Role::Lds: return loadLevel(at);
      case Role::Aeno:
        if (!hasBox_) fault(StackFaultKind::AenoWithoutBox, at);
        return change(at, flowOf(0) & static_cast<Condition>(~condition::Always));
      default: break;
    }
    control(at, desc);
  }

  void control(const Instruction& at, const Desc& desc) {
    if (desc.eno) hasBox_ = true;
    switch (desc.control) {
      case Control::Lscr: inSegment_ = true; return giveTop(Given::Segment, 0);
      case Control::ScrEnd: inSegment_ = false; break;
      case Control::For: use(0, at); return giveTop(Given::Loop, 0);
      case Control::Next: return giveTop(Given::Loop, 0);
      default: break;
    }
    if (desc.stack.needs > 1) return boxInputs(at, desc.stack.needs);
    if (desc.stack.needs == 0) return;
    use(0, at);
  }

  const std::size_t levels_;  ///< of the logic stack
  const KnownBits& known_;
  std::vector<StackFault>& faults_;
  std::vector<StackPoint>& points_;
  Inputs& inputs_;
  std::vector<Entry> entries_;
  std::vector<Bracket> brackets_;      ///< open LPS of this network
  std::vector<std::uint8_t> targets_;  ///< by step: a jump leads here
  std::size_t own_ = 0;                ///< entries below belong to earlier networks
  std::size_t flowsFrom_ = 0;          ///< conditions of entries below are not known any more
  std::size_t foreignBrackets_ = 0;
  bool isReported_ = false;  ///< FromBelow was reported for this network
  bool hasBox_ = false;      ///< a box with ENO stood in this network
  bool inSegment_ = false;
};

}  // namespace

StackRun::StackRun(const Program& program, const Plan& plan, const KnownBits& known) {
  points_.resize(program.instructionCount());
  if (plan.form() != StatementForm::Rungs) return;  // has no such stack (analysis/flow/logic_string.hpp)
  Run run(program.target, known, faults_, points_, inputs_);
  for (const Flow& flow : plan.flows) run.block(flow);
  // A network with an unreadable line has lost an instruction; what the stack misses there says nothing.
  std::vector<std::uint8_t> isDamaged(points_.size(), 0);
  for (const Flow& flow : plan.flows) {
    for (const FlowStep& step : flow.steps)
      isDamaged[step.instruction->id] = !flow.pou->networks[step.network].complete;
  }
  for (std::size_t id = 0; id < points_.size(); ++id) {
    if (isDamaged[id] != 0) points_[id].flow = 0;
  }
  for (auto& [id, conditions] : inputs_) {
    if (isDamaged[id] != 0) std::ranges::fill(conditions, Condition{0});
  }
  std::erase_if(faults_, [&](const StackFault& fault) { return isDamaged[fault.instruction->id] != 0; });
}

}  // namespace rungproof
