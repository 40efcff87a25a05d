// Rungs, items, wires.
#include "frontend/simaticsd/sd_circuit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

#include "frontend/flgnet/circuit_pins.hpp"
#include "frontend/flgnet/fragment.hpp"
#include "frontend/stl/stl_lexer.hpp"

namespace rungproof::simaticsd {

namespace {

using flgnet::inSmallLetters;
using flgnet::Part;
using flgnet::Pin;
using step7::Cursor;
using step7::Operand;
using step7::OperandForm;

/// Elements with the part of SimaticML that they are; the operand that stands alone goes to the first pin.
struct SdElement {
  std::string_view name, part;
  std::array<std::string_view, 2> pins;
  bool isNegated = false;  ///< of the operand
  std::string_view flowPin = "in";
};
constexpr auto sdElements = std::to_array<SdElement>({
    {"Contact", "Contact", {"operand"}},
    {"I_Contact", "Contact", {"operand"}, true},
    {"P_Contact", "PContact", {"operand", "bit"}},
    {"N_Contact", "NContact", {"operand", "bit"}},
    {"P_Trig", "PBox", {"bit"}},
    {"N_Trig", "NBox", {"bit"}},
    {"Not", "Not", {}},
    {"Coil", "Coil", {"operand"}},
    {"I_Coil", "Coil", {"operand"}, true},
    {"S_Coil", "SCoil", {"operand"}},
    {"R_Coil", "RCoil", {"operand"}},
    {"P_Coil", "PCoil", {"operand", "bit"}},
    {"N_Coil", "NCoil", {"operand", "bit"}},
    {"JumpCoil", "Jump", {"label"}},
    {"I_JumpCoil", "JumpNot", {"label"}},
    {"ReturnCoil", "Return", {}},
    // Coils of S5 timers and counters are their boxes with the other pins open.
    {"SP_Coil", "S_PULSE", {"timer", "tv"}, false, "s"},
    {"SE_Coil", "S_PEXT", {"timer", "tv"}, false, "s"},
    {"SD_Coil", "S_ODT", {"timer", "tv"}, false, "s"},
    {"SS_Coil", "S_ODTS", {"timer", "tv"}, false, "s"},
    {"SF_Coil", "S_OFFDT", {"timer", "tv"}, false, "s"},
    {"CU_Coil", "S_CU", {"counter"}, false, "cu"},
    {"CD_Coil", "S_CD", {"counter"}, false, "cd"},
    {"EQ_Contact", "Eq", {"in1", "in2"}, false, "pre"},
    {"NE_Contact", "Ne", {"in1", "in2"}, false, "pre"},
    {"GT_Contact", "Gt", {"in1", "in2"}, false, "pre"},
    {"GE_Contact", "Ge", {"in1", "in2"}, false, "pre"},
    {"LT_Contact", "Lt", {"in1", "in2"}, false, "pre"},
    {"LE_Contact", "Le", {"in1", "in2"}, false, "pre"},
    {"A", "A", {}, false, "in1"},
    {"O", "O", {}, false, "in1"},
    {"X", "X", {}, false, "in1"},
});

bool isInstanceElement(std::string_view part) { return part.starts_with("S_"); }

/// The name of a type as SimaticML has it; empty: none that a box takes.
std::string_view boxTypeName(s7300::TypeKind kind) {
  switch (kind) {
    case s7300::TypeKind::Int: return "Int";
    case s7300::TypeKind::DInt: return "DInt";
    case s7300::TypeKind::Real: return "Real";
    case s7300::TypeKind::Word: return "Word";
    case s7300::TypeKind::DWord: return "DWord";
    default: return "";
  }
}

struct SdArgument {
  std::string pin;  ///< in small letters; empty: the operand stands alone
  bool isOutput = false;
  bool isNegated = false;
  std::string wire;
  std::optional<Operand> value;  ///< nothing: the pin is open, or a wire stands there
  Span span;
};

class SdNetworkReader {
 public:
  SdNetworkReader(Cursor& cursor, const step7::BlockSyntax& block, SyntaxSink& sink)
      : cursor_(cursor), block_(block), sink_(sink) {}

