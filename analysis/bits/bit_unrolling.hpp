// Unrolling: the values of a system's literals in scans 0, 1, 2 ... as literals of one and-inverter graph, whose
// structural hashing folds what the initial state decides. Tested by tests/solver/bit_system_test.cpp.
#pragma once

#include <span>
#include <vector>

#include "analysis/bits/bit_cnf.hpp"
#include "analysis/bits/engine_contract.hpp"

namespace rungproof {

class Unrolling {
 public:
  enum class Start : std::uint8_t { Initial, Any };  ///< scan 0 begins in an initial state or in any state
  Unrolling(const BitSystem& system, Start start) : system_(system), start_(start) {}

  /// Literal `l` of the system in scan `frame`. Frames are added as needed.
  Lit at(int frame, Lit l) {
    while (static_cast<int>(frames_.size()) <= frame) addFrame();
    return frames_[frame][variableOf(l)] ^ (l & 1U);
  }
  const BitSystem& graph() const { return graph_; }
  BitSystem& graph() { return graph_; }
  /// The run of scans 0 .. depth in the solver's model.
  BitTrace trace(int depth, const BitCnf& cnf) const;

 private:
  void addFrame();
  const BitSystem& system_;
  Start start_;
  BitSystem graph_;
  std::vector<std::vector<Lit>> frames_;  ///< by scan, by variable
};

/// Teaches the solver that the literal follows from the assumptions, where that is soon seen.
void teach(Sat& sat, int literal, std::span<const int> assumptions, const Budget& budget);

/// Teaches the solver what of the system's guide follows in that scan from the assumptions.
void followGuide(const BitSystem& system, Unrolling& steps, int frame, Sat& sat, BitCnf& cnf,
                 std::span<const int> assumptions, const Budget& budget);

/// Does the run keep all constraints and is some bad literal true in its last scan?
bool isViolation(const BitSystem& system, const BitTrace& trace);

}  // namespace rungproof
