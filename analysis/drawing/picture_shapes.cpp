// Shapes of networks as keys.
#include "analysis/drawing/picture_shapes.hpp"

#include "analysis/drawing/raise.hpp"
#include "ir/s7200/cpu.hpp"
#include "ir/s7300/cpu.hpp"

namespace rungproof {

namespace {

/// The timers of 1 ms count between two instructions: the moment matters at which they are read.
bool countsBetweenInstructions(const Operand& operand) {
  return operand.area == Area::T && (operand.offset == 32 || operand.offset == 96);
}

}  // namespace

/// False: more than the shape decides. A call takes flow inputs over bits of local memory, and a box that exists in
/// drawings only has its output there.
bool PictureShapes::makeKey(const Network& network) {
  key_.clear();
  if (isStep7(target_) || !network.complete) return false;
  for (const Instruction& instruction : network.instructions) {
    const Desc* desc = instruction.desc;
    if (desc->control == Control::Call || desc->drawingOnly) return false;
    key_.append(reinterpret_cast<const char*>(&desc), sizeof desc);
    for (const Operand& operand : instruction.operands) {
      if (operand.area == Area::L) return false;  // may be a bit of the editor's own
      key_ += static_cast<char>(operand.kind);
      key_ += static_cast<char>(operand.area);
      key_ += countsBetweenInstructions(operand) ? '1' : '0';
    }
    key_ += static_cast<char>(instruction.operands.size());
  }
  return true;
}

bool PictureShapes::canBeDrawn(const Network& network) {
  const bool hasKey = makeKey(network);
  if (hasKey) {
    if (const auto known = known_.find(key_); known != known_.end()) return known->second;
  }
  bool isDrawn = false, comparedAddresses = false;
  for (const Form form : {Form::Ladder, Form::Fbd}) {
    if (isDrawn) break;
    const Raised raised = raise(network, form, target_);
    isDrawn = raised.drawing.has_value();
    comparedAddresses = comparedAddresses || raised.comparedAddresses;
  }
  if (hasKey && !comparedAddresses) known_.emplace(key_, isDrawn);
  return isDrawn;
}

}  // namespace rungproof
