// Simulator: the reference engine. It runs a program scan by scan on the concrete machine: power-up, RUN and STOP, the
// scan cycle of ir/s7200/scan_cycle.hpp, instruction times and what they move (1 ms timers, timed interrupts, pulse
// trains, watchdog), interrupts at instruction boundaries, devices and forced values.
//
// Time within a scan: every instruction takes its time of Appendix F; when a full ms of the CPU's clock has passed,
// everything that hangs on the 1 ms clock happens before the next instruction. After the program the rest of the scan
// passes the same way, then SM is refreshed and the outputs are written. A scan lasts as long as was asked for, or
// longer when program and interrupt routines need more.
//
// Replay of a run found by the prover (engine/replay.hpp) is the same engine with a script instead of the clock.
// Covered by tests/engine/*.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <set>
#include <vector>

#include "engine/block_start.hpp"
#include "engine/concrete.hpp"
#include "engine/devices.hpp"
#include "engine/dispatch_concrete.hpp"
#include "engine/endless_loop.hpp"
#include "engine/force.hpp"
#include "engine/instruction_observer.hpp"
#include "engine/interrupt_queue.hpp"
#include "engine/run_time_error.hpp"
#include "engine/scan_script.hpp"
#include "engine/start_up.hpp"
#include "ir/machine/choices.hpp"
#include "ir/machine/plan.hpp"

namespace rungproof {

/// What runs the program part of a scan: the reference engine alone, machine code wherever it does the same, or that
/// from the scan on from which it is worth its making.
enum class EngineKind : std::uint8_t { Reference, Compiled, Auto };

struct SimulatorOptions {
  Choices choices;
  EngineKind engine = EngineKind::Auto;
  std::uint32_t phaseMs = 0;     ///< since the last tick of the 10 ms and 100 ms time bases when RUN begins
  std::uint32_t scanUs = 10000;  ///< length of a scan in us for which nothing else is asked
  std::optional<std::vector<RetentiveRange>> retentive{};  ///< those of the system block; nothing: the CPU's default
  bool dataLost = false;                                   ///< first scan with SM0.2 = 1
  std::uint64_t seed = 1;  ///< for bits that the manual calls unknown, if Choice::UnknownBits is "random"
  ClockTime clock;         ///< real-time clock at power-up
};

template <class D, class Hooks>
class Scan;
class CallContracts;
struct LibraryEffect;
namespace compiled {
class CompiledProgram;
}

/// What is asked of one scan.
struct ScanRequest {
  std::uint32_t lengthUs = 0;  ///< 0: SimulatorOptions::scanUs
  std::vector<int> events{};   ///< interrupt events that occur at its start
  const ScanScript* script = nullptr;
};

class Simulator final : private Outside {
 public:
  /// Powers up into RUN after a download. The program must outlive the simulator. `outside`: gives the external values
  /// and hears of errors in place of the simulator's own devices (where machine code runs, of each the first time); may
  /// be nullptr.
  explicit Simulator(const Program& program, SimulatorOptions options = {}, Outside* outside = nullptr);
  ~Simulator() override;

  /// Power off and on; retentive cells keep their values.
  void powerCycle();
  /// Puts a clock `ms` into its period before the next scan: Reg::PhaseHundred the time bases of the timers,
  /// PhaseSecond SM0.5, PhaseMinute SM0.4, ClockPhase bit `bit` of the clock memory.
  void startClock(Reg clock, std::uint32_t ms, std::uint32_t bit = 0);
  /// The mode switch.
  void run();
  void stop();
  bool isRunning() const { return store_.get(Reg::Running, 0) != 0; }

  /// One scan; in STOP without the program.
  void scan(const ScanRequest& request = {});
  std::uint64_t scanCount() const { return scanCount_; }
  /// Time since power-up at the end of the last scan, and the length of that scan.
  std::uint64_t timeUs() const { return now_; }
  std::uint32_t lastScanUs() const { return lastScanUs_; }

  /// Value of a direct operand: I and Q from the image, T and C by width (Bit: the bit, Word: the current value).
  std::uint64_t read(const Operand& operand) const;
  /// State of the environment before the next scan: I sets the physical inputs, AI the analog inputs; other areas are
  /// written like by a panel. T and C by width.
  void write(const Operand& operand, std::uint64_t value);
  /// What a device writes: as write(), and a status that shows the end of a request ends it (engine/device_end.hpp).
  void writeByDevice(const Operand& operand, std::uint64_t value);
  bool physicalOutput(std::uint32_t byte, std::uint32_t bit) const {
    return store_.get(Reg::PhysicalOutput, byte * 8 + bit) != 0;
  }

  bool force(const Operand& operand, std::uint64_t value);
  void unforce(const Operand& operand);
  Devices& devices() { return devices_; }

  /// Shows every instruction of the following scans to the observer; nullptr: to nobody.
  void observe(InstructionObserver* observer) {
    observer_ = observer;
    attention_ = true;
  }

