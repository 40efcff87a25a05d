// Parts are prepared before a string begins: what several read, and what jumps but does not stand at the beginning of
// the string, is run and kept in a bit first.
#include "frontend/flgnet/circuit_statements.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "frontend/flgnet/circuit_pins.hpp"
#include "frontend/flgnet/fragment.hpp"
#include "frontend/step7/cursor.hpp"

namespace rungproof::flgnet {

namespace {

using s7300::BoxFrame;
using s7300::FbdBox;
using step7::OperandForm;
using step7::Statement;

constexpr int mostNesting = 7;     // general knowledge
constexpr int mostInString = 200;  ///< parts that stand behind each other in one string, written by calls in calls

class CircuitWriter : private CircuitPins {
 public:
  CircuitWriter(const Circuit& circuit, BoxLabels& labels, SyntaxSink& sink, step7::NetworkSyntax& network)
      : CircuitPins(circuit),
        labelsAhead_(circuit.labels),
        labels_(labels),
        sink_(sink),
        network_(network),
        parts_(circuit.parts.size()) {
    for (std::size_t i = 0; i < size(); ++i) {
      const auto isReadOutput = [](const Output& output) { return output.readers > 0; };
      parts_[i].readOutputs = std::ranges::count_if(part(i).outputs, isReadOutput);
    }
  }

  bool write() {
    for (const step7::Name& label : labelsAhead_) {
      Statement statement;
      statement.label = label;
      statement.span = label.span;
      network_.statements.push_back(std::move(statement));
    }
    for (const Fault& found : faults()) fault(found.part, found.message);
    for (std::size_t i = 0; i < size() && !isDamaged_; ++i) {
      if (parts_[i].readOutputs > 0) continue;
      prepare(i, true);
      execute(i);
    }
    for (std::size_t i = 0; i < size() && !isDamaged_; ++i) {
      if (parts_[i].state == State::Waiting) fault(i, "the part reads what comes from itself");
    }
    return !isDamaged_;
  }

 private:
  enum class State : std::uint8_t { Waiting, Open, Prepared };
  struct Prepared {
    State state = State::Waiting;
    std::ptrdiff_t readOutputs = 0;
    int height = 0;  ///< parentheses that are open at once while its string is written
    int length = 0;  ///< parts behind each other in its string
  };
  using Net = std::pair<std::size_t, std::string>;

  void fault(std::size_t i, const std::string& message) {
    const std::string name = part(i).callee ? part(i).callee->symbol : part(i).name;
    sink_.report(Syntax::XmlStructure, part(i).span, fmt::format("part {}: {}", excerpt(name), message));
    isDamaged_ = true;
  }

  const Operand& valueAt(std::size_t i, std::string_view pin) const { return part(i).input(pin)->value; }

  // Statements ------------------------------------------------------------------------------------------------------

  Statement& emit(std::string mnemonic) {
    Statement& statement = network_.statements.emplace_back();
    statement.mnemonic = {std::move(mnemonic), span_};
    statement.span = span_;
    return statement;
  }
  void emit(std::string mnemonic, Operand operand) { emit(std::move(mnemonic)).operand = std::move(operand); }
  void emitText(std::string mnemonic, std::string_view operand) {
    emit(std::move(mnemonic), operandFrom(operand, span_).value_or(Operand{}));
  }
  void noOperation() { emitText("NOP", "0"); }

  Operand freshBit() {
    Operand operand;
    operand.form = OperandForm::Address;
    operand.place = step7::Place::L;
    operand.size = step7::Size::Bit;
    operand.number = bits_ / 8;
    operand.bit = static_cast<std::uint8_t>(bits_ % 8);
    operand.isBehindDeclared = true;
    operand.span = span_;
    ++bits_;
    return operand;
  }

  Operand freshLabel() {
    Operand operand;
    operand.form = OperandForm::Word;
    operand.span = span_;
    do operand.name = fmt::format("_{:03}", ++labels_.last);
    while (labels_.taken.contains(operand.name));
    return operand;
  }
  void mark(const Operand& label) { network_.statements.back().label = {label.name, span_}; }

  // Flow ------------------------------------------------------------------------------------------------------------

