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
#include "ir/scan_cycle.hpp"

namespace rungproof {

/// What earlier runs have found out about the program.
struct Knowledge {
  std::map<Place, ValueSet> values;          ///< of cells at the start of scans, as far as they are known
  std::vector<Place> firstScans;             ///< 1 at the start of the first scan only
  std::map<Place, ValueSet> later;           ///< of pointer cells at the start of all scans but the first
  std::map<Place, std::uint64_t> constants;  ///< cells that keep one value in all runs
  Footprints footprints;
  TableTargets tables;          ///< of devices, where pointers lead to them
  bool followsPointers = true;  ///< false: pointers that are not constant stay unresolved
  bool isFinal = false;         ///< nothing is left to be learned
};

/// Events that the program attaches, with the routines they may have.
using Attachments = std::map<int, std::set<int>>;
Attachments attachmentsOf(const Plan& plan);

class ScanEncoding final : private CellSource, private Graph::Listener {
 public:
  using Runner = Scan<Graph, ScanEncoding>;

  ScanEncoding(const Program& program, const EncoderOptions& options, const Plan& plan, const MemoryLayout& layout,
               const Knowledge& knowledge);

  /// Hooks of the walk over the program.
  void before(Runner& runner, const FlowStep& step);
  void callWithoutBody(Runner& runner, const Instruction& instruction);
  void freshLocal(Runner& runner, unsigned frame, std::uint32_t byte);
  /// Whether a loop can go into another round, by what is known of the values of cells.
  bool isPossible(Graph::Bool condition);
  RoundsLeft beyondLimit(Graph::Bool condition);

  Node value(const Place& place) { return store_.value(place); }
  Node start(const Place& place);
  TransitionSystem system();

  Graph graph;
  TimeModel time;
  std::vector<HazardRecord> hazards;
  std::vector<Approximation> approximations;
  std::vector<ExternalInput> externals;
  std::vector<TickSite> tickSites;
  std::vector<EventSite> eventSites;
  std::vector<KeptCell> keptCells;                    ///< instead of constants, where a trail is followed
  std::map<std::uint32_t, std::vector<Node>> visits;  ///< by instruction that has a site: guards of its executions
  std::vector<Place> places() const { return store_.places(); }
  const std::vector<Cell>& cells() const { return store_.cells(); }
  const std::vector<BitWrite>& bitWrites() const { return store_.bitWrites(); }
  /// What the run has learned: footprints, and the state variables that pointers are made of.
  const Footprints& footprints() const { return footprints_; }
  const std::set<Node>& pointerCells() const { return pointerCells_; }
  /// Whether what the run did depends on the values of cells that it was told.
  bool reliesOnValues() const { return !pointerCells_.empty() || prunesLoops_; }
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
  ValueSet pointerValues(Node pointer, Node guard);
  Graph::Bool targets(Machine<Graph>& machine, Graph::Bits pointer, Width width, Ref<Graph>& ref) override;
  Graph::Bits unresolved(Machine<Graph>& machine, int width) override;
  void havoc(Machine<Graph>& machine) override;
  void havocBy(const Machine<Graph>& machine, const Approximation& cause);

  void run();
  void endOfScan();
  void boundary(Runner& runner, std::uint32_t instruction);
  void tick(std::uint32_t instruction, std::uint32_t visit);
  void interrupts(Runner& runner, std::uint32_t instruction, std::uint32_t visit);
  bool needsTicks(std::uint32_t instruction) const;
  bool mayInterrupt(int event, std::uint32_t instruction) const;
  void prepareTicks();
  void prepareWatched();
  bool isInput(const Place& place) const;
  Cell keeping(const Place& place, std::uint64_t value);
  std::optional<std::vector<std::uint64_t>> targetsOf(Node pointer, Node guard);
  Node init(const Place& place) const;
  Node input(std::string name, int width);
  Approximation& approximate(const Instruction* place, std::string_view reason);

  const Program& program_;
  const EncoderOptions& options_;
  const Plan& plan_;
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
  std::vector<int> events_;           ///< attached ones, by priority
  std::set<std::uint32_t> tickKeys_;  ///< footprint keys of all 1 ms timers
  Footprint watched_;                 ///< read in front of every instruction (EncoderOptions::watched)
  Footprints footprints_;
  std::uint32_t accesses_ = 0;  ///< since the clock was looked at
  Node consumed_ = noNode;      ///< ms of this scan that have reached the 1 ms timers
  int routine_ = -1;            ///< interrupt routine that runs
  bool isRecording_ = true;
  bool isClosed_ = false;
  bool hasHavoc_ = false;
  bool prunesLoops_ = false;
  LoopWidening widening_;
  VariableValues known_, later_;
  std::set<Node> pointerCells_;
};

}  // namespace rungproof
