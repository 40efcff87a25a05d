// Blocks, branches by masks, and what ends a trace's stay in the code.
#include "engine/lanes/lane_emitter.hpp"

#include "ir/check.hpp"

namespace rungproof::lanes {

using namespace asmjit;  // its Operand: by its full name
namespace Inst = x86::Inst;

/// A value of a loop is kept for those only that run: others may still need theirs of an earlier round.
void LaneEmitter::keep(ValueId id, const Vec& value) {
  const auto row = keptRow(id);
  if (!row) return;
  if (flow_.isInLoop[id]) return storeRow(*row, value);
  save(row->at, value);
}

void LaneEmitter::begin() {
  save(layout_.left(), constant(0, Rep::Truth));
  if (code_.isStraight) return;
  active_ = c_.newYmm();
  c_.vmovdqa(active_, at(layout_.active()));
}

void LaneEmitter::store(const Step& s) {
  const auto put = [&](Row row) { storeRow(row, use(s.a, row.rep)); };
  switch (s.op) {
    case CodeOp::StoreBit: return put({layout_.slot(s.value), Rep::Truth});
    case CodeOp::StoreState:
    case CodeOp::StoreStateWord: return put(layout_.state(s.value));
    case CodeOp::StoreRegister: return put(*layout_.reg(s.value));
    case CodeOp::StoreMemory: return storeMemory(s);
    case CodeOp::StoreSlots: return storeSlots(s);
    default: return storeAt(s);
  }
}

void LaneEmitter::count(const Step& s) {
  Ymm happens = use(s.a, Rep::Truth).piece[0];
  if (!code_.isStraight) happens = op(Inst::kIdVpand, happens, active_);
  save(layout_.error(s.value), op(Inst::kIdVpor, happens, at(layout_.error(s.value))));
}

void LaneEmitter::leave(const Step& s) {
  Ymm who = use(s.a, Rep::Truth).piece[0];
  if (!code_.isStraight) {
    who = op(Inst::kIdVpand, who, active_);
    c_.vpandn(active_, who, active_);
  }
  save(layout_.left(), op(Inst::kIdVpor, who, at(layout_.left())));
}

void LaneEmitter::leaveAll() {
  save(layout_.left(), op(Inst::kIdVpor, active_, at(layout_.left())));
  c_.vpxor(active_, active_, active_);
}

/// Those of the traces that run that take a branch.
x86::Ymm LaneEmitter::takers(const Step& s) {
  const Ymm who = fresh();
  if (s.op == CodeOp::Branch)
    c_.vmovdqa(who, active_);
  else if (s.op == CodeOp::BranchIf)
    c_.vpand(who, active_, use(s.a, Rep::Truth).piece[0]);
  else
    c_.vpandn(who, use(s.a, Rep::Truth).piece[0], active_);
  return who;
}
void LaneEmitter::wait(std::size_t row, const Ymm& who) { save(row, op(Inst::kIdVpor, who, at(row))); }

/// The next block takes over where nobody runs any more.
void LaneEmitter::skipIfNobody(std::uint32_t block) {
  c_.vptest(active_, active_);
  c_.jz(labels_[block + 1]);
}

void LaneEmitter::branch(const Step& s) { return flow_.goOnBehind.contains(step_) ? branchBack(s) : branchForward(s); }

void LaneEmitter::branchForward(const Step& s) {
  const Ymm who = takers(s);
  wait(layout_.pending(s.value), who);
  c_.vpandn(active_, who, active_);
  skipIfNobody(flow_.blockOf[step_]);
}

/// Those that go on wait for the last one that goes back.
void LaneEmitter::branchBack(const Step& s) {
  const Ymm who = takers(s);
  const std::size_t behind = layout_.kept(flow_.goOnBehind.at(step_));
  const Label goOn = labels_[flow_.blockOf[step_] + 1];
  c_.vptest(who, who);
  c_.jz(goOn);
  wait(behind, op(Inst::kIdVpandn, who, active_));
  wait(layout_.pending(s.value), who);
  c_.vpxor(active_, active_, active_);
  c_.jmp(labels_[flow_.blockOf[flow_.markAt.at(s.value)]]);
  beginBlock(flow_.blockOf[step_] + 1, behind);
}

/// Those that wait there run again.
void LaneEmitter::join(std::size_t waiting) {
  c_.vpor(active_, active_, at(waiting));
  save(waiting, constant(0, Rep::Truth));
}

}  // namespace rungproof::lanes