  /// Begins a string with what flows into the pin.
  void start(std::size_t i, const Pin& pin) {
    const bool isNegated = part(i).isNegated(pin.name);
    if (isTrue(pin)) return void(emit("SET"));
    if (const Operand* bit = operandOf(pin)) return emit(isNegated ? "AN" : "A", *bit);
    flow(pin.part, pin.from);
    span_ = part(i).span;
    if (isNegated) emit("NOT");
  }
  /// The same, nothing where it is power; whether anything stands there.
  bool startUnlessTrue(std::size_t i, const Pin* pin) {
    if (pin == nullptr || isTrue(*pin)) return false;
    start(i, *pin);
    return true;
  }
  /// Joins what flows into the pin to the string.
  void join(const std::string& letter, std::size_t i, const Pin& pin) {
    const std::string mnemonic = letter + (part(i).isNegated(pin.name) ? "N" : "");
    if (const Operand* bit = operandOf(pin)) return emit(mnemonic, *bit);
    emit(mnemonic + "(");
    if (isTrue(pin))
      emit("SET");
    else
      flow(pin.part, pin.from);
    span_ = part(i).span;
    emit(")");
  }
  const Operand* operandOf(const Pin& pin) const {
    if (pin.source == Pin::Source::Value && !isTrue(pin)) return &pin.value;
    if (pin.source != Pin::Source::Flow) return nullptr;
    const auto kept = kept_.find({pin.part, pin.from});
    return kept == kept_.end() ? nullptr : &kept->second;
  }

  /// A string whose result is the output of the part.
  void flow(std::size_t i, const std::string& pin) {
    const Part& p = part(i);
    span_ = p.span;
    switch (elementOf(i)) {
      case Element::Contact:
        startUnlessTrue(i, p.input("in"));
        return emit(p.isNegated("operand") ? "AN" : "A", valueAt(i, "operand"));
      case Element::EdgeContact: {
        const bool isJoined = startUnlessTrue(i, p.input("in"));
        if (isJoined) emit("A(");
        emit("A", valueAt(i, "operand"));
        emit(edgeOf(i), valueAt(i, "bit"));
        if (isJoined) emit(")");
        return;
      }
      case Element::Not: start(i, *p.input("in")); return void(emit("NOT"));
      case Element::EdgeBox: start(i, *p.input("in")); return emit(edgeOf(i), valueAt(i, "bit"));
      case Element::And:
      case Element::Or:
      case Element::Xor:
        for (const std::string& each : inputPins(i))
          join(elementOf(i) == Element::And ? "A" : elementOf(i) == Element::Or ? "O" : "X", i, *p.input(each));
        return;
      case Element::Coil: coil(i); return emit(p.isNegated("operand") ? "AN" : "A", valueAt(i, "operand"));
      case Element::SetCoil:
      case Element::ResetCoil:
      case Element::EdgeCoil: {
        const Operand bit = freshBit();
        start(i, *p.input("in"));
        emit("=", bit);
        emit("A", bit);
        coilBehind(i);
        return emit("A", bit);
      }
      case Element::SetReset:
      case Element::ResetSet: flipFlop(i); return emit("A", valueAt(i, "operand"));
      default: break;
    }
    if (isCompare(i)) return compare(i);
    if (isCall(i)) {
      callBlock(i, pin == enabledPin);
      if (pin != enabledPin) emit("A", outputBits_.at({i, pin}));
      return;
    }
    const FbdBox& row = *box(i);
    if (isTimerOrCounter(i)) {
      element(i, row);
      return emit("A", p.instance);
    }
    boxWithEnable(i, row, true);
  }

  std::string edgeOf(std::size_t i) const { return elementPart(part(i).name)->isFalling ? "FN" : "FP"; }

  void coil(std::size_t i) {
    start(i, *part(i).input("in"));
    if (part(i).isNegated("operand")) emit("NOT");
    emit("=", valueAt(i, "operand"));
  }
  /// What a coil does with the result of the string in front of it.
  void coilBehind(std::size_t i) {
    const Element element = elementOf(i);
    if (element == Element::EdgeCoil) emit(edgeOf(i), valueAt(i, "bit"));
    emit(element == Element::EdgeCoil ? "=" : element == Element::SetCoil ? "S" : "R", valueAt(i, "operand"));
  }

