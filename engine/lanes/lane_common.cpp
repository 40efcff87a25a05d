// Which values all traces have in common. First every value is taken for one that could be; what turns out to depend on
// a trace is crossed out until nothing is left to cross out. Memory is common from a store of a common value on, where
// all traces come to it at once, until another store. A store to a computed address could be one to any place: that it
// does not change what loops count with, is taken for granted, and a trace in which it does leaves the code there.
#include <algorithm>
#include <unordered_set>

#include "engine/lanes/lane_flow.hpp"

namespace rungproof::lanes {

namespace {

/// Whether one number is computed, where the operands are common.
bool isOneNumber(const Step& s, const Code& code) {
  switch (s.op) {
    case CodeOp::RealEqual:
    case CodeOp::RealLess:
    case CodeOp::RealLegal:
    case CodeOp::Mul:
    case CodeOp::DivideUnsigned:
    case CodeOp::RemainderUnsigned:
    case CodeOp::DivideSigned:
    case CodeOp::RemainderSigned:
    case CodeOp::RealAdd:
    case CodeOp::RealSub:
    case CodeOp::RealMul:
    case CodeOp::RealDiv:
    case CodeOp::RealFunction:
    case CodeOp::RealFromInt:
    case CodeOp::RealToInt:
    case CodeOp::LoadSlots:
    case CodeOp::LoadAt: return false;
    case CodeOp::ShiftLeft:
    case CodeOp::ShiftRight: return code.steps[s.b].op == CodeOp::Constant;
    default: return hasValue(s.op);
  }
}

/// Places of the state whose content is common, or all of them: nobody comes there.
class CommonPlaces {
 public:
  static std::uint64_t ofRegister(std::uint64_t index) { return 1ULL << 60 | index; }
  static std::uint64_t ofState(std::uint64_t number) { return 2ULL << 60 | number; }
  static std::uint64_t ofSlot(std::uint64_t slot) { return 3ULL << 60 | slot; }
  static std::uint64_t ofByte(Area area, std::uint64_t byte) {
    return 4ULL << 60 | static_cast<std::uint64_t>(area) << 40 | byte;
  }

  bool isEverything = false;
  bool contains(std::uint64_t place) const { return isEverything || places_.contains(place); }
  void put(std::uint64_t place, bool isCommon) {
    if (isEverything) return;
    if (isCommon)
      places_.insert(place);
    else
      places_.erase(place);
  }
  template <class IsGuarded>
  void forget(Area area, IsGuarded&& isGuarded) {
    std::erase_if(places_, [&](std::uint64_t p) {
      return p >> 60 == 4 && p >> 40 == ofByte(area, 0) >> 40 && !isGuarded(area, p & ((1ULL << 40) - 1));
    });
  }
  /// False: it was so already.
  bool keepOnly(const CommonPlaces& other) {
    if (other.isEverything) return false;
    if (isEverything) {
      *this = other;
      return true;
    }
    return std::erase_if(places_, [&](std::uint64_t p) { return !other.places_.contains(p); }) > 0;
  }

