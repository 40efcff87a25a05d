// Blocks, branches, and what ends a trace's stay in the code.
#include "engine/lanes/wide_emitter.hpp"

namespace rungproof::lanes {

using namespace asmjit;  // its Operand: by its full name
namespace Inst = x86::Inst;

void WideEmitter::begin() {
  c_.mov(at(layout_.left(), wideTruthBytes), 0);
  if (code_.isStraight) return;
  active_ = c_.newGpq();
  c_.mov(active_, at(layout_.active(), wideTruthBytes));
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
    save(row.at, broadcast(loadScalar(*place, Rep::Quad), row.rep));
    gps_.endStep();
    zmms_.endStep();
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

void WideEmitter::leaveAll() {
  c_.or_(at(layout_.left(), wideTruthBytes), active_);
  c_.xor_(active_.r32(), active_.r32());
  if (!flow_.isMaskedAt[step_]) c_.jmp(labels_.back());
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

void WideEmitter::branch(const Step& s) {
  if (flow_.isCommon[step_]) return jump(s);
  return flow_.goOnBehind.contains(step_) ? branchBack(s) : branchForward(s);
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
void WideEmitter::skipIfNobody(std::uint32_t block) {
  c_.test(active_, active_);
  c_.jz(labels_[block + 1]);
}

void WideEmitter::branchForward(const Step& s) {
  const Gp who = takers(s);
  c_.or_(at(layout_.pending(s.value), wideTruthBytes), who);
  c_.andn(active_, who, active_);
  skipIfNobody(flow_.blockOf[step_]);
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

/// Those that wait there run again.
void WideEmitter::join(std::size_t waiting) {
  c_.or_(active_, at(waiting, wideTruthBytes));
  c_.mov(at(waiting, wideTruthBytes), 0);
}

/// A value of a loop is kept for those only that run: others may still need theirs of an earlier round.
void WideEmitter::keep(ValueId id) {
  const auto kept = keptRow(id);
  if (!kept) return;
  const std::size_t offset = kept->at;
  const bool isMasked = flow_.isInLoop[id] && !flow_.isCommon[id];
  if (const auto found = scalars_.find(id); found != scalars_.end()) {
    c_.mov(at(offset, 8), found->second);
  } else if (repFor(widthOf(code_.steps[id])) == Rep::Truth) {
    if (isMasked) return storeTruth(offset, truth(id));
    c_.mov(at(offset, wideTruthBytes), truth(id));
  } else {
    const Number value = made(id);
    if (isMasked) return storeNumber(offset, value);
    save(offset, value);
  }
}

}  // namespace rungproof::lanes