  std::optional<flgnet::Circuit> read() {
    const std::uint32_t begin = cursor_.at();
    countWires();
    cursor_.skipSpace();
    if (cursor_.takeWord("LABEL")) label();
    while (!isDamaged_) {
      readAttributes(cursor_);
      if (cursor_.takeWord("END_NETWORK")) break;
      if (!cursor_.takeWord("RUNG")) {
        fault(cursor_.span(cursor_.at(), cursor_.at() + 1), "RUNG or END_NETWORK is missing");
        break;
      }
      rung();
    }
    skipToEnd();
    circuit_.span = cursor_.spanFrom(begin);
    if (isDamaged_) return std::nullopt;
    joinWires();
    return isDamaged_ ? std::nullopt : std::optional(std::move(circuit_));
  }

 private:
  struct Wire {
    std::size_t contributors = 0;
    std::vector<Pin> flows;           ///< what flows into it
    std::optional<std::size_t> join;  ///< its OR
    Span span;
  };

  void fault(Span span, std::string message) {
    if (!isDamaged_) sink_.report(Syntax::XmlStructure, span, std::move(message));
    isDamaged_ = true;
  }

  void skipToEnd() {
    if (!isDamaged_) return;
    while (!cursor_.atEnd() && !cursor_.takeWord("END_NETWORK")) {
      if (cursor_.peek() == '"')
        cursor_.to(std::max(cursor_.quotedEnd(), cursor_.at() + 1));
      else if (cursor_.word().empty())
        cursor_.skip(1);
    }
  }

  /// How many flows end in each wire: an OR is needed for more than one.
  void countWires() {
    const std::uint32_t back = cursor_.at();
    const std::string_view text = cursor_.text();
    const std::size_t stop = std::min(text.find("END_NETWORK", back), text.size());
    for (std::size_t at = text.find("wire#", back); at < stop; at = text.find("wire#", at + 1)) {
      cursor_.to(static_cast<std::uint32_t>(at + 5));
      const std::string name(cursor_.word());
      const std::string_view before = trimmed(text.substr(back, at - back));
      const bool isStart = before.ends_with("RUNG") && !before.ends_with("END_RUNG");
      const bool isPin = before.ends_with(":=") || before.ends_with("(") || before.ends_with(",");
      if (!isStart && !isPin) ++wires_[name].contributors;
    }
    cursor_.to(back);
  }

  void label() {
    cursor_.skipSpace();
    if (!cursor_.take('(')) return fault(cursor_.spanFrom(cursor_.at()), "the label needs a name in parentheses");
    cursor_.skipSpace();
    const std::uint32_t begin = cursor_.at();
    const std::string name(cursor_.word());
    circuit_.labels.push_back({name, cursor_.spanFrom(begin)});
    cursor_.skipSpace();
    if (!cursor_.take(')')) fault(cursor_.spanFrom(begin), "the closing parenthesis is missing");
  }

  // Rungs -----------------------------------------------------------------------------------------------------------

  void rung() {
    flow_ = start();
    while (!isDamaged_) {
      const SdAttributes attributes = readAttributes(cursor_);
      if (cursor_.takeWord("END_RUNG")) break;
      if (cursor_.atEnd() || step7::equalsWord(cursor_.peekWord(), "END_NETWORK"))
        return fault(cursor_.spanFrom(cursor_.at()), "END_RUNG is missing");
      item(attributes);
    }
    if (const std::optional<std::string> wire = wireHere()) into(*wire);
  }

  std::optional<std::string> wireHere() {
    cursor_.skipSpace();
    if (!cursor_.startsWithLetters("WIRE#")) return std::nullopt;
    cursor_.skip(5);
    return std::string(cursor_.word());
  }

  Pin rail(Span span) const {
    Pin pin;
    pin.source = Pin::Source::Rail;
    pin.span = span;
    return pin;
  }

