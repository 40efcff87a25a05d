// Finds that a scan which lasts long is in a loop without an end: at the head of a loop memory is as it was there
// before, and nothing came from outside meanwhile. Snapshots are taken ever more seldom (Brent), so that a loop of any
// number of rounds is found. Only for IEC 61131-3, where no clock runs inside a scan. Tested by tests/iec.
#pragma once

#include <cstdint>
#include <vector>

namespace rungproof {

class EndlessLoop {
 public:
  /// A scan begins.
  void begin() {
    rounds_ = 0;
    next_ = 1;
    isKept_ = false;
  }
  /// A value came from outside: the rounds before it say nothing.
  void disturb() { isKept_ = false; }
  /// At the head of a loop; whether the scan never leaves it.
  bool returns(std::uint32_t head, const std::vector<std::uint8_t>& memory) {
    if (isKept_ && head == head_ && memory == kept_) return true;
    if (++rounds_ == next_) {
      next_ *= 2;
      head_ = head;
      kept_ = memory;
      isKept_ = true;
    }
    return false;
  }

 private:
  std::uint64_t rounds_ = 0, next_ = 1;
  std::uint32_t head_ = 0;  ///< Instruction::id of the label
  std::vector<std::uint8_t> kept_;
  bool isKept_ = false;
};

}  // namespace rungproof
