// Forced values (001:7954-7976): any number of I and Q, up to 16 of V, M, AI and AQ. They replace inputs when these are
// read, immediate inputs, memory after the program, and outputs when these are written. Covered by
// tests/engine/mode_test.cpp.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "engine/concrete.hpp"
#include "ir/operand.hpp"

namespace rungproof {

class ForceTable {
 public:
  struct Entry {
    Operand operand;
    std::uint64_t value;
  };
  /// Forces a direct operand of I, Q, V, M, AI or AQ. False: the area cannot be forced, or 16 memory values are
  /// already.
  bool set(const Operand& operand, std::uint64_t value);
  void remove(const Operand& operand);
  bool empty() const { return entries_.empty(); }
  const std::vector<Entry>& entries() const { return entries_; }
  /// Writes the forced values of one area into memory.
  void apply(Area area, Concrete::Store& store) const;
  /// The forced value of one bit of I or Q (byte * 8 + bit), if it is forced.
  std::optional<bool> bit(Area area, std::uint32_t index) const;
  /// The forced value of an analog word, if it is forced.
  std::optional<std::uint16_t> word(Area area, std::uint32_t offset) const;

 private:
  std::vector<Entry> entries_;
};

}  // namespace rungproof
