// Decisions: what an encoding asked about its nodes on the way - is this condition known, which places can this
// pointer reach - and was told, in order. A second encoding of the same program that is told the same takes the same
// way, though its nodes are not simplified and would not tell by themselves. Tested by tests/certificate.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

namespace rungproof {

struct Decisions {
  enum class Kind : std::uint8_t { Value, Targets, Target };
  struct One {
    Kind kind;
    std::optional<std::uint64_t> answer;
  };
  std::vector<One> made;
  std::size_t next = 0;  ///< of those that are followed
  /// By place in `made`: answers that are told instead of the right ones. Mistakes that tests plant.
  std::map<std::size_t, std::optional<std::uint64_t>> planted{};

  /// What is told.
  std::optional<std::uint64_t> record(Kind kind, std::optional<std::uint64_t> answer) {
    if (const auto other = planted.find(made.size()); other != planted.end()) answer = other->second;
    made.push_back({kind, answer});
    return answer;
  }
};

/// The second encoding asks something else: it cannot be made so.
struct DecisionsDiverge {};

}  // namespace rungproof
