// What memory of the two programs may have to do with each other beyond equal places, where one is an S7-200's and one
// an S7-300/400's: a timer of either that measure the same time, bits that hold the same under other addresses.
// Candidates only: correspondence.hpp keeps those that every scan keeps. Tested by tests/equivalence/families_test.cpp.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "analysis/encoding/encoder.hpp"

namespace rungproof {

/// A relation that may hold at the start of every scan; nodes of OLD's graph, one bit.
struct MemoryRelation {
  std::string name;  ///< the same in every system of these programs
  Node start = noNode, end = noNode;
  Node first = noNode;  ///< before the first scan, of OLD's states
};

/// Where NEW's nodes are in OLD's graph: of a scan, and of its states before the first one.
struct NewView {
  std::function<Node(Node)> inScan, first;
};

class RelationCandidates {
 public:
  /// Touches the places that the relations speak of: before the systems are taken.
  RelationCandidates(EncodedScan& before, EncodedScan& after);

  std::vector<std::string> names() const;
  std::vector<MemoryRelation> relations(const NewView& view) const;

 private:
  /// A value of one program, in its own graph.
  struct Value {
    Node start = noNode, end = noNode;
    bool isNew = false;
  };
  using Read = std::function<Graph::Bits(const Value&)>;
  struct Candidate {
    std::string name;
    std::function<Graph::Bool(Graph&, const Read&)> holds;
  };
  /// Of a timer of an S7-200, whose preset is `length` units of `unit` ms, and of an S5 timer.
  struct TimerPair {
    Value in{}, bit{}, running{}, current{}, preset{};
    Value s5In{}, s5Bit{}, s5Running{}, s5Rest{}, s5AtEnd{};
    Value coming{};  ///< units that have passed and that the timer of the S7-200 adds in the next scan
    std::uint64_t length = 0;
    std::uint64_t unit = 0;
    bool isOffDelay = false;
  };

  void addTimers(EncodedScan& s7200, EncodedScan& step7, bool isStep7New);
  void add(const std::string& name, const TimerPair& pair);
  void addWholeTicks();
  Value ticks10() const { return {time_.ticks10(), time_.saturated16(time_.ticksWithin(10)), false}; }
  Value ticks100() const { return {time_.ticks100(), time_.saturated16(time_.ticksWithin(100)), false}; }
  void addBits(EncodedScan& s7200, EncodedScan& step7, bool isStep7New);
  void addSeenEdges(EncodedScan& scan, bool isNew);
  static Value valueOf(EncodedScan& scan, const Place& place, bool isNew);

  TimeModel& time_;  ///< OLD's, which both programs have
  Graph& graph_;     ///< OLD's
  std::vector<Candidate> candidates_;
};

}  // namespace rungproof