  void flipFlop(std::size_t i) {
    const bool resetWins = elementOf(i) == Element::SetReset;
    const auto act = [&](const char* pin, const char* mnemonic) {
      const Pin* input = part(i).input(pin);
      if (input == nullptr) return noOperation();
      start(i, *input);
      emit(mnemonic, valueAt(i, "operand"));
    };
    if (resetWins) act("s", "S");
    act(resetWins ? "r1" : "r", "R");
    if (!resetWins) act("s1", "S");
  }

  void compare(std::size_t i) {
    const bool isJoined = startUnlessTrue(i, part(i).input("pre"));
    if (isJoined) emit("A(");
    emit("L", valueAt(i, "in1"));
    emit("L", valueAt(i, "in2"));
    emit(fmt::format("{}{}", relationOf(part(i).name), compareSuffix(part(i).type)));
    if (isJoined) emit(")");
  }

  /// The statements of a row, separated by "; ".
  template <class Visit>
  static void eachStatement(std::string_view statements, Visit&& visit) {
    for (std::string_view rest = statements; !rest.empty();) {
      const std::string_view one = rest.substr(0, rest.find("; "));
      rest.remove_prefix(std::min(rest.size(), one.size() + 2));
      const std::size_t blank = one.find(' ');
      visit(one.substr(0, blank), blank == std::string_view::npos ? std::string_view() : one.substr(blank + 1));
    }
  }

  /// S5 timers and counters: inputs that are open do nothing.
  void element(std::size_t i, const FbdBox& row) {
    const Part& p = part(i);
    const Pin* input = nullptr;
    eachStatement(row.statements, [&](std::string_view mnemonic, std::string_view operand) {
      if (operand == "$BOX") return input == nullptr ? noOperation() : emit(std::string(mnemonic), p.instance);
      const std::string pin = inSmallLetters(operand.substr(1));
      if (mnemonic == "L") return emit("L", valueAt(i, pin));
      input = p.input(pin);
      if (input != nullptr) start(i, *input);
    });
    const bool isCounter = row.frame == BoxFrame::Counter;
    if (const Pin* set = p.input("s"); isCounter && set != nullptr) {
      start(i, *set);
      emit("L", valueAt(i, "pv"));
      emit("S", p.instance);
    } else if (isCounter) {
      noOperation();
    }
    if (const Pin* reset = p.input("r")) {
      start(i, *reset);
      emit("R", p.instance);
    } else {
      noOperation();
    }
    for (const auto& [load, pin] : {std::pair{"L", isCounter ? "cv" : "bi"}, {"LC", isCounter ? "cv_bcd" : "bcd"}}) {
      const Output* output = p.output(pin);
      if (output == nullptr || output->targets.empty()) {
        noOperation();
        continue;
      }
      emit(load, p.instance);
      for (const Operand& target : output->targets) emit("T", target);
    }
  }

  std::optional<Operand> jumpUnlessEnabled(std::size_t i) {
    if (!startUnlessTrue(i, part(i).input(enablePin))) return std::nullopt;
    Operand label = freshLabel();
    emit("JNB", label);
    return label;
  }
  void endOfJump(const std::optional<Operand>& label, bool scans) {
    if (scans)
      emitText("A", "BR");
    else if (label)
      noOperation();
    if (label) mark(*label);
  }

  void boxWithEnable(std::size_t i, const FbdBox& row, bool scans) {
    const std::optional<Operand> label = jumpUnlessEnabled(i);
    eachStatement(row.statements, [&](std::string_view mnemonic, std::string_view operand) {
      if (operand.empty()) return void(emit(std::string(mnemonic)));
      const std::string pin = inSmallLetters(operand.substr(1));
      if (mnemonic == "L") return emit("L", valueAt(i, pin));
      for (const std::string& each : {pin, pin + "1"}) {
        const Output* output = part(i).output(each);
        if (output == nullptr) continue;
        for (const Operand& target : output->targets) emit("T", target);
      }
    });
    if (row.frame == BoxFrame::Checked)
      emitText("AN", "OV");
    else
      emit("SET");
    emit("SAVE");
    emit("CLR");
    endOfJump(label, scans);
  }

