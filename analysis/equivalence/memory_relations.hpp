// What memory of two programs of different families may have to do with each other beyond equal places: timers of
// either that measure the same time, bits that hold the same under other addresses. Candidates only: correspondence.hpp
// keeps those that every scan keeps. Tested by tests/equivalence/families_test.cpp.
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

  /// Of a timer of an S7-200 or S7-300/400, as far as it is compared with a clock of IEC 61131-3.
  struct CountingTimer {
    std::string name;
    Value running{}, bit{};  ///< it counts where it runs, and its bit has not come yet
    Value input{};           ///< what it was given last
    Value atEnd{};           ///< with `isRest`: its bit when no ms are left
    bool isOffDelay = false;
    std::uint64_t length = 0;  ///< ms; 0: not known
    std::uint64_t unit = 1;    ///< ms that one step of `count` is
    Value count{};             ///< steps that have passed, or with `isRest` ms that are left
    bool isRest = false;
    Value coming{};  ///< steps that the next scan adds; nothing: none
  };

  std::vector<CountingTimer> countingTimers(EncodedScan& other, bool isNew);
  void addClocks(EncodedScan& variables, EncodedScan& other, bool isVariablesNew);
  void addTimers(EncodedScan& boxes, EncodedScan& elements, bool isElementsNew);
  void add(const std::string& name, const TimerPair& pair);
  void addWholeTicks();
  Value ticks10() const { return {time_.ticks10(), time_.saturated16(time_.ticksWithin(10)), false}; }
  Value ticks100() const { return {time_.ticks100(), time_.saturated16(time_.ticksWithin(100)), false}; }
  void addBits(EncodedScan& all, EncodedScan& own, bool isOwnNew);
  void addSeenEdges(EncodedScan& scan, bool isNew);
  static Value valueOf(EncodedScan& scan, const Place& place, bool isNew);

  TimeModel& time_;  ///< OLD's, which both programs have
  Graph& graph_;     ///< OLD's
  std::vector<Candidate> candidates_;
};

}  // namespace rungproof
