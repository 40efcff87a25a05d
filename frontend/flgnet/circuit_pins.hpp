// What the parts of a circuit are and what their pins are for. Part of frontend/flgnet.
#pragma once

#include "frontend/flgnet/circuit.hpp"
#include "frontend/flgnet/part_table.hpp"

namespace rungproof::flgnet {

class CircuitPins {
 public:
  explicit CircuitPins(const Circuit& circuit) : circuit_(circuit) {}

  struct Fault {
    std::size_t part;
    std::string message;
  };
  /// Pins that a part does not have or needs and lacks, negations beside inputs, values that go from part to part.
  std::vector<Fault> faults() const;

  std::size_t size() const { return circuit_.parts.size(); }
  const Part& part(std::size_t i) const { return circuit_.parts[i]; }
  Element elementOf(std::size_t i) const;
  /// Its row in the table of boxes; nullptr: no box.
  const s7300::FbdBox* box(std::size_t i) const { return boxOf(part(i).name, part(i).type); }
  bool isCall(std::size_t i) const { return part(i).callee.has_value() || !iecBlock(part(i).name).empty(); }
  bool isCompare(std::size_t i) const { return !relationOf(part(i).name).empty(); }
  bool isGate(std::size_t i) const;
  /// An S5 timer or counter as a box.
  bool isTimerOrCounter(std::size_t i) const;
  /// EN is a jump around what it does.
  bool jumps(std::size_t i) const { return isCall(i) || (box(i) != nullptr && !isTimerOrCounter(i)); }

  /// All that it can have but a call, in their order.
  std::vector<std::string> inputPins(std::size_t i) const;
  std::vector<std::string_view> outputPins(std::size_t i) const;
  /// An operand stands there, not the flow.
  bool isValuePin(std::size_t i, std::string_view pin) const;
  /// The output that the flow leaves by, of a call the one beside its parameters.
  std::string_view flowOutput(std::size_t i) const;
  /// A string begins there without a parenthesis.
  bool isLeading(std::size_t i, std::string_view pin) const;
  /// Power, or the constant TRUE.
  static bool isTrue(const Pin& pin);

 private:
  void check(std::size_t i, std::vector<Fault>& faults) const;
  void checkInputs(std::size_t i, std::vector<Fault>& faults) const;
  std::vector<std::string> neededPins(std::size_t i) const;

  const Circuit& circuit_;
};

inline constexpr std::string_view enablePin = "en", enabledPin = "eno";
std::string inSmallLetters(std::string_view text);

}  // namespace rungproof::flgnet
