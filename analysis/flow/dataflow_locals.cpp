// The pass over one block.
#include "analysis/flow/dataflow_locals.hpp"

#include <algorithm>
#include <unordered_map>

namespace rungproof {

namespace {

void fill(LocalBits& bits, std::uint32_t from, std::uint32_t count) {
  for (std::uint32_t k = from; k < std::min(from + count, localBits); ++k) bits.set(k);
}

class Pass {
 public:
  Pass(const Facts& facts, std::uint32_t block)
      : facts_(facts), flow_(facts.plan().flows[block]), pou_(facts.program().pous[block]) {}

  LocalFlow run() {
    for (const LocalVariable& local : pou_.locals) {
      if (local.section == VarSection::Input || local.section == VarSection::InOut) written_ |= localBitsOf(local);
    }
    const auto end = static_cast<std::uint32_t>(flow_.steps.size());
    for (std::uint32_t i = 0; i < end; ++i) {
      arrive(i);
      if (isLive_) step(i);
    }
    arrive(end);
    if (isLive_) leave(nullptr);
    return std::move(result_);
  }

 private:
  void arrive(std::uint32_t i) {
    const auto found = sent_.empty() ? sent_.end() : sent_.find(i);
    if (found == sent_.end()) return;
    written_ = isLive_ ? written_ & found->second : found->second;
    isLive_ = true;
  }
  void send(std::uint32_t target, std::uint32_t from) {
    if (target == noPartner || target <= from) return;  // a jump back brings no fewer writes than the label had
    const auto [place, isNew] = sent_.emplace(target, written_);
    if (!isNew) place->second &= written_;
  }

  void step(std::uint32_t i) {
    const FlowStep& step = flow_.steps[i];
    const Instruction& instruction = *step.instruction;
    const bool isAlways = (facts_.stack().at(step.id()).flow & condition::Always) != 0;
    const std::span<const Access> accesses = facts_.accesses().of(step.id());
    for (const Access& access : accesses) read(access);
    for (const Access& access : accesses) {
      if (access.write && access.area == Area::L && !access.viaPointer) written_ |= localBitsOf(access);
    }
    switch (instruction.desc->control) {
      case Control::Jump:
        send(step.partner, i);
        if (isAlways && step.partner != noPartner) isLive_ = false;
        break;
      case Control::For: send(step.partner == noPartner ? noPartner : step.partner + 1, i); break;
      case Control::ScrEndConditional:
      case Control::Lscr: send(step.partner, i); break;
      case Control::ReturnConditional:
        leave(&instruction);
        if (isAlways) isLive_ = false;
        break;
      case Control::Return:
        leave(&instruction);
        isLive_ = false;
        break;
      default: break;
    }
  }

  void read(const Access& access) {
    if (access.write || access.area != Area::L || access.viaPointer || access.operand == impliedOperand) return;
    const Desc& desc = *facts_.instruction(access.instruction).desc;
    const bool isOwn = access.operand < desc.operandCount &&
                       desc.operands[access.operand].direction == Direction::InOut && access.width == Width::Bit;
    const LocalBits bits = localBitsOf(access);
    if (isOwn || (bits & ~(written_ | reported_)).none()) return;
    result_.unwritten.push_back({&access});
    reported_ |= bits;
  }

  void leave(const Instruction* exit) {
    for (const LocalVariable& local : pou_.locals) {
      if (local.section != VarSection::Output) continue;
      const LocalBits bits = localBitsOf(local);
      if ((bits & ~written_).none()) continue;
      const bool isKnown = std::any_of(result_.exits.begin(), result_.exits.end(),
                                       [&](const LocalExit& e) { return e.parameter == &local; });
      if (!isKnown) result_.exits.push_back({&local, exit, !isWrittenAnywhere(bits)});
    }
  }

  bool isWrittenAnywhere(const LocalBits& bits) const {
    return std::any_of(flow_.steps.begin(), flow_.steps.end(), [&](const FlowStep& step) {
      const std::span<const Access> accesses = facts_.accesses().of(step.instruction->id);
      return std::any_of(accesses.begin(), accesses.end(), [&](const Access& a) {
        return a.write && a.area == Area::L && !a.viaPointer && (localBitsOf(a) & bits).any();
      });
    });
  }

  const Facts& facts_;
  const Flow& flow_;
  const Pou& pou_;
  LocalFlow result_;
  LocalBits written_, reported_;
  std::unordered_map<std::uint32_t, LocalBits> sent_;
  bool isLive_ = true;
};

}  // namespace

LocalBits localBitsOf(const Access& access) {
  LocalBits bits;
  if (access.width == Width::Bit)
    fill(bits, access.offset * 8 + access.bit, access.count);
  else
    fill(bits, access.offset * 8, access.certainLength() * 8);
  return bits;
}

LocalBits localBitsOf(const LocalVariable& local) {
  LocalBits bits;
  const bool isBit = local.address.width == Width::Bit;
  fill(bits, local.address.offset * 8 + (isBit ? local.address.bit : 0),
       static_cast<std::uint32_t>(rungproof::bits(local.address.width)));
  return bits;
}

LocalFlow localFlow(const Facts& facts, std::uint32_t block) { return Pass(facts, block).run(); }

}  // namespace rungproof
