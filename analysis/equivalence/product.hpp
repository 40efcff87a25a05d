// Two programs side by side as one transition system: the same physical inputs, the same scan lengths, each its own
// memory. Inputs are paired by address (AddressPairs), what happens inside a scan by instructions that stand for each
// other (ProgramMatch): the same immediate read in the same place of matched networks gives the same value. Undefined
// local memory, stack levels and registers are the same where equal networks read them (sharedUndefinedReads names what
// an equality rests on); everything undefined is the same in one and the same program, and else each program's own.
//
// NEW's states can be merged with those of OLD that they always equal, which equivalence.cpp finds out.
// Tested by tests/equivalence.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "analysis/bits/bit_blast.hpp"
#include "analysis/encoding/asked_properties.hpp"
#include "analysis/equivalence/device_requests.hpp"
#include "analysis/equivalence/memory_relations.hpp"
#include "analysis/equivalence/network_match.hpp"
#include "analysis/equivalence/pulse_drive.hpp"
#include "analysis/equivalence/side_copy.hpp"
#include "analysis/unread/unread_code.hpp"

namespace rungproof {

/// What the manual leaves undefined until the program has written it, and no stimulus gives.
constexpr bool isUndefinedRead(External kind) {
  return kind == External::LocalMemory || kind == External::StackBottom || kind == External::RegisterAtStart;
}

/// In front of an address of NEW where both programs are spoken of.
inline constexpr std::string_view newSidePrefix = "new.", oldSidePrefix = "old.";

inline Place bitPlace(const Address& address) {
  return memoryPlace(address.area, address.index / 8, Width::Bit, address.index % 8);
}
/// The i-th bit of a place of memory, from its most significant one.
inline Address bitOf(const Place& place, std::uint32_t i) {
  const std::uint32_t at = place.at + i;
  return {place.area, at / 8 * 8 + 7 - at % 8};
}

inline Place portPlace(std::uint32_t port) { return memoryPlace(Area::SM, portControl(port), Width::Byte); }

/// "Q0.0", "T37".
std::string nameOfBit(const Address& address);

/// One of the two programs, with its assumptions and external ranges.
struct Side {
  const Program* program = nullptr;  ///< what of it may be run
  PropertySet set;
  const UnreadCode* unread = nullptr;  ///< what was left out of it; nullptr: nothing
};

struct ProductOptions {
  EncoderOptions encoder;
  std::shared_ptr<Trail> trailBefore, trailAfter;  ///< left or followed by the encodings; may be missing
  AddressPairs pairs;
  Operands observed;  ///< addresses of OLD; empty: all outputs that either can write
  /// Assumptions that speak of both programs; an operand of NEW has a text that begins with newSidePrefix.
  std::vector<Property> assumptions;
  bool steadyInputs = false;   ///< an immediate read gives what the image has
  std::uint32_t latency = 0;   ///< NEW's outputs come so many scans later
  std::uint32_t settleMs = 0;  ///< a pair of outputs may differ for less than that without a break
};

/// A number of a pulse output: what PLS drives past the process image.
struct PulseSignal {
  std::uint32_t output = 0;
  PulseNumber number = PulseNumber::Mode;
};
/// "PLS0.width".
std::string nameOf(const PulseSignal& signal);
/// Those that are compared: of the generators that PLS in either program sets going, unless the map moves their outputs
/// or outputs come with latency.
std::vector<PulseSignal> comparedPulses(const Operands& observed, const AddressPairs& pairs, std::uint32_t latency,
                                        const UsedPulses& isUsed, const std::array<PulseForm, 2>& forms);

/// An output bit or word, and whether the two programs leave it different at the end of the scan (settling and latency
/// counted in).
struct ObservedBit {
  std::string name;                      ///< of OLD, else of NEW
  std::optional<Address> before, after;  ///< nothing: that program does not have it, it counts as 0 there
  Node differs = noNode;
  std::optional<PulseSignal> pulses{};  ///< in place of addresses
  std::uint32_t bits = 1;               ///< from the addresses on
};

/// A state of NEW equals its partner wherever a bit of OLD's state is `when`, at the starts of scans; by names of
/// states. Without `condition`: the relation of the name `state` holds.
struct PairCondition {
  std::string state, condition;
  bool when = true;
};

/// What may differ, for people.
std::string requestText(const struct RequestDifference& request, const Program& before, const Program& after);

/// Whether outputs differ, then whether one program stops alone.
std::vector<Question> outputQuestions(const struct JoinedSystem& joined);
/// "request3 differs": by the numbers of the requests.
std::vector<Question> requestQuestions(const struct JoinedSystem& joined);

/// That a device may be asked for different things.
struct RequestDifference {
  const Instruction* before;  ///< nullptr: OLD does not ask for that
  const Instruction* after;   ///< nullptr: NEW does not ask for that
  int port = -1;              ///< the port whose control byte differs at the end of the scan, without any request
  Node differs = noNode;
  int number = 0;  ///< the same in every system of these programs
};

/// The two programs with some of NEW's states merged into OLD's.
struct JoinedSystem {
  TransitionSystem system;  ///< without questions
  std::vector<ObservedBit> observed;
  Node stopDiffers = noNode;      ///< one program is stopped at the end of the scan, the other is not
  std::vector<Node> nextDiffers;  ///< by state of NEW: a merged one gets another value than OLD's; else noNode
  Node usesEstimates = noNode;    ///< 1 in scans that have no counterpart on the machine for certain; noNode: in none
  std::vector<Node> conditionStarts;        ///< by condition: it holds at the start of the scan, one of the constraints
  std::vector<Node> conditionBreaks;        ///< by condition: it does not hold at the end of the scan
  std::vector<RequestDifference> requests;  ///< without those that cannot be
  std::vector<Node> timeStates;             ///< they only measure time
  std::vector<Node> starts;        ///< by merged state of NEW: it starts with what OLD's starts with; 1 in scan 1
  std::shared_ptr<SideCopy> copy;  ///< of NEW into the system's graph
};

class ProgramProduct {
 public:
  /// `match` is kept by reference.
  ProgramProduct(const Side& before, const Side& after, const ProgramMatch& match, const ProductOptions& options);

