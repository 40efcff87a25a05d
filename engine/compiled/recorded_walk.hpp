// The walk of a program that is recorded as code: where the walk over values with guards follows both ways at once
// (ir/flow_walk.hpp), this one makes blocks and branches. Calls are recorded in place. What the machine keeps from
// instruction to instruction - logic stack and SCR, or the registers of an S7-300/400 - is brought to fixed places
// where a way ends that others join; a value that all ways have in common stays what it is. Of a loop the way back is
// not yet known where it begins: what changes on it, an earlier recording has found (LoopFacts).
#pragma once

#include <set>

#include "engine/compiled/recorder.hpp"
#include "ir/check.hpp"
#include "ir/flow_walk.hpp"

namespace rungproof {

template <class Derived, class Hooks>
class FlowWalk<Derived, Machine<compiled::Recorder>, Hooks> {
 protected:
  using M = Machine<compiled::Recorder>;
  using Bool = compiled::Recorder::Bool;
  using Bits = compiled::Recorder::Bits;
  using CodeOp = compiled::CodeOp;
  using ValueId = compiled::ValueId;

  FlowWalk(M& machine, Hooks& hooks, int, std::size_t) : m_(machine), hooks_(hooks) {
    eachPiece([&](Bool&) { widths_.push_back(0); }, [&](Bits&, int width) { widths_.push_back(width); });
    home_.assign(widths_.size(), nowhere);
    m_.d.code.states = static_cast<std::uint32_t>(widths_.size());
  }

  M& m_;
  Hooks& hooks_;

  /// State of the walk over one block.
  struct Walk {
    const Flow& flow;
    std::map<std::uint32_t, std::uint32_t> marks{};  ///< by index of the instruction: number of the block that begins
    std::set<std::uint32_t> heads{};                 ///< of loops
    std::uint32_t at = 0;
  };

  void walk(const Flow& flow) {
    Walk w{flow};
    path_.push_back(m_.current == nullptr ? 0 : m_.current->id);
    path_.push_back(static_cast<std::uint32_t>(&flow - m_.plan.flows.data()));
    const auto end = static_cast<std::uint32_t>(flow.steps.size());
    for (std::uint32_t at = 0; at < end; ++at) {
      const std::uint32_t target = targetOf(flow.steps[at]);
      if (target <= at) w.heads.insert(target);
    }
    for (std::uint32_t at = 0; at < end; ++at) {
      w.at = at;
      if (at == boxesEnd_) endBoxes();
      if (w.heads.contains(at)) {
        beginLoop(markAt(w, at), at);
        hooks_.timeAt.reset();
      } else if (const auto mark = w.marks.find(at); mark != w.marks.end()) {
        meet(mark->second);
        hooks_.timeAt.reset();
      }
      if (!isReached_) continue;
      m_.current = flow.steps[at].instruction;
      if (!boxes_) beginBoxes(w);
      hooks_.before(m_, flow.steps[at]);
      hooks_.run(m_, flow.steps[at], [&] { static_cast<Derived&>(*this).execute(w, at); });
    }
    if (end == boxesEnd_) endBoxes();
    if (const auto mark = w.marks.find(end); mark != w.marks.end()) {
      meet(mark->second);
      hooks_.timeAt.reset();
    }
    path_.resize(path_.size() - 2);
  }

  template <class Body>
  void inside(Bool condition, Body&& body) {
    if (m_.d.truth(condition) == false) return;
    if (m_.d.truth(condition) == true) return body();
    if (isShortCall()) {
      m_.d.calls.push_back({condition, (m_.frame + 1) * frameBytes});
      m_.when(condition, body);
      return m_.d.calls.pop_back();
    }
    const std::uint32_t behind = m_.d.code.marks++;
    const auto timeAt = std::exchange(hooks_.timeAt, std::nullopt);
    branchWhere(CodeOp::BranchUnless, condition, behind);
    body();
    meet(behind);
    hooks_.timeAt = timeAt;
  }

  template <class Body>
  void withOwnRegisters(Body&& body) {
    body();
  }

  /// Continues at `target` where `condition` holds. The end of the block is target steps.size().
  void branch(Walk& w, Bool condition, std::uint32_t target) {
    if (m_.d.truth(condition) == false || target == w.at + 1) return;
    if (target <= w.at) {
      CHECK(w.heads.contains(target), "a way back to where no loop begins");
      m_.d.code.hasLoops = true;
      m_.d.add({.op = CodeOp::CheckTime});
    }
    branchWhere(CodeOp::BranchIf, condition, markAt(w, target));
    hooks_.timeAt.reset();
  }

 private:
  static constexpr ValueId nowhere = ~ValueId{0};

