// Influence in a program of an S7-300/400 (influence.hpp says what that is): besides memory, its networks hand on
// registers, the open data blocks, and what calls give and take. Followed statement by statement along all paths, so
// that a network whose registers are its own depends on nothing but the places that it reads.
// Tested by tests/step7/one_unknown_test.cpp.
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <vector>

#include "analysis/flow/facts.hpp"
#include "analysis/flow/logic_string.hpp"
#include "analysis/flow/open_blocks.hpp"
#include "analysis/flow/place_rows.hpp"
#include "analysis/unread/influence.hpp"

namespace rungproof {

/// Where an access of an S7-300/400 may lie.
struct Reached {
  enum class Kind : std::uint8_t {
    Row,      ///< `row`; of L in the block of the instruction
    Data,     ///< anywhere in data block `dataBlock`
    AllData,  ///< in any data block
    InArea,   ///< anywhere in `row.area`
    ByCall,   ///< what the calls of its block give
    Anywhere
  };
  Kind kind = Kind::Row;
  PlaceRow row;
  std::uint32_t dataBlock = 0;
};

class StatementInfluence {
 public:
  static constexpr std::uint32_t none = Influence::none;

  explicit StatementInfluence(const Facts& facts);

  /// The network is not run, for that cause (any number but 0).
  void addNetwork(NetworkPlace place, std::uint32_t cause);
  /// A place is written, or holds nobody knows what, for that cause.
  void addPlace(const PlaceRow& row, std::uint32_t cause);
  void addDataBlock(std::uint32_t number, std::uint32_t cause);
  void addEverything(std::uint32_t cause);
  /// Follows what has been added to its end.
  void spread();

  std::uint32_t causeAt(const PlaceRow& row) const;
  std::uint32_t causeAt(NetworkPlace place) const;
  std::uint32_t everything() const { return everything_; }

  /// Whether the network may open, read or write one of the data blocks.
  bool mayUse(NetworkPlace place, const std::map<std::uint32_t, Span>& dataBlocks, std::uint32_t& number) const;

 private:
  /// The steps of a network in the flow of its block.
  struct Part {
    std::uint32_t first = 0, end = 0;
    std::uint32_t cause = none;
  };
  /// Registers whose values may be influenced.
  struct Registers {
    std::uint16_t mask = 0;
    std::uint32_t cause = none;
    bool join(const Registers& other);
  };
  struct Block {
    std::vector<Part> parts;  ///< by network
    LogicStates logic;
    OpenStates open;
    Registers entry, exit;
    std::vector<std::pair<std::uint32_t, bool>> instances;  ///< data blocks, and whether the whole is one
    std::map<std::uint32_t, std::uint32_t> local;           ///< influenced bits of L
  };
  struct Data {
    std::uint32_t whole = none;
    std::map<std::uint32_t, std::uint32_t> bits;
  };

  void findInstances();
  const FlowStep& step(std::uint32_t block, std::uint32_t at) const { return facts_.plan().flows[block].steps[at]; }
  std::uint32_t networkAt(std::uint32_t block, std::uint32_t at) const { return step(block, at).network; }
  void influence(std::uint32_t block, std::uint32_t network, std::uint32_t cause);
  void influenceBlock(std::uint32_t block, std::uint32_t cause);
  void control(std::uint32_t block, std::uint32_t at, std::uint32_t cause);
  void call(std::uint32_t block, const Instruction& instruction, std::uint32_t cause);
  void write(std::uint32_t block, std::uint32_t at, std::uint32_t cause);
  void write(std::uint32_t block, const Reached& place, std::uint32_t cause);
  template <class Visit>
  void eachCallee(std::uint32_t block, const Instruction& call, Visit&& visit) const;
  std::uint32_t causeRead(std::uint32_t block, std::uint32_t network) const;
  std::uint32_t causeOf(std::uint32_t block, const Reached& place) const;
  bool isOwnLocal(std::uint32_t block, std::uint32_t network, std::uint32_t at, const PlaceRow& row) const;
  std::vector<Reached> reached(std::uint32_t block, std::uint32_t at, const Access& access) const;
  std::vector<Reached> inInstance(std::uint32_t block, const Operand& instance, std::uint32_t first,
                                  std::uint32_t bits) const;
  void copyOut(std::uint32_t block, std::uint32_t at);
  void passRegisters(std::uint32_t block);
  void apply(std::uint32_t block, std::uint32_t at, Registers& registers) const;
  void startErrorBlocks();

  const Facts& facts_;
  std::vector<Block> blocks_;
  std::map<Area, std::map<std::uint32_t, std::uint32_t>> places_;  ///< influenced bits, or numbers
  std::map<Area, std::uint32_t> areas_;                            ///< the whole
  std::map<std::uint32_t, Data> data_;
  std::set<std::uint32_t> given_;  ///< ids of calls whose places the called block has influenced
  std::uint32_t allData_ = none, someData_ = none, some_ = none, everything_ = none;
  bool isChanged_ = false;
};

}  // namespace rungproof
