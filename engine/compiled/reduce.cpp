// Backwards through the code: first which stores are overwritten, then which values lead to something that stays.
#include "engine/compiled/reduce.hpp"

#include <optional>
#include <unordered_map>
#include <unordered_set>

namespace rungproof::compiled {

namespace {

bool isStateStore(CodeOp op) { return op == CodeOp::StoreState || op == CodeOp::StoreStateWord; }

class PlaceSet {
 public:
  explicit PlaceSet(std::size_t count) : words_((count + 63) / 64) {}
  bool contains(std::size_t place) const { return (words_[place / 64] >> (place % 64) & 1) != 0; }
  void add(std::size_t place) { words_[place / 64] |= std::uint64_t{1} << (place % 64); }
  void remove(std::size_t place) { words_[place / 64] &= ~(std::uint64_t{1} << (place % 64)); }
  void clear() { words_.assign(words_.size(), 0); }
  void keepOnly(const PlaceSet& other) {
    for (std::size_t i = 0; i < words_.size(); ++i) words_[i] &= other.words_[i];
  }

 private:
  std::vector<std::uint64_t> words_;
};

/// Everything that stores write, numbered: registers, bits that have slots, bytes.
class Places {
 public:
  Places(const Code& code, std::size_t registers) : slots_(registers), count_(slots_ + 8 * code.slots.size()) {
    for (const Step& step : code.steps) {
      const bool isAccess = step.op == CodeOp::StoreMemory || step.op == CodeOp::LoadMemory;
      for (std::uint64_t i = 0; isAccess && i < step.width / 8U; ++i) {
        if (bytes_.try_emplace(key(step.area, step.value + i), count_).second) ++count_;
      }
    }
  }

  std::size_t count() const { return count_; }
  /// take(place) for each that the step stores or loads.
  template <class Take>
  void of(const Step& step, Take&& take) const {
    switch (step.op) {
      case CodeOp::LoadRegister:
      case CodeOp::StoreRegister: return take(step.value);
      case CodeOp::LoadBit:
      case CodeOp::StoreBit: return take(slots_ + step.value);
      case CodeOp::LoadSlots:
      case CodeOp::StoreSlots:
        for (std::uint64_t bit = 0; bit < 8; ++bit) take(slots_ + step.value + bit);
        return;
      case CodeOp::LoadMemory:
      case CodeOp::StoreMemory:
        for (std::uint64_t i = 0; i < step.width / 8U; ++i) take(bytes_.at(key(step.area, step.value + i)));
        return;
      default: return;
    }
  }
  template <class Take>
  void ofArea(const Code& code, Area area, Take&& take) const {
    for (const auto& [at, place] : bytes_) {
      if (at >> 32 == static_cast<std::uint64_t>(area)) take(place);
    }
    for (std::size_t i = 0; i < code.slots.size(); ++i) {
      for (std::size_t bit = 0; code.slots[i].area == area && bit < 8; ++bit) take(slots_ + 8 * i + bit);
    }
  }

 private:
  static std::uint64_t key(Area area, std::uint64_t byte) { return static_cast<std::uint64_t>(area) << 32 | byte; }
  std::size_t slots_, count_;  ///< number of the first slot; of all
  std::unordered_map<std::uint64_t, std::size_t> bytes_;
};

/// Backwards over the code: places that every run writes from there on before it reads them. A scan that leaves the
/// code starts anew, so that Leave needs nothing of what was stored. Local memory is nobody's when the program has
/// ended.
class Overwritten {
 public:
  Overwritten(const Code& code, const Places& places) : code_(code), places_(places), later_(places.count()) {
    for (const Step& step : code.steps) {
      if (isBranch(step.op)) ++branches_[step.value];
    }
    places.ofArea(code, Area::L, [&](std::size_t place) { later_.add(place); });
  }

  /// Stores that nobody reads become dropped. Of loads only those count that are needed.
  void drop(const std::vector<bool>& isNeeded, std::vector<bool>& isDropped) {
    for (std::size_t i = code_.steps.size(); i-- > 0;) {
      const Step& step = code_.steps[i];
      switch (step.op) {
        case CodeOp::StoreRegister:
        case CodeOp::StoreBit:
        case CodeOp::StoreSlots:
        case CodeOp::StoreMemory: {
          bool isRead = false;
          places_.of(step, [&](std::size_t place) { isRead = isRead || !later_.contains(place); });
          isDropped[i] = !isRead;
          places_.of(step, [&](std::size_t place) { later_.add(place); });
          break;
        }
        case CodeOp::StoreAt:
          isDropped[i] =
              at_ && at_->area == step.area && at_->a == step.a && at_->value == step.value && at_->width == step.width;
          at_ = step;
          break;
        case CodeOp::LoadAt:
          if (!isNeeded[i]) break;
          places_.ofArea(code_, step.area, [&](std::size_t place) { later_.remove(place); });
          forgetAt(step.area);
          break;
        case CodeOp::Mark:
          at_.reset();
          if (branches_.contains(step.value)) atMark_.insert_or_assign(step.value, later_);
          break;
        case CodeOp::Branch:
        case CodeOp::BranchIf:
        case CodeOp::BranchUnless: branch(step); break;
        case CodeOp::LoadMemory:
          if (isNeeded[i]) forgetAt(step.area);
          [[fallthrough]];
        default:
          if (isNeeded[i]) places_.of(step, [&](std::size_t place) { later_.remove(place); });
      }
    }
  }

