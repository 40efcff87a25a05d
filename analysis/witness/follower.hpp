// A property followed along a run of the engine, scan end by scan end, by the monitor that the prover builds into its
// systems. Tested by tests/prover.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "analysis/property.hpp"
#include "engine/replay.hpp"

namespace rungproof {

class Follower {
 public:
  explicit Follower(const Property& property);

  /// The monitor's answer (Monitor::evaluate) at the end of `scan`, which left `state`.
  bool evaluate(Concrete& domain, const Concrete::Store& state, const ReplayScan& scan, bool isFirst);
  /// What the monitor remembers from scan to scan.
  std::span<const std::uint64_t> cells() const { return cells_; }

 private:
  std::uint64_t leaf(const Concrete::Store& state, const ReplayScan& scan, const Operand& operand, int width) const;
  bool isUnchanged(const Concrete::Store& state, const ReplayScan& scan);

  const Property& property_;
  std::vector<std::uint64_t> cells_;
  /// Of a property without cells and first scan: what it read last; its answer stays while that does.
  std::vector<const Operand*> read_;
  std::vector<std::uint64_t> seen_;
  bool isStateless_ = false;
  bool answer_ = false;
};

}  // namespace rungproof
