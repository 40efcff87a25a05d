// Logic, arithmetic, comparisons and selection; shifts and conversions are in drawn_conversions.cpp.
#include "frontend/graphical/drawn_functions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

#include "ir/overlap.hpp"

namespace rungproof {

namespace {

using namespace std::string_view_literals;

const std::set<std::string_view>& plainNames() {
  static const std::set<std::string_view> names = {
      "AND", "OR",  "XOR",   "NOT",  "ADD", "SUB", "MUL", "DIV", "MOD", "MOVE",  "SEL",   "MUX",
      "MIN", "MAX", "LIMIT", "GT",   "GE",  "EQ",  "LE",  "LT",  "NE",  "SHL",   "SHR",   "ROL",
      "ROR", "ABS", "NEG",   "SQRT", "LN",  "EXP", "SIN", "COS", "TAN", "TRUNC", "ROUND", "CONVERT"};
  return names;
}

/// The signs that some editors write into their boxes, and names with the type behind them: ADD_INT, GT_DINT.
std::string plainName(std::string_view written) {
  std::string name = foldedName(written);
  static constexpr std::array<std::pair<std::string_view, std::string_view>, 14> signs = {{{"&", "AND"},
                                                                                           {">=1", "OR"},
                                                                                           {"=1", "XOR"},
                                                                                           {"+", "ADD"},
                                                                                           {"-", "SUB"},
                                                                                           {"*", "MUL"},
                                                                                           {"/", "DIV"},
                                                                                           {">", "GT"},
                                                                                           {">=", "GE"},
                                                                                           {"=", "EQ"},
                                                                                           {"<=", "LE"},
                                                                                           {"<", "LT"},
                                                                                           {"<>", "NE"},
                                                                                           {":=", "MOVE"}}};
  for (const auto& [sign, meaning] : signs) {
    if (name == sign) return std::string(meaning);
  }
  const std::size_t bar = name.rfind('_');
  if (bar != std::string::npos && iecTypeNamed(name.substr(bar + 1)) != IecType::None &&
      plainNames().contains(std::string_view(name).substr(0, bar)))
    name.resize(bar);
  return name;
}

std::optional<std::pair<IecType, IecType>> conversionTypes(std::string_view name) {
  if (name.starts_with("TO_")) {
    const IecType to = iecTypeNamed(name.substr(3));
    return to == IecType::None ? std::nullopt : std::optional(std::pair(IecType::None, to));
  }
  const std::size_t at = name.find("_TO_");
  if (at == std::string_view::npos) return std::nullopt;
  const IecType from = iecTypeNamed(name.substr(0, at)), to = iecTypeNamed(name.substr(at + 4));
  if (from == IecType::None || to == IecType::None) return std::nullopt;
  return std::pair(from, to);
}

Arithmetic arithmeticOf(IecType type) {
  if (type == IecType::Real) return Arithmetic::Real;
  if (type == IecType::Dint || type == IecType::Time || type == IecType::Uint || type == IecType::Word ||
      type == IecType::Udint || type == IecType::Dword)
    return Arithmetic::DInt;
  return Arithmetic::Int;
}
IecType typeOf(Arithmetic kind) {
  return kind == Arithmetic::Real ? IecType::Real : kind == Arithmetic::DInt ? IecType::Dint : IecType::Int;
}
char letterOf(Arithmetic kind) { return kind == Arithmetic::Real ? 'R' : kind == Arithmetic::DInt ? 'D' : 'I'; }

std::string_view moveFor(IecType type) {
  return type == IecType::Real          ? "MOVR"
         : widthOf(type) == Width::Byte ? "MOVB"
         : widthOf(type) == Width::Word ? "MOVW"
                                        : "MOVD";
}

}  // namespace

bool DrawnFunctions::isKnown(std::string_view name) {
  const std::string plain = plainName(name);
  return plainNames().contains(plain) || conversionTypes(plain).has_value();
}

DrawnValue DrawnFunctions::run(const VariablePlace* target) {
  target_ = target;
  const std::string name = plainName(e_.text);
  for (const DrawnPin& pin : e_.inputs) {
    if (foldedName(pin.name) == "EN") continue;
    if (pin.links.empty() && pin.expression.empty()) {
      l_.sink_.operand(e_, fmt::format("input {} is left open", pin.name));
      return {};
    }
    DrawnValue value = l_.input(e_, pin);
    if (value.kind == DrawnValue::Kind::Nothing) return {};
    if (name != "NOT") l_.fresh_ = 0;
    in_.push_back(std::move(value));
  }
  DrawnValue result;
  const bool isDone = logic(name, result) || arithmetic(name, result) || comparison(name, result) ||
                      selection(name, result) || shift(name, result) || mathematics(name, result) ||
                      conversion(name, result);
  if (!isDone) l_.sink_.circuit(e_, fmt::format("function {} is not known", e_.text));
  if (result.isPower() && !l_.isTrue(enable_)) result.wire = l_.gate(Shape::And, {enable_, result.wire});
  return result;
}

bool DrawnFunctions::readInputs(std::size_t least, std::size_t most) {
  if (in_.size() >= least && in_.size() <= most) return true;
  l_.sink_.operand(e_, least == most ? fmt::format("it needs {} inputs, not {}", least, in_.size())
                                     : fmt::format("it needs at least {} inputs, not {}", least, in_.size()));
  return false;
}

/// The type that the inputs share: that of the first input with a type, or of a wider one.
IecType DrawnFunctions::commonType() const {
  IecType type = IecType::None;
  for (const DrawnValue& value : in_) {
    if (!value.isData() || value.type == IecType::None) continue;
    if (type == IecType::None || widthOf(value.type) > widthOf(type)) type = value.type;
  }
  if (type != IecType::None) return type;
  if (target_ != nullptr && target_->type != IecType::Bool && target_->type != IecType::None) return target_->type;
  const bool isWide = std::any_of(in_.begin(), in_.end(), [](const DrawnValue& value) {
    return value.isData() && !fits(value.operand.value, IecType::Int);
  });
  return isWide ? IecType::Dint : IecType::Int;
}

Operand DrawnFunctions::resultPlace(IecType type) {
  if (target_ != nullptr && !target_->constant && target_->copy == nullptr && target_->type == type) {
    const bool isShared = std::any_of(in_.begin(), in_.end(), [&](const DrawnValue& value) {
      return value.isData() && overlaps(value.operand, target_->operand);
    });
    if (!isShared) return target_->operand;
  }
  return l_.temporary(type);
}

void DrawnFunctions::move(const Operand& from, const Operand& to, IecType type, Wire enable) {
  l_.box(moveFor(type), {from, to}, enable);
}

DrawnValue DrawnFunctions::moved(const DrawnValue& value, IecType type, Wire enable) {
  const Operand place = resultPlace(type);
  l_.moveTo(VariablePlace{type, place, std::nullopt, nullptr}, value, enable, e_);
  return l_.data(place, type);
}

// Logic

DrawnValue DrawnFunctions::boolGate(std::string_view name) {
  std::vector<Wire> wires;
  for (const DrawnValue& value : in_) wires.push_back(value.wire);
  if (name == "AND") return l_.power(l_.gate(Shape::And, std::move(wires)));
  if (name == "OR") return l_.power(l_.gate(Shape::Or, std::move(wires)));
  if (name == "NOT") return l_.power(l_.negation(wires[0]));
  Wire sum = wires[0];
  for (std::size_t i = 1; i < wires.size(); ++i) {
    const Wire one = l_.gate(Shape::And, {sum, l_.inverted(wires[i])});
    const Wire other = l_.gate(Shape::And, {l_.inverted(sum), wires[i]});
    sum = l_.gate(Shape::Or, {one, other});
  }
  return l_.power(sum);
}

DrawnValue DrawnFunctions::bitwise(std::string_view name) {
  const IecType type = commonType();
  if (type == IecType::Real || type == IecType::String || type == IecType::Time) {
    l_.sink_.operand(e_, fmt::format("it works on BOOL, BYTE, WORD and DWORD, not on {}", iecTypeName(type)));
    return {};
  }
  const char width = widthOf(type) == Width::Byte ? 'B' : widthOf(type) == Width::Word ? 'W' : 'D';
  const DrawnValue result = moved(in_[0], type, enable_);
  if (name == "NOT") {
    l_.box(fmt::format("INV{}", width), {result.operand}, enable_);
    return result;
  }
  for (std::size_t i = 1; i < in_.size(); ++i) {
    if (in_[i].operand.kind != OperandKind::Constant && widthOf(in_[i].type) != widthOf(type)) {
      l_.sink_.operand(
          e_, fmt::format("its inputs have different types, {} and {}", iecTypeName(type), iecTypeName(in_[i].type)));
      return {};
    }
    l_.box(fmt::format("{}{}", name, width), {in_[i].operand, result.operand}, enable_);
  }
  return result;
}

bool DrawnFunctions::logic(std::string_view name, DrawnValue& result) {
  if (name != "AND" && name != "OR" && name != "XOR" && name != "NOT") return false;
  const bool isNot = name == "NOT";
  if (!readInputs(isNot ? 1 : 2, isNot ? 1 : 1024)) return true;
  const auto powers = std::count_if(in_.begin(), in_.end(), [](const DrawnValue& value) { return value.isPower(); });
  if (powers == 0) {
    result = bitwise(name);
  } else if (static_cast<std::size_t>(powers) == in_.size()) {
    result = boolGate(name);
  } else {
    l_.sink_.operand(e_, "some inputs are BOOL and some are numbers");
  }
  return true;
}

// Arithmetic

/// Adds to a place or takes from it, modulo 2^16 or 2^32 as IEC 61131-3 programs do; +I and +D leave the place on
/// overflow (001:4814). A word is added as a double word, of which the low half goes back; a double word in halves.
void DrawnFunctions::sum(char sign, Arithmetic kind, const Operand& number, const Operand& place, Wire enable) {
  if (kind == Arithmetic::Real) return void(l_.box(fmt::format("{}R", sign), {number, place}, enable));
  const Operand wide = l_.temporary(IecType::Dint);
  const std::string operation = fmt::format("{}D", sign);
  const auto low = [&](const Operand& of) { return l_.lowPart(of, Width::Word); };
  if (kind == Arithmetic::Int) {
    Operand other = number;
    if (number.kind != OperandKind::Constant) {
      other = l_.temporary(IecType::Dint);
      l_.box("ITD", {number, other}, enable);
    }
    l_.box("ITD", {place, wide}, enable);
    l_.box(operation, {other, wide}, enable);
    return move(low(wide), place, IecType::Int, enable);
  }
  const Operand other = longCopy(number, enable), part = l_.temporary(IecType::Dint);
  for (const auto& [from, to] : {std::pair{place, wide}, {other, part}}) {
    move(constant(0), to, IecType::Dint, enable);
    move(low(from), low(to), IecType::Int, enable);
  }
  l_.box(operation, {part, wide}, enable);
  sum(sign, Arithmetic::Int, highPart(other), highPart(place), enable);
  sum('+', Arithmetic::Int, highPart(wide), highPart(place), enable);  // what is carried: 0, 1 or -1
  move(low(wide), low(place), IecType::Int, enable);
}

Operand DrawnFunctions::highPart(Operand place) {
  place.width = Width::Word;
  return place;
}

Operand DrawnFunctions::longCopy(const Operand& from, Wire enable) {
  const Operand place = l_.temporary(IecType::Dint);
  move(from, place, IecType::Dint, enable);
  return place;
}

/// Products of at most 16 bits: MUL has 32 bits for each, of which the low ones go on.
std::optional<DrawnValue> DrawnFunctions::product(IecType type) {
  DrawnValue result = in_[0];
  for (std::size_t i = 1; i < in_.size(); ++i) {
    const auto one = factor(result), other = factor(in_[i]);
    if (!one || !other) return std::nullopt;
    const Operand wide = l_.temporary(IecType::Dint);
    move(*one, l_.lowPart(wide, Width::Word), IecType::Int, enable_);
    l_.box("MUL", {*other, wide}, enable_);
    result = l_.data(l_.lowPart(wide, widthOf(type)), type);
  }
  return result;
}

/// A product modulo 2^32, of words: *D forms none that needs more bits. With a = 2^16 A + a' and b = 2^16 B + b' it is
/// a' b' + 2^16 (A b' + a' B). MUL takes a' and b' as signed, so b' is missing in the high word where a' has its sign
/// bit, and a' where b' has.
Operand DrawnFunctions::longProduct(const Operand& a, const Operand& b) {
  const auto low = [&](const Operand& place) { return l_.lowPart(place, Width::Word); };
  const auto times = [&](const Operand& one, const Operand& other) {
    const Operand wide = l_.temporary(IecType::Dint);
    move(one, low(wide), IecType::Int, enable_);
    l_.box("MUL", {other, wide}, enable_);
    return wide;
  };
  const auto signBit = [&](const Operand& of) {
    const Operand place = l_.temporary(IecType::Int);
    move(of, place, IecType::Int, enable_);
    l_.box("SRW", {place, constant(15)}, enable_);
    return place;
  };
  const Operand left = longCopy(a, enable_), right = longCopy(b, enable_);
  const Operand result = times(low(left), low(right));
  for (const Operand& part : {times(highPart(left), low(right)), times(low(left), highPart(right)),
                              times(signBit(low(left)), low(right)), times(signBit(low(right)), low(left))})
    sum('+', Arithmetic::Int, low(part), highPart(result), enable_);
  return result;
}

/// A number of at most 16 bits as INT: the low bits of a product are the same whatever the sign means.
std::optional<Operand> DrawnFunctions::factor(DrawnValue value) {
  if (value.operand.kind == OperandKind::Constant) {
    value.operand.value = static_cast<std::int16_t>(value.operand.value);
  } else if (widthOf(value.type) == Width::Word) {
    value.type = IecType::Int;
  }
  return l_.widened(value, Arithmetic::Int, enable_, e_);
}

/// The remainder: DIV leaves it beside the quotient (001:4890); double integers: a - a / b * b. That of a division by 0
/// is 0.
DrawnValue DrawnFunctions::modulo(const Operands& operands, Arithmetic kind, IecType type) {
  const Operand wide = l_.temporary(IecType::Dint);
  const bool isDouble = kind == Arithmetic::DInt;
  const Operand zero = constant(0);
  const bool isPlain = operands[1].kind == OperandKind::Constant && operands[1].value != 0;
  const auto divides = [&] {
    return isPlain ? enable_ : l_.compare(isDouble ? "LDD<>" : "LDW<>", operands[1], zero, enable_);
  };
  Operand rest = wide;
  if (isDouble) {
    rest = l_.temporary(IecType::Dint);
    move(operands[0], wide, IecType::Dint, enable_);
    l_.box("/D", {operands[1], wide}, divides());
    l_.box("*D", {operands[1], wide}, divides());
    move(operands[0], rest, IecType::Dint, enable_);
    l_.box("-D", {wide, rest}, enable_);
  } else {
    move(operands[0], l_.lowPart(wide, Width::Word), IecType::Int, enable_);
    l_.box("DIV", {operands[1], wide}, divides());
    rest.width = Width::Word;
  }
  if (!isPlain)
    move(zero, rest, isDouble ? IecType::Dint : IecType::Int,
         l_.compare(isDouble ? "LDD=" : "LDW=", operands[1], zero, enable_));
  return l_.data(widthOf(type) == rest.width ? rest : l_.lowPart(rest, widthOf(type)), type);
}

bool DrawnFunctions::arithmetic(std::string_view name, DrawnValue& result) {
  static constexpr std::array<std::pair<std::string_view, char>, 5> operations = {
      {{"ADD", '+'}, {"SUB", '-'}, {"MUL", '*'}, {"DIV", '/'}, {"MOD", '%'}}};
  const auto* found =
      std::find_if(operations.begin(), operations.end(), [&](const auto& row) { return row.first == name; });
  if (found == operations.end()) return false;
  const bool isOpen = name == "ADD" || name == "MUL";
  if (!readInputs(2, isOpen ? 32 : 2)) return true;
  IecType type = commonType();
  // TIME times a number is TIME; a number never decides it.
  for (const DrawnValue& value : in_) {
    if (value.isData() && value.type == IecType::Time) type = IecType::Time;
  }
  if (type == IecType::Udint || type == IecType::Dword) {
    l_.sink_.operand(e_, fmt::format("the S7-200 cannot calculate with {}", iecTypeName(type)));
    return true;
  }
  if (type == IecType::String || (type == IecType::Real && name == "MOD")) {
    l_.sink_.operand(e_, fmt::format("{} is not defined for {}", name, iecTypeName(type)));
    return true;
  }
  if (name == "MUL" && widthOf(type) != Width::DWord) {
    if (const auto found = product(type)) result = *found;
    return true;
  }
  const Arithmetic kind = arithmeticOf(type);
  Operands operands;
  for (const DrawnValue& value : in_) {
    const auto operand = l_.widened(value, kind, enable_, e_);
    if (!operand) return true;
    operands.push_back(*operand);
  }
  if (name == "MOD") {
    result = modulo(operands, kind, type);
    return true;
  }
  if (name == "MUL" && kind == Arithmetic::DInt) {
    Operand so = operands[0];
    for (std::size_t i = 1; i < operands.size(); ++i) so = longProduct(so, operands[i]);
    result = l_.data(so, type);
    return true;
  }
  const IecType worked = typeOf(kind);
  const bool isNarrower = widthOf(worked) != widthOf(type);
  // The S7-200 adds to a place: a variable that goes up by itself needs no copy.
  const bool isInPlace = !isNarrower && target_ != nullptr && target_->type == type &&
                         operands[0].kind == OperandKind::Direct &&
                         toString(operands[0]) == toString(target_->operand) &&
                         std::none_of(operands.begin() + 1, operands.end(),
                                      [&](const Operand& operand) { return overlaps(operand, target_->operand); });
  const Operand place = isNarrower ? l_.temporary(worked) : isInPlace ? target_->operand : resultPlace(type);
  if (!isInPlace) move(operands[0], place, worked, enable_);
  for (std::size_t i = 1; i < operands.size(); ++i) {
    if (name == "ADD" || name == "SUB")
      sum(found->second, kind, operands[i], place, enable_);
    else
      l_.box(fmt::format("{}{}", found->second, letterOf(kind)), {operands[i], place}, enable_);
  }
  result = l_.data(isNarrower ? l_.lowPart(place, widthOf(type)) : place, type);
  return true;
}

// Comparisons

Wire DrawnFunctions::related(std::string_view relation, const DrawnValue& a, const DrawnValue& b, Wire input) {
  IecType type = a.type;
  if (type == IecType::None || (b.type != IecType::None && widthOf(b.type) > widthOf(type))) type = b.type;
  if (type == IecType::None)
    type = fits(a.operand.value, IecType::Int) && fits(b.operand.value, IecType::Int) ? IecType::Int : IecType::Dint;
  const bool isByte =
      (type == IecType::Byte || type == IecType::Usint) && a.type != IecType::Sint && b.type != IecType::Sint;
  if (isByte) {
    for (const DrawnValue* value : {&a, &b}) {
      if (value->operand.kind != OperandKind::Constant || fits(value->operand.value, IecType::Byte)) continue;
      l_.sink_.operand(e_, fmt::format("constant {} does not fit {}", value->operand.value, iecTypeName(type)));
      return input;
    }
    return l_.compare(fmt::format("LDB{}", relation), a.operand, b.operand, input);
  }
  const bool isUnordered = relation == "=" || relation == "<>";
  if ((type == IecType::Udint || type == IecType::Dword) && !isUnordered) {
    // The order of unsigned numbers is that of signed ones with the top bit flipped.
    std::array<Operand, 2> flipped;
    const std::array<const DrawnValue*, 2> values = {&a, &b};
    for (std::size_t i = 0; i < 2; ++i) {
      flipped[i] = l_.temporary(IecType::Dword);
      l_.moveTo(VariablePlace{IecType::Dword, flipped[i], std::nullopt, nullptr}, *values[i], l_.rail(), e_);
      l_.box("XORD", {constant(0x80000000LL, ConstantForm::Hex), flipped[i]}, l_.rail());
    }
    return l_.compare(fmt::format("LDD{}", relation), flipped[0], flipped[1], input);
  }
  const bool isWord = (type == IecType::Word || type == IecType::Uint) && isUnordered && a.type != IecType::Int &&
                      b.type != IecType::Int;
  const Arithmetic kind = isWord ? Arithmetic::Int : arithmeticOf(type);
  const auto left = l_.widened(a, kind, l_.rail(), e_);
  const auto right = left ? l_.widened(b, kind, l_.rail(), e_) : std::nullopt;
  if (!right) return input;
  const char letter = kind == Arithmetic::Int ? 'W' : letterOf(kind);
  return l_.compare(fmt::format("LD{}{}", letter, relation), *left, *right, input);
}

bool DrawnFunctions::comparison(std::string_view name, DrawnValue& result) {
  static constexpr std::array<std::pair<std::string_view, std::string_view>, 6> relations = {
      {{"GT", ">"}, {"GE", ">="}, {"EQ", "="}, {"LE", "<="}, {"LT", "<"}, {"NE", "<>"}}};
  const auto* found =
      std::find_if(relations.begin(), relations.end(), [&](const auto& row) { return row.first == name; });
  if (found == relations.end()) return false;
  if (!readInputs(2, name == "NE" ? 2 : 32)) return true;
  const auto powers = std::count_if(in_.begin(), in_.end(), [](const DrawnValue& value) { return value.isPower(); });
  if (static_cast<std::size_t>(powers) == in_.size() && in_.size() == 2 && (name == "EQ" || name == "NE")) {
    result = boolGate("XOR");
    if (name == "EQ") result.wire = l_.inverted(result.wire);
    return true;
  }
  if (powers > 0) {
    l_.sink_.operand(e_, "BOOL has no order; compare numbers");
    return true;
  }
  if (std::any_of(in_.begin(), in_.end(), [](const DrawnValue& value) { return value.type == IecType::String; })) {
    if (in_.size() == 2 && (name == "EQ" || name == "NE") && in_[0].type == in_[1].type)
      result = l_.power(l_.compare(name == "EQ" ? "LDS=" : "LDS<>", in_[0].operand, in_[1].operand, l_.rail()));
    else
      l_.sink_.operand(e_, "texts can only be compared for equality, two at a time");
    return true;
  }
  Wire wire = enable_;
  for (std::size_t i = 0; i + 1 < in_.size(); ++i) wire = related(found->second, in_[i], in_[i + 1], wire);
  result = l_.power(wire);
  return true;
}

// Selection

bool DrawnFunctions::selection(std::string_view name, DrawnValue& result) {
  if (name == "MOVE") {
    if (!readInputs(1, 1)) return true;
    result = in_[0];
    if (result.isData() && !l_.isTrue(enable_)) result = moved(in_[0], commonType(), enable_);
    return true;
  }
  if (name == "SEL") {
    if (!readInputs(3, 3)) return true;
    if (!in_[0].isPower() || in_[1].isPower() != in_[2].isPower()) {
      l_.sink_.operand(e_, "G must be BOOL, IN0 and IN1 of one type");
      return true;
    }
    const Wire g = in_[0].wire;
    if (in_[1].isPower()) {
      const Wire zero = l_.gate(Shape::And, {l_.inverted(g), in_[1].wire});
      const Wire one = l_.gate(Shape::And, {g, in_[2].wire});
      result = l_.power(l_.gate(Shape::Or, {zero, one}));
      return true;
    }
    const IecType type = commonType();
    result = moved(in_[1], type, enable_);
    l_.moveTo(VariablePlace{type, result.operand, std::nullopt, nullptr}, in_[2], l_.gate(Shape::And, {enable_, g}),
              e_);
    return true;
  }
  if (name == "MUX") {
    if (!readInputs(3, 33)) return true;
    const DrawnValue selector = in_[0];
    in_.erase(in_.begin());
    if (!selector.isData() ||
        std::any_of(in_.begin(), in_.end(), [](const DrawnValue& value) { return !value.isData(); })) {
      l_.sink_.operand(e_, "K and the inputs must be numbers");
      return true;
    }
    const IecType type = commonType();
    result = moved(in_[0], type, enable_);
    for (std::size_t k = 1; k < in_.size(); ++k) {
      const Wire chosen =
          related("=", selector, l_.data(constant(static_cast<std::int64_t>(k)), IecType::None), enable_);
      l_.moveTo(VariablePlace{type, result.operand, std::nullopt, nullptr}, in_[k], chosen, e_);
    }
    return true;
  }
  if (name != "MIN" && name != "MAX" && name != "LIMIT") return false;
  const bool isLimit = name == "LIMIT";
  if (!readInputs(isLimit ? 3 : 2, isLimit ? 3 : 32)) return true;
  if (std::any_of(in_.begin(), in_.end(), [](const DrawnValue& value) { return !value.isData(); })) {
    l_.sink_.operand(e_, "its inputs must be numbers");
    return true;
  }
  const IecType type = commonType();
  const auto typed = [&](DrawnValue value) {
    if (value.type == IecType::None) value.type = type;
    return value;
  };
  const auto next = [&](const DrawnValue& so, const DrawnValue& value, bool wantsSmaller) {
    const Wire replaces = related(wantsSmaller ? "<" : ">", typed(value), so, enable_);
    l_.moveTo(VariablePlace{type, so.operand, std::nullopt, nullptr}, value, replaces, e_);
  };
  if (isLimit) {  // MIN(MAX(IN, MN), MX)
    result = moved(in_[1], type, enable_);
    next(result, in_[0], false);
    next(result, in_[2], true);
    return true;
  }
  result = moved(in_[0], type, enable_);
  for (std::size_t i = 1; i < in_.size(); ++i) next(result, in_[i], name == "MIN");
  return true;
}

}  // namespace rungproof
