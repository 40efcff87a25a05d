// Which addresses of two programs stand for each other: the same address, unless a map says otherwise. Bits of memory
// are paired one by one, timers, counters and analog words by number, and interrupt events by number too. The first
// program is called OLD, the second NEW. Tested by tests/equivalence/address_pairs_test.cpp.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "ir/operand.hpp"

namespace rungproof {

/// One thing that a program can read or write: a bit of memory counted byte * 8 + bit, or the number of a timer,
/// counter, accumulator, fast counter or analog word.
struct Address {
  Area area = Area::V;
  std::uint32_t index = 0;
  friend bool operator==(const Address&, const Address&) = default;
};
/// Whether an address is a whole value instead of a bit: numbers, and the words that the terminals give. What goes to
/// AQ is counted in bits like memory.
constexpr bool isWholeValue(Area area) {
  return addressedByNumber(area) || area == Area::PI || (isInputArea(area) && isAnalogue(area));
}
/// First address that a direct operand names; of PI that of the sample, which has the area AI in both families.
Address addressOf(const Operand& operand);
/// Addresses that are compared as one value.
struct ComparedRange {
  Address first;
  std::uint32_t bits = 1;
};
/// The operand that names one address: a bit, the bit of a timer or counter, or the word of an analog output.
Operand operandAt(const Address& address);
/// How many addresses it names from there on.
std::uint32_t extentOf(const Operand& operand);

class AddressPairs {
 public:
  /// Pairs `count` addresses from `before` on in OLD with as many from `after` on in NEW. False if one of them has a
  /// partner already.
  bool add(Address before, Address after, std::uint32_t count);
  /// Has these addresses of OLD compared as one value, if what stands for them in NEW stands together too.
  void compareAsOne(ComparedRange range) { wholes_.push_back(range); }
  /// Has these addresses of OLD compared beside what lies in the areas of outputs.
  void compareToo(ComparedRange range) { others_.push_back(range); }
  const std::vector<ComparedRange>& comparedToo() const { return others_; }
  /// Pairs an interrupt event of OLD with one of NEW. False if one of them has a partner already.
  bool addEvent(int before, int after);
  /// Only what is paired stands for each other: equal addresses of these programs have nothing in common.
  void separate() { isSeparate_ = true; }
  bool isSeparate() const { return isSeparate_; }
  bool empty() const { return runs_.empty() && events_.empty(); }
  /// The event of OLD for one of NEW: the same one unless the map gives it to another.
  std::optional<int> eventBefore(int after) const;

  /// What stands in OLD for an address of NEW; nothing if the map gives that address of OLD to another one.
  std::optional<Address> before(Address after) const;
  /// What stands in NEW for an address of OLD.
  std::optional<Address> after(Address before) const;
  /// Whether the map itself names that address of NEW.
  bool names(Address after) const;
  /// What an address of OLD is compared with: the word of an analog output where it stands together in both programs,
  /// or what is compared as one.
  ComparedRange comparedFrom(Address before) const;
  /// The same for an address of NEW that has no partner.
  ComparedRange comparedAlone(Address after) const;
  /// The operand of OLD for a direct operand of NEW; nothing if its parts are not together there.
  std::optional<Operand> before(const Operand& after) const;

 private:
  struct Run {
    Address before, after;
    std::uint32_t count;
  };
  std::vector<Run> runs_;
  std::vector<ComparedRange> wholes_, others_;
  std::vector<std::pair<int, int>> events_;
  bool isSeparate_ = false;
};

}  // namespace rungproof
