// One run of the scan over graph nodes: the part of the encoder that talks to the machine. It gives touched places
// their values at the start of the scan, answers the machine's questions for external values and pointers, and lets
// ticks and interrupts come at instruction boundaries. encoder.cpp repeats it until what it knows is stable.
#pragma once

#include <map>
#include <set>

#include "analysis/encoding/device_writes.hpp"
#include "analysis/encoding/encoder.hpp"
#include "analysis/encoding/footprint.hpp"
#include "analysis/encoding/loop_widening.hpp"
#include "analysis/encoding/pointer_values.hpp"
#include "analysis/encoding/routine_effects.hpp"
#include "analysis/encoding/told_facts.hpp"
#include "ir/families/run.hpp"
#include "ir/s7200/call_contract.hpp"
#include "ir/s7200/event.hpp"

namespace rungproof {

/// What cells can be together at the start of all scans but the first.
struct KnownWalk {
  std::vector<Place> cells;
  std::set<std::vector<std::uint64_t>> together;
};

/// What earlier runs have found out about the program.
struct Knowledge {
  std::map<Place, ValueSet> values;          ///< of cells at the start of scans, as far as they are known
  std::vector<Place> firstScans;             ///< 1 at the start of the first scan only
  std::map<Place, ValueSet> later;           ///< of pointer cells at the start of all scans but the first
  std::vector<KnownWalk> walks;              ///< of pointer cells
  std::map<Place, std::uint64_t> constants;  ///< cells that keep one value in all runs
  Footprints footprints;
  TableTargets tables;          ///< of devices, where pointers lead to them
  bool followsPointers = true;  ///< false: pointers that are not constant stay unresolved
  bool isFinal = false;         ///< nothing is left to be learned
};

/// Events that the program attaches, with the routines they may have.
using Attachments = std::map<int, std::set<int>>;
Attachments attachmentsOf(const Plan& plan);

constexpr int queueBits = 5;  ///< width of a count of entries in a queue, at most 16

/// What of the interrupt queue, the timed events and the edges of inputs lies outside the machine, as it is now.
struct EventStates {
  /// By timed event: ms since it came last, at the end of the scan. Not there: it cannot come.
  std::map<std::uint32_t, Node> sinceLast;
  Node passed = noNode;            ///< ms of the scan at least, at this place
  std::map<int, Node> waiting;     ///< entries of timed events, 21 and 22 in the queue
  std::map<int, Node> left;        ///< routine + 1 of an entry whose event was detached (Choice::DetachedEvents)
  std::map<int, Node> lastEdge;    ///< by input of which both edges are attached; 0: not known, 1: rising, 2: falling
  std::set<int> overflowBits;      ///< bits of SM4 that the program can see
  std::vector<StateVariable> all;  ///< those that live on from scan to scan, next: not set
};

class ScanEncoding final : private CellSource, private Graph::Listener {
 public:
  using Runner = Scan<Graph, ScanEncoding>;

  ScanEncoding(const Program& program, const EncoderOptions& options, const Plan& plan, const MemoryLayout& layout,
               const Knowledge& knowledge, const RoutineEffects* effects);

  /// Hooks of the walk over the program.
  void before(Runner& runner, const FlowStep& step);
  void callWithoutBody(Runner& runner, const Instruction& instruction);
  void freshLocal(Runner& runner, std::uint32_t base, std::uint32_t byte);
  /// Whether a loop can go into another round, by what is known of the values of cells.
  bool isPossible(Graph::Bool condition);
  RoundsLeft beyondLimit(Graph::Bool condition, bool isFirst);

  Node value(const Place& place) { return store_.value(place); }
  Node halted() const { return machine_.halted.node; }
  Node faulted() const { return machine_.faulted.node; }
  Node start(const Place& place);
  TransitionSystem system();
  ToldFacts toldFacts();

