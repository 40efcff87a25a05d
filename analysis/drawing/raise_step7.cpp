// The result of logic operation is followed as an expression: what is closed, and the AND group that is open behind an
// O without operand. The drawing is made of gates with contacts at the rail; ladder puts the inputs of an AND into
// series.
#include "analysis/drawing/raise_step7.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "ir/s7200/isa.hpp"
#include "ir/s7300/box_match.hpp"
#include "ir/s7300/statement_role.hpp"

namespace rungproof {

namespace {

/// The logic of one level of parentheses; element 0: none.
struct LogicLevel {
  std::uint32_t closed = 0;  ///< all but the open group
  std::uint32_t group = 0;   ///< the AND group behind an O without operand
  bool hasOr = false;
  bool isFresh = true;  ///< the next scan begins a logic string
  ScanJoin join{};      ///< how the level joins what stands before it
};

/// L 20.0 of the LAD/FBD compiler, and what was written into it.
struct EditorBranch {
  Operand bit;
  std::uint32_t value = 0;
  bool isRead = false;
};

class RaisingStep7 {
 public:
  RaisingStep7(const Network& network, Form form) : network_(network), form_(form) {}

  Raised run() {
    // Where all that it may write is known, every statement is there, and some operand is in no file.
    const bool isLost = !network_.complete && !network_.mayWrite;
    if (isLost) return {std::nullopt, "a line of the network could not be read", nullptr};
    drawing_.elements.emplace_back();  // the rail
    for (; at_ < network_.instructions.size() && reason_.empty(); ++at_) step();
    if (reason_.empty() && (levels_.size() > 1 || isOpenEnded_ || !loaded_.empty())) refuse("ends without a coil");
    if (reason_.empty() && !std::ranges::all_of(branches_, &EditorBranch::isRead))
      refuse("leaves an intermediate result to other networks");
    if (!reason_.empty()) return {std::nullopt, reason_, faulty_};
    return {std::move(drawing_), {}, nullptr};
  }

 private:
  const Instruction& current() const { return network_.instructions[std::min(at_, network_.instructions.size() - 1)]; }
  void refuse(std::string_view why) {
    if (!reason_.empty()) return;
    faulty_ = &current();
    std::string name(current().desc->drawn.empty() ? current().desc->stl : current().desc->drawn);
    if (!current().operands.empty()) name = std::string(current().desc->stl) + " " + toString(current().operands[0]);
    reason_ = fmt::format("{} {}", name, why);
  }
  LogicLevel& level() { return levels_.back(); }

  std::uint32_t add(Shape shape, const Desc* desc, const std::vector<std::uint32_t>& from, Operands operands) {
    Element element;
    element.shape = shape;
    element.desc = desc;
    element.operands = std::move(operands);
    for (const std::uint32_t each : from) element.inputs.push_back({each, false});
    element.span = current().span;
    element.instruction = static_cast<std::uint32_t>(at_);
    drawing_.elements.push_back(std::move(element));
    return static_cast<std::uint32_t>(drawing_.elements.size() - 1);
  }
  std::uint32_t negation(std::uint32_t of) {
    return add(Shape::Contact, &s7200Instructions().only(Role::Not), {of}, {});
  }
  std::uint32_t gate(Shape shape, std::uint32_t left, std::uint32_t right) {
    return left == 0 ? right : add(shape, nullptr, {left, right}, {});
  }
  /// The whole RLO of a level.
  std::uint32_t total(LogicLevel& of) {
    if (of.group != 0) of.closed = gate(Shape::Or, of.closed, of.group);
    of.group = 0;
    of.hasOr = false;
    return of.closed;
  }

  void step() {
    if (!loaded_.empty() && !takesLoaded()) return refuse("stands where a comparison or a timer takes what was loaded");
    switch (statementRole(current())) {
      case StatementRole::Nothing: return;
      case StatementRole::AndScan:
      case StatementRole::OrScan: return scan();
      case StatementRole::OrOfAnds: return orGroup();
      case StatementRole::Open: return open();
      case StatementRole::Close: return close();
      case StatementRole::Negate: return negate();
      case StatementRole::Edge: return edge();
      case StatementRole::Load: return load();
      case StatementRole::Compare:
      case StatementRole::CompareRealEqual: return compare();
      case StatementRole::Assign: return assign();
      case StatementRole::Latch:
      case StatementRole::ResetTimer:
      case StatementRole::CountUp:
      case StatementRole::CountDown:
      case StatementRole::ResetCounter: return coil({});
      case StatementRole::StartTimer:
      case StatementRole::SetCounter: return start();
      case StatementRole::JumpKeepingRlo: return enabledCall() ? void() : box();
      case StatementRole::Call: return call();
      default: return refuse("has no picture in LAD or FBD");
    }
  }
  bool takesLoaded() const {
    const StatementRole role = statementRole(current());
    return role == StatementRole::Load || isComparison(role) || role == StatementRole::StartTimer ||
           role == StatementRole::SetCounter;
  }