  /// In the scans to come, whether bits that the manual calls unknown are 0, without a question to `outside` and unseen
  /// by the observer.
  void readUnknownAsZero(bool isZero) { unknownIsZero_ = isZero; }
  /// S7-300/400: whether the program asks modules at once that answer as the image of the inputs does.
  bool asksInputModules() const { return !askedModules_.empty(); }
  /// Says that `outside` gives 0 for what an S7-300/400 leaves open: registers at the start of an organization block,
  /// first units of timers, modules that do not answer. Machine code takes that for granted.
  void expectFreeZero() { freeIsZero_ = true; }

  const Concrete::Store& store() const { return store_; }
  /// Replaces the state, for a replay that starts elsewhere than at power-up.
  void setStore(const Concrete::Store& store) {
    store_ = store;
    isCalm_ = false;
    queue_.clear();
    lastEdge_ = {};
  }
  /// Where a run stands in time, beside its state.
  struct Moment {
    std::uint64_t scanCount = 0;
    std::uint64_t timeUs = 0;     ///< since power-up
    std::uint64_t clockMs = 0;    ///< ticks of the 1 ms clock
    std::uint32_t sinceTick = 0;  ///< since the last of them, 10 ns
  };
  /// The same with the time, for a run that has never called for a device or an interrupt.
  void goOnFrom(const Concrete::Store& store, const Moment& moment);
  /// Of a scan of that length which begins `sinceTick` behind a tick of the 1 ms clock: up to this time (10 ns) after
  /// its start the program may end without anything else having a part in what the scan leaves, as long as no event is
  /// attached and no device runs. Nothing: the scan is longer than the CPU allows.
  std::optional<std::uint64_t> quietTime(std::uint32_t lengthUs, std::uint32_t sinceTick) const;
  /// What each instruction takes at most, 10 ns, by Instruction::id.
  std::vector<std::uint32_t> longestTimes() const;

  const Plan& plan() const { return plan_; }
  const Target& target() const { return machine_.target; }
  const RunTimeErrors& errors() const;
  /// Scans of which machine code ran the program.
  std::uint64_t compiledScans() const { return compiledScans_; }
  /// Events that a stimulus or script named although nothing could cause them then.
  const std::set<int>& eventsWithoutCause() const { return withoutCause_; }
  /// Events that stopped an S7-300/400 because it has no block for them.
  const std::set<int>& eventsWithoutBlock() const { return withoutBlock_; }
  /// The instruction that executed STOP last, or nullptr.
  const Instruction* stoppedBy() const { return stoppedBy_; }

 private:
  struct Hooks;
  using Runner = Scan<Concrete, Hooks>;
  /// One instruction, by Instruction::id: its time in 10 ns, and the form of its meaning to run.
  struct Cost {
    static constexpr std::uint32_t perUs = 100;
    static constexpr std::uint32_t perMs = 1000 * perUs;
    std::array<std::uint32_t, 2> time;  ///< without and with power flow
    Execute<Concrete> run;
  };

  std::uint64_t external(const ExternalSite& site, int width) override;
  std::uint64_t externalValue(const ExternalSite& site, int width);
  std::uint64_t kept(const LibraryEffect& effect) const;
  void report(Hazard hazard, const Instruction* place) override;
  void signal(Signal which, std::uint32_t index) override;
  std::uint64_t unknown(int width);
  std::uint64_t startByte(int block, std::uint32_t byte, std::uint64_t unknown) const;

  void prepareCosts();
  void showInputsToModules();
  void scanInRun(const ScanRequest& request, std::uint32_t lengthUs);
  void scanInStop(std::uint32_t lengthUs);
  void boundary(Runner& runner, const FlowStep* step);
  void lookAtInputs(std::uint32_t lengthUs);
  // calm_scan.cpp
  bool becomesCalm() const;
  bool staysCalm(const ScanRequest& request, std::uint32_t lengthUs) const;
  void beginCalmly(std::uint32_t lengthUs);
  void endCalmly(std::uint32_t lengthUs);
  // compiled/simulator_with_code.cpp
  bool runCompiled(std::uint32_t lengthUs);
  bool mayRunCompiled();
  compiled::CompiledProgram* machineCode(bool countsTime);
  // simulator_events.cpp
  void raiseInputEdges();
  void forgetInputEdges();
  void raiseByStimulus(int event);
  void raise(int event);
  bool meetsMissingBlock(int event);
  void raiseTimer(const TimerUse& use, bool reached);
  void attachTimed(std::uint32_t event);
  std::uint64_t periodOf(std::uint32_t timer) const;
  std::uint64_t elapsedOf(std::uint32_t timer) const;
  void endDelay(std::uint32_t timer);
  bool runsTimed(std::uint32_t timer) const;
  bool mayBeDue(int event) const;
  bool hasCause(int event);
  void occur(int event);
  void scripted(Runner& runner, ScanPlace place);
  void scriptedWrites(ScanPlace place);
  void endSave();
  bool isScriptQuiet() const;
  void beginScript(std::uint32_t lengthMs);
  void endScript();
  void forgetEdges();
  void serveEvent(Runner& runner, int event);
  void checkWatchdog();
  void watchLoops(const FlowStep& step);
  bool isInTime(std::uint64_t position) const;
  std::uint64_t watchdogTime() const { return watchdogTime_; }
  std::uint64_t quietTime() const;
  void setClock();
  void passMillisecond(Runner& runner);
  bool mayServe() const;
  void serveInterrupts(Runner& runner);
  void runRoutine(Runner& runner, const InterruptQueue::Waiting& waiting);
  void passRest(Runner& runner, std::uint32_t lengthUs);
  bool isQuietUntil(std::uint64_t position) const;
  void finishScan(std::uint32_t lengthUs);