  Graph graph;
  TimeModel time;
  std::vector<HazardRecord> hazards;
  std::vector<Approximation> approximations;
  std::vector<ExternalInput> externals;
  std::map<std::string, Node> deviceInputs;
  std::vector<TickSite> tickSites;
  std::vector<EventSite> eventSites;
  std::vector<SiteInput> siteInputs;
  std::vector<KeptCell> keptCells;                    ///< instead of constants, where a trail is followed
  std::vector<Node> listFacts;                        ///< the same: that lists of values which it tells are complete
  std::map<std::uint32_t, std::vector<Node>> visits;  ///< by instruction that has a site: guards of its executions
  std::vector<Place> places() const { return store_.places(); }
  const std::vector<Cell>& cells() const { return store_.cells(); }
  const std::vector<BitWrite>& bitWrites() const { return store_.bitWrites(); }
  /// What the run has learned: footprints, and the state variables that pointers are made of.
  const Footprints& footprints() const { return footprints_; }
  const std::set<Node>& pointerCells() const { return pointerCells_; }
  /// Whether what the run did depends on the values of cells that it was told.
  bool reliesOnValues() const { return !pointerCells_.empty() || prunesLoops_ || restsOnEntries_; }
  /// What the cells that pointers of routines are made of hold where routines can come (RoutineEffects::entry).
  const EntryValues& entryValues() const { return entryValues_; }
  /// Values of nodes that follow from it.
  const VariableValues& keptValues() const { return keptValues_; }
  bool hasEvents() const { return !attachments_.empty(); }
  /// No more of the program follows: what is touched from now on has never been written.
  void close() { isClosed_ = true; }
  /// The sample of an analog input, or what was read of it last (Choice::AnalogSampling), by word address. What the
  /// program does not read is sampled for whoever asks.
  Node analogInput(std::uint32_t byte);
  const std::map<std::uint32_t, Node>& analogInputs() const { return analog_; }
  const DeviceWrites& devices() const { return devices_; }
  /// Where pointers to tables of devices led in this run.
  const TableTargets& tableTargets() const { return tableTargets_; }

 private:
  Cell cellAt(const Place& place) override;
  Cell newCell(const Place& place);
  Node atScan(const Cell& cell) override;
  Node startOfCell(const Place& place);
  Node localByte(std::uint32_t entry, std::uint32_t byte) override;
  void accessed() override;
  Graph::Bits external(const ExternalSite& site, int width) override;
  void report(Hazard hazard, Graph::Bool condition, const Instruction* place) override;
  using Evaluation = ValueSet (ValueEvaluator::*)(Node, Node, std::size_t);
  ValueSet pointerValues(Node pointer, Node guard, Evaluation evaluation = &ValueEvaluator::valuesOf);
  ValueSet whereItLeads(Node pointer, Node guard);
  void tellList(Graph::Bool isIn);
  std::vector<Node> decidedFacts();
  void addKnownValues(ToldFacts& told);
  Graph::Bool targets(Machine<Graph>& machine, Graph::Bits pointer, Width width, Ref<Graph>& ref) override;
  std::optional<std::vector<std::uint64_t>> locations(Machine<Graph>& machine, Graph::Bits location) override;
  std::optional<std::vector<std::uint64_t>> locationsInBlock(Machine<Graph>& machine, Graph::Bits location,
                                                             Width width) override;
  Graph::Bits unresolved(Machine<Graph>& machine, int width) override;
  void havoc(Machine<Graph>& machine) override;
  void meetUnknownErrors(Machine<Graph>& machine, bool isWrite);
  void signalled(Signal which, std::uint32_t index, Graph::Bool guard) override;
  void havocBy(const Machine<Graph>& machine, const Approximation& cause);

