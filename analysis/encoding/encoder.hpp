// Encoder: the exact transition system of one scan of a program. It runs the templated scan once over graph nodes and
// gathers what the run asked for and met: state and inputs, external values with their places, hazards, writes to
// single bits, and everything it could only approximate.
//
// A run is a sequence of scans from power-up. It ends with the scan in which STOP or a fatal error ends the program;
// a constraint says that each scan starts in RUN.
// Covered by tests/encoder/encoder_test.cpp and tests/differential.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "analysis/encoding/symbolic_store.hpp"
#include "analysis/encoding/time_model.hpp"
#include "analysis/encoding/told_facts.hpp"
#include "analysis/encoding/trail.hpp"
#include "analysis/graph/transition_system.hpp"
#include "analysis/property.hpp"
#include "engine/scan_script.hpp"
#include "engine/start_up.hpp"
#include "ir/machine/choices.hpp"
#include "ir/machine/plan.hpp"

namespace rungproof {

/// Bytes `first` to `last` of an area that a panel or the network may write before any scan: from bit `lowBit` of the
/// first one to bit `highBit` of the last one.
struct ExternalBytes {
  Area area = Area::V;
  std::uint32_t first = 0;
  std::uint32_t last = 0;
  std::uint8_t lowBit = 0;
  std::uint8_t highBit = 7;
};

struct EncoderOptions {
  Choices choices;
  bool coversAllReadings = false;  ///< those of fixed choices too, to see what depends on them
  TimeRange time;
  bool initialRetentive = false;                           ///< retentive cells start with any value
  std::optional<std::vector<RetentiveRange>> retentive{};  ///< those of the system block; nothing: the CPU's default
  std::vector<ExternalBytes> externals;
  Operands observed;  ///< direct operands that properties read: they shape the state variables
  /// What properties say of one moment: perhaps any number of interrupts keeps it.
  std::vector<Expr> statements{};
  /// By Instruction::id: what cannot reach any question and is not encoded (analysis/unread/cone_of_influence.hpp).
  std::vector<bool> isLeftOut;
  /// What blocks without text write is as much as their contract says (ir/s7200/call_contract.hpp); false: anything.
  bool followsContracts = false;
  bool interrupts = true;
  bool interruptsInside = true;  ///< false: events come between scans only
  int eventPasses = 2;  ///< times that each event is let in at one place; what more of them can do is estimated
  int loopLimit = 256;  ///< rounds of a backward jump that are followed
  std::size_t stepLimit = 50000;  ///< instructions of one scan, loops unrolled, after which no loop is followed further
  /// Asked now and then while the program is encoded; throws whatever shall end it (proof_watch.hpp).
  std::function<void()> interruption;
  /// Left or followed by the final encoding; may be missing.
  std::shared_ptr<Trail> trail;
  /// What properties read in front of every instruction: interrupts and 1 ms ticks that write it are let in everywhere.
  Operands watched;
  /// Called in front of every instruction that may run, for properties that hold at every instruction.
  std::function<void(Machine<Graph>&, const Instruction&)> atInstruction;
};

/// Something that can go wrong: `condition` ranges over the state at the start of the scan and its inputs.
struct HazardRecord {
  Hazard hazard;
  Node condition;
  const Instruction* place;  ///< nullptr: not at an instruction
};

/// What is not exact, and where.
struct Approximation {
  const Instruction* place;  ///< nullptr: the whole program
  std::string reason;
  /// Nodes that may have more values than on the machine: a run may then have no counterpart there, and proofs hold.
  /// A property whose cone has none of them does not depend on it.
  std::vector<Node> carriers{};
  /// Scans in which this is 1 are not followed to their end: no proof holds unless it can never be 1. noNode: none.
  Node leftOut = noNode;
  /// 1 in scans that use values of the carriers: without such scans a run is exact. noNode: not known.
  Node used = noNode;
};

/// An external value, in the order in which the scan asks; asked for only where `guard` holds.
struct ExternalInput {
  ExternalSite site;
  Node node;  ///< noNode: asked for but used nowhere
  int width;
  Node guard;
};

/// A place in the scan at which ticks or interrupts can come: in front of one execution of an instruction.
struct BoundarySite {
  std::uint32_t instruction;  ///< Instruction::id, or ScanPlace::afterProgram
  std::uint32_t visit;        ///< index in EncodedScan::visits(instruction)
  Node guard;                 ///< whether the scan comes here
};
struct TickSite {
  BoundarySite where;
  Node ticks;  ///< of 1 ms, 16 bits
};
struct EventSite {
  BoundarySite where;
  int event;
  Node fires;   ///< the event comes and is attached, or its routine runs out of the queue
  Node waited;  ///< the latter
};

/// A free input of a place inside the scan: whether an event comes there, or how many ms have passed.
struct SiteInput {
  static constexpr int ticks = -1;
  int event;                  ///< ticks: ms
  std::uint32_t instruction;  ///< as in BoundarySite
  Node node;
};

/// A bit or byte that a device writes at the start of the scan where `guard` holds.
struct DeviceWrite {
  Operand operand;
  Node guard;
  Node value;
};

/// One scan as a transition system, with the meaning of its variables.
class EncodedScan {
 public:
  EncodedScan(const Program& program, const EncoderOptions& options);
  ~EncodedScan();
  EncodedScan(EncodedScan&&) noexcept;
  EncodedScan& operator=(EncodedScan&&) noexcept;

