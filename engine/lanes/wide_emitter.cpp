// Blocks, branches, and what ends a trace's stay in the code.
#include "engine/lanes/wide_emitter.hpp"

#include "ir/check.hpp"

namespace rungproof::lanes {

using namespace asmjit;  // its Operand: by its full name
namespace Inst = x86::Inst;

namespace {

/// Mask registers that hold something from step to step.
constexpr std::size_t mostMasks = 4;

}  // namespace

WideEmitter::WideEmitter(const Code& code, const std::vector<bool>& isNeeded, LaneLayout& layout,
                         std::deque<StepByTrace>& byTrace, CodeHolder& holder)
    : code_(code),
      isNeeded_(isNeeded),
      layout_(layout),
      byTrace_(byTrace),
      c_(&holder),
      flow_(code, isNeeded, true),
      labels_(flow_.lastBlock + 2) {
  layout_.keepRows(flow_.keptRows);
}

bool WideEmitter::emit() {
  struct FirstError final : ErrorHandler {
    void handleError(Error, const char*, BaseEmitter*) override { isThere = true; }
    bool isThere = false;
  } error;
  c_.setErrorHandler(&error);
  FuncNode* const function = c_.addFunc(FuncSignatureT<void, std::uint8_t*>());
  function->frame().setAvxEnabled();
  function->frame().setAvx512Enabled();
  function->frame().setAvxCleanup();
  rows_ = c_.newGpq();
  function->setArg(0, rows_);
  for (Label& label : labels_) label = c_.newLabel();
  c_.mov(at(layout_.left(), wideTruthBytes), 0);
  if (!code_.isStraight) {
    active_ = c_.newGpq();
    c_.mov(active_, at(layout_.active(), wideTruthBytes));
    position_ = c_.newGpq();
    c_.xor_(position_.r32(), position_.r32());
  }
  for (step_ = 0; step_ < code_.steps.size(); ++step_) {
    if (!isNeeded_[step_]) continue;
    const Step& s = code_.steps[step_];
    if (hasValue(s.op)) {
      if (!flow_.isFolded[step_]) value(step_);
    } else if (s.op < CodeOp::Leave) {
      store(s);
    } else {
      control(s);
    }
    release();
    thinMasks(mostMasks);
  }
  step_ = static_cast<ValueId>(code_.steps.size() - 1);
  if (code_.countsTime && !code_.isStraight) checkTime();
  c_.bind(labels_.back());
  spreadRegisters();
  c_.ret();
  c_.endFunc();
  const bool isFinal = c_.finalize() == kErrorOk;
  c_.setErrorHandler(nullptr);
  return isFinal && !error.isThere;
}

/// Where a register stands as one number while the code runs.
std::optional<std::size_t> WideEmitter::oneNumber(std::uint64_t reg) const {
  const auto number = flow_.oneNumberAt.find(reg);
  if (number == flow_.oneNumberAt.end() || layout_.reg(reg)->rep == Rep::Truth) return std::nullopt;
  return layout_.kept(number->second);
}

/// What stood as one number while the code ran is brought to the rows.
void WideEmitter::spreadRegisters() {
  forgetAll();
  for (const auto& [reg, number] : flow_.oneNumberAt) {
    const auto place = oneNumber(reg);
    if (!place) continue;
    const Row row = *layout_.reg(reg);
    const Number all = broadcast(loadScalar(*place, Rep::Quad), row.rep);
    for (std::size_t i = 0; i < pieceCount(row.rep); ++i)
      c_.vmovdqa64(at(row.at + wideBytes * i), all.piece[i].as<Zmm>());
    gps_.endStep();
    zmms_.endStep();
  }
}

void WideEmitter::control(const Step& s) {
  switch (s.op) {
    case CodeOp::Leave: return leave(s);
    case CodeOp::Count: return count(s);
    case CodeOp::Mark: {
      const bool joins = flow_.joins.contains(s.value);
      return beginBlock(flow_.blockOf[step_], joins ? std::optional(layout_.pending(s.value)) : std::nullopt);
    }
    case CodeOp::Branch:
    case CodeOp::BranchIf:
    case CodeOp::BranchUnless:
      if (flow_.isCommon[step_]) return jump(s);
      return flow_.goOnBehind.contains(step_) ? branchBack(s) : branchForward(s);
    case CodeOp::AddTime:
      if (!code_.isStraight) c_.add(position_, imm(s.value));
      return;
    case CodeOp::CheckTime: return checkTime();
    default: CHECK(false, "time that depends on the power flow is taken for its most");
  }
}

void WideEmitter::count(const Step& s) {
  const Mem errors = at(layout_.error(s.value), wideTruthBytes);
  if (code_.isStraight) return void(c_.or_(errors, truth(s.a)));
  const Gp who = freshGp();
  c_.mov(who, active_);
  c_.emit(Inst::kIdAnd, who, truthSource(s.a));
  c_.or_(errors, who);
}

void WideEmitter::leave(const Step& s) {
  if (code_.isStraight) return void(c_.or_(at(layout_.left(), wideTruthBytes), truth(s.a)));
  const Gp who = freshGp();
  c_.mov(who, active_);
  c_.emit(Inst::kIdAnd, who, truthSource(s.a));
  leave(who);
}

/// Where nobody waits elsewhere and all leave, the scan is over.
void WideEmitter::leave(const Gp& who) {
  c_.or_(at(layout_.left(), wideTruthBytes), who);
  c_.andn(active_, who, active_);
  if (!flow_.isMaskedAt[step_]) c_.jz(labels_.back());
}

/// The longest of all traces counts for each.
void WideEmitter::checkTime() {
  const Label isShort = c_.newLabel();
  c_.cmp(position_, at(offsetof(LaneLayout::Head, mostTime), 8));
  c_.jbe(isShort);
  c_.or_(at(layout_.left(), wideTruthBytes), active_);
  c_.xor_(active_.r32(), active_.r32());
  if (!flow_.isMaskedAt[step_]) c_.jmp(labels_.back());
  c_.bind(isShort);
}

/// Those of the traces that run that take a branch.
x86::Gp WideEmitter::takers(const Step& s) {
  const Gp who = freshGp();
  if (s.op == CodeOp::BranchUnless) {
    c_.andn(who, truth(s.a), active_);
    return who;
  }
  c_.mov(who, active_);
  if (s.op == CodeOp::BranchIf) c_.emit(Inst::kIdAnd, who, truthSource(s.a));
  return who;
}

/// All traces go the same way.
void WideEmitter::jump(const Step& s) {
  const Label to = labels_[flow_.blockOf[flow_.markAt.at(s.value)]];
  if (s.op == CodeOp::Branch) {
    c_.jmp(to);
  } else {
    const Gp condition = truth(s.a);
    c_.test(condition, condition);
    if (s.op == CodeOp::BranchIf)
      c_.jnz(to);
    else
      c_.jz(to);
  }
  if (flow_.goOnBehind.contains(step_)) beginBlock(flow_.blockOf[step_] + 1, std::nullopt);
}

/// The next block takes over where nobody runs any more.
void WideEmitter::branchForward(const Step& s) {
  const Gp who = takers(s);
  c_.or_(at(layout_.pending(s.value), wideTruthBytes), who);
  c_.andn(active_, who, active_);
  c_.test(active_, active_);
  c_.jz(labels_[flow_.blockOf[step_] + 1]);
}

/// Those that go on wait for the last one that goes back.
void WideEmitter::branchBack(const Step& s) {
  const Gp who = takers(s), others = freshGp();
  const std::size_t behind = layout_.kept(flow_.goOnBehind.at(step_));
  const Label goOn = labels_[flow_.blockOf[step_] + 1];
  c_.test(who, who);
  c_.jz(goOn);
  c_.andn(others, who, active_);
  c_.or_(at(behind, wideTruthBytes), others);
  c_.or_(at(layout_.pending(s.value), wideTruthBytes), who);
  c_.xor_(active_.r32(), active_.r32());
  c_.jmp(labels_[flow_.blockOf[flow_.markAt.at(s.value)]]);
  beginBlock(flow_.blockOf[step_] + 1, behind);
}

void WideEmitter::beginBlock(std::uint32_t block, std::optional<std::size_t> waiting) {
  forgetAll();
  c_.bind(labels_[block]);
  if (waiting) {
    c_.or_(active_, at(*waiting, wideTruthBytes));
    c_.mov(at(*waiting, wideTruthBytes), 0);
  }
  const ValueId next = step_ + (code_.steps[step_].op == CodeOp::Mark ? 0 : 1);
  if (!flow_.isMaskedAt[std::min<std::size_t>(next, flow_.isMaskedAt.size() - 1)]) return;
  c_.test(active_, active_);
  c_.jz(labels_[block + 1]);
}

/// A value of a loop is kept for those only that run: others may still need theirs of an earlier round.
void WideEmitter::keep(ValueId id) {
  const auto kept = flow_.keptAt.find(id);
  if (kept == flow_.keptAt.end()) return;
  const std::size_t offset = layout_.kept(kept->second);
  const bool isMasked = flow_.isInLoop[id] && !flow_.isCommon[id];
  if (const auto found = scalars_.find(id); found != scalars_.end()) {
    c_.mov(at(offset, 8), found->second);
  } else if (repFor(widthOf(code_.steps[id])) == Rep::Truth) {
    if (isMasked) return storeTruth(offset, truth(id));
    c_.mov(at(offset, wideTruthBytes), truth(id));
  } else {
    const Number value = made(id);
    if (isMasked) return storeNumber(offset, value);
    for (std::size_t i = 0; i < pieceCount(value.rep); ++i)
      c_.vmovdqa64(at(offset + wideBytes * i), inRegister(value.piece[i]));
  }
}

}  // namespace rungproof::lanes