  // ---- Logic ----------------------------------------------------------------------------------------

  void scan() {
    const Operand& operand = current().operands[0];
    const bool isCondition = operand.kind == OperandKind::Constant;
    if (isCondition) return refuse("has no picture in LAD or FBD");
    const ScanJoin join = scanJoin(current());
    if (EditorBranch* branch = branchOf(operand)) {
      if (!level().isFresh) return refuse("is an intermediate result in the middle of logic");
      branch->isRead = true;
      return check(join, join.negated ? negation(branch->value) : branch->value, true);
    }
    const Desc& contact = s7200Instructions().bitContact(Role::Load, join.negated);
    check(join, add(Shape::Contact, &contact, {0}, {operand}), false);
  }

  void check(ScanJoin join, std::uint32_t value, bool isBranch) {
    LogicLevel& here = level();
    isOpenEnded_ = true;
    if (here.isFresh) {
      if (hasCoil_ && levels_.size() == 1 && !isBranch && !isCallAhead())
        return refuse("begins a second rung in the network");
      here.closed = value;
      here.group = 0;
      here.hasOr = here.isFresh = false;
    } else if (join.role == StatementRole::AndScan && here.hasOr) {
      here.group = gate(Shape::And, here.group, value);
    } else {
      const std::uint32_t left = total(here);
      here.closed = gate(join.role == StatementRole::AndScan ? Shape::And : Shape::Or, left, value);
    }
  }

  void orGroup() {
    if (level().isFresh) return refuse("stands before any check");
    total(level());
    level().hasOr = true;
  }

  void open() {
    const ScanJoin join = scanJoin(current());
    if (join.role == StatementRole::XorScan) return refuse("has no picture in LAD or FBD");
    LogicLevel inner;
    inner.join = join;
    levels_.push_back(inner);
  }

  void close() {
    if (levels_.size() < 2) return refuse("closes what this network has not opened");
    if (level().isFresh) return refuse("closes parentheses without a check");
    const ScanJoin join = level().join;
    const std::uint32_t value = total(level());
    levels_.pop_back();
    check(join, join.negated ? negation(value) : value, false);
  }

  void negate() {
    if (level().isFresh || level().hasOr) return refuse("negates what this network has not checked");
    level().closed = negation(total(level()));
  }

  /// Seen as a contact it would stand beside others of an AND; only behind the whole logic it is drawn.
  void edge() {
    if (level().isFresh || levels_.size() > 1 || form_ == Form::Fbd) return refuse("has no picture here");
    level().closed = add(Shape::Contact, current().desc, {total(level())}, current().operands);
  }

  // ---- Values ---------------------------------------------------------------------------------------

  void load() {
    if (loaded_.empty() && s7300::boxAt(network_, at_)) return box();
    if (loaded_.size() == 2) return refuse("has no picture in LAD or FBD");
    loaded_.push_back(current().operands[0]);
  }

  void compare() {
    // Its RLO takes the place of what was checked before: it is drawn where nothing was.
    if (loaded_.size() != 2 || !level().isFresh) return refuse("has no picture here");
    check({}, add(Shape::Contact, current().desc, {0}, loaded_), false);
    loaded_.clear();
  }

  // ---- Coils ----------------------------------------------------------------------------------------

  void assign() {
    const Operand& operand = current().operands[0];
    const bool isEditorBit = operand.kind == OperandKind::Direct && operand.area == Area::L && operand.text.empty();
    if (!isEditorBit) return coil({});
    if (level().isFresh && !hasCoil_) return refuse("has no logic in this network");
    branches_.push_back({operand, ended()});
    isOpenEnded_ = false;
  }

  void start() {
    if (loaded_.size() != 1) return refuse("has no value in this network");
    coil(std::exchange(loaded_, {}));
  }

  void coil(Operands values) {
    if (levels_.size() > 1) return refuse("stands inside of parentheses");
    if (level().isFresh && !hasCoil_) return refuse("has no logic in this network");
    Operands operands = current().operands;
    operands.insert(operands.end(), values.begin(), values.end());
    const std::uint32_t from = ended();
    add(Shape::Coil, current().desc, {from}, std::move(operands));
    isOpenEnded_ = false;
  }

  void box() {
    const std::optional<s7300::MatchedBox> match = s7300::boxAt(network_, at_);
    if (!match) return refuse("has no picture in LAD or FBD");
    if (levels_.size() > 1) return refuse("stands inside of parentheses");
    if (level().isFresh && !hasCoil_) return refuse("has no logic in this network");
    const std::uint32_t from = ended();
    const std::uint32_t element = add(Shape::Box, match->desc, {from}, match->operands);
    at_ += match->length - 1;
    isOpenEnded_ = match->passesOn;
    if (match->passesOn) level() = LogicLevel{element, 0, false, false, {}};
  }

