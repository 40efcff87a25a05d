// One pass over the main program: only what stands there outside of loops and is never left out runs once a scan.
#include "analysis/flow/pulse_bits.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <tuple>

namespace rungproof {

namespace {

constexpr Condition lasting = condition::FirstScan | condition::Pulse | condition::NotFirstScan | condition::Pause;

/// A contact of a bit: 0 if the bit is `isNegated`.
struct Literal {
  std::uint32_t key;  ///< cell * 8 + bit
  bool isNegated;

  friend bool operator==(const Literal&, const Literal&) = default;
};

class PulseFinder {
 public:
  explicit PulseFinder(const Facts& facts) : facts_(facts) {}

  KnownBits run() {
    for (const InstructionPlace& place : facts_.instructions()) {
      if (!runsOnce(place) || place.instruction->operands.empty()) continue;
      const Operand& o = place.instruction->operands[0];
      if (o.kind != OperandKind::Direct || o.area == Area::L || o.bit > 7 || place.instruction->desc->immediate)
        continue;
      switch (roleOf(*place.instruction)) {
        case Role::Assign: coil(place, o); break;
        case Role::Set: latch(place, o); break;
        case Role::Ton: timer(place, o); break;
        case Role::Ctu: counter(place, o); break;
        default: break;
      }
    }
    return std::move(bits_);
  }

 private:
  bool runsOnce(const InstructionPlace& place) const {
    const ExecutionPoint& point = facts_.execution().at(place.instruction->id);
    return facts_.program().pous[place.block].kind == PouKind::Main && point.isReachable && !point.inLoop &&
           !point.isSkipped && !facts_.isUnread(place.instruction->id);
  }
  Condition flowOf(const InstructionPlace& place) const { return facts_.stack().at(place.instruction->id).flow; }
  std::uint32_t noKey() const { return facts_.bits().size(); }
  std::uint32_t keyOf(const Operand& o, std::uint32_t block) const {
    const std::uint32_t cell = facts_.index().cells().cell(o.area, o.offset, block);
    return cell == facts_.index().cells().size() || o.bit > 7 ? noKey() : cell * 8 + o.bit;
  }
  void know(const Operand& o, Condition what) { bits_.emplace(bitKey(o.area, o.offset, o.bit), what); }

  /// Instructions that write the bit; nothing if that is not known for certain.
  std::optional<std::vector<std::uint32_t>> writersOf(std::uint32_t key) const {
    constexpr std::size_t most = 1000;  // accesses that are looked through
    if (key == noKey() || facts_.index().at(key / 8).size() > most || facts_.index().isWrittenAtLarge(key / 8) ||
        facts_.isExternal(key / 8))
      return std::nullopt;
    std::vector<std::uint32_t> writers;
    for (const std::uint32_t i : facts_.index().at(key / 8)) {
      const Access& access = facts_.access(i);
      if (!access.write) continue;
      if (access.maybe || access.most != access.count) return std::nullopt;
      const std::uint32_t start = facts_.cellOf(access) * 8;
      const bool isBits = access.width == Width::Bit && !access.byNumber();
      const bool covers = !isBits || (start + access.bit <= key && key < start + access.bit + access.count);
      if (covers && (writers.empty() || writers.back() != access.instruction)) writers.push_back(access.instruction);
    }
    return writers;
  }
  bool isOnlyWriter(std::uint32_t key, const Instruction& instruction) const {
    if (key == noKey() || facts_.writers(key / 8, key % 8) != 1) return false;
    const auto writers = writersOf(key);
    return writers && writers->size() == 1 && writers->front() == instruction.id;
  }

