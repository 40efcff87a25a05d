// One body of a drawn block to networks of the program: results are computed in their order, what feeds them before
// them, everything once. Power becomes elements of a Drawing (ir/drawing.hpp), numbers go through operands. Contacts
// and blocks that detect edges become EU and ED, which see none in the first scan (001:2763), where IEC 61131-3 would
// see a rising one if the signal is 1 at the start.
// Tested by tests/graphical/plcopen_test.cpp; behaviour by tests/graphical/agreement_test.cpp.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "frontend/graphical/drawn_build.hpp"
#include "frontend/graphical/drawn_circuit.hpp"
#include "ir/drawing.hpp"

namespace rungproof {

/// What an output delivers.
struct DrawnValue {
  enum class Kind : std::uint8_t { Nothing, Power, Data } kind = Kind::Nothing;
  Wire wire;        ///< Power
  Operand operand;  ///< Data; type None: an integer constant that takes any type
  IecType type = IecType::None;

  bool isPower() const { return kind == Kind::Power; }
  bool isData() const { return kind == Kind::Data; }
};

/// Kinds of arithmetic that the S7-200 has (001:4786).
enum class Arithmetic : std::uint8_t { Int, DInt, Real };

class DrawnLowering {
 public:
  DrawnLowering(DrawnBuild& build, DrawnCopy& copy, Pou& pou)
      : build_(build), sink_(build.sink()), copy_(copy), pou_(pou) {}

  /// Appends the networks of one drawing to the block.
  void body(const DrawnNetwork& network, Form form);

 private:
  friend class DrawnFunctions;
  friend class DrawnBlocks;
  struct State {
    bool isBusy = false, isDone = false;
    std::vector<std::pair<std::string, DrawnValue>> outputs;
    bool isWritten = false;  ///< an output whose block wrote its variable already
  };

  // elements
  Wire rail() const { return {0, false}; }
  static Wire inverted(Wire wire) { return {wire.from, !wire.negated}; }
  /// The opposite; a variable that was just read for one reader becomes a negated contact.
  Wire negation(Wire wire);
  bool isTrue(Wire wire) const { return wire.from == 0 && !wire.negated; }
  bool isFalse(Wire wire) const { return wire.from == 0 && wire.negated; }
  Wire add(Shape shape, std::string_view mnemonic, Operands operands, std::vector<Wire> inputs);
  Wire contact(const Operand& bit, Wire input);
  Wire compare(std::string_view mnemonic, const Operand& a, const Operand& b, Wire input);
  Wire edge(Wire input, DrawnEdge kind);
  Wire gate(Shape shape, std::vector<Wire> inputs);
  /// Lines that meet: those that part from one line at the same place meet again before they meet the others.
  Wire parallel(std::vector<Wire> wires, std::size_t shared);
  /// The contacts in series that end in this wire, from the left rail on.
  std::vector<std::uint32_t> seriesOf(Wire wire) const;
  Wire box(std::string_view mnemonic, Operands operands, Wire enable);
  void coil(std::string_view mnemonic, Operands operands, Wire input) {
    add(Shape::Coil, mnemonic, std::move(operands), {input});
  }
  void assign(const Operand& bit, Wire input) { coil("=", {bit}, input); }
  /// The power through a bit of memory, for where lines of power cannot go.
  Wire throughMemory(Wire input);

  // values
  static DrawnValue power(Wire wire);
  static DrawnValue data(Operand operand, IecType type);
  DrawnValue readPlace(const VariablePlace& place, const DrawnElement& element);
  DrawnValue literalValue(const IecLiteral& literal) const;
  /// Variable, pin of an instance, address or literal; reports what it does not find.
  std::optional<VariablePlace> resolve(std::string_view text, const DrawnElement& element);
  std::optional<VariablePlace> memberOf(DrawnCopy& copy, std::string_view pin);
  DrawnValue expression(std::string_view text, const DrawnElement& element);
  DrawnValue input(const DrawnElement& element, const DrawnPin& pin);
  /// The power at a pin; reports a pin that is open or carries a number.
  std::optional<Wire> powerAt(const DrawnElement& element, const DrawnPin* pin, std::string_view name);
  DrawnValue outputOf(int i, std::string_view pin, const DrawnElement& asker);
  void moveTo(const VariablePlace& target, const DrawnValue& value, Wire enable, const DrawnElement& element);
  /// The value as an operand of that kind of arithmetic, widened through a temporary where it is narrower.
  std::optional<Operand> widened(const DrawnValue& value, Arithmetic kind, Wire enable, const DrawnElement& element);
  Operand temporary(IecType type);
  static Operand lowPart(Operand operand, Width width);

  // elements of the drawing
  bool evaluate(int i);
  bool evaluateContact(int i, const DrawnElement& element);
  void coilOf(const DrawnElement& element);
  void outVariable(int i, const DrawnElement& element);
  void connector(int i, const DrawnElement& element);
  bool block(int i, const DrawnElement& element);
  void jump(const DrawnElement& element);
  void result(int i);
  std::optional<Wire> joinedInput(const DrawnElement& element);

  // networks
  void begin();
  std::vector<int> appendNetworks(Form form);
  void finish(Form form);
  void appendNetwork(std::vector<std::uint32_t> members, Form form, int circuit);
  std::vector<std::vector<std::uint32_t>> pieces() const;
  void reportIdle();
  int labelNumber(const std::string& name);

  DrawnBuild& build_;
  DrawnSink& sink_;
  DrawnCopy& copy_;
  Pou& pou_;
  const DrawnNetwork* network_ = nullptr;
  DrawnCircuit* circuit_ = nullptr;
  std::vector<State> states_;
  Drawing drawing_;
  std::vector<std::uint32_t> place_;  ///< by element of the drawing: its index in its network
  std::vector<int> owner_;            ///< by element of the drawing: the drawn element it comes from
  std::uint32_t fresh_ = 0;           ///< contact that was just read and has no reader yet
  int current_ = 0;                   ///< drawn element that is being computed
  int depth_ = 0;
  std::vector<bool> damaged_;
  std::vector<bool> idle_;  ///< circuits with elements that lead nowhere
  Operands connectorBits_;
  std::map<std::string, int> labels_;
  int nextNumber_ = 1;
};

}  // namespace rungproof