  /// What the rung begins with: power, a wire, or in FBD an operand.
  Pin start() {
    if (const std::optional<std::string> wire = wireHere()) return *wire == "powerrail" ? rail({}) : outOf(*wire);
    const std::uint32_t begin = cursor_.at();
    const bool isNegated = cursor_.takeWord("NOT");
    cursor_.skipSpace();
    const std::uint32_t at = cursor_.at();
    const std::string_view head = headHere();
    cursor_.skipSpace();
    const bool isBox = head.empty() || cursor_.peek() == '(' || equalsIgnoringCase(head, "END_RUNG");
    std::optional<Operand> operand =
        isBox ? std::nullopt
              : flgnet::operandFrom(head, cursor_.span(at, at + static_cast<std::uint32_t>(head.size())));
    if (!operand) {
      cursor_.to(begin);
      return rail(cursor_.spanFrom(begin));
    }
    Pin pin;
    pin.source = Pin::Source::Value;
    pin.value = std::move(*operand);
    pin.span = pin.value.span;
    return isNegated ? inverted(std::move(pin)) : pin;
  }

  /// Letters of a name with its parts and indices; empty: something else stands here.
  std::string_view headHere() {
    const std::uint32_t begin = cursor_.at();
    int brackets = 0;
    while (!cursor_.atEnd()) {
      const char c = cursor_.peek();
      if (c == '"' || c == '\'') {
        const std::uint32_t end = cursor_.quotedEnd();
        if (end == 0) break;
        cursor_.to(end);
        continue;
      }
      if (c == '[') ++brackets;
      if (c == ']') --brackets;
      const bool isPart = step7::isWordByte(c) || c == '#' || c == '.' || c == '%' || c == '[' || c == ']' ||
                          c == '+' || c == '-' || (c == ':' && cursor_.peek(1) != '=') ||
                          (brackets > 0 && (c == ',' || c == ' '));
      if (!isPart) break;
      cursor_.skip(1);
    }
    return cursor_.slice(begin, cursor_.at());
  }

  // Wires -----------------------------------------------------------------------------------------------------------

  /// The flow ends in the wire.
  void into(const std::string& name) {
    Wire& wire = wires_[name];
    wire.flows.push_back(flow_);
  }

  /// What comes out of the wire: all that flow into it, wherever they are written.
  Pin outOf(const std::string& name) {
    Wire& wire = wires_[name];
    if (wire.contributors == 0) {
      fault(cursor_.spanFrom(cursor_.at()), fmt::format("nothing flows into wire#{}", excerpt(name)));
      return rail({});
    }
    if (wire.contributors == 1 && wire.flows.size() == 1) return wire.flows.front();
    if (!wire.join) {
      wire.join = circuit_.parts.size();
      Part part;
      part.name = "O";
      part.cardinality = std::max<std::size_t>(2, wire.contributors);
      part.span = cursor_.spanFrom(cursor_.at());
      circuit_.parts.push_back(std::move(part));
    }
    return flowOf(*wire.join, "out");
  }

  void joinWires() {
    for (auto& [name, wire] : wires_) {
      if (!wire.join) continue;
      for (std::size_t i = 0; i < wire.flows.size(); ++i)
        connect(*wire.join, fmt::format("in{}", i + 1), wire.flows[i]);
      if (wire.flows.size() == 1) {  // an OR of one is the flow itself
        Pin twice = wire.flows.front();
        connect(*wire.join, "in2", twice);
      }
    }
  }

  static Pin flowOf(std::size_t part, std::string from) {
    Pin pin;
    pin.source = Pin::Source::Flow;
    pin.part = part;
    pin.from = std::move(from);
    return pin;
  }

  void connect(std::size_t part, std::string pin, Pin source) {
    if (source.source == Pin::Source::Flow) ++outputOf(source.part, source.from).readers;
    if (circuit_.parts[part].input(pin) != nullptr)
      return fault(circuit_.parts[part].span, fmt::format("pin {} is given twice", excerpt(pin)));
    source.name = std::move(pin);
    source.span = circuit_.parts[part].span;
    if (std::exchange(source.isNegated, false)) circuit_.parts[part].negated.insert(source.name);
    circuit_.parts[part].inputs.add(std::move(source));
  }
  flgnet::Output& outputOf(std::size_t part, const std::string& pin) { return circuit_.parts[part].outputs.named(pin); }

  /// A part that inverts the flow.
  Pin inverted(Pin pin) {
    Part part;
    part.name = "Not";
    part.span = pin.span;
    circuit_.parts.push_back(std::move(part));
    const std::size_t index = circuit_.parts.size() - 1;
    connect(index, "in", std::move(pin));
    return flowOf(index, "out");
  }

