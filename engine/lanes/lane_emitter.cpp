// Blocks, branches by masks, and what ends a trace's stay in the code.
#include "engine/lanes/lane_emitter.hpp"

#include <algorithm>

#include "ir/check.hpp"

namespace rungproof::lanes {

using namespace asmjit;  // its Operand: by its full name
namespace Inst = x86::Inst;

LaneEmitter::LaneEmitter(const Code& code, const std::vector<bool>& isNeeded, LaneLayout& layout,
                         std::deque<StepByTrace>& byTrace, CodeHolder& holder)
    : code_(code), isNeeded_(isNeeded), layout_(layout), byTrace_(byTrace), c_(&holder) {
  findBlocks();
  findKept();
  findFolded();
  findEnds();
}

/// A block begins at a mark, and behind a branch back, where those go on that do not take it. Within a block nobody
/// joins. Where no branch leads past a step, every trace comes to it, and at the same time.
void LaneEmitter::findBlocks() {
  const std::size_t count = code_.steps.size();
  std::vector<int> waiting(count + 1, 0), looping(count + 1, 0);
  for (ValueId i = 0; i < count; ++i) {
    if (code_.steps[i].op == CodeOp::Mark) markAt_[code_.steps[i].value] = i;
  }
  blockOf_.resize(count);
  std::uint32_t block = 0;
  for (ValueId i = 0; i < count; ++i) {
    const Step& s = code_.steps[i];
    if (s.op == CodeOp::Mark) ++block;
    blockOf_[i] = block;
    if (!isBranch(s.op)) continue;
    const ValueId target = markAt_.at(s.value);
    if (target > i) {
      ++waiting[i + 1];
      --waiting[target];
    } else {
      ++waiting[target];
      --waiting[i + 1];
      ++looping[target];
      --looping[i + 1];
      goOnBehind_[i] = 0;
      ++block;
    }
  }
  labels_.resize(block + 2);
  int isPassed = 0, isRepeated = 0;
  for (std::size_t i = 0; i < count; ++i) {
    isMaskedAt_.push_back((isPassed += waiting[i]) > 0);
    isInLoop_.push_back((isRepeated += looping[i]) > 0);
  }
}

void LaneEmitter::findKept() {
  std::size_t rows = 0;
  const auto uses = [&](ValueId user, ValueId id) {
    const CodeOp op = code_.steps[id].op;
    if (op == CodeOp::False || op == CodeOp::True || op == CodeOp::Constant || blockOf_[id] == blockOf_[user]) return;
    if (keptAt_.try_emplace(id, rows).second) rows += pieceCount(repFor(widthOf(code_.steps[id])));
  };
  for (ValueId i = 0; i < code_.steps.size(); ++i) {
    if (!isNeeded_[i]) continue;
    const Step& s = code_.steps[i];
    const int operands = compiled::operandCount(s.op);
    if (operands > 0) uses(i, s.a);
    if (operands > 1) uses(i, s.b);
    if (operands > 2) uses(i, s.c);
  }
  for (auto& [branch, row] : goOnBehind_) row = rows++;
  layout_.keepRows(rows);
}

/// And negates its first operand for nothing; of two negated ones the second is made.
void LaneEmitter::findFolded() {
  isFolded_.assign(code_.steps.size(), false);
  for (ValueId i = 0; i < code_.steps.size(); ++i) {
    const Step& s = code_.steps[i];
    isFolded_[i] = isNeeded_[i] && s.op == CodeOp::Not && !keptAt_.contains(i) && !keptAt_.contains(s.a);
  }
  for (ValueId i = 0; i < code_.steps.size(); ++i) {
    const Step& s = code_.steps[i];
    const int operands = isNeeded_[i] ? compiled::operandCount(s.op) : 0;
    const bool isAnd = s.op == CodeOp::And;
    if (operands > 0 && !isAnd) isFolded_[s.a] = false;
    if (operands > 1 && (!isAnd || isFolded_[s.a])) isFolded_[s.b] = false;
    if (operands > 2) isFolded_[s.c] = false;
  }
}

void LaneEmitter::findEnds() {
  endsAt_.resize(code_.steps.size());
  std::vector<std::uint32_t> seenIn(code_.steps.size(), ~std::uint32_t{0});
  for (ValueId i = static_cast<ValueId>(code_.steps.size()); i-- > 0;) {
    if (!isNeeded_[i]) continue;
    const Step& s = code_.steps[i];
    const auto use = [&](ValueId id) {
      if (std::exchange(seenIn[id], blockOf_[i]) != blockOf_[i]) endsAt_[i].push_back(id);
    };
    const int operands = compiled::operandCount(s.op);
    for (const auto& [isThere, id] : {std::pair(operands > 0, s.a), {operands > 1, s.b}, {operands > 2, s.c}}) {
      if (!isThere) continue;
      use(id);
      if (isFolded_[id]) use(code_.steps[id].a);
    }
    if (hasValue(s.op)) use(i);
  }
}

/// A value of a loop is kept for those only that run: others may still need theirs of an earlier round.
void LaneEmitter::keep(ValueId id, const Vec& value) {
  const auto kept = keptAt_.find(id);
  if (kept == keptAt_.end()) return;
  const Row row{layout_.kept(kept->second), value.rep};
  if (isInLoop_[id]) return storeRow(row, value);
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
      if (!isFolded_[step_]) value(step_);
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
    case CodeOp::Mark: return beginBlock(blockOf_[step_], layout_.pending(s.value));
    case CodeOp::Branch:
    case CodeOp::BranchIf:
    case CodeOp::BranchUnless: return goOnBehind_.contains(step_) ? branchBack(s) : branchForward(s);
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
  c_.jz(labels_[blockOf_[step_] + 1]);
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
  const std::size_t behind = layout_.kept(goOnBehind_.at(step_));
  const Label goOn = labels_[blockOf_[step_] + 1];
  c_.vptest(who, who);
  c_.jz(goOn);
  wait(behind, op(Inst::kIdVpandn, who, active_));
  wait(layout_.pending(s.value), who);
  c_.vpxor(active_, active_, active_);
  c_.jmp(labels_[blockOf_[markAt_.at(s.value)]]);
  beginBlock(blockOf_[step_] + 1, behind);
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
  if (!isMaskedAt_[std::min<std::size_t>(next, isMaskedAt_.size() - 1)]) return;
  c_.vptest(active_, active_);
  c_.jz(labels_[block + 1]);
}

}  // namespace rungproof::lanes
