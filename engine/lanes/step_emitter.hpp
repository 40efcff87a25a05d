// StepEmitter: what the emitters for registers of 256 and of 512 bits have in common. They go through recorded code
// once and give every needed step its instructions, for all traces of a group. Branches are followed by masks: active_
// says which traces run; those that branch wait in the row of their mark until control, which always goes on with the
// first block that anybody waits for, comes there. A value that another block uses is kept in a row; within a block the
// code library finds registers. `Emitter` derives from this; `Value` is a value of all traces of one form (Rep).
#pragma once

#include <asmjit/x86.h>

#include <algorithm>
#include <deque>
#include <optional>
#include <vector>

#include "engine/lanes/lane_code.hpp"
#include "engine/lanes/lane_flow.hpp"
#include "ir/check.hpp"

namespace rungproof::lanes {

/// What is translated, and where to.
struct Translation {
  const Code& code;
  const std::vector<bool>& isNeeded;
  LaneLayout& layout;
  std::deque<StepByTrace>& byTrace;  ///< steps that the code refers to
  asmjit::CodeHolder& holder;
};

template <class Emitter, class Value>
class StepEmitter {
 public:
  StepEmitter(const Translation& t, bool isWide)
      : code_(t.code),
        layout_(t.layout),
        c_(&t.holder),
        flow_(t.code, t.isNeeded, isWide, t.layout.form == Form::Bits ? code_.steps.size() : stepsOfPart),
        labels_(flow_.lastBlock + 2),
        isNeeded_(t.isNeeded),
        byTrace_(t.byTrace),
        isWide_(isWide) {
    layout_.keepRows(flow_.keptRows, flow_.keptTruths);
  }
  /// False: the library could not do it.
  bool emit();
  /// Where the functions begin that are called one behind the other.
  const std::vector<asmjit::Label>& entries() const { return entries_; }

 protected:
  using Gp = asmjit::x86::Gp;
  using Mem = asmjit::x86::Mem;
  using InstId = asmjit::InstId;

  Mem at(std::size_t offset, std::uint32_t bytes) {
    return asmjit::x86::ptr(rows_, static_cast<std::int32_t>(offset), bytes);
  }
  /// Where a value is kept for other blocks, if it is.
  std::optional<Row> keptRow(ValueId id) const;
  /// The same of one that must be.
  Row ofEarlierBlock(ValueId id) const;
  /// The row of one byte of memory.
  Row byteRow(const Step& s, std::uint32_t k) const;
  /// A value of memory by its bytes: byte number k of the place by `single(k)`, the highest first.
  template <class Single>
  Value joined(int bytes, Single&& single);
  Value loadMemory(const Step& s);
  /// Numbers of the form of so many bits. The count of a shift may be any number.
  Value shift(const Step& s);
  Value extract(const Step& s);
  Value byTrace(const Step& s);
  void callByTrace(const Step& s, Rep rep, const ReachedRows& rows = {});
  void beginBlock(std::uint32_t block, std::optional<std::size_t> waiting);

  const Code& code_;
  LaneLayout& layout_;
  asmjit::x86::Compiler c_;
  const LaneFlow flow_;
  std::vector<asmjit::Label> labels_;  ///< by block, and one behind the last
  Gp rows_;
  ValueId step_ = 0;  ///< that is being emitted

 private:
  /// The code of a part stays in the nearest cache while all groups go through it.
  static constexpr std::size_t stepsOfPart = 600;

  Emitter& self() { return static_cast<Emitter&>(*this); }
  void beginFunction();
  void endFunction();
  void control(const Step& s);
  void checkTime();