  // Items -----------------------------------------------------------------------------------------------------------

  void item(const SdAttributes& attributes) {
    if (const std::optional<std::string> wire = wireHere()) {
      into(*wire);
      flow_ = outOf(*wire);
      return;
    }
    // NOT in front of a box, and not the element Not( ).
    const std::uint32_t first = cursor_.at();
    bool isInverted = cursor_.takeWord("NOT");
    cursor_.skipSpace();
    if (isInverted && cursor_.peek() == '(') {
      isInverted = false;
      cursor_.to(first);
    }
    const std::uint32_t begin = cursor_.at();
    const std::string head(headHere());
    cursor_.skipSpace();
    if (head.empty() || !cursor_.take('('))
      return fault(cursor_.span(begin, std::max(cursor_.at(), begin + 1)), "an element with parentheses is missing");
    std::vector<SdArgument> arguments;
    if (!readArguments(arguments)) return;
    const Span span = cursor_.spanFrom(begin);
    element(head, span, attributes, arguments);
    if (isInverted && !isDamaged_) flow_ = inverted(flow_);
  }

  bool readArguments(std::vector<SdArgument>& arguments) {
    for (cursor_.skipSpace(); !cursor_.take(')'); cursor_.skipSpace()) {
      SdArgument argument;
      const std::uint32_t begin = cursor_.at();
      std::string_view head = headHere();
      cursor_.skipSpace();
      const bool isInput = cursor_.startsWith(":="), isOutput = cursor_.startsWith("=>");
      if (isInput || isOutput) {
        argument.pin = inSmallLetters(head);
        if (argument.pin.starts_with('"') && argument.pin.ends_with('"') && argument.pin.size() > 2)
          argument.pin = argument.pin.substr(1, argument.pin.size() - 2);
        argument.isOutput = isOutput;
        cursor_.skip(2);
        cursor_.skipSpace();
      } else {
        cursor_.to(begin);
      }
      argument.isNegated = cursor_.takeWord("NOT");
      cursor_.skipSpace();
      const std::uint32_t at = cursor_.at();
      if (const std::optional<std::string> wire = wireHere()) {
        argument.wire = *wire;
      } else {
        head = headHere();
        argument.span = cursor_.spanFrom(at);
        if (!head.empty()) {
          argument.value = flgnet::operandFrom(head, argument.span);
          if (!argument.value) {
            fault(argument.span, fmt::format("the operand {} cannot be read", excerpt(head)));
            return false;
          }
        }
      }
      arguments.push_back(std::move(argument));
      cursor_.skipSpace();
      if (cursor_.take(',') || cursor_.peek() == ')') continue;
      fault(cursor_.span(begin, std::max(cursor_.at(), begin + 1)), "the closing parenthesis is missing");
      return false;
    }
    return true;
  }

  void element(const std::string& head, Span span, const SdAttributes& attributes,
               const std::vector<SdArgument>& arguments) {
    const auto row =
        std::ranges::find_if(sdElements, [&](const SdElement& each) { return equalsIgnoringCase(each.name, head); });
    if (row != sdElements.end()) return knownElement(*row, span, attributes, arguments);
    const std::size_t point = head.rfind('.');
    const bool isOperand = head[0] == '#' || head[0] == '"' || head[0] == '%';
    const std::string box = point == std::string::npos ? head : head.substr(point + 1);
    if (isOperand && point != std::string::npos && !flgnet::iecBlock(box).empty())
      return iecBox(head.substr(0, point), box, span, arguments);
    if (isOperand) return call(head, span, arguments);
    if (flgnet::isBoxPart(head)) return valueBox(head, span, attributes, arguments);
    static constexpr std::array<std::string_view, 30> known = {"S_RS",
                                                               "S_SR",
                                                               "SR",
                                                               "RS",
                                                               "S_BitfieldCoil",
                                                               "R_BitfieldCoil",
                                                               "TP_Coil",
                                                               "TOn_Coil",
                                                               "TOf_Coil",
                                                               "TOnr_Coil",
                                                               "RT_Coil",
                                                               "PT_Coil",
                                                               "SC_Coil",
                                                               "SaveCoil",
                                                               "McrOpenCoil",
                                                               "McrCloseCoil",
                                                               "McrActivateCoil",
                                                               "McrDeactivateCoil",
                                                               "Normalize",
                                                               "OpenDBCoil",
                                                               "Scale",
                                                               "MIN",
                                                               "MAX",
                                                               "Limit",
                                                               "Sel",
                                                               "Mux",
                                                               "Calculate",
                                                               "TONR",
                                                               "Swap",
                                                               "Inc"};
    const bool isKnown =
        head.ends_with("Contact") || head.ends_with("Coil") ||
        std::ranges::any_of(known, [&](std::string_view each) { return equalsIgnoringCase(each, head); });
    if (isKnown) return fault(span, fmt::format("part {} is not covered", excerpt(head)));
    call("\"" + head + "\"", span, arguments);
  }