  /// Where an instruction may lead back to.
  static std::uint32_t targetOf(const FlowStep& step) {
    if (step.partner == noPartner) return noPartner;
    switch (step.instruction->desc->control) {
      case Control::Jump:
      case Control::Branch:
      case Control::Distributor: return step.partner;
      case Control::Next: return step.partner + 1;
      default: return noPartner;
    }
  }

  std::uint32_t markAt(Walk& w, std::uint32_t at) {
    const auto [place, isNew] = w.marks.try_emplace(at, m_.d.code.marks);
    if (isNew) ++m_.d.code.marks;
    return place->second;
  }

  // ---- Short calls -----------------------------------------------------------------------------------

  /// Where many traces run side by side, somebody takes nearly every call: a short one without branches is done for
  /// all, and what it writes is chosen.
  bool isShortCall() const {
    constexpr std::size_t mostSteps = 64;
    if (!m_.d.code.isWholeScan || m_.d.code.countsTime || m_.current == nullptr) return false;
    if (m_.current->desc->control != Control::Call) return false;
    const auto steps = stepsOfCall(*m_.current, mostSteps);
    return steps && *steps <= mostSteps;
  }
  /// Instructions that a call runs; nothing: there are branches, or more than `most`.
  std::optional<std::size_t> stepsOfCall(const Instruction& call, std::size_t most) const {
    const bool hasNumber = !call.operands.empty() && call.operands[0].kind == OperandKind::Constant;
    const Flow* callee = hasNumber ? m_.plan.subroutine(static_cast<int>(call.operands[0].value)) : nullptr;
    if (callee == nullptr) return std::nullopt;
    std::size_t count = callee->steps.size();
    for (const FlowStep& step : callee->steps) {
      const Control control = step.instruction->desc->control;
      const bool isEnd = control == Control::Return && &step == &callee->steps.back();
      if (control == Control::None || control == Control::SubroutineHead || isEnd) continue;
      const auto inner =
          control == Control::Call && count < most ? stepsOfCall(*step.instruction, most - count) : std::nullopt;
      if (!inner) return std::nullopt;
      count += *inner;
    }
    return count <= most ? std::optional(count) : std::nullopt;
  }

  // ---- Boxes behind the same power flow -------------------------------------------------------------

  static bool isConditional(const FlowStep& step) {
    const Desc& desc = *step.instruction->desc;
    return desc.execution == Execution::Conditional && desc.control == Control::None;
  }

  /// What is done sooner than branched around.
  static bool isShort(const FlowStep& step) {
    const Role role = step.instruction->desc->role;
    return role == Role::Set || role == Role::Reset;
  }

  /// Boxes that run or do not run together are a part of their own. They leave logic stack and SCR alone.
  void beginBoxes(const Walk& w) {
    const FlowStep& first = w.flow.steps[w.at];
    if (!m_.d.hasParts || !isConditional(first) || !first.instruction->desc->eno) return;
    const Bool runs = m_.powerFlow();
    if (m_.d.truth(runs)) return;
    std::uint32_t end = w.at + 1;
    const auto isInside = [&] {
      return end < w.flow.steps.size() && isConditional(w.flow.steps[end]) && !w.marks.contains(end) &&
             !w.heads.contains(end);
    };
    while (isInside()) ++end;
    const auto boxes = std::span(w.flow.steps).subspan(w.at, end - w.at);
    if (std::ranges::all_of(boxes, isShort)) return;
    m_.enoAfter(m_.d.constant(false));  // of those that go past it; the first box sets that of the others
    hooks_.skip(boxes);
    boxes_ = m_.d.beginPart(runs);
    timeBeforeBoxes_ = std::exchange(hooks_.timeAt, std::nullopt);
    boxesEnd_ = end;
  }
  void endBoxes() {
    m_.d.endPart(*std::exchange(boxes_, std::nullopt));
    hooks_.goOn();
    hooks_.timeAt = timeBeforeBoxes_;
    boxesEnd_ = noPartner;
  }

  // ---- What the machine keeps, in pieces ------------------------------------------------------------