 private:
  std::unordered_set<std::uint64_t> places_;
};

}  // namespace

bool LaneFlow::isGuarded(Area area, std::uint64_t byte) const {
  return std::ranges::any_of(
      guarded, [&](const Guarded& g) { return g.area == area && byte >= g.first && byte - g.first < g.count; });
}

/// Where computed addresses are written to, the memory from which conditions of ways back are computed.
void LaneFlow::findGuarded() {
  std::vector<bool> isAsked(code_.steps.size(), false);
  for (const auto& [branch, row] : goOnBehind) isAsked[code_.steps[branch].a] = isNeeded_[branch];
  for (ValueId i = static_cast<ValueId>(code_.steps.size()); i-- > 0;) {
    const Step& s = code_.steps[i];
    if (!isAsked[i] || !hasValue(s.op)) continue;
    eachOperand(s, [&](ValueId id) { isAsked[id] = true; });
    const bool isWritten = s.op == CodeOp::LoadMemory && std::ranges::any_of(code_.steps, [&](const Step& store) {
                             return store.op == CodeOp::StoreAt && store.area == s.area;
                           });
    if (isWritten) guarded.push_back({s.area, static_cast<std::uint32_t>(s.value), s.width / 8U});
  }
}

void LaneFlow::findCommon() {
  const auto begin = [&] {
    for (ValueId i = 0; i < code_.steps.size(); ++i) {
      const Step& s = code_.steps[i];
      isCommon[i] = isNeeded_[i] && (isOneNumber(s, code_) || isBranch(s.op));
    }
    do findMasks();
    while (narrowCommon());
  };
  const auto isCommonLoad = [&](const Guarded& g) {
    for (ValueId i = 0; i < code_.steps.size(); ++i) {
      const Step& s = code_.steps[i];
      if (isNeeded_[i] && isCommon[i] && s.op == CodeOp::LoadMemory && s.area == g.area && s.value == g.first)
        return true;
    }
    return false;
  };
  findGuarded();
  begin();
  // What is not common in spite of it needs no guard.
  if (std::erase_if(guarded, [&](const Guarded& g) { return !isCommonLoad(g); }) > 0) begin();
  findRegisters();
}

void LaneFlow::findRegisters() {
  if (goOnBehind.empty()) return;  // written once as a rule
  for (const std::uint64_t reg : commonAtEnd_) oneNumberAt.try_emplace(reg, 0);
  for (ValueId i = 0; i < code_.steps.size(); ++i) {
    const Step& s = code_.steps[i];
    const bool isOther = s.op == CodeOp::LoadRegister && (!isCommon[i] || repFor(s.width) == Rep::Truth);
    const bool isTruthStore = s.op == CodeOp::StoreRegister && repFor(widthOf(code_.steps[s.a])) == Rep::Truth &&
                              code_.steps[s.a].op != CodeOp::Constant;
    if (isNeeded_[i] && (isOther || isTruthStore)) oneNumberAt.erase(s.value);
  }
  for (auto& [reg, row] : oneNumberAt) row = keptRows++;
}

/// Crosses out what the masks as they are now, and what is crossed out already, allow no more.
bool LaneFlow::narrowCommon() {
  bool isNarrowed = false;
  const auto crossOut = [&](ValueId id) {
    if (isCommon[id]) isNarrowed = true;
    isCommon[id] = false;
  };
  std::unordered_map<std::uint64_t, CommonPlaces> atMark;
  for (const auto& [mark, step] : markAt) atMark[mark].isEverything = true;
  for (bool isNew = true; isNew;) {
    isNew = false;
    CommonPlaces now;
    for (ValueId i = 0; i < code_.steps.size(); ++i) {
      const Step& s = code_.steps[i];
      if (!isNeeded_[i]) continue;
      const int operands = compiled::operandCount(s.op);
      const bool isOfCommon =
          (operands < 1 || isCommon[s.a]) && (operands < 2 || isCommon[s.b]) && (operands < 3 || isCommon[s.c]);
      if ((hasValue(s.op) || isBranch(s.op)) && !isOfCommon) crossOut(i);
      if (isBranch(s.op) && isMaskedAt[i]) crossOut(i);
      const bool isStored = isOfCommon && !isMaskedAt[i];
      const auto load = [&](std::uint64_t place) {
        if (!now.contains(place)) crossOut(i);
      };
      switch (s.op) {
        case CodeOp::LoadBit: load(CommonPlaces::ofSlot(s.value)); break;
        case CodeOp::LoadState:
        case CodeOp::LoadStateWord: load(CommonPlaces::ofState(s.value)); break;
        case CodeOp::LoadRegister: load(CommonPlaces::ofRegister(s.value)); break;
        case CodeOp::LoadMemory:
          for (std::uint64_t k = 0; k < s.width / 8U; ++k) load(CommonPlaces::ofByte(s.area, s.value + k));
          break;
        case CodeOp::StoreBit: now.put(CommonPlaces::ofSlot(s.value), isStored); break;
        case CodeOp::StoreState:
        case CodeOp::StoreStateWord: now.put(CommonPlaces::ofState(s.value), isStored); break;
        case CodeOp::StoreRegister: now.put(CommonPlaces::ofRegister(s.value), isStored); break;
        case CodeOp::StoreSlots:
          for (std::uint64_t bit = 0; bit < 8; ++bit) now.put(CommonPlaces::ofSlot(s.value + bit), false);
          break;
        case CodeOp::StoreMemory:
          for (std::uint64_t k = 0; k < s.width / 8U; ++k)
            now.put(CommonPlaces::ofByte(s.area, s.value + k), isStored && !isClearing(s, code_));
          break;
        case CodeOp::StoreAt:
          now.forget(s.area, [&](Area area, std::uint64_t byte) { return isGuarded(area, byte); });
          break;
        case CodeOp::Mark:
          atMark[s.value].keepOnly(now);
          now = atMark[s.value];
          break;
        case CodeOp::Branch:
        case CodeOp::BranchIf:
        case CodeOp::BranchUnless:
          if (atMark[s.value].keepOnly(now) && markAt.at(s.value) < i) isNew = true;
          if (s.op == CodeOp::Branch) now.isEverything = true;
          break;
        default: break;
      }
    }
    commonAtEnd_.clear();
    for (const Step& s : code_.steps) {
      if (s.op == CodeOp::StoreRegister && !now.isEverything && now.contains(CommonPlaces::ofRegister(s.value)))
        commonAtEnd_.push_back(s.value);
    }
  }
  return isNarrowed;
}

}  // namespace rungproof::lanes