  // ---- Calls ----------------------------------------------------------------------------------------

  /// What stands in front of a call may be made for one of its pins.
  bool isCallAhead() const {
    return std::any_of(network_.instructions.begin() + static_cast<std::ptrdiff_t>(at_), network_.instructions.end(),
                       [](const Instruction& each) { return statementRole(each) == StatementRole::Call; });
  }

  void call() {
    if (levels_.size() > 1) return refuse("stands inside of parentheses");
    if (isOpenEnded_) return refuse("does not ask the logic in front of it");
    callBox(0, true);
  }

  /// JNB around a call: its EN. Behind the label A BR hands ENO on.
  bool enabledCall() {
    const std::vector<Instruction>& all = network_.instructions;
    const bool isCall = at_ + 2 < all.size() && statementRole(all[at_ + 1]) == StatementRole::Call &&
                        all[at_ + 2].desc->control == Control::LabelMark &&
                        all[at_ + 2].operands[0].value == all[at_].operands[0].value;
    if (!isCall || levels_.size() > 1 || level().isFresh) return false;
    const std::uint32_t enable = ended();
    const std::size_t behind = at_ + 3;
    const bool passesOn = behind < all.size() && statementRole(all[behind]) == StatementRole::AndScan &&
                          all[behind].operands[0].kind == OperandKind::Constant && all[behind].operands[0].text == "BR";
    ++at_;
    const std::uint32_t element = callBox(enable, !passesOn);
    at_ = passesOn ? behind : behind - 1;
    isOpenEnded_ = passesOn;
    if (passesOn) level() = LogicLevel{element, 0, false, false, {}};
    return true;
  }

  /// Bits that the compiler made in front of the call are power inputs; the first one that it reads behind it is the
  /// power output, unless ENO is.
  std::uint32_t callBox(std::uint32_t enable, bool mayFlowOut) {
    Operands operands = current().operands;
    std::vector<std::uint32_t> inputs{enable};
    std::optional<Operand> flow;
    for (std::size_t i = 1; i < operands.size(); ++i) {
      Operand& operand = operands[i];
      if (operand.kind == OperandKind::Missing) {
        operand.kind = OperandKind::Symbol;  // an open pin, which no power reaches
      } else if (EditorBranch* branch = branchOf(operand)) {
        inputs.push_back(branch->value);
        branch->isRead = true;
        operand = Operand{};
      } else if (mayFlowOut && !flow && isReadBehind(operand)) {
        flow = std::exchange(operand, Operand{});
      }
    }
    const std::uint32_t element = add(Shape::Box, current().desc, inputs, std::move(operands));
    if (flow) branches_.push_back({*flow, element, true});
    level().isFresh = hasCoil_ = true;
    isOpenEnded_ = false;
    return element;
  }
  bool isReadBehind(const Operand& bit) const {
    const bool isEditorBit =
        bit.kind == OperandKind::Direct && bit.area == Area::L && bit.width == Width::Bit && bit.text.empty();
    return isEditorBit && at_ + 1 < network_.instructions.size() &&
           std::any_of(network_.instructions.begin() + static_cast<std::ptrdiff_t>(at_) + 1,
                       network_.instructions.end(), [&](const Instruction& each) {
                         return statementRole(each) == StatementRole::AndScan && isSameBit(each.operands[0], bit);
                       });
  }
  static bool isSameBit(const Operand& a, const Operand& b) {
    return a.kind == OperandKind::Direct && a.area == b.area && a.offset == b.offset && a.bit == b.bit;
  }

  /// The RLO at a coil; the next check begins a new string.
  std::uint32_t ended() {
    const std::uint32_t value = total(level());
    level().isFresh = hasCoil_ = true;
    return value;
  }

  EditorBranch* branchOf(const Operand& operand) {
    if (operand.kind != OperandKind::Direct || operand.area != Area::L || !operand.text.empty()) return nullptr;
    const auto same = std::ranges::find_if(branches_.rbegin(), branches_.rend(), [&](const EditorBranch& branch) {
      return branch.bit.offset == operand.offset && branch.bit.bit == operand.bit;
    });
    return same == branches_.rend() ? nullptr : &*same;
  }

  const Network& network_;
  Form form_;
  std::size_t at_ = 0;
  Drawing drawing_;
  std::vector<LogicLevel> levels_ = std::vector<LogicLevel>(1);
  Operands loaded_;  ///< L that a comparison or a timer takes
  std::vector<EditorBranch> branches_;
  bool hasCoil_ = false;
  bool isOpenEnded_ = false;  ///< something was checked and no coil takes it yet
  std::string reason_;
  const Instruction* faulty_ = nullptr;
};

}  // namespace

Raised raiseStep7(const Network& network, Form form) { return RaisingStep7(network, form).run(); }

}  // namespace rungproof
