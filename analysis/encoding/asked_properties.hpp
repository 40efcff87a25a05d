// AskedProperties: the properties of a program as questions about its encoding. Each property's monitor becomes part of
// the transition system: its cells are state, its answer is the bad state of a question; assumptions and pulses are
// constraints. Covered by tests/prover.
#pragma once

#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "analysis/encoding/encoder.hpp"
#include "analysis/encoding/exact_reals.hpp"
#include "analysis/encoding/execution_record.hpp"
#include "analysis/property.hpp"

namespace rungproof {

/// The state variables that stand for one property's cells, in their order.
struct MonitorState {
  std::vector<Node> before;
  std::vector<Node> after;
};

/// A property with what became of it.
struct AskedProperty {
  Property property;
  Node answer = noNode;  ///< Monitor::evaluate() at the end of the scan (or at some instruction of it)
  MonitorState state;
};

class AskedProperties {
 public:
  /// Encodes the program with the properties' addresses and external ranges in mind. `goals` are what is asked;
  /// assumptions and pulses among `set` constrain all of them.
  /// record: told of each instruction that the final encoding comes to.
  AskedProperties(const Program& program, const PropertySet& set, const std::vector<Property>& goals,
                  EncoderOptions options, ExecutionRecord* record = nullptr);

  EncodedScan& encoding() { return *encoding_; }
  const std::vector<AskedProperty>& goals() const { return goals_; }
  const std::vector<AskedProperty>& assumptions() const { return assumptions_; }

  /// What is not exact: what the encoder left open, and REAL operations, which the bit-level engines take as any value.
  const std::vector<Approximation>& approximations() const { return approximations_; }

  /// The whole system; questions are those of the goals in their order, then the added ones.
  TransitionSystem system();
  /// A further question over nodes of the encoding, for built-in checks.
  void ask(std::string name, Node bad) { extra_.push_back({std::move(name), bad}); }
  /// What `value` (a node of the encoding) was in the scan before; 0 in the first scan.
  Node before(std::string name, Node value);
  /// The condition where the scan has an end (EncodedScan::faulted).
  Node atScanEnd(Node condition);
  /// Names of state variables that only measure time: their change does not count as a change of the program.
  bool isTimeState(Node variable) const;

 private:
  struct Leaf;
  void addMonitor(AskedProperty& asked);
  void assumeOfEachRead(AskedProperty& assumed);
  void chooseTimeBases(const PropertySet& set, const std::vector<Property>& goals);
  Property inItsBase(const Property& property) const;
  Node leaf(const Operand& operand, int width);
  void approximateReals(const Instruction* place, std::size_t first, std::size_t end);

  std::unique_ptr<EncodedScan> encoding_;
  std::vector<AskedProperty> goals_;
  std::vector<AskedProperty> assumptions_;
  std::vector<StateVariable> cells_;
  std::vector<Node> timeCells_;
  std::unordered_map<std::string, int> timeBases_;  ///< by property name; of those with clocks
  std::vector<Question> extra_;
  std::vector<Approximation> approximations_;
};

/// What must be reachable so that the property does not hold for want of occasions, as a reach property; nothing for
/// plain invariants.
std::optional<Property> premiseOf(const Property& property);

}  // namespace rungproof