  std::optional<Literal> literalOf(const Instruction& contact, std::uint32_t block) const {
    if (contact.desc->execution != Execution::Stack || contact.operands.size() != 1 ||
        contact.operands[0].kind != OperandKind::Direct)
      return std::nullopt;
    const std::uint32_t key = keyOf(contact.operands[0], block);
    if (key == noKey()) return std::nullopt;
    return Literal{key, invertsImage(*contact.desc)};
  }
  /// What was found in front of a step.
  struct KnownRung {
    std::uint32_t step = 0;
    std::optional<std::vector<Literal>> literals;
  };
  /// Of a network: outputs behind each other share what stands in front of them, branches what stands in front of LPS.
  struct KnownRungs {
    KnownRung ofOutput, ofBranch;
  };

  /// Bit contacts of a rung that is one series of contacts (`joint`: And) or one row of parallel ones (Or).
  std::optional<std::vector<Literal>> rungBefore(const InstructionPlace& place, Role joint) const {
    KnownRungs& known = rungs_[std::tuple(place.block, place.network, joint)];
    KnownRung branch;
    std::size_t behindBranch = 0;
    std::optional<std::vector<Literal>> literals = std::vector<Literal>();
    if (!walkBack(place, joint, known, *literals, branch.step, behindBranch)) literals.reset();
    if (literals && branch.step > 0)
      branch.literals.emplace(literals->begin() + static_cast<std::ptrdiff_t>(behindBranch), literals->end());
    if (branch.step > 0) known.ofBranch = std::move(branch);
    known.ofOutput = {place.step, literals};
    return literals;
  }
  /// False: it is no such rung. `branch`: the step of the nearest LPS, `behindBranch` literals stand behind it.
  bool walkBack(const InstructionPlace& place, Role joint, const KnownRungs& known, std::vector<Literal>& literals,
                std::uint32_t& branch, std::size_t& behindBranch) const {
    const Flow& flow = facts_.plan().flows[place.block];
    for (std::uint32_t at = place.step; at > 0 && flow.steps[at - 1].network == place.network;) {
      for (const KnownRung* rung : {&known.ofOutput, &known.ofBranch}) {
        if (rung->step != at) continue;
        if (rung->literals) literals.insert(literals.end(), rung->literals->begin(), rung->literals->end());
        return rung->literals.has_value();
      }
      const Instruction& instruction = *flow.steps[--at].instruction;
      const Role role = roleOf(instruction);
      if (role == Role::Load || role == joint) {
        if (const auto literal = literalOf(instruction, place.block))
          literals.push_back(*literal);
        else if (joint == Role::Or)
          return false;
        if (role == Role::Load) return true;
      } else if (role == Role::Lpp || role == Role::Lrd) {
        for (int open = 1; open > 0 && at > 0;) {
          const Role earlier = roleOf(*flow.steps[--at].instruction);
          open += earlier == Role::Lpp ? 1 : earlier == Role::Lps ? -1 : 0;
        }
      } else if (role == Role::Lps) {
        if (branch == 0) behindBranch = literals.size();
        if (branch == 0) branch = at;
      } else if (isLogic(role) || instruction.desc->control != Control::None) {
        return false;
      }
    }
    return false;
  }

  void coil(const InstructionPlace& place, const Operand& o) {
    if (hasBitAndWord(o.area) || !isOnlyWriter(keyOf(o, place.block), *place.instruction)) return;
    const Condition flow = flowOf(place) & lasting;
    if (flow != 0)
      know(o, flow);
    else if (isEdgeByHand(place))
      know(o, condition::Pulse);
  }

