// Paths through a block of an S7-300/400 that know what they have passed: a path on which a jump was taken carries what
// that says of RLO, BR and the bits that were scanned, and takes no later jump against it. A LAD box leaves its ENO in
// BR, so what stands behind `A BR; JNB` runs only where the box before it ran. What is not followed is unknown. Where
// there are too many paths they forget their bits, and if that is not enough they become one that knows nothing. Tested
// by tests/rules/step7_control_rules_test.cpp.
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "analysis/flow/facts.hpp"
#include "analysis/flow/statement_paths.hpp"

namespace rungproof {

enum class Known : std::uint8_t { No, Yes, Unknown };

class PathKnowledge {
 public:
  using BitKey = std::uint64_t;

  bool operator==(const PathKnowledge&) const = default;
  /// Of a path that is only known to be one of several.
  static PathKnowledge nothing();
  /// Of RLO, BR and what is open alone.
  PathKnowledge withoutBits() const {
    PathKnowledge path = *this;
    path.bits_.clear();
    path.rloBit_ = noKey;
    return path;
  }

  /// What a step makes of it: visit(target, knowledge) for every step that may follow.
  template <class Visit>
  void follow(const Facts& facts, const Flow& flow, std::uint32_t at, Visit&& visit) const;

 private:
  static constexpr BitKey noKey = 0;

  struct Branch;
  /// An open parenthesis, and what stood before it.
  struct Level {
    Known rlo = Known::Unknown, firstCheck = Known::No;
    bool isOrOpen = false;
    ScanJoin join{};
    bool operator==(const Level& other) const {
      return rlo == other.rlo && firstCheck == other.firstCheck && isOrOpen == other.isOrOpen &&
             join.role == other.join.role && join.negated == other.join.negated;
    }
  };

  static BitKey keyOf(const Facts& facts, const Instruction& instruction);
  std::vector<Branch> branches(const Facts& facts, const Flow& flow, std::uint32_t at) const;
  /// The path once with RLO 0 and once with RLO 1, where it is not known which.
  std::vector<PathKnowledge> byRlo() const;
  Known valueOf(BitKey key) const;
  void setBit(BitKey key, Known value);
  void scan(ScanJoin join, Known value, BitKey key);
  void close();
  void endString() { firstCheck_ = Known::No, isOrOpen_ = false; }
  void forgetWritten(const Facts& facts, const Instruction& instruction);
  void forgetGlobals();
  void apply(const Facts& facts, const Instruction& instruction);

  Known rlo_ = Known::Unknown, br_ = Known::Unknown, firstCheck_ = Known::No;
  bool isOrOpen_ = false;                         ///< behind O without operand
  BitKey rloBit_ = noKey;                         ///< a bit that has the value of the RLO
  std::vector<std::pair<BitKey, Known>> bits_{};  ///< those that are known, in the order of their keys
  std::vector<Level> levels_{};
};

struct PathKnowledge::Branch {
  PathKnowledge knowledge;
  std::optional<std::uint32_t> target{};  ///< nothing: every step that may be next
};

template <class Visit>
void PathKnowledge::follow(const Facts& facts, const Flow& flow, std::uint32_t at, Visit&& visit) const {
  for (const Branch& branch : branches(facts, flow, at)) {
    if (branch.target) {
      visit(*branch.target, branch.knowledge);
      continue;
    }
    eachNext(flow, at, [&](std::uint32_t next) { visit(next, branch.knowledge); });
  }
}

/// As statesOf(), along such paths: `State` beside it has the same `join`.
template <class State, class Apply>
std::vector<std::optional<State>> statesOnConditionalPaths(const Facts& facts, const Flow& flow, const State& entry,
                                                           Apply&& apply) {
  constexpr std::size_t mostPaths = 16;
  struct Path {
    PathKnowledge knowledge;
    State state;
    bool isDue = true;
  };
  const auto end = static_cast<std::uint32_t>(flow.steps.size());
  std::vector<std::vector<Path>> paths(end + 1);
  enum class Keeps : std::uint8_t { All, NoBits, Nothing };
  std::vector<Keeps> keeps(end + 1, Keeps::All);  // less where too many have come
  paths[0].push_back({PathKnowledge{}, entry});
  const auto join = [&](std::uint32_t at, const PathKnowledge& arriving, const State& state) {
    const PathKnowledge knowledge = keeps[at] == Keeps::All      ? arriving
                                    : keeps[at] == Keeps::NoBits ? arriving.withoutBits()
                                                                 : PathKnowledge::nothing();
    for (Path& path : paths[at]) {
      if (path.knowledge != knowledge) continue;
      path.isDue = path.state.join(state) || path.isDue;
      return;
    }
    paths[at].push_back({knowledge, state});
  };
  const auto arrive = [&](std::uint32_t at, const PathKnowledge& knowledge, const State& state) {
    join(at, knowledge, state);
    while (paths[at].size() > mostPaths) {
      keeps[at] = keeps[at] == Keeps::All ? Keeps::NoBits : Keeps::Nothing;
      for (const Path& path : std::exchange(paths[at], {})) join(at, path.knowledge, path.state);
    }
  };
  for (bool again = true; again;) {
    again = false;
    for (std::uint32_t at = 0; at < end; ++at) {
      for (std::size_t i = 0; i < paths[at].size(); ++i) {
        if (!std::exchange(paths[at][i].isDue, false)) continue;
        const Path path = paths[at][i];
        State state = path.state;
        apply(state, flow.steps[at]);
        path.knowledge.follow(facts, flow, at, [&](std::uint32_t next, const PathKnowledge& knowledge) {
          arrive(next, knowledge, state);
          again = again || (next <= at && next < end);
        });
      }
    }
  }
  std::vector<std::optional<State>> before(end + 1);
  for (std::uint32_t at = 0; at <= end; ++at) {
    for (const Path& path : paths[at]) {
      if (before[at])
        before[at]->join(path.state);
      else
        before[at] = path.state;
    }
  }
  return before;
}

}  // namespace rungproof
