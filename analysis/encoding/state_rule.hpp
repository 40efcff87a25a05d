// StateRule: a statement about memory at one moment: a cell lies within bounds or is one of these numbers, one cell
// equals or does not exceed another, either only where a bit is so; or what a property says. It is asked of nodes of
// any graph, and of the constants of a state that was seen. Covered by tests/environment/routine_invariant_test.cpp.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "analysis/encoding/memory_layout.hpp"
#include "analysis/encoding/symbolic_store.hpp"
#include "analysis/property.hpp"

namespace rungproof {

/// A part of a property that speaks of one moment and of memory only, cut into the cells of a program.
class SaidOfMemory {
 public:
  /// Nothing: it looks back, or at something else than memory.
  static std::shared_ptr<const SaidOfMemory> of(const Expr& said, const MemoryLayout& layout);

  Node holds(Graph& graph, const std::function<Node(const Place&)>& valueOf) const;
  const std::vector<Place>& places() const { return places_; }

 private:
  /// `width` bits of a cell, of which `low` is the lowest.
  struct Piece {
    Place cell;
    std::uint32_t low;
    std::uint8_t width;
  };
  struct Read {
    Operand operand;
    int width;
    std::vector<Piece> pieces;  ///< the highest first
  };
  bool add(const Operand& operand, int width, const MemoryLayout& layout);

  Property property_;
  std::vector<Read> reads_;
  std::vector<Place> places_;
};

/// The statements within a property about one moment, each with its opposite: what holds of one run of a routine is
/// often what somebody wants to know.
std::vector<Expr> statementsIn(const Property& property);

struct StateRule {
  using ValueOf = std::function<Node(const Place&)>;
  enum class Kind : std::uint8_t {
    AtLeast,
    AtMost,
    SignedAtLeast,
    SignedAtMost,  // of `place`; the first of `constants`
    OneOf,         // `constants`
    Same,
    NotAbove,
    SignedNotAbove,  // of `place` and `other`
    Said
  };
  struct Condition {
    Place bit;
    bool isOn;
    friend bool operator==(const Condition&, const Condition&) = default;
  };

  Kind kind;
  Place place{};
  std::vector<std::uint64_t> constants{};
  Place other{};
  std::optional<Condition> where{};  ///< nothing is said elsewhere
  std::shared_ptr<const SaidOfMemory> said{};

  Node holds(Graph& graph, const ValueOf& valueOf) const;
  std::vector<Place> places() const;
};

/// Rules that hold together.
using StateRules = std::vector<StateRule>;
Graph::Bool allHold(Graph& graph, const StateRules& rules, const StateRule::ValueOf& valueOf);

}  // namespace rungproof
