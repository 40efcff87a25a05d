// Instructions that exclude each other by the text: the way to one demands what the way to the other forbids. A way is
// the chain of calls that leads to a block and the rungs that they stand on: contacts in series, comparisons of a word
// with constants (the dispatcher of a state machine), steps of one chain of SCR segments. What the text leaves open may
// still exclude each other; then the prover knows.
//
// A dispatched block that passes the state on lets the next one run in the same scan: the one hands over to the other
// then, so this counts as exclusion too. Tested by tests/rules/exclusion_test.cpp.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "analysis/flow/facts.hpp"

namespace rungproof {

class Exclusion {
 public:
  explicit Exclusion(const Facts& facts);

  /// The ways on which the instruction acts, as a number; equal ways have equal numbers.
  std::uint32_t waysTo(std::uint32_t instruction);
  /// Whether of two kinds of ways one at most is open at a time.
  bool exclude(std::uint32_t a, std::uint32_t b) const;

 private:
  /// A bit with its value, or a word within limits.
  struct Demand {
    std::uint32_t place = 0;  ///< area, address and width
    std::int64_t low = 0, high = 0;

    auto operator<=>(const Demand&) const = default;
  };
  using Way = std::vector<Demand>;  ///< all of them hold; sorted
  using Ways = std::vector<Way>;    ///< one of them is taken

  static Demand bitDemand(const Operand& bit, bool on);
  void addContact(const Instruction& contact, Way& way, int depth);
  std::optional<Demand> comparison(const Instruction& contact) const;
  Way behind(const Network& network, std::size_t at, int depth);
  const Ways& toBlock(std::uint32_t block, int depth);
  Way at(std::uint32_t instruction);
  std::uint32_t numberOf(Ways ways);
  bool contradict(const Demand& a, const Demand& b) const;
  bool contradict(const Way& a, const Way& b) const;
  void findSteps();

  const Facts& facts_;
  std::map<std::uint32_t, Ways> blocks_;
  std::map<std::uint32_t, std::uint32_t> toAllOf_;  ///< by block: number of the ways to what its rungs do not decide
  std::map<Ways, std::uint32_t> numbers_;
  std::vector<const Ways*> ways_;                     ///< by number
  std::map<std::uint32_t, Demand> segments_;          ///< by instruction in an SCR segment: its step is on
  std::map<std::uint32_t, std::uint32_t> stepBlock_;  ///< by place of a step: the block whose chain it belongs to
};

}  // namespace rungproof