  /// The block's own name of a pin.
  static std::string formalOf(const std::string& pin) { return pin == "ld" ? "LOAD" : pin; }

  void callBlock(std::size_t i, bool scans) {
    const Part& p = part(i);
    span_ = p.span;
    const std::optional<Operand> label = jumpUnlessEnabled(i);
    Statement call;
    call.mnemonic = {"CALL", span_};
    call.span = span_;
    call.hasArguments = true;
    if (p.callee) {
      call.operand.form = OperandForm::Symbol;
      call.operand.name = p.callee->symbol;
      call.operand.span = span_;
    } else {
      call.operand = *operandFrom(iecBlock(p.name), span_);
    }
    if (p.instance.form == OperandForm::Local)
      call.operand = p.instance;
    else
      call.instance = p.instance;
    const auto argument = [&](const std::string& pin, const Operand& actual) {
      call.arguments.push_back({{formalOf(pin), span_}, actual, span_});
    };
    for (const Pin& pin : p.inputs) {
      if (pin.name == enablePin || pin.source == Pin::Source::Open) continue;
      const auto bit = inputBits_.find({i, pin.name});
      argument(pin.name, bit == inputBits_.end() ? pin.value : bit->second);
    }
    std::vector<std::pair<Operand, const Output*>> copied;
    for (const Output& output : p.outputs) {
      if (output.name == enabledPin) continue;
      if (output.readers == 0 && output.targets.size() == 1) {
        argument(output.name, output.targets[0]);
      } else {
        const Operand bit = freshBit();
        outputBits_[{i, output.name}] = bit;
        argument(output.name, bit);
        copied.emplace_back(bit, &output);
      }
    }
    network_.statements.push_back(std::move(call));
    for (const auto& [bit, output] : copied) {
      for (const Operand& target : output->targets) {
        emit("A", bit);
        emit("=", target);
      }
    }
    endOfJump(label, scans);
  }

  // Order -----------------------------------------------------------------------------------------------------------

  /// Runs what the part reads and what cannot stand inside its string. `isAtStart`: no parenthesis is open there.
  /// A drawing may be any number of parts long, so what is open stands in a list.
  void prepare(std::size_t first, bool isAtStart) {
    struct Opened {
      std::size_t part;
      bool isAtStart;
      std::size_t pin = 0;
    };
    std::vector<Opened> opened;
    const auto open = [&](std::size_t i, bool atStart) {
      if (parts_[i].state == State::Open) return fault(i, "the part reads what comes from itself");
      parts_[i].state = State::Open;
      opened.push_back({i, atStart});
    };
    if (parts_[first].state != State::Prepared) open(first, isAtStart);
    while (!opened.empty() && !isDamaged_) {
      Opened& top = opened.back();
      const std::size_t i = top.part;
      if (top.pin == part(i).inputs.size()) {
        measure(i);
        parts_[i].state = State::Prepared;
        opened.pop_back();
        continue;
      }
      const Pin& pin = part(i).inputs[top.pin];
      if (pin.source == Pin::Source::Flow && !kept_.contains({pin.part, pin.from})) {
        const bool leads = top.isAtStart && isLeading(i, pin.name);
        if (parts_[pin.part].state != State::Prepared) {
          open(pin.part, leads);
          continue;
        }
        if (mustBeKept(pin, leads)) keep(pin.part);
      }
      if (isCall(i) && pin.name != enablePin) keepParameter(i, pin);
      ++top.pin;
    }
  }

  /// A parameter takes an operand: what else stands there is kept in a bit.
  void keepParameter(std::size_t i, const Pin& pin) {
    const bool isOperand = pin.source == Pin::Source::Value && !part(i).isNegated(pin.name);
    if (isOperand || pin.source == Pin::Source::Open) return;
    span_ = part(i).span;
    const Operand bit = freshBit();
    start(i, pin);
    emit("=", bit);
    inputBits_[{i, pin.name}] = bit;
  }

  bool mustBeKept(const Pin& pin, bool leads) const {
    const Output& output = *part(pin.part).output(pin.from);
    const Prepared& source = parts_[pin.part];
    return output.readers > 1 || !output.targets.empty() || source.readOutputs > 1 || (jumps(pin.part) && !leads) ||
           source.height >= mostNesting - 1 || source.length >= mostInString;
  }