  /// `x AND NOT m` where a later coil gives m the value of x: on in the scan in which x comes, then m blocks it.
  bool isEdgeByHand(const InstructionPlace& place) const {
    const auto rung = rungBefore(place, Role::And);
    if (!rung) return false;
    return std::any_of(rung->begin(), rung->end(), [&](const Literal& blocked) {
      if (!blocked.isNegated || facts_.writers(blocked.key / 8, blocked.key % 8) != 1) return false;
      const auto writers = writersOf(blocked.key);
      if (!writers || writers->size() != 1) return false;
      const InstructionPlace& memory = facts_.place(writers->front());
      if (!isPlainCoil(*memory.instruction->desc) || !runsOnce(memory) || memory.step < place.step) return false;
      const auto follows = rungBefore(memory, Role::And);
      return follows && follows->size() == 1 && isPlain(memory) &&
             std::find(rung->begin(), rung->end(), follows->front()) != rung->end() &&
             !isWrittenBetween(follows->front().key, place.step, memory.step);
    });
  }
  /// The rung holds nothing but bit contacts: as many as it has logic instructions in front of its first output.
  bool isPlain(const InstructionPlace& place) const {
    const Flow& flow = facts_.plan().flows[place.block];
    for (std::uint32_t at = place.step; at > 0 && flow.steps[at - 1].network == place.network;) {
      const Instruction& instruction = *flow.steps[--at].instruction;
      if (roleOf(instruction) == Role::Load) return literalOf(instruction, place.block).has_value();
      if (roleOf(instruction) == Role::And && !literalOf(instruction, place.block)) return false;
    }
    return false;
  }
  bool isWrittenBetween(std::uint32_t key, std::uint32_t from, std::uint32_t to) const {
    const auto writers = writersOf(key);
    if (!writers) return true;
    return std::any_of(writers->begin(), writers->end(), [&](std::uint32_t id) {
      const InstructionPlace& place = facts_.place(id);
      const bool isMain = facts_.program().pous[place.block].kind == PouKind::Main;
      return !isMain || (place.step > from && place.step < to);
    });
  }

  /// S for one scan, and an R that takes the bit back whenever it is on.
  void latch(const InstructionPlace& place, const Operand& o) {
    const Condition flow = flowOf(place) & (condition::FirstScan | condition::Pulse);
    const std::uint32_t key = keyOf(o, place.block);
    if (flow == 0 || hasBitAndWord(o.area) || key == noKey() || facts_.bits().at(key).size() != 2) return;
    const auto writers = writersOf(key);
    if (!writers || writers->size() != 2) return;
    const std::uint32_t other = writers->front() == place.instruction->id ? writers->back() : writers->front();
    const InstructionPlace& reset = facts_.place(other);
    if (!isReset(roleOf(*reset.instruction)) || reset.instruction->desc->immediate || !runsOnce(reset)) return;
    const auto rung = rungBefore(reset, Role::And);
    const bool isItsOwn = rung && isPlain(reset) && *rung == std::vector<Literal>{{key, false}};
    if ((flowOf(reset) & condition::Always) == 0 && !isItsOwn) return;
    know(o, reset.step > place.step ? flow : condition::Pulse);
  }

  /// A box that its own bit switches off, or resets, in the next scan.
  void timer(const InstructionPlace& place, const Operand& o) {
    const auto rung = rungBefore(place, Role::And);
    if (!rung || facts_.timerBoxes(o.offset).size() != 1 || !hasPreset(*place.instruction)) return;
    if (std::find(rung->begin(), rung->end(), Literal{keyOf(o, place.block), true}) != rung->end())
      know(o, condition::Pulse);
  }
  void counter(const InstructionPlace& place, const Operand& o) {
    const auto resets = rungBefore(place, Role::Or);
    if (!resets || facts_.counterBoxes(o.offset).size() != 1 || !hasPreset(*place.instruction)) return;
    if (std::find(resets->begin(), resets->end(), Literal{keyOf(o, place.block), false}) != resets->end())
      know(o, condition::Pulse);
  }
  static bool hasPreset(const Instruction& box) {
    return box.operands.size() > 1 && box.operands[1].kind == OperandKind::Constant && box.operands[1].value > 0;
  }

  const Facts& facts_;
  KnownBits bits_;
  mutable std::map<std::tuple<std::uint32_t, std::uint32_t, Role>, KnownRungs> rungs_;  ///< by block, network, joint
};

}  // namespace

KnownBits pulseBits(const Facts& facts) { return PulseFinder(facts).run(); }

}  // namespace rungproof
