// What bounds are looked for (invariants_bounds.hpp): which words count the same ticks, under which conditions, and up
// to which value. Tested by tests/solver/invariants_test.cpp.
#pragma once

#include <vector>

#include "analysis/bits/bit_blast.hpp"
#include "analysis/portfolio/certificate.hpp"
#include "analysis/portfolio/invariants.hpp"

namespace rungproof {

/// Chain: of clocks against many timers, one condition each: timers that start each other need no more. Few: of clocks
/// against timers, while a condition holds; a chain of steps needs no more, and many would take too long. Stops: the
/// same until the clock or timer that is subtracted stops. Pending: also for timers that have not run out, for steps
/// that their own timers end; it comes last, since the most bounds are looked for.
enum class BoundScope : std::uint8_t { Chain, Few, Stops, All, Pending };

/// The word below widenings.
inline Node withoutExtension(const Graph& graph, Node n) {
  while (graph[n].op == Op::Zext || graph[n].op == Op::Sext) n = graph[n].child[0];
  return n;
}
inline bool isOrder(Op op) { return op == Op::Ult || op == Op::Ule || op == Op::Slt || op == Op::Sle; }

/// A state word that counts: what is compared of it is a Summand (certificate.hpp), with the node of the increment. Of
/// a word that counts down, as the rest of a timer does, it is the complement, which counts up.
struct CountingWord {
  std::size_t state = 0;  ///< index in TransitionSystem::states
  Summand sum;
  std::vector<std::uint64_t> stops;  ///< values at which it may stop
  Op extension = Op::Zext;           ///< how the program extends it: Sext, or anything else
  bool countsDown = false;
  bool isChained = false;  ///< the increment is added in parts
  bool isTimer() const { return sum.isPending || countsDown; }
};

/// A clock against a word that counts by `amount` in a scan: what their difference is made of.
struct Rate {
  Node difference = noNode;
  Node clock = noNode, increment = noNode, word = noNode;
  std::uint64_t amount = 0;
  bool isDown = false;  ///< the word counts down
  bool isBehind =
      false;  ///< the difference is how far the word is ahead of the clock, instead of the clock of the word
  bool isSigned = false;  ///< the word
};

/// "guard implies difference <= bound, unless stopped": what is sought is the bound.
struct BoundTemplate {
  Node guard = noNode;        ///< width 1 over states; noNode: always
  Node stopped = noNode;      ///< width 1: one of the words has reached a value at which it may stop; noNode: never
  Node difference = noNode;   ///< signed
  int left = -1, right = -1;  ///< of a difference of two words: their indices in BoundTemplates::words

  friend bool operator==(const BoundTemplate&, const BoundTemplate&) = default;
};

struct BoundTemplates {
  std::vector<CountingWord> words;
  std::vector<BoundTemplate> templates;
  std::vector<Rate> rates;  ///< of templates
};

/// Adds the nodes to the graph of the system. `known`: of blast's bits; equal latches give one guard.
BoundTemplates boundTemplates(const TransitionSystem& system, const BitBlast& blast, const Invariants& known,
                              std::uint64_t seed, BoundScope scope, const Budget& budget);

}  // namespace rungproof