  /// The string of a part whose inputs are prepared.
  void measure(std::size_t i) {
    Prepared& own = parts_[i];
    const bool joins = elementOf(i) == Element::EdgeContact || isCompare(i);
    own.height = joins ? 1 : 0;
    own.length = 1;
    for (const Pin& pin : part(i).inputs) {
      if (isValuePin(i, pin.name) || operandOf(pin) != nullptr || (isCall(i) && pin.name != enablePin)) continue;
      const bool isFlow = pin.source == Pin::Source::Flow;
      own.height = std::max(own.height, (isFlow ? parts_[pin.part].height : 0) + (isGate(i) ? 1 : 0));
      if (isFlow) own.length = std::max(own.length, parts_[pin.part].length + 1);
    }
  }

  /// Runs the part and keeps what others read of it.
  void keep(std::size_t i) {
    const Part& p = part(i);
    const auto store = [&](const Output& output) {
      const Operand bit = freshBit();
      emit("=", bit);
      kept_[{i, output.name}] = bit;
      for (const Operand& target : output.targets) {
        emit("A", bit);
        emit("=", target);
      }
    };
    if (!isCall(i)) {
      const Output& output = *p.output(flowOutput(i));
      flow(i, output.name);
      return store(output);
    }
    const Output* eno = p.output(enabledPin);
    callBlock(i, eno != nullptr);
    if (eno != nullptr) store(*eno);
    for (const Output& output : p.outputs) {
      if (output.name != enabledPin && output.readers > 0) kept_[{i, output.name}] = outputBits_.at({i, output.name});
    }
  }

  /// Runs a part that nothing reads from.
  void execute(std::size_t i) {
    if (isDamaged_) return;
    const Part& p = part(i);
    span_ = p.span;
    const Output* output = p.output(flowOutput(i));
    const bool writes = output != nullptr && !output->targets.empty();
    switch (elementOf(i)) {
      case Element::Coil: coil(i); break;
      case Element::SetCoil:
      case Element::ResetCoil:
      case Element::EdgeCoil:
        start(i, *p.input("in"));
        coilBehind(i);
        break;
      case Element::Jump:
      case Element::JumpNot: {
        const bool isAlways = !startUnlessTrue(i, p.input("in"));
        if (isAlways && elementOf(i) == Element::JumpNot) return noOperation();
        return emit(isAlways ? "JU" : elementOf(i) == Element::Jump ? "JC" : "JCN", valueAt(i, "label"));
      }
      case Element::Return:
        start(i, *p.input("in"));
        emit("SAVE");
        return void(emit("BEC"));
      case Element::SetReset:
      case Element::ResetSet: flipFlop(i); break;
      default: {
        if (isCall(i)) {
          callBlock(i, writes);
          break;
        }
        const FbdBox* row = box(i);
        const bool isElement = isTimerOrCounter(i);
        if (isElement)
          element(i, *row);
        else if (row != nullptr)
          boxWithEnable(i, *row, writes);
        else
          flow(i, std::string(flowOutput(i)));
        if (row == nullptr && !writes) emit("=", freshBit());  // ends the string that nobody reads
        if (isElement && writes) emit("A", p.instance);
        if (isElement && !writes) noOperation();
        break;
      }
    }
    if (!writes) return;
    const Element element = elementOf(i);
    if (element == Element::SetReset || element == Element::ResetSet) emit("A", valueAt(i, "operand"));
    for (const Operand& target : output->targets) emit("=", target);
  }

  const std::vector<step7::Name>& labelsAhead_;
  BoxLabels& labels_;
  SyntaxSink& sink_;
  step7::NetworkSyntax& network_;
  std::vector<Prepared> parts_;
  std::map<Net, Operand> kept_, inputBits_, outputBits_;
  std::uint32_t bits_ = 0;
  Span span_;
  bool isDamaged_ = false;
};

}  // namespace

bool writeStatements(const Circuit& circuit, BoxLabels& labels, SyntaxSink& sink, step7::NetworkSyntax& network) {
  return CircuitWriter(circuit, labels, sink, network).write();
}

}  // namespace rungproof::flgnet