  std::size_t add(Part part) {
    circuit_.parts.push_back(std::move(part));
    return circuit_.parts.size() - 1;
  }

  void give(std::size_t part, const std::string& pin, const SdArgument& argument) {
    if (argument.isOutput) {
      if (argument.value) outputOf(part, pin).targets.push_back(*argument.value);
      return;
    }
    if (argument.wire.empty() && !argument.value) return;  // open
    Pin source;
    if (!argument.wire.empty()) {
      source = outOf(argument.wire);
    } else {
      source.source = Pin::Source::Value;
      source.value = *argument.value;
    }
    source.isNegated = argument.isNegated;
    connect(part, pin, std::move(source));
  }

  void knownElement(const SdElement& row, Span span, const SdAttributes& attributes,
                    const std::vector<SdArgument>& arguments) {
    Part part;
    part.name = row.part;
    part.span = span;
    const bool isGate = row.flowPin == "in1", isCompare = row.flowPin == "pre";
    if (isCompare) {
      part.type = typeOf(attributes, arguments);
      if (flgnet::compareSuffix(part.type).empty())
        return fault(span, fmt::format("part {} with type {} is not covered", row.name,
                                       part.type.empty() ? "none" : excerpt(part.type)));
    }
    if (isGate && arguments.empty()) return;  // the flow alone
    if (isGate) part.cardinality = arguments.size() + 1;
    if (row.isNegated) part.negated.insert("operand");
    const std::size_t index = add(std::move(part));
    connect(index, std::string(row.flowPin), flow_);
    std::size_t next = 0;
    for (const SdArgument& argument : arguments) {
      std::string pin = argument.pin;
      // Operands of coils have other names in some versions: their order tells.
      const bool isNamed = std::ranges::find(row.pins, pin) != row.pins.end() && !pin.empty();
      if (!isGate && !isNamed) pin = next < row.pins.size() ? row.pins[next] : std::string_view();
      ++next;
      if (pin.empty()) return fault(span, fmt::format("{} takes no such operand", row.name));
      if (isInstanceElement(row.part) && pin == row.pins[0]) {
        if (argument.value) circuit_.parts[index].instance = *argument.value;
        continue;
      }
      if (pin == "label" && argument.value) {
        Operand label = *argument.value;
        label.form = OperandForm::Word;
        if (label.name.empty() && !label.path.empty()) label.name = label.path.front().name;
        Pin source;
        source.source = Pin::Source::Value;
        source.value = std::move(label);
        connect(index, pin, std::move(source));
        continue;
      }
      give(index, pin, argument);
    }
    flow_ = flowOf(index, isInstanceElement(row.part) ? "q" : "out");
  }

