// Influence: what a program does that depends on networks which nobody runs. From what those may write it follows,
// network by network, who reads it, what these write, and which blocks they switch. Everything left is the same
// whatever the networks do. Syntactic, and therefore generous: a place that may be influenced counts as influenced.
// Tested by tests/prover/unread_test.cpp.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <unordered_set>
#include <vector>

#include "analysis/flow/facts.hpp"
#include "analysis/flow/place_rows.hpp"

namespace rungproof {

/// Acts on hardware, on the queue of interrupts or on a partner: its effects do not show in its operands.
bool actsOnDevices(const Desc& desc);
/// Whether the instructions take levels of the logic stack that none of them has filled.
bool takesFromBelow(const Facts& facts, std::span<const std::uint32_t> instructions);

/// A network by its indices in Program::pous and Pou::networks.
struct NetworkPlace {
  std::uint32_t block = 0;
  std::uint32_t network = 0;
};

class Influence {
 public:
  /// No cause.
  static constexpr std::uint32_t none = 0;

  explicit Influence(const Facts& facts);

  /// The network is not run, for that cause (any number but 0): it may write what its instructions write.
  void addNetwork(NetworkPlace place, std::uint32_t cause);
  /// The network is run in another form: jumps that stay in it decide nothing outside.
  void addChangedNetwork(NetworkPlace place, std::uint32_t cause);
  /// A place is written for that cause.
  void addPlace(const PlaceRow& row, std::uint32_t cause);
  /// Everything may be written for that cause.
  void addEverything(std::uint32_t cause);
  /// Follows what has been added to its end.
  void spread();

  /// Why the place may be influenced.
  std::uint32_t causeAt(const PlaceRow& row) const;
  /// Why what the network does may be influenced.
  std::uint32_t causeAt(NetworkPlace place) const;
  /// Why anything may be.
  std::uint32_t everything() const { return everything_; }

 private:
  struct Part {
    NetworkPlace place;
    std::vector<std::uint32_t> instructions;  ///< Instruction::id
    bool needsStack = false;                  ///< takes levels of the logic stack that networks before it have left
    std::uint32_t cause = none;
  };

  void collectParts();
  const Part* part(NetworkPlace place) const;
  void add(NetworkPlace place, std::uint32_t cause, bool isWhole);
  const std::unordered_set<std::uint32_t>& staysInside(std::uint32_t block);
  void influence(Part& part, std::uint32_t cause);
  void influenceBlock(std::uint32_t block, std::uint32_t cause);
  void writesOf(std::uint32_t instruction, std::uint32_t cause);
  void controlOf(const Part& part, std::uint32_t instruction, std::uint32_t cause);
  std::uint32_t causeRead(const Part& part) const;

  const Facts& facts_;
  std::vector<Part> parts_;               ///< in program order
  std::vector<std::uint32_t> firstPart_;  ///< by block; one more at the end
  PlaceMap<std::uint32_t> places_;        ///< causes
  std::uint32_t everything_ = none;
  std::uint32_t some_ = none;  ///< cause of any place, for reads through pointers
  bool isChanged_ = false;
  std::map<std::uint32_t, std::unordered_set<std::uint32_t>> staysInside_;  ///< Instruction::id, by block
};

}  // namespace rungproof