 private:
  void forgetAt(Area area) {
    if (at_ && at_->area == area) at_.reset();
  }
  void branch(const Step& step) {
    at_.reset();
    const auto target = atMark_.find(step.value);
    if (target == atMark_.end()) {  // back, where everything may be read
      later_.clear();
      return;
    }
    const bool isLast = --branches_[step.value] == 0;
    if (step.op == CodeOp::Branch)
      later_ = target->second;
    else
      later_.keepOnly(target->second);
    if (isLast) atMark_.erase(target);
  }

  const Code& code_;
  const Places& places_;
  PlaceSet later_;
  std::optional<Step> at_;  ///< the next store to a computed address of this block, before which nobody reads its area
  std::unordered_map<std::uint64_t, PlaceSet> atMark_;       ///< of marks to which branches are still to come
  std::unordered_map<std::uint64_t, std::size_t> branches_;  ///< by mark: to it, not yet seen
};

/// Follows values back from the steps that do something. What a block finds in a state place comes from all blocks
/// before it.
class Needs {
 public:
  Needs(const Code& code, const std::vector<bool>& isDropped) : code_(code), isDropped_(isDropped) {
    isNeeded_.assign(code.steps.size(), false);
    findBlocks();
  }

  std::vector<bool> take() {
    for (std::size_t i = 0; i < code_.steps.size(); ++i) {
      const CodeOp op = code_.steps[i].op;
      if (!hasValue(op) && !isStateStore(op) && !isDropped_[i]) need(static_cast<ValueId>(i));
    }
    while (!waiting_.empty()) {
      const ValueId id = waiting_.back();
      waiting_.pop_back();
      const Step& step = code_.steps[id];
      const int count = operandCount(step.op);
      if (count > 0) need(step.a);
      if (count > 1) need(step.b);
      if (count > 2) need(step.c);
      if (step.op == CodeOp::LoadState || step.op == CodeOp::LoadStateWord) needState(blockOf_[id], step.value);
    }
    return std::move(isNeeded_);
  }

 private:
  void need(ValueId id) {
    if (isNeeded_[id]) return;
    isNeeded_[id] = true;
    waiting_.push_back(id);
  }

  void findBlocks() {
    std::unordered_map<std::uint64_t, std::uint32_t> blockAt;  // by number of the mark
    std::uint32_t block = 0;
    blockOf_.resize(code_.steps.size());
    for (std::size_t i = 0; i < code_.steps.size(); ++i) {
      if (code_.steps[i].op == CodeOp::Mark) blockAt[code_.steps[i].value] = ++block;
      blockOf_[i] = block;
    }
    before_.resize(block + 1);
    stores_.resize(block + 1);
    bool fallsThrough = true;
    for (std::size_t i = 0; i < code_.steps.size(); ++i) {
      const Step& step = code_.steps[i];
      if (step.op == CodeOp::Mark && fallsThrough) before_[blockOf_[i]].push_back({blockOf_[i] - 1, i});
      if (step.op == CodeOp::Mark) fallsThrough = true;
      if (isBranch(step.op) && fallsThrough) before_[blockAt[step.value]].push_back({blockOf_[i], i});
      if (step.op == CodeOp::Branch) fallsThrough = false;
      if (isStateStore(step.op)) stores_[blockOf_[i]].push_back(i);
    }
  }

  /// The value that state `number` has where `block` begins.
  void needState(std::uint32_t block, std::uint64_t number) {
    std::vector<std::uint32_t> asking{block};
    while (!asking.empty()) {
      const std::uint32_t next = asking.back();
      asking.pop_back();
      if (!asked_.insert(static_cast<std::uint64_t>(next) << 16 | number).second) continue;
      for (const Way& way : before_[next]) {
        bool isFound = false;
        const std::vector<std::size_t>& stores = stores_[way.block];
        for (std::size_t k = stores.size(); k-- > 0 && !isFound;) {
          if (stores[k] > way.from || code_.steps[stores[k]].value != number) continue;
          need(static_cast<ValueId>(stores[k]));
          isFound = true;
        }
        if (!isFound) asking.push_back(way.block);
      }
    }
  }

  struct Way {
    std::uint32_t block;
    std::size_t from;  ///< step at which it leaves that block
  };
  const Code& code_;
  const std::vector<bool>& isDropped_;
  std::vector<bool> isNeeded_;
  std::vector<ValueId> waiting_;
  std::vector<std::uint32_t> blockOf_;
  std::vector<std::vector<Way>> before_;
  std::vector<std::vector<std::size_t>> stores_;
  std::unordered_set<std::uint64_t> asked_;
};

}  // namespace

std::vector<bool> neededSteps(const Code& code, std::size_t registers) {
  constexpr int rounds = 3;  // each drops what only dropped stores have read
  const Places places(code, registers);
  std::vector<bool> isDropped(code.steps.size(), false);
  std::vector<bool> isNeeded = Needs(code, isDropped).take();
  for (int round = 0; round < rounds; ++round) {
    Overwritten(code, places).drop(isNeeded, isDropped);
    isNeeded = Needs(code, isDropped).take();
  }
  return isNeeded;
}

}  // namespace rungproof::compiled
