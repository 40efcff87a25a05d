// Pointers: the places whose content is used as an address, with what makes them, moves them and uses them. Pointers of
// accumulators and local memory belong to one block, those of V memory to the program. Along straight code the address
// itself is followed, so that an access behind MOVD & and constant steps is decided without a solver.
// Addresses and steps: 001:1459-1478. Tested by tests/rules/data_rules_test.cpp.
#pragma once

#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "analysis/flow/facts.hpp"

namespace rungproof {

struct Pointer {
  Area area = Area::V;
  std::uint32_t offset = 0;
  std::uint32_t block = 0;                ///< of accumulators and L; V pointers: the first block that uses them
  std::vector<const Access*> uses;        ///< accesses through it
  std::vector<const Instruction*> steps;  ///< INCD, DECD, +D, -D on it
  bool isSet = false;                     ///< something writes it that could make an address
  bool isSetAgain = false;                ///< set in other scans than the first
  bool isCompared = false;                ///< a comparison asks its value

  /// Whether it is moved on for ever: steps outside the first scan, never set back, never compared.
  bool isUnbounded() const { return !steps.empty() && isSet && !isSetAgain && !isCompared; }
};

/// An access through a pointer that holds a known address.
struct PointerUse {
  const Access* access;
  const Instruction* set;  ///< the MOVD & that made the address
  Area area;
  std::int64_t offset;  ///< byte, or number of a T or C; negative: before the area
};

/// What the steps of one network add to a pointer between two settings of it.
struct PointerStride {
  const Access* use;        ///< an access of the narrowest width
  int narrowest;            ///< bytes of that width; T and C: 2
  std::int64_t total;       ///< bytes
  const Instruction* last;  ///< the last step
};

class PointerTable {
 public:
  explicit PointerTable(const Facts& facts);

  std::span<const Pointer> all() const { return pointers_; }
  std::span<const PointerUse> knownUses() const { return known_; }
  std::span<const PointerStride> strides() const { return strides_; }
  /// The pointer behind an access through a pointer, or nullptr.
  const Pointer* find(const Access& access, std::uint32_t block) const;

 private:
  struct Life;
  std::uint64_t key(Area area, std::uint32_t offset, std::uint32_t block) const;
  Pointer* at(Area area, std::uint32_t offset, std::uint32_t block);
  void collectUses(const Facts& facts);
  void collectWrites(const Facts& facts);
  void followBlock(const Facts& facts, const Flow& flow, std::uint32_t block);
  void closeStrides(Life& life);

  std::vector<Pointer> pointers_;
  std::unordered_map<std::uint64_t, std::size_t> byPlace_;
  std::vector<PointerUse> known_;
  std::vector<PointerStride> strides_;
};

}  // namespace rungproof
