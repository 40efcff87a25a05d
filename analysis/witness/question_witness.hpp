// Witnesses of questions that are no properties, such as those of the built-in checks: a found run, in real scans, is
// followed on the exact system until the question's node is 1, and on the engine; both must have the same state after
// every scan, as far as the question depends on it. Inputs that may have any value without changing the answer are
// found the same way. Covered by tests/prover/witness_test.cpp and tests/prover/builtin_test.cpp.
#pragma once

#include <optional>
#include <span>
#include <unordered_set>
#include <utility>
#include <vector>

#include "analysis/witness/witness.hpp"

namespace rungproof {

/// A run of the exact system, scan by scan.
struct ExactRun {
  std::vector<std::uint64_t> initial;              ///< by state; counts where the state starts with any value
  std::vector<std::vector<std::uint64_t>> inputs;  ///< by scan and input of the system
  std::vector<std::uint32_t> lengths;              ///< ms, by scan
};

/// One question about an encoding.
class QuestionWitness {
 public:
  /// `cone`: the variables (node indices) that the question depends on; it must outlive this.
  QuestionWitness(EncodedScan& encoding, const TransitionSystem& system, Node bad,
                  const std::unordered_set<std::uint32_t>& cone)
      : encoding_(encoding), system_(system), bad_(bad), cone_(cone) {}

  /// The run that `trace` of another system over the same program describes, up to the scan in which the question's
  /// node is 1; nothing if it never is. Scans longer than the range become several.
  std::optional<ExactRun> runOf(const TransitionSystem& found, const WordTrace& trace, const TimeRange& range) const;
  /// What is kept of a run that the engine repeats: scans, or how many they are and how long they last.
  enum class Kept : std::uint8_t { Scans, Length };
  /// Another question about the same encoding.
  struct Other {
    Node bad;
    std::unordered_set<std::uint32_t> cone;
    std::optional<Witness> witness{};  ///< result: where the run shows it as well; its length only
  };
  /// The run as the engine repeats it; nothing if it does not. `others` are followed beside it.
  std::optional<Witness> witness(const Program& program, const Choices& choices, const ExactRun& run,
                                 Kept kept = Kept::Scans, std::span<Other> others = {}) const;
  /// Sets inputs that do not matter to 0; `matters`, as in Witness, tells which do. "Any value" is tried with 0, with
  /// all ones, and with random values for all idle inputs together. False if `seconds` were not enough.
  bool dropIdle(ExactRun& run, std::vector<std::vector<bool>>& matters, double seconds, std::uint64_t seed) const;

 private:
  /// What the encoding and the engine must agree on after each scan.
  struct Compared {
    Place place;
    Node next;
  };
  std::vector<Compared> comparedIn(const std::unordered_set<std::uint32_t>& cone) const;

  EncodedScan& encoding_;
  const TransitionSystem& system_;
  Node bad_;
  const std::unordered_set<std::uint32_t>& cone_;
};

}  // namespace rungproof
