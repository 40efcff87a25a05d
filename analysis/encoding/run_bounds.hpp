// What any number of runs of some routines, in any order, keep of the cells that they write: bounds of one cell ("never
// falls", "at most what it was or 1000", "one of these numbers") and of two ("their sum", "not above the other").
// They are proposed, tried on random states, and proved by Z3 all together: those that stay hold after any number of
// runs, because they hold after none. Rules of the state itself (kept_states.hpp) stand beside them: where all of a set
// held before, all hold after. What neither tells of may become anything. Covered by tests/environment.
#pragma once

#include <functional>
#include <map>
#include <set>
#include <vector>

#include "analysis/encoding/entry_values.hpp"
#include "analysis/encoding/state_rule.hpp"
#include "analysis/encoding/symbolic_store.hpp"
#include "analysis/graph/graph.hpp"

namespace rungproof {

class RunBounds {
 public:
  /// A cell in front of all runs, and in front of one of them.
  struct Cell {
    Place place;
    Node before, now;
    bool isWritten = true;         ///< false: only read, so that both are the same
    bool isOfReals = false;        ///< what REAL arithmetic decides: proofs about it come to no end
    bool isBehindPointer = false;  ///< written through one: it has rules of its own, and no bounds
    bool hasNoBounds() const { return isOfReals || isBehindPointer; }
  };
  /// What one routine leaves in the cells that it writes, by their numbers.
  using Run = std::vector<std::pair<std::size_t, Node>>;
  /// A cell in front of the runs and behind them.
  struct Ends {
    Node before, after;
  };
  using EndsOf = std::function<Ends(const Place&)>;

  void find(Graph& graph, const std::vector<Cell>& cells, const std::vector<Run>& runs);
  /// Takes sets of rules in that runs keep.
  void add(std::vector<StateRules> kept);
  /// What holds in front of all runs; each run keeps it.
  void begin(const EntryValues& values);
  /// How cells may change together.
  struct Change {
    EndsOf ends;
    /// Whether a condition can be 1 here; where a rule of one cell cannot be broken before, it bounds what is left. May
    /// be missing.
    std::function<bool(Graph::Bool)> isPossible{};
    std::map<std::size_t, Graph::Bool> known{};  ///< by group
  };
  /// Whether the place may change so, together with those that are bound to it.
  Graph::Bool mayChange(Graph& graph, const Place& place, Change& change) const;
  /// The cells that bounds speak of.
  std::vector<Place> places() const;
  /// Facts about nodes of a graph, of `cells` as above: bounds hold where nothing runs, and one run from a state
  /// within all bounds ends within them.
  std::vector<Node> facts(Graph& graph, const std::vector<Cell>& cells, const std::vector<Run>& runs) const;
  void forget(const Place& place);

 private:
  enum class Kind : std::uint8_t {
    AtLeast,
    AtMost,
    SignedAtLeast,
    SignedAtMost,
    OneOf,  // of `place`
    Sum,
    Difference,  // of `place` and `other`: what it was
    // Where it was so before: parts of a whole that fits their width; `place` so far behind `other`.
    Parts,
    SignedParts,
    Behind,
    SignedBehind,
    NotAbove,
    Below,
    SignedNotAbove,
    SignedBelow,  // `place` in relation to `other`, where it was so before
    NotBoth,
    NotNeither,  // bits, where it was so before
  };
  struct Bound {
    Kind kind;
    Place place;
    std::vector<std::uint64_t> constants{};  ///< that count beside the value before; of OneOf: all of them
    Place other{};
    bool isOfTwo() const { return kind >= Kind::Sum; }
    bool isAbout(const Place& p) const { return place == p || (isOfTwo() && other == p); }
    Node holds(Graph& graph, const EndsOf& ends) const;
    Node holdsForOne(Graph& graph, Ends ends) const;
    Node holdsForTwo(Graph& graph, Ends a, Ends b) const;
  };
  class Search;
  void group();
  std::size_t count() const { return bounds_.size() + kept_.size() + entered_.size(); }
  bool isOfEntry(std::size_t number) const { return number >= bounds_.size() + kept_.size(); }
  /// Of a bound, behind these of a set of rules, and behind those of a cell whose values at the beginning are known.
  std::set<Place> placesOf(std::size_t number) const;
  Node holds(Graph& graph, std::size_t number, const EndsOf& ends,
             const std::function<bool(Graph::Bool)>& isPossible = {}) const;

  std::set<Place> written_;
  std::vector<Bound> bounds_;
  std::vector<StateRules> kept_;
  std::vector<std::pair<Place, ValueSet>> entered_;
  std::map<Place, std::size_t> groupOf_;          ///< of written cells that bounds and rules connect
  std::vector<std::vector<std::size_t>> groups_;  ///< numbers of the bounds and sets of rules of each group
};

}  // namespace rungproof
