// Replay: the reference engine driven by a script, so that a run which the prover found can be repeated exactly. For
// every scan the script gives inputs, length and ticks, the values of external sites, and the interrupts and 1 ms
// ticks in front of given instructions. Nothing else happens: devices and the clock inside the scan stand still.
// Covered by tests/engine/replay_test.cpp.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "engine/concrete.hpp"
#include "engine/given_values.hpp"
#include "engine/instruction_observer.hpp"
#include "engine/run_time_error.hpp"
#include "engine/scan_script.hpp"
#include "ir/machine/choices.hpp"
#include "ir/machine/plan.hpp"

namespace rungproof {

/// A direct operand set before a scan: I the physical input, others the memory itself.
struct PresetValue {
  Operand operand;
  std::uint64_t value;
};

struct ReplayScan {
  std::vector<PresetValue> inputs;
  std::uint32_t lengthMs = 10;
  ScanScript script;
  /// For every kind, index and instruction the values in the order in which the run asks for them. A value that is
  /// missing is 0 (Choice::UnknownBits decides for stack bottom, local memory and unknown status); an input that is
  /// read at once keeps the last value given, an analog one what it was set to or found at last.
  std::vector<ExternalValue> externals;
  std::uint32_t repeats = 1;  ///< the same scan is made that many times, one after the other
};

struct ReplayResult {
  std::vector<Concrete::Store> states;  ///< after each scan, the last one included that a fatal error or STOP ended
  std::vector<RunTimeError> errors;
  std::size_t unusedExternals =
      0;  ///< values that the run did not ask for; more than 0: prover and engine walked apart
};

/// Whether the scan that left this state has an end: a scan that a fatal error ends has none (001:13906-13910).
inline bool hasScanEnd(const Concrete::Store& state) { return state.get(Reg::Fault, 0) == 0; }

/// The same scan by scan, for scripts that are made on the way.
class ReplayRun {
 public:
  /// Begins with `initial`, or with power-up if it is nullptr. `watcher`: is shown every instruction; may be nullptr.
  ReplayRun(const Program& program, const Choices& choices, const Concrete::Store* initial = nullptr,
            InstructionObserver* watcher = nullptr);
  ~ReplayRun();
  ReplayRun(const ReplayRun&) = delete;
  ReplayRun& operator=(const ReplayRun&) = delete;

  /// What is given to each of the scans to come.
  void load(const ReplayScan& scan);
  /// Makes a scan; gives the state after it.
  const Concrete::Store& scan();
  /// False after a scan that a fatal error or STOP ended.
  bool isRunning() const;
  const std::vector<RunTimeError>& errors() const;
  /// As ReplayResult has them, of the scans so far.
  std::size_t unusedExternals() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// Is shown the state after each scan and the index of its ReplayScan; false ends the replay.
using ReplayObserver = std::function<bool(const Concrete::Store& state, std::size_t scan)>;

/// Runs the scans from `initial`, or from power-up if it is nullptr. With an observer no states are kept, so that
/// stretches of any length can be replayed. `watcher`: is shown every instruction; may be nullptr.
ReplayResult replay(const Program& program, const Choices& choices, const std::vector<ReplayScan>& scans,
                    const Concrete::Store* initial = nullptr, const ReplayObserver& observer = {},
                    InstructionObserver* watcher = nullptr);

}  // namespace rungproof
