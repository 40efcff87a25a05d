// Blocks, masks, and the uses of values.
#include "engine/lanes/lane_flow.hpp"

#include <algorithm>

namespace rungproof::lanes {

LaneFlow::LaneFlow(const Code& code, const std::vector<bool>& isNeeded, bool seesCommon, std::size_t mostOfPart)
    : isCommon(code.steps.size(), false), code_(code), isNeeded_(isNeeded) {
  if (code.isStraight)
    findParts(mostOfPart);
  else
    findBlocks();
  if (seesCommon) findCommon();
  findMasks();
  findFolded();
  findTaken();
  for (auto* marks : {&isDeferred, &isFit, &isPatched}) marks->assign(code.steps.size(), false);
  nextStore_.assign(code.steps.size(), 0);
  if (code.isStraight) findNextStores();
  if (seesCommon) findSums();
  if (seesCommon) findMerged();
  findKept();
  if (seesCommon) findPatched();
  findEnds();
}

/// Of a number whose upper part is only joined with another lower part, that part need not be taken out.
void LaneFlow::findPatched() {
  const auto isUpper = [&](ValueId id) {
    const Step& s = code_.steps[id];
    const int bits = s.op == CodeOp::Extract ? widthOf(code_.steps[s.a]) : 0;
    return (bits == 16 || bits == 32) && static_cast<int>(s.value) + s.width == bits && !keptAt.contains(id) &&
           blockOf[id] == blockOf[s.a];
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

/// Of straight code each part is a block.
void LaneFlow::findParts(std::size_t mostOfPart) {
  std::size_t count = 0;
  for (ValueId i = 0; i < code_.steps.size(); ++i) {
    if (isNeeded_[i] && count++ == mostOfPart) {
      partsAt.insert(i);
      ++lastBlock;
      count = 1;
    }
    blockOf.push_back(lastBlock);
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

void LaneFlow::findNextStores() {
  const auto never = static_cast<ValueId>(code_.steps.size());
  std::unordered_map<std::uint64_t, ValueId> slots, bytes;
  std::array<ValueId, areaCount> reached;
  reached.fill(never);
  const auto byteOf = [](const Step& s, std::uint64_t k) {
    return static_cast<std::uint64_t>(s.area) << 32 | (s.value + k);
  };
  const auto at = [&](const auto& places, std::uint64_t place) {
    const auto found = places.find(place);
    return found == places.end() ? never : found->second;
  };
  for (ValueId i = never; i-- > 0;) {
    const Step& s = code_.steps[i];
    if (!isNeeded_[i]) continue;
    if (s.op == CodeOp::StoreBit) slots[s.value] = i;
    for (std::uint64_t bit = 0; s.op == CodeOp::StoreSlots && bit < 8; ++bit) slots[s.value + bit] = i;
    for (std::uint64_t k = 0; s.op == CodeOp::StoreMemory && k < s.width / 8U; ++k) bytes[byteOf(s, k)] = i;
    if (s.op == CodeOp::StoreAt) reached[static_cast<std::size_t>(s.area)] = i;
    if (s.op == CodeOp::LoadBit) nextStore_[i] = at(slots, s.value);
    if (s.op == CodeOp::LoadMemory) nextStore_[i] = reached[static_cast<std::size_t>(s.area)];
    for (std::uint64_t k = 0; s.op == CodeOp::LoadMemory && k < s.width / 8U; ++k)
      nextStore_[i] = std::min(nextStore_[i], at(bytes, byteOf(s, k)));
  }
}

void LaneFlow::findKept() {
  const auto uses = [&](ValueId user, ValueId id) {
    const CodeOp op = code_.steps[id].op;
    if (op == CodeOp::False || op == CodeOp::True || op == CodeOp::Constant || blockOf[id] == blockOf[user]) return;
    if (user <= nextStore_[id]) {
      readAgain.insert(id);
      return;
    }
    const Rep rep = repFor(widthOf(code_.steps[id]));
    const bool isTruth = rep == Rep::Truth;
    if (keptAt.try_emplace(id, isTruth ? keptTruths : keptRows).second)
      (isTruth ? keptTruths : keptRows) += isTruth ? 1 : pieceCount(rep);
  };
  for (ValueId i = 0; i < code_.steps.size(); ++i) {
    if (!isNeeded_[i]) continue;
    eachOperand(code_.steps[i], [&](ValueId id) {
      uses(i, isFolded[id] ? code_.steps[id].a : id);
      if (isDeferred[id]) eachOperand(code_.steps[id], [&](ValueId part) { uses(i, part); });
    });
  }
  std::erase_if(readAgain, [&](ValueId id) { return keptAt.contains(id); });
  for (auto& [branch, row] : goOnBehind) row = keptRows++;
}

/// And negates its first operand for nothing; of two negated ones the second is made.
void LaneFlow::findFolded() {
  isFolded.assign(code_.steps.size(), false);
  for (ValueId i = 0; i < code_.steps.size(); ++i) isFolded[i] = isNeeded_[i] && code_.steps[i].op == CodeOp::Not;
  for (ValueId i = 0; i < code_.steps.size(); ++i) {
    const Step& s = code_.steps[i];
    const int operands = isNeeded_[i] ? compiled::operandCount(s.op) : 0;
    const bool isAnd = s.op == CodeOp::And;
    if (operands > 0 && !isAnd) isFolded[s.a] = false;
    if (operands > 1 && (!isAnd || isFolded[s.a])) isFolded[s.b] = false;
    if (operands > 2) isFolded[s.c] = false;
  }
}

/// A choice between truth values, of which the block has already made what is both condition and chosen.
void LaneFlow::findTaken() {
  std::unordered_map<std::uint64_t, ValueId> both;
  const auto keyOf = [](ValueId a, ValueId b) { return std::uint64_t{std::min(a, b)} << 32 | std::max(a, b); };
  for (ValueId i = 0; i < code_.steps.size(); ++i) {
    const Step& s = code_.steps[i];
    if (!isNeeded_[i]) continue;
    if (s.op == CodeOp::And) both[keyOf(s.a, s.b)] = i;
    if (s.op != CodeOp::SelectBit) continue;
    const auto found = both.find(keyOf(s.a, s.b));
    if (found != both.end() && blockOf[found->second] == blockOf[i]) takenAt.emplace(i, found->second);
  }
}

std::vector<std::uint32_t> LaneFlow::useCounts() const {
  std::vector<std::uint32_t> counts(code_.steps.size(), 0);
  for (ValueId i = 0; i < code_.steps.size(); ++i) {
    if (isNeeded_[i]) eachOperand(code_.steps[i], [&](ValueId id) { ++counts[id]; });
  }
  return counts;
}

/// Whether something else is chosen where a sum with a constant part overflows.
bool LaneFlow::isSumUnlessOverflow(ValueId select) const {
  const Step& s = code_.steps[select];
  if (!isNeeded_[select] || s.op != CodeOp::Select || isCommon[s.a]) return false;
  const Step &overflow = code_.steps[s.a], &sum = code_.steps[s.c];
  const bool isAdded = overflow.op == CodeOp::AddOverflows && sum.op == CodeOp::Add;
  const bool isSubtracted = overflow.op == CodeOp::SubOverflows && sum.op == CodeOp::Sub;
  const auto isPart = [&](ValueId id) { return code_.steps[id].op == CodeOp::Constant && code_.steps[id].value != 0; };
  return (isAdded || isSubtracted) && overflow.width == sum.width && overflow.a == sum.a && overflow.b == sum.b &&
         (isPart(sum.b) || (isAdded && isPart(sum.a))) && blockOf[select] == blockOf[s.a] &&
         blockOf[select] == blockOf[s.c];
}

/// A sum that nobody but such a choice wants is made there, under the mask of those that do not overflow. Who else asks
/// for the overflow must be able to ask for its opposite.
void LaneFlow::findSums() {
  const std::vector<std::uint32_t> counts = useCounts();
  for (ValueId i = 0; i < code_.steps.size(); ++i) {
    const Step& s = code_.steps[i];
    if (!isSumUnlessOverflow(i) || counts[s.c] != 1 || s.b == s.a) continue;
    sumAt.emplace(i, s.c);
    isFit[s.a] = true;
  }
  const auto isOverflow = [&](ValueId id) {
    return code_.steps[id].op == CodeOp::AddOverflows || code_.steps[id].op == CodeOp::SubOverflows;
  };
  const auto mayAsk = [&](ValueId user, ValueId overflow) {
    const Step& s = code_.steps[user];
    if (blockOf[user] != blockOf[overflow]) return false;
    const ValueId other = s.a == overflow ? s.b : s.a;
    if (s.op == CodeOp::And) return !isFolded[other] && !isOverflow(other);
    return sumAt.contains(user) || (takenAt.contains(user) && s.b == overflow && s.a != overflow && s.c != overflow);
  };
  for (ValueId i = 0; i < code_.steps.size(); ++i) {
    if (!isNeeded_[i]) continue;
    eachOperand(code_.steps[i], [&](ValueId id) {
      if (isFit[id] && !mayAsk(i, id)) isFit[id] = false;
    });
  }
  std::erase_if(sumAt, [&](const auto& entry) { return !isFit[code_.steps[entry.first].a]; });
  for (const auto& [select, sum] : sumAt) isDeferred[sum] = true;
}

/// Nobody has written there since what stands there was read, and nobody but the store asks for the choice.
void LaneFlow::findMerged() {
  const std::vector<std::uint32_t> counts = useCounts();
  for (ValueId i = 0; i < code_.steps.size(); ++i) {
    const Step& s = code_.steps[i];
    if (!isNeeded_[i] || s.op != CodeOp::StoreMemory) continue;
    const Step &choice = code_.steps[s.a], &before = code_.steps[choice.c];
    const bool isChoice = choice.op == CodeOp::Select && counts[s.a] == 1 && !isCommon[s.a] && !sumAt.contains(s.a) &&
                          blockOf[s.a] == blockOf[i];
    const bool isThere = before.op == CodeOp::LoadMemory && before.area == s.area && before.value == s.value &&
                         before.width == s.width && nextStore_[choice.c] == i;
    if (!isChoice || !isThere) continue;
    merged.insert(s.a);
    isDeferred[s.a] = true;
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
      if (isDeferred[id]) eachOperand(code_.steps[id], use);
    });
    if (const auto taken = takenAt.find(i); taken != takenAt.end()) use(taken->second);
    if (hasValue(s.op)) use(i);
  }
}

}  // namespace rungproof::lanes