  Graph& graph() const;
  const Plan& plan() const;
  TimeModel& time() const;
  const EncoderOptions& options() const;

  /// Whether the CPU and its blocks have that place; the others do not ask for places that it does not have.
  bool holds(const Place& place) const;
  /// Value of a direct operand at the end of the scan, `width` bits; T and C by width. AI: the
  /// sample.
  Node atEnd(const Operand& operand, int width);
  Node atEnd(const Place& place);
  /// Value at the start of the scan, before inputs act.
  Node atStart(const Place& place);
  /// Whether this is the first scan.
  Node firstScan() const;
  /// Whether STOP in the main program or a fatal error ends the program in this scan; a fatal error: then the scan has
  /// no end, nothing is written and no property is asked about it (001:13906-13910).
  Node halted() const;
  Node faulted() const;

  /// State, inputs and constraints of all that has been touched up to now. Call after the last atEnd().
  TransitionSystem system();

  const std::vector<HazardRecord>& hazards() const;
  const std::vector<BitWrite>& bitWrites() const;
  const std::vector<Approximation>& approximations() const;
  const std::vector<ExternalInput>& externals() const;
  /// The samples of analog inputs by word address; with Choice::AnalogSampling = each-read what was read last.
  const std::map<std::uint32_t, Node>& analogInputs() const;
  /// Inputs that say what devices do, by name; the names tell the request and its addresses.
  const std::map<std::string, Node>& deviceInputs() const;
  /// What devices may write at the start of the scan.
  const std::vector<DeviceWrite>& deviceWrites() const;
  const std::vector<TickSite>& tickSites() const;
  const std::vector<EventSite>& eventSites() const;
  /// The inputs of these places, in the order of the scan.
  const std::vector<SiteInput>& siteInputs() const;
  /// All places of tick and event sites, and the guards of the executions of an instruction in the order of the scan.
  std::vector<const BoundarySite*> boundaries() const;
  const std::vector<Node>& visits(std::uint32_t instruction) const;
  /// Places whose values at the start of a scan are inputs (I, external memory, status written by devices) or state.
  const std::vector<Cell>& cells() const;
  /// Of an encoding that follows a trail.
  const std::vector<KeptCell>& keptCells() const;
  /// The same: what it was told, of all that has been touched and asked up to now. Adds nodes to the graph.
  ToldFacts toldFacts() const;
  /// Everything that has been read or written up to now except local memory, as runs of bits and registers.
  std::vector<Place> places() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace rungproof