  void run();
  void endOfScan();
  void boundary(Runner& runner, std::uint32_t instruction);
  void tick(std::uint32_t instruction, std::uint32_t visit);
  std::set<std::uint32_t> timersTouchedBy(std::uint32_t instruction) const;
  bool needsTicks(std::uint32_t instruction) const;
  bool mayInterrupt(int event, std::uint32_t instruction) const;
  std::uint32_t visitOf(std::uint32_t instruction);
  // scan_interrupts.cpp
  void leaveOutNesting();
  void beginEvents();
  void endEvents();
  void interrupts(Runner& runner, std::uint32_t instruction);
  void noteAttachment(const Instruction& instruction);
  void noteLock(int event);
  void restartTimed(int event, const Instruction& instruction, Graph::Bool runs);
  void timerReached(const TimerUse& use, Graph::Bool reached);
  void queueOne(int event, Graph::Bool condition);
  void noteEndOfReception(const Instruction& instruction);
  struct Round;
  void runEvent(Runner& runner, Round& round, int event);
  void noteEntry(Round& round, Graph::Bool mayCome);
  void tellKept(const Round& round);
  void runRoutines(Runner& runner, Round& round, int event, Graph::Bool fires);
  void serveLeft(Runner& runner, Round& round, int event);
  void moreRuns(Runner& runner, Round& round);
  void passTime(Round& round);
  void followEdges(int event);
  void followOverflow(Round& round);
  void endOverflow(const Round& round);
  Graph::Bool occurs(Round& round, int event);
  Graph::Bool isReady(int event);
  Graph::Bool isLockedOut(int event);
  Graph::Bool isDue(std::uint32_t timer);
  Graph::Bool isNextDue(std::uint32_t timer);
  Graph::Bits periodOf(std::uint32_t timer);
  Graph::Bool isAttached(int event, int routine);
  Graph::Bool hasRoutine(int event);
  Graph::Bool interruptsEnabled();
  Graph::Bool here(Graph::Bool condition) { return graph.land(machine_.guard, condition); }
  Graph::Bool freely(std::string name, Graph::Bool use);
  Node anyOf(std::string name, int width);
  Approximation& estimate();
  void useEstimate(Graph::Bool used);
  Node state(std::string name, int width);
  void become(Node& place, Graph::Bool condition, Node value) {
    place = graph.make(Op::Ite, graph[place].width, condition.node, value, place);
  }
  void prepareTicks();
  void prepareWatched();
  bool isInput(const Place& place) const;
  bool isCount(const Place& place) const;
  Cell keeping(const Place& place, std::uint64_t value);
  std::optional<std::vector<std::uint64_t>> targetsOf(Node pointer, Node guard);
  Node init(const Place& place) const;
  bool isRetained(const Place& place) const;
  void constrainStart(const Place& place, Node node);
  bool isOfItsType(std::uint32_t offset) const;
  void constrainStartsByType();
  bool setsClock() const;
  bool isFixed(Choice choice) const { return !options_.coversAllReadings && options_.choices.isFixed(choice); }
  Node input(std::string name, int width);
  Node siteInput(int event, std::uint32_t instruction, int width);
  Approximation& approximate(const Instruction* place, std::string_view reason);
  void leaveOut(const Instruction* place, std::string_view reason, Graph::Bool condition);

  const Program& program_;
  const EncoderOptions options_;
  const CallContracts contracts_;
  const Plan& plan_;
  const MemoryLayout& layout_;
  const Knowledge& knowledge_;
  Concrete::Store initial_;
  Graph::Store store_;
  Machine<Graph> machine_;
  std::vector<Node> inputs_;
  std::vector<Node> constraints_;
  std::vector<Node> totalConstraints_;
  std::map<Place, Node> starts_;  ///< of all cells
  TableTargets tableTargets_;
  DeviceWrites devices_;
  std::vector<std::vector<std::size_t>> localEntries_;  ///< by entry: index in externals of each byte
  std::map<std::uint32_t, Node> analog_;
  Attachments attachments_;
  std::vector<int> events_;  ///< attached ones, by priority
  const RoutineEffects* effects_;
  EventStates eventStates_;
  bool isAfterEnable_ = false;        ///< ENI stands in front of this place
  Footprint tickKeys_;                ///< of all that the 1 ms clock moves
  std::set<std::uint32_t> iecCalls_;  ///< instructions that call an IEC timer
  Footprint watched_;                 ///< read in front of every instruction (EncoderOptions::watched)
  Footprints footprints_;
  std::uint32_t accesses_ = 0;  ///< since the clock was looked at
  Node consumed_ = noNode;      ///< ms of this scan that have reached the 1 ms timers
  int routine_ = -1;            ///< interrupt routine that runs
  bool isRecording_ = true;
  bool isClosed_ = false;
  std::optional<std::uint32_t> visit_;  ///< of the instruction at hand, once visitOf() was asked
  bool hasHavoc_ = false;
  bool hasPointers_ = false;  ///< the program has some, and interrupts
  bool prunesLoops_ = false;
  LoopWidening widening_;
  VariableValues known_, later_;
  std::set<Node> pointerCells_;
  EntryValues entryValues_;
  VariableValues keptValues_;  ///< of what routines have left
  bool restsOnEntries_ = false;
};

}  // namespace rungproof
