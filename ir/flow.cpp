// Pairs jumps, loops and segments of a block. JMP and LBL: 001:5782-5801; FOR, NEXT: 001:5750-5770, depth 8
// 001:5752; SCR: 001:5803-5841, borders 001:5818.
#include "ir/flow.hpp"

#include <map>

namespace rungproof {

namespace {

class Pairing {
 public:
  explicit Pairing(Flow& flow) : flow_(flow) {}

  void run() {
    for (std::uint32_t i = 0; i < flow_.steps.size(); ++i) visit(i);
    for (const std::uint32_t open : loops_) fault(FlowProblem::ForWithoutNext, open);
    if (segment_ != noPartner) fault(FlowProblem::LscrWithoutScre, segment_);
    resolveJumps();
  }

 private:
  void visit(std::uint32_t i) {
    segmentOf_.push_back(segment_);
    switch (control(i)) {
      case Control::LabelMark: label(i); break;
      case Control::Jump:
      case Control::Branch:
      case Control::Distributor: jumps_.push_back(i); break;
      case Control::For:
        if (loops_.size() >= 8) fault(FlowProblem::ForTooDeep, i);
        loops_.push_back(i);
        break;
      case Control::Next: next(i); break;
      case Control::Lscr: openSegment(i); break;
      case Control::ScrEnd: closeSegment(i); break;
      case Control::Scrt:
      case Control::ScrEndConditional:
        if (segment_ == noPartner) fault(FlowProblem::ScrtOutsideSegment, i);
        flow_.steps[i].partner = segment_;
        break;
      case Control::End:
        if (segment_ != noPartner) fault(FlowProblem::EndInsideSegment, i);
        break;
      default: break;
    }
  }

  void label(std::uint32_t i) {
    const auto [place, isNew] = labels_.emplace(number(i), i);
    if (!isNew)
      flow_.faults.push_back(
          {FlowProblem::LabelTwice, flow_.steps[i].instruction, flow_.steps[place->second].instruction});
  }
  void next(std::uint32_t i) {
    if (loops_.empty()) return fault(FlowProblem::NextWithoutFor, i);
    pair(loops_.back(), i);
    loops_.pop_back();
  }
  void openSegment(std::uint32_t i) {
    if (segment_ != noPartner) fault(FlowProblem::LscrInsideSegment, i);
    segment_ = i;
    segmentOf_.back() = i;
  }
  void closeSegment(std::uint32_t i) {
    if (segment_ == noPartner) return fault(FlowProblem::ScreWithoutLscr, i);
    pair(segment_, i);
    for (std::uint32_t k = segment_ + 1; k < i; ++k) {
      if (control(k) == Control::ScrEndConditional) flow_.steps[k].partner = i;
    }
    segment_ = noPartner;
  }
  void resolveJumps() {
    for (const std::uint32_t i : jumps_) {
      const auto target = labels_.find(number(i));
      if (target == labels_.end()) {
        fault(FlowProblem::LabelMissing, i);
        continue;
      }
      flow_.steps[i].partner = target->second;
      if (segmentOf_[i] != segmentOf_[target->second]) {
        flow_.faults.push_back(
            {FlowProblem::JumpAcrossScr, flow_.steps[i].instruction, flow_.steps[target->second].instruction});
      }
    }
  }

  Control control(std::uint32_t i) const { return flow_.steps[i].instruction->desc->control; }
  std::int64_t number(std::uint32_t i) const {
    const Instruction& instruction = *flow_.steps[i].instruction;
    return instruction.operands.empty() ? -1 : instruction.operands[0].value;
  }
  void pair(std::uint32_t a, std::uint32_t b) {
    flow_.steps[a].partner = b;
    flow_.steps[b].partner = a;
  }
  void fault(FlowProblem problem, std::uint32_t i) { flow_.faults.push_back({problem, flow_.steps[i].instruction}); }

  Flow& flow_;
  std::map<std::int64_t, std::uint32_t> labels_;
  std::vector<std::uint32_t> jumps_;
  std::vector<std::uint32_t> loops_;
  std::vector<std::uint32_t> segmentOf_;
  std::uint32_t segment_ = noPartner;
};

}  // namespace

Flow flowOf(const Pou& pou, const std::vector<bool>& isLeftOut) {
  Flow flow;
  flow.pou = &pou;
  std::size_t count = 0;
  for (const Network& network : pou.networks) count += network.instructions.size();
  flow.steps.reserve(count);
  for (std::uint32_t n = 0; n < pou.networks.size(); ++n) {
    for (const Instruction& instruction : pou.networks[n].instructions) {
      if (isLeftOut.empty() || !isLeftOut[instruction.id]) flow.steps.push_back({&instruction, noPartner, n});
    }
  }
  Pairing(flow).run();
  return flow;
}

}  // namespace rungproof
