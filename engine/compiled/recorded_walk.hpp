// The walk of a program that is recorded as code: where the walk over values with guards follows both ways at once
// (ir/flow_walk.hpp), this one makes blocks and branches. Calls are recorded in place. What the machine keeps from
// instruction to instruction - logic stack and SCR - is brought to fixed places where ways meet.
#pragma once

#include <set>

#include "engine/compiled/recorder.hpp"
#include "ir/flow_walk.hpp"

namespace rungproof {

template <class Derived, class Hooks>
class FlowWalk<Derived, Machine<compiled::Recorder>, Hooks> {
 protected:
  using M = Machine<compiled::Recorder>;
  using Bool = compiled::Recorder::Bool;
  using CodeOp = compiled::CodeOp;

  FlowWalk(M& machine, Hooks& hooks, int, std::size_t) : m_(machine), hooks_(hooks), home_(machine.stackLevels + 1) {}

  M& m_;
  Hooks& hooks_;

  /// State of the walk over one block.
  struct Walk {
    const Flow& flow;
    std::map<std::uint32_t, std::uint32_t> marks{};  ///< by index of the instruction: number of the block that begins
    std::uint32_t at = 0;
  };

  void walk(const Flow& flow) {
    Walk w{flow};
    const auto end = static_cast<std::uint32_t>(flow.steps.size());
    for (std::uint32_t at = 0; at < end; ++at) {
      const FlowStep& step = flow.steps[at];
      if (step.instruction->desc->control == Control::None || step.partner == noPartner) continue;
      markAt(w, step.partner);
      if (step.partner + 1 <= end) markAt(w, step.partner + 1);
    }
    for (std::uint32_t at = 0; at < end; ++at) {
      w.at = at;
      const auto mark = w.marks.find(at);
      if (mark != w.marks.end() && !m_.d.code.isStraight) meet(mark->second);
      m_.current = flow.steps[at].instruction;
      hooks_.before(m_, flow.steps[at]);
      hooks_.run(m_, flow.steps[at], [&] { static_cast<Derived&>(*this).execute(w, at); });
    }
    if (!m_.d.code.isStraight) meet(markAt(w, end));
  }

  template <class Body>
  void inside(Bool condition, Body&& body) {
    if (m_.d.truth(condition) == false) return;
    if (m_.d.truth(condition) == true) return body();
    const std::uint32_t behind = m_.d.code.marks++;
    branchWhere(CodeOp::BranchUnless, condition, behind);
    body();
    meet(behind);
  }

  /// Continues at `target` where `condition` holds. The end of the block is target steps.size().
  void branch(Walk& w, Bool condition, std::uint32_t target) {
    if (m_.d.truth(condition) == false) return;
    if (target <= w.at) {
      m_.d.code.hasLoops = true;
      m_.d.add({.op = CodeOp::CheckTime});
    }
    branchWhere(CodeOp::BranchIf, condition, markAt(w, target));
  }

 private:
  std::uint32_t markAt(Walk& w, std::uint32_t at) {
    const auto [place, isNew] = w.marks.try_emplace(at, m_.d.code.marks);
    if (isNew) ++m_.d.code.marks;
    return place->second;
  }

  Bool& state(std::size_t i) { return i < m_.stackLevels ? m_.stack[i] : m_.scrActive; }

  /// Brings stack and SCR to their places.
  void bringHome() {
    for (std::size_t i = 0; i < home_.size(); ++i) {
      if (home_[i] && home_[i]->id == state(i).id) continue;
      m_.d.add({.op = CodeOp::StoreState, .a = state(i).id, .value = i});
      home_[i] = state(i);
    }
  }
  void branchWhere(CodeOp op, Bool condition, std::uint32_t mark) {
    bringHome();
    const bool isAlways = m_.d.truth(condition) == true;
    m_.d.add({.op = isAlways ? CodeOp::Branch : op, .a = condition.id, .value = mark});
  }
  /// A block begins here; nothing is known of what the ways to it have in common.
  void meet(std::uint32_t mark) {
    bringHome();
    m_.d.add({.op = CodeOp::Mark, .value = mark});
    m_.d.forgetValues();
    m_.d.store->forget();
    for (std::size_t i = 0; i < home_.size(); ++i) {
      state(i) = {m_.d.add({.op = CodeOp::LoadState, .width = 1, .value = i})};
      home_[i] = state(i);
    }
  }

  std::vector<std::optional<Bool>> home_;
};

}  // namespace rungproof