  std::size_t newStateCount() const { return newSystem_.states.size(); }
  /// Whether the state of NEW stands for something of OLD and starts as that does.
  bool isMergeable(std::size_t newState) const { return partners_[newState].start != noNode; }
  /// By state of NEW: its name, which is "" for what only the encoding as it is written has (KeptCell).
  std::vector<std::string> newStateNames() const;
  /// `isMerged`: by state of NEW; others than mergeable ones do not count. `isOneScan`: NEW's other states have any
  /// value at the start of each scan, which shows what holds whatever they are. `conditions` hold at the start of each
  /// scan.
  JoinedSystem merged(const std::vector<bool>& isMerged, bool isOneScan,
                      const std::vector<PairCondition>& conditions = {});
  /// Whether the pulse outputs get the same commands in every scan, as far as states that are merged show it: PLS
  /// drives its outputs past the process image.
  bool pulsesCorrespond(const std::vector<bool>& isMerged);
  /// Undefined values that decide outputs and are taken to be the same for both programs, in OLD; after merged().
  std::vector<ExternalSite> sharedUndefinedReads();
  /// By output, then RUN: it depends on what a device does for a request, which is the same for both programs.
  std::vector<bool> dependsOnDevices(const JoinedSystem& joined);
  /// States of OLD that are one bit.
  std::vector<std::string> oldBitNames() const;
  /// Relations that may hold between the memories of two families.
  std::vector<PairCondition> relationConditions() const;

