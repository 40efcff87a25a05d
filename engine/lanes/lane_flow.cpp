// Blocks, masks, and the uses of values.
#include "engine/lanes/lane_flow.hpp"

#include <algorithm>

namespace rungproof::lanes {

LaneFlow::LaneFlow(const Code& code, const std::vector<bool>& isNeeded, bool seesCommon)
    : isCommon(code.steps.size(), false), code_(code), isNeeded_(isNeeded) {
  findBlocks();
  if (seesCommon) findCommon();
  findMasks();
  findKept();
  findFolded();
  isPatched.assign(code.steps.size(), false);
  if (seesCommon) findPatched();
  findEnds();
}

/// Of a number whose upper part is only joined with another lower part, that part need not be taken out.
void LaneFlow::findPatched() {
  const auto isUpper = [&](ValueId id) {
    const Step& s = code_.steps[id];
    const int bits = s.op == CodeOp::Extract ? widthOf(code_.steps[s.a]) : 0;
    return (bits == 16 || bits == 32) && static_cast<int>(s.value) + s.width == bits && !keptAt.contains(id) &&
           !keptAt.contains(s.a);
  };
  for (ValueId i = 0; i < code_.steps.size(); ++i) isPatched[i] = isNeeded_[i] && isUpper(i);
  for (ValueId i = 0; i < code_.steps.size(); ++i) {
    if (!isNeeded_[i]) continue;
    const Step& s = code_.steps[i];
    const bool isPatch = s.op == CodeOp::Join && !isCommon[i] && s.value == code_.steps[s.a].value && s.a != s.b;
    eachOperand(s, [&](ValueId id) {
      if (!isPatch || id != s.a) isPatched[id] = false;
    });
  }
}

/// A block begins at a mark, and behind a branch back, where those go on that do not take it. Within a block nobody
/// joins.
void LaneFlow::findBlocks() {
  const auto count = static_cast<ValueId>(code_.steps.size());
  for (ValueId i = 0; i < count; ++i) {
    if (code_.steps[i].op == CodeOp::Mark) markAt[code_.steps[i].value] = i;
  }
  blockOf.resize(count);
  for (ValueId i = 0; i < count; ++i) {
    const Step& s = code_.steps[i];
    if (s.op == CodeOp::Mark) ++lastBlock;
    blockOf[i] = lastBlock;
    if (!isBranch(s.op) || markAt.at(s.value) > i) continue;
    goOnBehind[i] = 0;
    ++lastBlock;
  }
}

/// Where no branch leads past a step that some take and others do not, every trace comes to it, and at the same time.
void LaneFlow::findMasks() {
  const std::size_t count = code_.steps.size();
  std::vector<int> waiting(count + 1, 0), looping(count + 1, 0);
  joins.clear();
  for (ValueId i = 0; i < count; ++i) {
    const Step& s = code_.steps[i];
    if (!isBranch(s.op) || isCommon[i]) continue;
    const ValueId target = markAt.at(s.value);
    joins.insert(s.value);
    if (target > i) {
      ++waiting[i + 1];
      --waiting[target];
    } else {
      ++waiting[target];
      --waiting[i + 1];
      ++looping[target];
      --looping[i + 1];
    }
  }
  isMaskedAt.clear();
  isInLoop.clear();
  int isPassed = 0, isRepeated = 0;
  for (std::size_t i = 0; i < count; ++i) {
    isMaskedAt.push_back((isPassed += waiting[i]) > 0);
    isInLoop.push_back((isRepeated += looping[i]) > 0);
  }
}

void LaneFlow::findKept() {
  const auto uses = [&](ValueId user, ValueId id) {
    const CodeOp op = code_.steps[id].op;
    if (op == CodeOp::False || op == CodeOp::True || op == CodeOp::Constant || blockOf[id] == blockOf[user]) return;
    if (keptAt.try_emplace(id, keptRows).second) keptRows += pieceCount(repFor(widthOf(code_.steps[id])));
  };
  for (ValueId i = 0; i < code_.steps.size(); ++i) {
    if (!isNeeded_[i]) continue;
    const Step& s = code_.steps[i];
    eachOperand(s, [&](ValueId id) { uses(i, id); });
  }
  for (auto& [branch, row] : goOnBehind) row = keptRows++;
}

/// And negates its first operand for nothing; of two negated ones the second is made.
void LaneFlow::findFolded() {
  isFolded.assign(code_.steps.size(), false);
  for (ValueId i = 0; i < code_.steps.size(); ++i) {
    const Step& s = code_.steps[i];
    isFolded[i] = isNeeded_[i] && s.op == CodeOp::Not && !keptAt.contains(i) && !keptAt.contains(s.a);
  }
  for (ValueId i = 0; i < code_.steps.size(); ++i) {
    const Step& s = code_.steps[i];
    const int operands = isNeeded_[i] ? compiled::operandCount(s.op) : 0;
    const bool isAnd = s.op == CodeOp::And;
    if (operands > 0 && !isAnd) isFolded[s.a] = false;
    if (operands > 1 && (!isAnd || isFolded[s.a])) isFolded[s.b] = false;
    if (operands > 2) isFolded[s.c] = false;
  }
}

void LaneFlow::findEnds() {
  endsAt.resize(code_.steps.size());
  std::vector<std::uint32_t> seenIn(code_.steps.size(), ~std::uint32_t{0});
  for (ValueId i = static_cast<ValueId>(code_.steps.size()); i-- > 0;) {
    if (!isNeeded_[i]) continue;
    const Step& s = code_.steps[i];
    const auto use = [&](ValueId id) {
      if (std::exchange(seenIn[id], blockOf[i]) != blockOf[i]) endsAt[i].push_back(id);
    };
    eachOperand(s, [&](ValueId id) {
      use(id);
      if (isFolded[id] || isPatched[id]) use(code_.steps[id].a);
    });
    if (hasValue(s.op)) use(i);
  }
}

}  // namespace rungproof::lanes
