// Backwards through the code: first which stores are overwritten, then which values lead to something that stays.
#include "engine/compiled/reduce.hpp"

#include <unordered_map>
#include <unordered_set>

namespace rungproof::compiled {

namespace {

bool isStateStore(CodeOp op) { return op == CodeOp::StoreState || op == CodeOp::StoreStateWord; }
bool endsBlock(CodeOp op) { return op == CodeOp::Mark || isBranch(op); }

/// Places that are written again further on in the same block. A scan that leaves the code starts anew, so that Leave
/// needs nothing of what was stored.
class Overwritten {
 public:
  Overwritten(const Code& code, std::size_t registers) : slots_(code.slots.size() * 8), registers_(registers) {}

  void forget() { ++epoch_; }
  bool isRegister(std::uint64_t at) const { return registers_[at] == epoch_; }
  void registerIs(std::uint64_t at, bool isWritten) { registers_[at] = isWritten ? epoch_ : 0; }
  bool isSlot(std::uint64_t first, int count) const {
    for (int i = 0; i < count; ++i) {
      if (slots_[first + static_cast<std::uint64_t>(i)] != epoch_) return false;
    }
    return true;
  }
  void slotIs(std::uint64_t first, int count, bool isWritten) {
    for (int i = 0; i < count; ++i) slots_[first + static_cast<std::uint64_t>(i)] = isWritten ? epoch_ : 0;
  }
  bool isMemory(const Step& step) const {
    for (int i = 0; i < step.width / 8; ++i) {
      const auto found = memory_.find(key(step, i));
      if (found == memory_.end() || found->second != epoch_) return false;
    }
    return true;
  }
  void memoryIs(const Step& step, bool isWritten) {
    for (int i = 0; i < step.width / 8; ++i) memory_[key(step, i)] = isWritten ? epoch_ : 0;
  }
  void forgetMemory() { memory_.clear(); }

 private:
  static std::uint64_t key(const Step& step, int i) {
    return static_cast<std::uint64_t>(step.area) << 32 | (step.value + static_cast<std::uint64_t>(i));
  }
  std::uint32_t epoch_ = 1;
  std::vector<std::uint32_t> slots_, registers_;
  std::unordered_map<std::uint64_t, std::uint32_t> memory_;
};

/// Marks stores that are overwritten as not needed; everything else may be.
void dropOverwritten(const Code& code, std::size_t registers, std::vector<bool>& isDropped) {
  Overwritten later(code, registers);
  for (std::size_t i = code.steps.size(); i-- > 0;) {
    const Step& step = code.steps[i];
    if (endsBlock(step.op)) later.forget();
    switch (step.op) {
      case CodeOp::StoreRegister:
        isDropped[i] = later.isRegister(step.value);
        later.registerIs(step.value, true);
        break;
      case CodeOp::LoadRegister: later.registerIs(step.value, false); break;
      case CodeOp::StoreBit:
        isDropped[i] = later.isSlot(step.value, 1);
        later.slotIs(step.value, 1, true);
        break;
      case CodeOp::LoadBit: later.slotIs(step.value, 1, false); break;
      case CodeOp::StoreSlots:
        isDropped[i] = later.isSlot(step.value, 8);
        later.slotIs(step.value, 8, true);
        break;
      case CodeOp::LoadSlots: later.slotIs(step.value, 8, false); break;
      case CodeOp::StoreMemory:
        isDropped[i] = later.isMemory(step);
        later.memoryIs(step, true);
        break;
      case CodeOp::LoadMemory: later.memoryIs(step, false); break;
      case CodeOp::LoadAt: later.forgetMemory(); break;
      default: break;
    }
  }
}

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
  std::vector<bool> isDropped(code.steps.size(), false);
  dropOverwritten(code, registers, isDropped);
  return Needs(code, isDropped).take();
}

}  // namespace rungproof::compiled