  /// What a run of `asked`, made from a merged system, is for one of the two programs.
  WordTrace oldTrace(const TransitionSystem& asked, const WordTrace& trace);
  WordTrace newTrace(const JoinedSystem& merged, const TransitionSystem& asked, const WordTrace& trace);
  AskedProperties& oldSide() { return old_; }
  AskedProperties& newSide() { return new_; }
  const TransitionSystem& oldSystem() const { return oldSystem_; }
  const TransitionSystem& newSystem() const { return newSystem_; }

 private:
  struct Output {
    std::optional<Address> before, after;
    Node oldValue = noNode, newValue = noNode;  ///< each of its own graph; noNode: 0
    std::optional<PulseSignal> pulses{};
    std::uint32_t bits = 1;
  };
  /// What of OLD stands for a state of NEW; noNode: nothing.
  struct Partner {
    Node start = noNode;
    Node next = noNode;
    bool isWorld = false;  ///< the same for both whatever they do: time, and what the manual leaves open
  };

  void collectOutputs();
  void addPulses();
  void addOutput(std::set<std::pair<Area, std::uint32_t>>& known, const Address& before);
  void findPartners();
  void replaceCells(SideCopy& copy);
  void replaceExternals(SideCopy& copy);
  void replaceSites(SideCopy& copy);
  void addConditions(JoinedSystem& result, const std::vector<PairCondition>& conditions);
  void addRelations(JoinedSystem& result, const std::vector<PairCondition>& conditions);
  bool isTrueAtFirst(Node relation) const;
  void startAlike(JoinedSystem& result, Node before, Node after);
  bool isSameProgram(const Side& before, const Side& after) const;
  void replaceEstimates(SideCopy& copy, const std::vector<bool>& isMerged);
  void noteEstimates(JoinedSystem& result);
  void compareRequests(JoinedSystem& result);
  std::vector<std::uint32_t> usedPorts();
  void holdInputs(JoinedSystem& result);
  void findClocks();
  void holdClocks(JoinedSystem& result);
  void assume(JoinedSystem& result);
  Node assumedLeaf(SideCopy* copy, const Operand& operand, int width);
  void compareOutputs(JoinedSystem& result);
  Node delayed(JoinedSystem& result, Node value, const std::string& name);
  Node settled(JoinedSystem& result, Node differs, const std::string& name);
  std::optional<Place> oldRegister(const Place& newPlace);
  Node oldValue(const Place& newPlace, bool atEnd);
  bool isStatusOfOld(const Place& newPlace) const;
  bool isOldInput(const Place& newPlace);
  bool isSharedPlace(const Place& newPlace);
  bool startsAlike(Node oldStart, const StateVariable& newState) const;
  static WordTrace sideTrace(const std::vector<Node>& states, const std::vector<Node>& inputs,
                             const TransitionSystem& asked, const WordTrace& trace);

  const ProductOptions options_;
  const ProgramMatch& match_;
  std::set<std::uint32_t> sameInstructions_;      ///< of NEW, in networks that OLD has too
  std::map<Node, ExternalSite> sharedUndefined_;  ///< by nodes of OLD's graph
  RequestRecord oldRequests_, newRequests_;       ///< the encodings tell them
  AskedProperties old_, new_;
  TransitionSystem oldSystem_, newSystem_;
  RelationCandidates relations_;
  std::vector<Output> outputs_;
  std::vector<std::pair<Node, Node>> clocks_;         ///< inputs of OLD's graph that show what NEW has in SMB0
  bool isSame_ = false;                               ///< the same instructions in the same order
  std::array<PulseForm, 2> pulseForms_{};             ///< of OLD and of NEW
  std::set<std::pair<Area, std::uint32_t>> oldBits_;  ///< bits of memory that OLD's scan touches
  std::set<Node> kept_;                               ///< states of NEW that keep their value
  Node firstScan_ = noNode;
  Node oldRuns_ = noNode, newRuns_ = noNode;  ///< in RUN at the end of the scan
  std::vector<Partner> partners_;             ///< by state of NEW
};

}  // namespace rungproof
