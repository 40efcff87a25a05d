// The lines of a drawn network: who feeds whom, which circuits are separate, in which order results are computed,
// where loops are cut. IEC 61131-3 leaves to the order of execution what an element in a loop sees; here it is the
// editor's order where it is stated, otherwise top to bottom, then left to right, an element always after what feeds
// it. A loop through a function block is cut at the block: whoever is computed before it sees its outputs of the
// previous scan. A loop without a function block needs a connector, which then keeps the value; any other is an error.
// Tested by tests/graphical/plcopen_test.cpp.
#pragma once

#include <string>
#include <unordered_map>
#include <vector>

#include "frontend/graphical/drawn_model.hpp"
#include "frontend/graphical/drawn_sink.hpp"

namespace rungproof {

class DrawnCircuit {
 public:
  static constexpr int nothing = -1;

  /// `isFunctionBlock(element)`: a block with memory. `variablesKeep`: a variable that is read and written cuts a loop
  /// that no such block cuts, and a block whose order is stated is a result of its own. Reports ids used twice, lines
  /// that come from nowhere, connectors without partner, and loops that nothing cuts.
  template <class Predicate>
  DrawnCircuit(const DrawnNetwork& network, DrawnSink& sink, Predicate&& isFunctionBlock, bool variablesKeep = false)
      : network_(network), sink_(sink), variablesKeep_(variablesKeep) {
    for (const DrawnElement& element : network.elements)
      hasMemory_.push_back(element.kind == DrawnKind::Block && isFunctionBlock(element));
    build();
  }

  const DrawnNetwork& network() const { return network_; }
  const DrawnElement& element(int i) const { return network_.elements[static_cast<std::size_t>(i)]; }
  int count() const { return static_cast<int>(network_.elements.size()); }

  /// Index of the element that a line comes from, or nothing.
  int sourceOf(const DrawnLink& link) const;
  /// The connector that a continuation goes on from, or nothing.
  int connectorOf(int continuation) const;
  /// Outputs are read from memory: the element stands in a loop and is computed by itself.
  bool isCut(int i) const { return cut_[static_cast<std::size_t>(i)]; }
  /// Part of a loop that nothing cuts (reported).
  bool isInLoop(int i) const { return loop_[static_cast<std::size_t>(i)]; }
  /// A block without memory that no result needs: it is called for what it does.
  bool isLoose(int i) const { return loose_[static_cast<std::size_t>(i)]; }
  /// Elements with a line from this output, in the order of the file; `pin` empty: from any output.
  struct Consumer {
    int element;
    const DrawnPin* pin;
    const DrawnLink* link;
  };
  const std::vector<Consumer>& consumersOf(int i) const { return consumers_[static_cast<std::size_t>(i)]; }
  /// Number of the separate circuit that an element belongs to.
  int circuitOf(int i) const { return circuit_[static_cast<std::size_t>(i)]; }
  /// Elements that produce results, in the order of execution.
  const std::vector<int>& results() const { return results_; }
  /// The same from top to bottom, whatever order the editor states.
  std::vector<int> resultsByPosition() const { return orderedResults(false); }
  /// Which of these circuits a comment belongs to: the first that reaches below it; without positions that of the next
  /// element. circuits.size(): none.
  std::size_t below(const DrawnNote& note, const std::vector<int>& circuits) const;
  /// Circuits with something wrong in them.
  const std::vector<bool>& damaged() const { return damaged_; }

 private:
  void build();
  void indexElements();
  void connect();
  void findCircuits();
  void cutLoops();
  void findLoose();
  std::vector<std::vector<int>> loops() const;
  std::vector<int> feedersOf(int i) const;
  std::vector<int> orderedResults(bool byStatedOrder) const;
  bool isResult(int i) const;
  void damage(int i) { damaged_[static_cast<std::size_t>(circuitOf(i))] = true; }

  const DrawnNetwork& network_;
  DrawnSink& sink_;
  std::vector<bool> hasMemory_;
  bool variablesKeep_;
  std::unordered_map<std::string, int> byId_;
  std::unordered_map<std::string, int> connectors_;  ///< by name
  std::vector<std::vector<Consumer>> consumers_;
  std::vector<int> circuit_;
  std::vector<bool> cut_, loop_, loose_, damaged_;
  std::vector<int> results_;
};

}  // namespace rungproof
