// StepWords: the words that keep the step of a sequence, found from how a program uses them. A reader tells every use
// before it reads the first block. Part of the LogicReaders.
#pragma once

#include <compare>
#include <cstdint>
#include <map>
#include <set>

#include "ir/program.hpp"

namespace rungproof {

class StepWords {
 public:
  /// What is told or asked from here on stands in this block.
  void beginBlock(const Pou& block) { block_ = &block; }
  /// The word is compared for equality with the constant.
  void compares(const Operand& word, std::int64_t constant) { uses_[keyOf(word)].compared.insert(constant); }
  /// The word chooses what runs next, whatever it is compared with.
  void selects(const Operand& word) { uses_[keyOf(word)].selects = true; }
  /// The constant is moved to the word.
  void moves(const Operand& word, std::int64_t constant) { uses_[keyOf(word)].moved.insert(constant); }
  /// Something else is written to the word.
  void writes(const Operand& word) { uses_[keyOf(word)].computed = true; }

  /// Several constants come to it, nothing else does, and it is compared with several or selects.
  bool contains(const Operand& word) const {
    const auto found = uses_.find(keyOf(word));
    if (found == uses_.end()) return false;
    const Uses& uses = found->second;
    return uses.moved.size() > 1 && !uses.computed && (uses.selects || uses.compared.size() > 1);
  }

 private:
  struct Uses {
    std::set<std::int64_t> compared, moved;
    bool selects = false, computed = false;
  };
  struct Key {
    Area area;
    std::uint32_t offset;
    Way way;  ///< with `isReached`
    bool isReached, inDi;
    const Pou* block;  ///< that reaches it: in another block the same text may be another word
    friend auto operator<=>(const Key&, const Key&) = default;
  };
  Key keyOf(const Operand& word) const {
    if (word.reach == nullptr) return {word.area, word.offset, {}, false, false, nullptr};
    return {word.area, word.offset, word.reach->way, true, word.reach->inDi, block_};
  }

  std::map<Key, Uses> uses_;
  const Pou* block_ = nullptr;
};

}  // namespace rungproof
