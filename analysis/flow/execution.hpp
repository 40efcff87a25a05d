// When instructions run: reachable at all, skipped by jumps, repeated by loops, inside a step, every scan or only in
// the first one. All of it by sweeps over the rows of Flow, linear in the program. Loops and jumps: 001:5750-5801;
// steps: 001:5830; returns: 001:6735. Tested by tests/rules/facts_test.cpp.
#pragma once

#include <cstdint>
#include <vector>

#include "analysis/flow/call_graph.hpp"
#include "analysis/flow/stack_depth.hpp"

namespace rungproof {

/// How often a block runs in one scan.
enum class Runs : std::uint8_t { Never, AtMostOnce, Once, Several };

struct ExecutionPoint {
  bool isReachable : 1 = true;  ///< some path from the start of its block leads here
  bool inLoop : 1 = false;      ///< between FOR and NEXT, or between a label and a jump back to it
  bool isSkipped : 1 = false;   ///< some JMP, LSCR, CRET ... may leave it out in a scan
  Condition within = 0;         ///< what the jumps and returns around it leave: FirstScan, Pulse
};

class ExecutionTable {
 public:
  ExecutionTable(const Program& program, const Plan& plan, const CallGraph& calls, const StackRun& stack);

  const ExecutionPoint& at(std::uint32_t instruction) const { return points_[instruction]; }
  /// Instruction::id of what may leave this one out in a scan; asked only where something may.
  std::uint32_t skipper(std::uint32_t instruction) const;
  /// How often the block runs in a scan, called from the main program; interrupt routines: AtMostOnce per event.
  Runs runs(std::uint32_t block) const { return runs_[block]; }
  /// What is known about every run of the block: FirstScan, Pulse (only for single scans, or as an interrupt).
  Condition condition(std::uint32_t block) const { return conditions_[block]; }

 private:
  void reach(const Flow& flow, const StackRun& stack);
  void sweep(const Flow& flow, const StackRun& stack);
  void narrow(const Flow& flow, const StackRun& stack);
  void count(const Program& program, const CallGraph& calls, const StackRun& stack);

  /// Instructions from `first` on, as far as they are skipped, are so by `skipper`.
  struct Skipped {
    std::uint32_t first, skipper;
  };

  std::vector<ExecutionPoint> points_;
  std::vector<Skipped> skipped_;  ///< in program order
  std::vector<Runs> runs_;
  std::vector<Condition> conditions_;
};

}  // namespace rungproof