  /// The type that a template names, or that the first operand with a declaration or a prefix has.
  std::string typeOf(const SdAttributes& attributes, const std::vector<SdArgument>& arguments) const {
    std::string from, to;
    for (const SdAttribute& each : partsOf(valueOf(attributes, "S7_Templates"))) {
      const std::string key = inSmallLetters(each.key);
      if (key.find("time") != std::string::npos) continue;
      (key.find("dest") != std::string::npos ? to : from) = each.value;
    }
    if (!from.empty()) return to.empty() || to == from ? from : fmt::format("{}>{}", from, to);
    for (const SdArgument& argument : arguments) {
      if (!argument.value) continue;
      if (const std::string type(declaredType(*argument.value)); !type.empty()) return type;
    }
    return {};
  }
  std::string_view declaredType(const Operand& operand) const {
    if (operand.form == OperandForm::Constant) {
      if (operand.constant.kind == s7300::ConstantKind::Real) return "Real";
      return operand.constant.kind == s7300::ConstantKind::Long ? "DInt" : "";
    }
    if (operand.form != OperandForm::Local || operand.path.size() != 1 || !operand.path[0].indices.empty()) return "";
    for (const step7::DeclarationSyntax& declaration : block_.declarations) {
      if (s7300::isSameName(declaration.name.text, operand.path[0].name))
        return boxTypeName(declaration.type->elementary.kind);
    }
    return "";
  }

  /// Without S7_GenerateENO the flow goes on as it came.
  void valueBox(const std::string& name, Span span, const SdAttributes& attributes,
                const std::vector<SdArgument>& arguments) {
    Part part;
    part.name = name;
    part.span = span;
    part.type = typeOf(attributes, arguments);
    const bool rounds = name == "Round" || name == "Trunc" || name == "Ceil" || name == "Floor";
    if (rounds && part.type == "Real") part.type = "Real>DInt";
    if (flgnet::boxOf(part.name, part.type) == nullptr)
      return fault(span, fmt::format("part {} with type {} is not covered", excerpt(name),
                                     part.type.empty() ? "none" : excerpt(part.type)));
    const std::size_t index = add(std::move(part));
    connect(index, std::string(flgnet::enablePin), flow_);
    for (const SdArgument& argument : arguments) give(index, argument.pin, argument);
    if (equalsIgnoringCase(valueOf(attributes, "S7_GenerateENO"), "TRUE"))
      flow_ = flowOf(index, std::string(flgnet::enabledPin));
  }

  void iecBox(const std::string& instance, const std::string& box, Span span,
              const std::vector<SdArgument>& arguments) {
    Part part;
    part.name = box;
    part.span = span;
    const std::optional<Operand> data = flgnet::operandFrom(instance, span);
    if (!data) return fault(span, fmt::format("the instance {} cannot be read", excerpt(instance)));
    part.instance = *data;
    const std::size_t index = add(std::move(part));
    connect(index, std::string(flgnet::iecFlowInput(box)), flow_);
    for (const SdArgument& argument : arguments) give(index, argument.pin, argument);
    flow_ = flowOf(index, std::string(flgnet::iecFlowOutput(box)));
  }

  /// A block, or an instance by itself: what it is an instance of, its declaration says.
  void call(const std::string& head, Span span, const std::vector<SdArgument>& arguments) {
    Part part;
    part.span = span;
    std::optional<Operand> callee = flgnet::operandFrom(head, span);
    const bool isBlock = callee && callee->form == OperandForm::Symbol && callee->path.empty();
    if (!callee || (!isBlock && callee->form != OperandForm::Local))
      return fault(span, fmt::format("the call of {} is not covered", excerpt(head)));
    part.callee = step7::BlockName{std::nullopt, 0, isBlock ? callee->name : callee->path.front().name, span};
    if (!isBlock) part.instance = std::move(*callee);
    const std::size_t index = add(std::move(part));
    connect(index, std::string(flgnet::enablePin), flow_);
    for (const SdArgument& argument : arguments) {
      if (argument.pin.empty()) return fault(span, "the call names its parameters");
      if (argument.pin != flgnet::enabledPin) give(index, argument.pin, argument);
    }
    flow_ = flowOf(index, std::string(flgnet::enabledPin));
  }

  Cursor& cursor_;
  const step7::BlockSyntax& block_;
  SyntaxSink& sink_;
  flgnet::Circuit circuit_;
  std::map<std::string, Wire> wires_;
  Pin flow_;
  bool isDamaged_ = false;
};

}  // namespace

std::optional<flgnet::Circuit> readSdNetwork(Cursor& cursor, const step7::BlockSyntax& block, SyntaxSink& sink) {
  return SdNetworkReader(cursor, block, sink).read();
}

}  // namespace rungproof::simaticsd