  const std::vector<bool>& isNeeded_;
  std::deque<StepByTrace>& byTrace_;
  const bool isWide_;
  std::vector<asmjit::Label> entries_;
  Gp position_;  ///< time that this scan has taken at most, 10 ns
};

template <class Emitter, class Value>
bool StepEmitter<Emitter, Value>::emit() {
  struct FirstError final : asmjit::ErrorHandler {
    void handleError(asmjit::Error, const char*, asmjit::BaseEmitter*) override { isThere = true; }
    bool isThere = false;
  } error;
  c_.setErrorHandler(&error);
  for (asmjit::Label& label : labels_) label = c_.newLabel();
  beginFunction();
  self().begin();
  if (!code_.isStraight) {
    position_ = c_.newGpq();
    c_.xor_(position_.r32(), position_.r32());
  }
  for (step_ = 0; step_ < code_.steps.size(); ++step_) {
    if (!isNeeded_[step_]) continue;
    if (flow_.partsAt.contains(step_)) {
      self().forgetAll();
      endFunction();
      beginFunction();
    }
    const Step& s = code_.steps[step_];
    if (hasValue(s.op)) {
      if (!flow_.isFolded[step_]) self().value(step_);
    } else if (s.op < CodeOp::Leave) {
      self().store(s);
    } else {
      control(s);
    }
    self().release();
  }
  step_ = static_cast<ValueId>(code_.steps.size() - 1);
  if (code_.countsTime && !code_.isStraight) checkTime();
  c_.bind(labels_.back());
  self().end();
  endFunction();
  const bool isFinal = c_.finalize() == asmjit::kErrorOk;
  c_.setErrorHandler(nullptr);
  return isFinal && !error.isThere;
}

template <class Emitter, class Value>
void StepEmitter<Emitter, Value>::beginFunction() {
  asmjit::FuncNode* const function = c_.addFunc(asmjit::FuncSignatureT<void, std::uint8_t*>());
  function->frame().setAvxEnabled();
  if (isWide_) function->frame().setAvx512Enabled();
  function->frame().setAvxCleanup();
  rows_ = c_.newGpq();
  function->setArg(0, rows_);
  entries_.push_back(function->label());
}
template <class Emitter, class Value>
void StepEmitter<Emitter, Value>::endFunction() {
  c_.ret();
  c_.endFunc();
}

template <class Emitter, class Value>
void StepEmitter<Emitter, Value>::control(const Step& s) {
  switch (s.op) {
    case CodeOp::Leave: return self().leave(s);
    case CodeOp::Count: return self().count(s);
    case CodeOp::Mark: {
      if (code_.isStraight) return;  // nobody branches there
      const bool joins = flow_.joins.contains(s.value);
      return beginBlock(flow_.blockOf[step_], joins ? std::optional(layout_.pending(s.value)) : std::nullopt);
    }
    case CodeOp::Branch:
    case CodeOp::BranchIf:
    case CodeOp::BranchUnless: return self().branch(s);
    case CodeOp::AddTime:
      if (!code_.isStraight) c_.add(position_, asmjit::imm(s.value));
      return;
    case CodeOp::CheckTime: return checkTime();
    default: CHECK(false, "time that depends on the power flow is taken for its most");
  }
}

/// The longest of all traces counts for each.
template <class Emitter, class Value>
void StepEmitter<Emitter, Value>::checkTime() {
  const asmjit::Label isShort = c_.newLabel();
  c_.cmp(position_, at(offsetof(LaneLayout::Head, mostTime), 8));
  c_.jbe(isShort);
  self().leaveAll();
  c_.bind(isShort);
}

template <class Emitter, class Value>
void StepEmitter<Emitter, Value>::beginBlock(std::uint32_t block, std::optional<std::size_t> waiting) {
  self().forgetAll();
  c_.bind(labels_[block]);
  if (waiting) self().join(*waiting);
  const ValueId next = step_ + (code_.steps[step_].op == CodeOp::Mark ? 0 : 1);
  if (flow_.isMaskedAt[std::min<std::size_t>(next, flow_.isMaskedAt.size() - 1)]) self().skipIfNobody(block);
}

template <class Emitter, class Value>
std::optional<Row> StepEmitter<Emitter, Value>::keptRow(ValueId id) const {
  const auto kept = flow_.keptAt.find(id);
  if (kept == flow_.keptAt.end()) return std::nullopt;
  const Rep rep = repFor(widthOf(code_.steps[id]));
  return Row{rep == Rep::Truth ? layout_.keptTruth(kept->second) : layout_.kept(kept->second), rep};
}
template <class Emitter, class Value>
Row StepEmitter<Emitter, Value>::ofEarlierBlock(ValueId id) const {
  const auto row = keptRow(id);
  CHECK(row.has_value(), "a value that no block has made");
  return *row;
}

template <class Emitter, class Value>
Row StepEmitter<Emitter, Value>::byteRow(const Step& s, std::uint32_t k) const {
  const auto row = layout_.cell(s.area, static_cast<std::uint32_t>(s.value) + k, 1);
  CHECK(row.has_value(), "a byte without a row");
  return *row;
}

template <class Emitter, class Value>
template <class Single>
Value StepEmitter<Emitter, Value>::joined(int bytes, Single&& single) {
  CHECK(bytes == 1 || bytes == 2 || bytes == 4, "a width that no instruction has");
  if (bytes == 1) return single(0);
  const Value first = self().together(single(0), single(1));
  return bytes == 2 ? first : self().together(first, self().together(single(2), single(3)));
}

template <class Emitter, class Value>
Value StepEmitter<Emitter, Value>::loadMemory(const Step& s) {
  const int bytes = s.width / 8;
  if (const auto row = layout_.cell(s.area, static_cast<std::uint32_t>(s.value), bytes)) return self().loaded(*row);
  return joined(bytes, [&](std::uint32_t k) { return self().loaded(byteRow(s, k)); });
}

template <class Emitter, class Value>
Value StepEmitter<Emitter, Value>::shift(const Step& s) {
  using namespace asmjit::x86;
  const bool isLeft = s.op == CodeOp::ShiftLeft;
  const Rep own = numberFor(s.width);
  const Step& count = code_.steps[s.b];
  const bool isConstant = count.op == CodeOp::Constant;
  if (isConstant && count.value >= s.width) return self().constant(0, own);
  const Rep rep = std::max(own, isConstant ? Rep::Word : std::max(Rep::Double, repFor(widthOf(count))));
  const Value number = self().use(s.a, rep);
  if (isConstant)
    return self().fit(self().shifted(number, isLeft, static_cast<std::uint32_t>(count.value)), own, s.width);
  const InstId id = rep == Rep::Quad ? (isLeft ? Inst::kIdVpsllvq : Inst::kIdVpsrlvq)
                                     : (isLeft ? Inst::kIdVpsllvd : Inst::kIdVpsrlvd);
  return self().fit(self().each(id, number, self().use(s.b, rep)), own, s.width);
}

template <class Emitter, class Value>
Value StepEmitter<Emitter, Value>::extract(const Step& s) {
  const Rep own = repFor(s.width), from = repFor(widthOf(code_.steps[s.a]));
  if (static_cast<int>(s.value) >= bitsOf(std::max(from, Rep::Word))) return self().constant(0, own);
  Value value = self().use(s.a, std::max(from, s.value == 0 ? own : std::max(own, Rep::Word)));
  if (s.value != 0) value = self().shifted(value, false, static_cast<std::uint32_t>(s.value));
  return self().fit(value, own, s.width);
}

template <class Emitter, class Value>
Value StepEmitter<Emitter, Value>::byTrace(const Step& s) {
  const bool isBinary = compiled::operandCount(s.op) == 2;
  const int bits = std::max({bitsNeeded(code_.steps[s.a]), isBinary ? bitsNeeded(code_.steps[s.b]) : 1, widthOf(s)});
  const Rep rep = numberFor(bits);
  self().save(layout_.scratch(0), self().use(s.a, rep));
  if (isBinary) self().save(layout_.scratch(1), self().use(s.b, rep));
  self().beforeCall();
  callByTrace(s, rep);
  return self().fit(self().copyOf({layout_.scratch(2), rep}), numberFor(widthOf(s)), widthOf(s));
}

/// The operands stand in the scratch rows 0 and 1, the result in 2.
template <class Emitter, class Value>
void StepEmitter<Emitter, Value>::callByTrace(const Step& s, Rep rep, const ReachedRows& rows) {
  const StepByTrace& by = byTrace_.emplace_back(StepByTrace{s, rows});
  if (!code_.isStraight) self().saveActive();
  asmjit::InvokeNode* call = nullptr;
  c_.invoke(&call, asmjit::imm(reinterpret_cast<std::uintptr_t>(&doByTrace)),
            asmjit::FuncSignatureT<void, const void*, const void*, void*, std::uint64_t>());
  call->setArg(0, asmjit::imm(reinterpret_cast<std::uintptr_t>(&by)));
  call->setArg(1, asmjit::imm(reinterpret_cast<std::uintptr_t>(&layout_)));
  call->setArg(2, rows_);
  call->setArg(3, asmjit::imm(static_cast<std::uint64_t>(rep)));
}

}  // namespace rungproof::lanes
