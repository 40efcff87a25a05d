// StepWords: the words that keep the step of a sequence, found from how a program uses them. A reader tells every use
// before it reads the first block. Part of the LogicReaders.
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <utility>

#include "ir/operand.hpp"

namespace rungproof {

class StepWords {
 public:
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
  using Key = std::pair<Area, std::uint32_t>;
  static Key keyOf(const Operand& word) { return {word.area, word.offset}; }

  std::map<Key, Uses> uses_;
};

}  // namespace rungproof
