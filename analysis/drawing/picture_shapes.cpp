// Shapes of networks as keys.
#include "analysis/drawing/picture_shapes.hpp"

#include <fmt/format.h>

#include "analysis/drawing/raise.hpp"
#include "ir/dialect.hpp"
#include "ir/s7200/cpu.hpp"

namespace rungproof {

namespace {

/// The timers of 1 ms count between two instructions: the moment matters at which they are read.
bool countsBetweenInstructions(const Operand& operand) {
  return operand.area == Area::T && (operand.offset == 32 || operand.offset == 96);
}

/// A bit of the editor's own, from L60.0, or something in local memory that may reach there.
bool mayBeOfEditor(const Operand& operand) {
  constexpr std::uint32_t farBelow = 56;  // a double word ends in front of L60
  return operand.area == Area::L && (operand.kind != OperandKind::Direct || operand.offset > farBelow);
}

}  // namespace

/// False: more than the shape decides. A call takes flow inputs over bits of local memory, and a box that exists in
/// drawings only has its output there.
bool PictureShapes::makeKey(const Network& network) {
  key_.clear();
  if (formOf(target_) == StatementForm::Accumulators || !network.complete) return false;
  for (const Instruction& instruction : network.instructions) {
    const Desc* desc = instruction.desc;
    if (desc->control == Control::Call || desc->drawingOnly) return false;
    key_.append(reinterpret_cast<const char*>(&desc), sizeof desc);
    for (const Operand& operand : instruction.operands) {
      if (mayBeOfEditor(operand)) return false;
      key_ += static_cast<char>(operand.kind);
      key_ += static_cast<char>(operand.area);
      key_ += countsBetweenInstructions(operand) ? '1' : '0';
    }
    key_ += static_cast<char>(instruction.operands.size());
  }
  return true;
}

bool PictureShapes::canBeDrawn(const Network& network) {
  last_ = nullptr;
  lastNetwork_ = &network;
  const bool hasKey = makeKey(network);
  if (hasKey) {
    if (const auto known = known_.find(key_); known != known_.end()) {
      last_ = &known->second;
      return last_->isDrawn;
    }
  }
  Verdict verdict;
  bool comparedAddresses = false;
  for (const Form form : {Form::Ladder, Form::Fbd}) {
    if (verdict.isDrawn) break;
    const Raised raised = raise(network, form, target_);
    verdict.isDrawn = raised.drawing.has_value();
    verdict.clause = raised.clause;
    verdict.at = raised.at == nullptr ? 0 : static_cast<std::size_t>(raised.at - network.instructions.data());
    comparedAddresses = comparedAddresses || raised.comparedAddresses;
  }
  if (hasKey && !comparedAddresses) last_ = &known_.emplace(key_, verdict).first->second;
  return verdict.isDrawn;
}

PictureShapes::Refusal PictureShapes::refusalOf(const Network& network) const {
  if (&network == lastNetwork_ && last_ != nullptr && !last_->clause.empty()) {
    const Instruction& at = network.instructions[last_->at];
    return {&at, fmt::format("{} {}", nameInReason(at), last_->clause)};
  }
  Raised fbd = raise(network, Form::Fbd, target_);
  return {fbd.at, std::move(fbd.reason)};
}

}  // namespace rungproof