  Plan plan_;
  std::shared_ptr<const CallContracts> contracts_;  ///< of calls of blocks without text
  SimulatorOptions options_;
  Outside* outside_;
  Concrete domain_;
  Concrete::Store store_;
  Machine<Concrete> machine_;
  InterruptQueue queue_;
  ForceTable forced_;
  Devices devices_;
  BlockStart starts_;
  mutable RunTimeErrors errors_;  ///< without what machine code has counted since somebody asked
  std::vector<Cost> costs_;
  bool unknownIsZero_;       ///< bits that the manual calls unknown are read as 0
  bool freeIsZero_ = false;  ///< `outside` gives 0 for what an S7-300/400 leaves open

  std::uint64_t now_ = 0;        ///< us since power-up, at the start of the scan
  std::uint64_t clockMs_ = 0;    ///< ticks of the 1 ms clock since power-up
  std::uint32_t sinceTick_ = 0;  ///< from the last of them to the start of the scan, 10 ns
  std::uint32_t scanTicks_ = 0;  ///< 1 ms ticks in this scan
  std::uint64_t startMs_ = 0;    ///< clockMs_ at the start of the scan
  std::uint64_t scanCount_ = 0;
  std::uint32_t lastScanUs_ = 0;
  std::uint64_t moment_ = 0;    ///< grows with every instant at which events may occur together
  std::uint64_t position_ = 0;  ///< within the scan, 10 ns
  std::uint64_t nextMs_ = 0;    ///< position at which the next boundary is looked at: that of the next 1 ms tick
  bool hasWatchdog_ = true;
  std::uint64_t watchdogTime_ = 0, longestScan_ = 0;  ///< 10 ns
  std::uint64_t watchdogFrom_ = 0;
  bool hasTimeError_ = false;  ///< OB80 was called in this scan for its length
  std::uint32_t pending_ = 0;  ///< time of the instruction that is running
  bool attention_ = false;     ///< events wait in the queue, an observer looks, or loops are watched
  EndlessLoop loop_;
  InstructionObserver* observer_ = nullptr;
  const Instruction* stoppedBy_ = nullptr;
  const std::string* calledBlock_ = nullptr;  ///< library block whose outputs are being asked for
  std::set<int> withoutCause_;
  std::set<int> withoutBlock_;
  int priority_ = 0;  ///< of the organization block that has interrupted OB1
  std::uint64_t random_;
  std::uint32_t edgeInputs_ = 0;  ///< the inputs of edge events as these saw them last
  const ScanScript* script_ = nullptr;
  std::vector<std::uint32_t> visits_;  ///< executions of each instruction in this scan, under a script only
  std::uint32_t scriptedTicks_ = 0;
  std::uint32_t scriptedMs_ = 0;                          ///< length of the scan
  std::array<std::uint32_t, timedEventCount> timedMs_{};  ///< since a timed event at the end of the scan
  std::uint32_t passedMs_ = 0;                            ///< of the scan, at least, at the place reached
  std::array<int, edgeInputCount> lastEdge_{};            ///< 0: not known, 1: rising, 2: falling

  /// The program as machine code, without and with its time; what was tried and is not there stays nullptr.
  std::array<std::unique_ptr<compiled::CompiledProgram>, 2> compiled_;
  std::array<bool, 2> isCompileTried_{};
  bool isCalm_ = false;                      ///< only the program decides what the next scan leaves (calm_scan.cpp)
  std::uint64_t longestCalm_ = 0;            ///< 10 ns: longest scan that the CPU allows
  bool hasFineTimers_ = false;               ///< timers that count single ms
  std::vector<std::uint32_t> askedModules_;  ///< bytes of PI that answer as the image's inputs until write() says more
  bool readsStart_ = false;                  ///< of OB1, as engine/block_start.hpp gives it
  bool touchesQueueBits_ = false;            ///< an instruction may write SM4.0 to SM4.2
  bool savesMemory_ = false;                 ///< the CPU's SM31.7 starts saving
  std::uint64_t compiledScans_ = 0;
  std::uint64_t referenceUntil_ = 0;  ///< scan up to which machine code, which has given up, is not tried again
  std::uint32_t givenUp_ = 0;         ///< times in a row
};

}  // namespace rungproof
