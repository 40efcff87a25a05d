// ExecutionRecord: what a scan does at each instruction, as nodes of the encoding. It listens to the encoder in front
// of every instruction and keeps under which guard the instruction runs, the stack levels that it samples, the presets
// that timers and counters are given, stack levels that were pushed out of the bottom (001:2759), and whether a contact
// makes a difference to what the rest of its rung does. The built-in checks are questions about these nodes. Covered by
// tests/prover/builtin_test.cpp and tests/prover/rule_questions_test.cpp.
#pragma once

#include <array>
#include <map>
#include <vector>

#include "analysis/encoding/encoder.hpp"

namespace rungproof {

/// One execution of an instruction in a scan.
struct Visit {
  const Instruction* instruction;
  Node guard;                                        ///< whether the scan comes here
  std::array<Node, 3> flow{noNode, noNode, noNode};  ///< stack levels that it samples, top first, 0 in an inactive step
  Node preset = noNode;                              ///< of a timer or counter, 16 bits; noNode: a constant, or unknown
  /// ExecutionRecord with bits: the own bit of a contact or comparison, of EU, ED, FP and FN whether they let a change
  /// through; noNode: not known.
  Node bit = noNode;
  /// The same: the RLO of an S7-300/400, the value on top of the stack of an IEC program as a truth value.
  Node result = noNode;
  Node target = noNode;  ///< the same: the value of the operand that the instruction writes, in its width
};

/// An instruction that takes a level which the stack has lost.
struct LostLevel {
  const Instruction* push;  ///< what pushed it out; nullptr: depends on the path
  const Instruction* use;
  Node condition;
};

class ExecutionRecord {
 public:
  /// contacts: also find out which contacts make a difference (contactEffects). bits: keep Visit::bit and what follows.
  ExecutionRecord(const Program& program, bool contacts, bool bits = false);

  /// In front of an instruction of the final round of the encoding.
  void at(Machine<Graph>& machine, const Instruction& instruction);

  const std::vector<Visit>& visits() const { return visits_; }
  const std::vector<LostLevel>& lostLevels() const { return lostLevels_; }
  /// Whether the bit of a timer or counter is 1 in front of some instruction that names it; noNode: none does.
  Node seenOn(Area area, std::uint32_t number) const {
    const auto found = seenOn_.find({area, number});
    return found == seenOn_.end() ? noNode : found->second;
  }
  /// By contact: 1 in a scan in which its rung would do something else without it - bridged in a series, cut out of a
  /// parallel circuit. Contacts whose rung goes through something that the record does not follow are left out.
  const std::map<const Instruction*, Node>& contactEffects() const { return contactEffects_; }

 private:
  static constexpr std::uint64_t bottom =
      mostStackLevels;  ///< height at which a network begins: what is below belongs to others
  static constexpr int heightBits = 16;

  struct Site {
    std::uint32_t block = 0, network = 0;
    const Instruction* next = nullptr;  ///< in the same network
    bool isFirst = false;               ///< of its network
    bool isEntry = false;               ///< of its block, and no jump leads back to it: no path is beyond it yet
  };
  /// Levels pushed up to now, and how many of them, counted from below, are lost.
  struct Heights {
    Node height = noNode, lost = noNode;
    std::map<std::uint64_t, const Instruction*> lostBy{};
  };
  /// The rung as it is without one contact.
  struct Bridged {
    const Instruction* contact;
    std::uint32_t block, network;
    LogicStack<Graph> stack;
    bool takesTop = false;  ///< the last instruction made a new top: go on with that
  };

  void noteBits(Machine<Graph>& machine, const Instruction& instruction, Visit& visit) const;
  void followHeights(Machine<Graph>& machine, const Instruction& instruction, const Site& site);
  void followContacts(Machine<Graph>& machine, const Instruction& instruction, const Site& site);
  bool follow(Machine<Graph>& machine, const Instruction& instruction, Bridged& bridged);
  void begin(Machine<Graph>& machine, const Instruction& contact, const Site& site);

  std::vector<Site> sites_;             ///< by Instruction::id
  std::vector<bool> hasEntriesWithin_;  ///< by block: a jump leads into the middle of one of its networks
  std::vector<bool> takesFromBelow_;    ///< by block: some network uses levels of an earlier one
  bool contacts_, bits_;
  std::array<Heights, frameCount> heights_{};
  std::vector<Bridged> bridged_;
  std::vector<Visit> visits_;
  std::vector<LostLevel> lostLevels_;
  std::map<const Instruction*, Node> contactEffects_;
  std::map<std::pair<Area, std::uint32_t>, Node> seenOn_;
};

/// Contacts and compare contacts that decide the top of the stack in front of instruction `at` of a network.
std::vector<const Instruction*> rungOf(const Network& network, std::size_t at);

}  // namespace rungproof
