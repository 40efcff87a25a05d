// Finds that a scan which lasts long is in a loop without an end: at the head of a loop memory is as it was there
// before, and nothing came from outside meanwhile. Two rounds in a row have to run the same instructions: then the
// calls in which the loop stands are the same too, and not several calls of one block. Snapshots are taken ever more
// seldom (Brent), so that a loop of any number of rounds is found. Only for IEC 61131-3, where no clock runs inside a
// scan. Tested by tests/iec.
#pragma once

#include <cstdint>
#include <optional>
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
  /// In front of each instruction.
  void step(std::uint32_t id) { course_ = course_ * 0x100000001B3ULL + id + 1; }
  /// At the head of a loop; whether the scan never leaves it.
  bool returns(std::uint32_t head, const std::vector<std::uint8_t>& memory) {
    if (isKept_ && head == head_ && memory == kept_) {
      if (round_ == course_) return true;
      round_ = course_;
      course_ = 0;
      return false;
    }
    if (++rounds_ == next_) {
      next_ *= 2;
      head_ = head;
      kept_ = memory;
      isKept_ = true;
      round_.reset();
      course_ = 0;
    }
    return false;
  }

 private:
  std::uint64_t rounds_ = 0, next_ = 1;
  std::uint32_t head_ = 0;  ///< Instruction::id of the label
  std::vector<std::uint8_t> kept_;
  bool isKept_ = false;
  std::uint64_t course_ = 0;            ///< of the instructions since the head was passed with that memory
  std::optional<std::uint64_t> round_;  ///< the same of the round before
};

}  // namespace rungproof
