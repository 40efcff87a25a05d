// Time in the transition system. A scan lasts dt ms, any number within the configured range; ticks of the 10 ms and
// 100 ms time bases must follow from it exactly. Absolute time is split into digits, 100 N + 10 d + u: each scan
// chooses the new digits, and
//     dt = 100 n + 10 (d' - d) + (u' - u),   ticks of 10 ms = 10 n + d' - d,   ticks of 100 ms = n
// so no division appears. Ticks reach the program in the next scan (ir/s7200/scan_cycle.hpp), so n and d' - d are kept.
// d and u start with any value: the time bases run freely, RUN begins anywhere in their intervals (001:6592). Four bits
// hold a digit; those of 10 to 15 mean it less 10, so every start is one.
//
// Where no timer counts in these bases, on an S7-300/400, the length of a scan is one input.
//
// The relaxed range lets a scan last up to 2^22 ms. Every real run is a relaxed run, so proofs hold; a relaxed
// witness must be expanded into real scans before it counts.
// Covered by tests/encoder/time_model_test.cpp.
#pragma once

#include <cstdint>
#include <vector>

#include "analysis/graph/transition_system.hpp"

namespace rungproof {

/// Length of a scan in ms, 1 <= low <= high <= 65535.
struct TimeRange {
  std::uint32_t low = 1;
  std::uint32_t high = 500;
  bool relaxed = false;
  bool hasBases = false;  ///< ticks of 10 ms and 100 ms are asked for, or the program is one of an S7-200
};

class TimeModel {
 public:
  static constexpr std::uint32_t relaxedHigh = 1U << 22;

  TimeModel(Graph& graph, const TimeRange& range);

  /// ms of this scan, width() bits.
  Node dt() const { return dt_; }
  int width() const { return width_; }
  std::uint32_t high() const { return high_; }
  /// dt cut to 16 bits with saturation: enough for timers, which stop at 32767.
  Node dt16() { return saturated16(dt_); }
  /// A number of ms or ticks cut to 16 bits, or to `width`, with saturation.
  Node saturated16(Node value) { return saturated(value, 16); }
  Node saturated(Node value, int width);
  /// Ticks at the start of this scan, 16 bits, saturated. These and all that tells of digits: with hasBases only.
  Node ticks10();
  Node ticks100();
  /// Ticks of `base` (1, 10 or 100 ms) that fall into this scan; any width.
  Node ticksWithin(int base);
  /// The digits of the absolute time at the start and at the end of this scan, 4 bits each.
  Node tensBefore() const { return ten_; }
  Node onesBefore() const { return one_; }
  Node tensNow() const { return tensNow_; }
  Node onesNow() const { return onesNow_; }

  /// What the transition system gets: state, inputs, and the constraint, which can always be met.
  const std::vector<StateVariable>& states() const { return states_; }
  const std::vector<Node>& inputs() const { return inputs_; }
  /// Where the length is fixed: its ms, and its ticks of 10 and 100 ms where they are the same in every scan.
  std::vector<std::uint64_t> steadySteps() const;
  /// noNode if the length is fixed.
  Node constraint() const { return constraint_; }

 private:
  void plain();
  void free();
  void fixed(std::uint32_t length);
  Node number(std::uint64_t value, int width) { return graph_.constantNode(value, width); }
  Node state(const char* name, int width, Node next);
  Node digit(const char* name);
  Graph& graph_;
  std::uint32_t low_, high_;
  bool relaxed_;
  int width_;
  Node dt_ = noNode;
  Node hundredsNow_ = noNode, tensNow_ = noNode, onesNow_ = noNode;
  Node hundreds_ = noNode;  ///< ticks of 100 ms since the scan before
  Node ten_ = noNode;       ///< digit d at the start of this scan
  Node one_ = noNode;       ///< digit u
  Node step_ = noNode;      ///< d less the digit at the start of the scan before, 5 bits, signed
  Node constraint_ = noNode;
  std::vector<StateVariable> states_;
  std::vector<Node> inputs_;
};

}  // namespace rungproof
