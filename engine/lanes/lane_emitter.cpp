// Blocks, branches by masks, and what ends a trace's stay in the code.
#include "engine/lanes/lane_emitter.hpp"

#include <algorithm>

#include "ir/check.hpp"

namespace rungproof::lanes {

using namespace asmjit;  // its Operand: by its full name
namespace Inst = x86::Inst;

LaneEmitter::LaneEmitter(const Code& code, const std::vector<bool>& isNeeded, LaneLayout& layout,
                         std::deque<StepByTrace>& byTrace, CodeHolder& holder)
    : code_(code),
      isNeeded_(isNeeded),
      layout_(layout),
      byTrace_(byTrace),
      c_(&holder),
      flow_(code, isNeeded, false),
      labels_(flow_.lastBlock + 2) {
  layout_.keepRows(flow_.keptRows);
}

/// A value of a loop is kept for those only that run: others may still need theirs of an earlier round.
void LaneEmitter::keep(ValueId id, const Vec& value) {
  const auto kept = flow_.keptAt.find(id);
  if (kept == flow_.keptAt.end()) return;
  const Row row{layout_.kept(kept->second), value.rep};
  if (flow_.isInLoop[id]) return storeRow(row, value);
  for (std::size_t i = 0; i < pieceCount(row.rep); ++i) save(row.at + rowBytes * i, value.piece[i]);
}

bool LaneEmitter::emit() {
  struct FirstError final : ErrorHandler {
    void handleError(Error, const char*, BaseEmitter*) override { isThere = true; }
    bool isThere = false;
  } error;
  c_.setErrorHandler(&error);
  FuncNode* const function = c_.addFunc(FuncSignatureT<void, std::uint8_t*>());
  function->frame().setAvxEnabled();
  function->frame().setAvxCleanup();
  rows_ = c_.newGpq();
  function->setArg(0, rows_);
  for (Label& label : labels_) label = c_.newLabel();
  save(layout_.left(), constant(0, Rep::Truth).piece[0]);
  if (!code_.isStraight) {
    active_ = c_.newYmm();
    c_.vmovdqa(active_, at(layout_.active()));
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
  }
  c_.bind(labels_.back());
  step_ = static_cast<ValueId>(code_.steps.size() - 1);
  if (code_.countsTime && !code_.isStraight) checkTime();
  c_.ret();
  c_.endFunc();
  const bool isFinal = c_.finalize() == kErrorOk;
  c_.setErrorHandler(nullptr);
  return isFinal && !error.isThere;
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

void LaneEmitter::control(const Step& s) {
  switch (s.op) {
    case CodeOp::Leave: return leave(s);
    case CodeOp::Count: {
      Ymm happens = use(s.a, Rep::Truth).piece[0];
      if (!code_.isStraight) happens = op(Inst::kIdVpand, happens, active_);
      return save(layout_.error(s.value), op(Inst::kIdVpor, happens, at(layout_.error(s.value))));
    }
    case CodeOp::Mark: return beginBlock(flow_.blockOf[step_], layout_.pending(s.value));
    case CodeOp::Branch:
    case CodeOp::BranchIf:
    case CodeOp::BranchUnless: return flow_.goOnBehind.contains(step_) ? branchBack(s) : branchForward(s);
    case CodeOp::AddTime:
      if (!code_.isStraight) c_.add(position_, imm(s.value));
      return;
    case CodeOp::CheckTime: return checkTime();
    default: CHECK(false, "time that depends on the power flow is taken for its most");
  }
}

void LaneEmitter::leave(const Step& s) {
  Ymm who = use(s.a, Rep::Truth).piece[0];
  if (!code_.isStraight) {
    who = op(Inst::kIdVpand, who, active_);
    c_.vpandn(active_, who, active_);
  }
  save(layout_.left(), op(Inst::kIdVpor, who, at(layout_.left())));
}

/// The longest of all traces counts for each.
void LaneEmitter::checkTime() {
  const Label isShort = c_.newLabel();
  c_.cmp(position_, at(offsetof(LaneLayout::Head, mostTime), 8));
  c_.jbe(isShort);
  save(layout_.left(), op(Inst::kIdVpor, active_, at(layout_.left())));
  c_.vpxor(active_, active_, active_);
  c_.bind(isShort);
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
void LaneEmitter::skipIfNobody() {
  c_.vptest(active_, active_);
  c_.jz(labels_[flow_.blockOf[step_] + 1]);
}

void LaneEmitter::branchForward(const Step& s) {
  const Ymm who = takers(s);
  wait(layout_.pending(s.value), who);
  c_.vpandn(active_, who, active_);
  skipIfNobody();
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

void LaneEmitter::beginBlock(std::uint32_t block, std::size_t waiting) {
  values_.clear();
  for (auto& [reg, holders] : holders_) {
    if (holders <= 0) continue;
    holders = isFree;
    free_.push_back(registers_[reg]);
  }
  c_.bind(labels_[block]);
  c_.vpor(active_, active_, at(waiting));
  save(waiting, constant(0, Rep::Truth).piece[0]);
  const ValueId next = step_ + (code_.steps[step_].op == CodeOp::Mark ? 0 : 1);
  if (!flow_.isMaskedAt[std::min<std::size_t>(next, flow_.isMaskedAt.size() - 1)]) return;
  c_.vptest(active_, active_);
  c_.jz(labels_[block + 1]);
}

}  // namespace rungproof::lanes