  /// An address register is two of them: the area, which pointer arithmetic keeps, and the address.
  template <class OnBit, class OnBits>
  void eachPiece(OnBit&& onBit, OnBits&& onBits) {
    if (m_.plan.form() == StatementForm::Accumulators) {
      m_.step7.each(onBit, [&](Bits& bits, int width) {
        if (&bits != &m_.step7.ar[0] && &bits != &m_.step7.ar[1]) return onBits(bits, width);
        Bits area = m_.d.extract(bits, 31, 24), address = m_.d.extract(bits, 23, 0);
        onBits(area, 8);
        onBits(address, 24);
        bits = m_.d.concat(area, 8, address, 24);
      });
      return;
    }
    for (std::size_t i = 0; i < m_.stackLevels; ++i) onBit(m_.stack[i]);
    onBit(m_.scrActive);
  }
  std::vector<ValueId> pieces() {
    std::vector<ValueId> ids;
    eachPiece([&](Bool& bit) { ids.push_back(bit.id); }, [&](Bits& bits, int) { ids.push_back(bits.id); });
    return ids;
  }
  void setPieces(const std::vector<ValueId>& ids) {
    std::size_t i = 0;
    eachPiece([&](Bool& bit) { bit.id = ids[i++]; }, [&](Bits& bits, int) { bits.id = ids[i++]; });
  }

  /// Brings those to their places that do not stand there.
  std::vector<ValueId> bringHome() {
    std::vector<ValueId> ids = pieces();
    for (std::size_t i = 0; i < ids.size(); ++i) {
      if (home_[i] == ids[i]) continue;
      m_.d.add({.op = widths_[i] == 0 ? CodeOp::StoreState : CodeOp::StoreStateWord, .a = ids[i], .value = i});
      home_[i] = ids[i];
    }
    return ids;
  }

  // ---- Blocks -----------------------------------------------------------------------------------------

  struct Loop {
    std::vector<std::uint32_t> key;
    std::vector<ValueId> kept;  ///< by piece; nowhere: read anew
  };

  void branchWhere(CodeOp op, Bool condition, std::uint32_t mark) {
    if (!isReached_) return;
    std::vector<ValueId> ids = bringHome();
    const bool isAlways = m_.d.truth(condition) == true;
    if (isAlways)
      m_.d.add({.op = CodeOp::Branch, .value = mark});
    else
      m_.d.branch(op, condition, mark);
    if (isAlways) isReached_ = false;
    const auto loop = loops_.find(mark);
    if (loop == loops_.end()) {
      ways_[mark].push_back(std::move(ids));
      return;
    }
    for (std::size_t i = 0; i < ids.size(); ++i) {
      if (loop->second.kept[i] == nowhere || loop->second.kept[i] == ids[i]) continue;
      m_.d.loops->changed[loop->second.key].insert(i);
      m_.d.loops->isComplete = false;
    }
  }

  /// A block begins to which those lead that branched to `mark`, and the instruction before.
  void meet(std::uint32_t mark) {
    if (ways_.contains(mark)) begin(mark, {});
  }
  void beginLoop(std::uint32_t mark, std::uint32_t at) {
    Loop loop{path_, {}};
    loop.key.push_back(at);
    loop.kept = begin(mark, m_.d.loops->changed[loop.key]);
    loops_.emplace(mark, std::move(loop));
  }
  std::vector<ValueId> begin(std::uint32_t mark, const std::set<std::size_t>& changed) {
    std::vector<std::vector<ValueId>> ways = std::move(ways_[mark]);
    ways_.erase(mark);
    if (isReached_) ways.push_back(bringHome());
    m_.d.add({.op = CodeOp::Mark, .value = mark});
    m_.d.forgetValues();
    m_.d.store->forget();
    std::vector<ValueId> kept(widths_.size(), nowhere), ids;
    for (std::size_t i = 0; i < widths_.size(); ++i) {
      const bool isOne =
          !ways.empty() && std::ranges::all_of(ways, [&](const auto& way) { return way[i] == ways[0][i]; });
      if (isOne && !changed.contains(i))
        ids.push_back(kept[i] = ways[0][i]);
      else
        ids.push_back(m_.d.add({.op = widths_[i] == 0 ? CodeOp::LoadState : CodeOp::LoadStateWord,
                                .width = static_cast<std::uint8_t>(std::max(widths_[i], 1)),
                                .value = i}));
    }
    setPieces(ids);
    home_ = pieces();
    isReached_ = true;
    return kept;
  }

  std::vector<int> widths_;                                          ///< of the pieces, 0: a truth value
  std::vector<ValueId> home_;                                        ///< by piece: the value that stands in its place
  std::map<std::uint32_t, std::vector<std::vector<ValueId>>> ways_;  ///< by mark: the pieces as branches to it had them
  std::map<std::uint32_t, Loop> loops_;                              ///< by mark, those that have begun
  std::vector<std::uint32_t> path_;                                  ///< calls on the way
  std::optional<compiled::Recorder::Part> boxes_;                    ///< that is being recorded
  std::uint32_t boxesEnd_ = noPartner;                               ///< index of the instruction behind it
  typename Hooks::TimeAt timeBeforeBoxes_;  ///< where it is added for all, past the part or not
  bool isReached_ = true;                   ///< whether anything leads to what is recorded next
};

}  // namespace rungproof
