// Calls of SCL: blocks with and without a value, instances, timers and counters of the S5 kind. An actual parameter
// that is no place of its type is computed into temporary data; what a block hands out goes there too where the target
// is an element with a computed index or of a wider type.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "frontend/step7/constant_parser.hpp"
#include "frontend/step7/operand_parser.hpp"
#include "frontend/step7/scl_lowering.hpp"
#include "frontend/stl/syntax_sink.hpp"
#include "ir/block_map.hpp"
#include "ir/s7300/block.hpp"
#include "ir/s7300/library.hpp"

namespace rungproof::step7 {

using s7300::TypeKind;

namespace {

struct ElementRow {
  std::string_view name, start;
  bool isCounter = false;
};
constexpr std::array<ElementRow, 8> sclElements = {{{"S_PULSE", "SP"},
                                                    {"S_PEXT", "SE"},
                                                    {"S_ODT", "SD"},
                                                    {"S_ODTS", "SS"},
                                                    {"S_OFFDT", "SF"},
                                                    {"S_CU", "", true},
                                                    {"S_CD", "", true},
                                                    {"S_CUD", "", true}}};

std::string sclName(std::string_view name) {
  if (name.starts_with('#')) name.remove_prefix(1);
  if (name.size() > 1 && name.starts_with('"') && name.ends_with('"')) name = name.substr(1, name.size() - 2);
  return std::string(name);
}

bool isSclFormal(const s7300::Field& field) { return field.section <= Section::InOut; }

}  // namespace

const iec::Argument* SclLowering::argument(const iec::Expr& expr, std::string_view name) const {
  const auto found = std::ranges::find_if(
      expr.arguments, [&](const iec::Argument& argument) { return iec::foldedName(argument.name) == name; });
  return found == expr.arguments.end() ? nullptr : &*found;
}

SclValue SclLowering::call(const iec::Expr& expr, bool isStatement) {
  const bool isWord = expr.parts.size() == 1 && !expr.parts[0].name.starts_with('"') && !isLocal(expr.parts[0].name);
  if (isWord) {
    const std::string name = iec::foldedName(expr.parts[0].name);
    const bool isOwn =
        catalogue_.keyOf(BlockName{std::nullopt, 0, expr.parts[0].name, expr.span}).has_value() &&
        catalogue_.entry(*catalogue_.keyOf(BlockName{std::nullopt, 0, expr.parts[0].name, expr.span})) != nullptr;
    if (!isOwn) {
      if (std::ranges::find(sclElements, name, &ElementRow::name) != sclElements.end())
        return element(expr, name, isStatement);
      if (const SclValue made = standardFunction(expr, name); made.kind != Kind::Unknown) return made;
    }
  }
  if (const std::optional<SclValue> made = blockCall(expr, isStatement)) return *made;
  return inRegister(Kind::Void, expr.span);
}

/// What a parameter hands out, to the place that the caller names.
void SclLowering::giveOut(const iec::Argument& argument, const SclValue& value) {
  const Spot to = placeOf(*argument.value);
  bool isUntyped = false;
  const Kind kind = kindOf(to.bound, argument.span, isUntyped);
  SclValue given = value;
  given.isUntyped = given.isUntyped || (isUntyped && sclBits(given.kind) == sclBits(kind));
  store(to, as(given, kind, argument.span), argument.span);
}

std::optional<SclValue> SclLowering::blockCall(const iec::Expr& expr, bool isStatement) {
  using PartKind = iec::PathPart::Kind;
  for (const iec::PathPart& part : expr.parts) {
    if (part.kind != PartKind::Name) refuse(expr.span, "the call of an element of an array is not covered");
  }
  Statement made;
  made.mnemonic = {"CALL", expr.span};
  made.span = expr.span;
  made.hasArguments = true;
  BlockKey callee;
  const auto keyAt = [&](std::size_t part) -> std::optional<BlockKey> {
    const std::string& name = expr.parts[part].name;
    Cursor cursor(name, expr.span.file);
    if (const std::optional<BlockName> block = readBlockName(cursor); block && cursor.atEnd())
      return BlockKey{*block->kind, block->number};
    return catalogue_.keyOf(BlockName{std::nullopt, 0, sclName(name), expr.parts[part].span});
  };
  const auto blockOperand = [&](BlockKey key, std::size_t part) {
    Operand operand;
    operand.form = OperandForm::Block;
    operand.block = BlockName{key.kind, key.number, {}, expr.parts[part].span};
    operand.span = expr.parts[part].span;
    return operand;
  };
  const auto missing = [&](std::size_t part) {
    reports_.reportOnce(Syntax::BlockMissing, expr.parts[part].span,
                        fmt::format("{} is in none of the files", sclName(expr.parts[part].name)), scope_.name,
                        network_->number);
    throw Refused{};
  };
  if (isLocal(expr.parts[0].name)) {
    made.operand.form = OperandForm::Local;
    made.operand.span = expr.parts[0].span;
    for (const iec::PathPart& part : expr.parts) made.operand.path.push_back({sclName(part.name), {}, part.span});
    const BoundOperand instance = bound(made.operand);
    const std::string type = instance.type ? instance.type->name : std::string();
    const bool isSystem = type.starts_with("SFB ");
    if (!isSystem && !type.starts_with("FB "))
      refuse(expr.span, fmt::format("{} is no instance of a block", written(made.operand.span)), Syntax::SclType);
    callee = {isSystem ? BlockKind::Sfb : BlockKind::Fb,
              static_cast<std::uint32_t>(std::stoul(type.substr(type.find(' ') + 1)))};
  } else {
    const std::optional<BlockKey> first = keyAt(0);
    if (!first) missing(0);
    callee = *first;
    made.operand = blockOperand(callee, 0);
    const std::size_t count = expr.parts.size();
    if (callee.kind == BlockKind::Db) {
      const CatalogueEntry* entry = catalogue_.entry(callee);
      if (entry == nullptr) missing(0);
      const std::optional<BlockKey> of = types_.instanceOf(*entry->syntax);
      if (!of || count != 1)
        refuse(expr.span, fmt::format("{} is no instance of a block", entry->name), Syntax::SclType);
      made.instance = made.operand;
      callee = *of;
      made.operand = blockOperand(callee, 0);
    } else if (callee.kind == BlockKind::Fb || callee.kind == BlockKind::Sfb) {
      if (count != 2)
        refuse(expr.span, fmt::format("{} needs an instance data block", toString(callee)), Syntax::CallList);
      const std::optional<BlockKey> instance = keyAt(1);
      if (!instance || instance->kind != BlockKind::Db) missing(1);
      made.instance = blockOperand(*instance, 1);
    } else if ((callee.kind != BlockKind::Fc && callee.kind != BlockKind::Sfc) || count != 1) {
      refuse(expr.span, fmt::format("{} is no block that can be called", written(expr.parts[0].span)), Syntax::SclType);
    }
  }
  const bool hasInstanceData = callee.kind == BlockKind::Fb || callee.kind == BlockKind::Sfb;
  std::shared_ptr<const s7300::Structure> parameters;
  if (const CatalogueEntry* entry = catalogue_.entry(callee)) {
    parameters = hasInstanceData ? types_.structure(callee) : types_.parameters(*entry->syntax);
  } else if (const s7300::LibraryBlock* library = s7300::libraryBlock(blockTypeOf(irNumber(callee)), callee.number)) {
    parameters = s7300::interfaceOf(*library);
  }
  if (parameters == nullptr) missing(0);

  struct Given {
    const iec::Argument* argument;
    SclValue value;
  };
  std::vector<Given> outputs;
  const iec::Argument* enable = argument(expr, "EN");
  const iec::Argument* enabled = argument(expr, "ENO");
  if ((enable != nullptr || enabled != nullptr) && !isStatement)
    refuse(expr.span, "EN and ENO of a call inside an expression are not covered");
  const std::string skip = freshLabel();
  if (enable != nullptr) {
    if (enable->value == nullptr) refuse(enable->span, "EN has no value", Syntax::SclText);
    scan(valueAs(*enable->value, Kind::Bool));
    emitJump("JNB", skip);
  }
  std::size_t position = 0;
  for (const iec::Argument& given : expr.arguments) {
    if (&given == enable || &given == enabled) continue;
    const s7300::Field* field = nullptr;
    if (given.name.empty()) {
      for (std::size_t i = 0, inputs = 0; i < parameters->fields.size() && field == nullptr; ++i) {
        if (parameters->fields[i].section == Section::Input && inputs++ == position) field = &parameters->fields[i];
      }
      ++position;
    } else {
      field = parameters->field(given.name);
    }
    if (field == nullptr || !isSclFormal(*field) || (given.name.empty() && hasInstanceData)) {
      refuse(given.span,
             fmt::format("{} has no parameter {}", toString(callee),
                         given.name.empty() ? written(given.span) : given.name),
             Syntax::CallList);
    }
    if (given.isNegated) refuse(given.span, "NOT in front of an output is not covered");
    if (given.value == nullptr) continue;  // Q => with nothing behind it
    Argument actual;
    actual.formal = {field->name, given.span};
    actual.span = given.span;
    const Kind kind = field->type.kind;
    if (sclBits(kind) == 0) {  // complex types, timers, pointers: by name
      std::vector<std::pair<std::size_t, const iec::PathPart*>> computed;
      if (given.value->kind == iec::ExprKind::Path) {
        actual.actual = operandOf(*given.value, computed);
      } else {
        const SclValue constant = given.value->kind == iec::ExprKind::Literal ? value(*given.value) : SclValue{};
        if (!constant.isPlain) refuse(given.span, fmt::format("{} takes a variable", field->name), Syntax::CallList);
        actual.actual = constant.operand;
      }
      if (!computed.empty()) refuse(given.span, "a computed index of such a parameter is not covered");
    } else if (field->section == Section::Input) {
      SclValue input = valueAs(*given.value, kind);
      const bool isPlace = input.isPlain && !input.isNegated && input.operand.form != OperandForm::Word;
      const bool isTruth = input.isPlain && kind == Kind::Bool && input.operand.form == OperandForm::Constant;
      if (!isPlace || isTruth || input.isLiteral || input.operand.place == Place::T) input = inTemporary(input);
      actual.actual = input.operand;
    } else {
      if (given.value->kind != iec::ExprKind::Path)
        refuse(given.span, fmt::format("{} takes a variable", field->name), Syntax::CallList);
      const Spot to = placeOf(*given.value);
      if (to.bound.constant) refuse(given.span, fmt::format("{} takes a variable", field->name), Syntax::CallList);
      bool isUntyped = false;
      const Kind target = kindOf(to.bound, given.span, isUntyped);
      const bool isSame = target == kind || (isUntyped && sclBits(target) == sclBits(kind));
      if (isSame && to.indices.empty()) {
        actual.actual = to.operand;
      } else {
        SclValue held = inRegister(kind, given.span);
        if (field->section == Section::InOut) {
          if (!isSame)
            refuse(given.span, fmt::format("{} has another type than the parameter", written(given.span)),
                   Syntax::SclType);
          held = inTemporary(as(value(*given.value), kind, given.span));
        } else {
          held.isPlain = true;
          held.operand = temporary(kind);
        }
        actual.actual = held.operand;
        outputs.push_back({&given, held});
      }
    }
    if (actual.actual.span.length == 0) actual.actual.span = given.span;
    made.arguments.push_back(std::move(actual));
  }
  const s7300::Field* const result = parameters->field("RET_VAL");
  std::optional<SclValue> returned;
  const bool isGivenByName = argument(expr, "RET_VAL") != nullptr;
  if (!hasInstanceData && result != nullptr && result->section > Section::Input && !isGivenByName) {
    if (sclBits(result->type.kind) == 0)
      refuse(expr.span, fmt::format("a value of type {} is not covered", s7300::toString(result->type)));
    SclValue value = inRegister(result->type.kind, expr.span);
    value.isPlain = true;
    value.operand = temporary(value.kind);
    Argument actual;
    actual.formal = {result->name, expr.span};
    actual.actual = value.operand;
    actual.span = expr.span;
    made.arguments.push_back(std::move(actual));
    returned = value;
  }
  if (!returned && !isStatement)
    refuse(expr.span, fmt::format("{} has no value", written(expr.parts[0].span)), Syntax::SclType);
  span_ = expr.span;
  ++effects_;
  network_->statements.push_back(std::move(made));
  for (const Given& output : outputs) giveOut(*output.argument, output.value);
  if (enable != nullptr) mark(skip);
  if (enabled != nullptr && enabled->value != nullptr) {
    SclValue eno = inRegister(Kind::Bool, enabled->span);
    eno.isPlain = true;
    eno.operand.form = OperandForm::Word;
    eno.operand.name = "BR";
    eno.operand.span = enabled->span;
    giveOut(*enabled, inTemporary(eno));
  }
  return returned;
}

/// SCL takes T#5s where a timer takes an S5TIME: what it would be as S5T#5s.
SclValue SclLowering::s5TimeOfLiteral(SclValue time, Span span) {
  const std::string_view given = reports_.program().sources->file(span.file).text(span);
  const std::string text = fmt::format("S5T{}", given.substr(std::min(given.find('#'), given.size())));
  Cursor cursor(text, span.file);
  const ConstantOutcome outcome = readConstant(cursor, MnemonicSet::International, TextEncoding::Utf8);
  if (!outcome.constant || !cursor.atEnd())
    refuse(span, fmt::format("{} is no S5TIME: that is 0MS to 2H46M30S", written(span)), Syntax::SclType);
  time.kind = Kind::S5Time;
  time.operand = sclConstant(*outcome.constant, span);
  return time;
}

/// S_ODT(T_NO := T1, S := .., TV := .., R := .., BI := .., Q := ..) and the others, as the boxes of these names.
SclValue SclLowering::element(const iec::Expr& expr, const std::string& name, bool isStatement) {
  ++effects_;
  const ElementRow& row = *std::ranges::find(sclElements, name, &ElementRow::name);
  const iec::Argument* number = argument(expr, row.isCounter ? "C_NO" : "T_NO");
  if (number == nullptr || number->value == nullptr || number->value->kind != iec::ExprKind::Path)
    refuse(expr.span, fmt::format("{} needs {}", name, row.isCounter ? "C_NO" : "T_NO"), Syntax::CallList);
  static constexpr std::array<std::string_view, 8> ofTimers = {"T_NO", "S", "TV", "R", "BI", "Q"};
  static constexpr std::array<std::string_view, 8> ofCounters = {"C_NO", "CU", "CD", "S", "PV", "R", "CV", "Q"};
  for (const iec::Argument& given : expr.arguments) {
    const auto& known = row.isCounter ? ofCounters : ofTimers;
    const std::string formal = iec::foldedName(given.name);
    const bool isOther = (formal == "CU" && name == "S_CD") || (formal == "CD" && name == "S_CU");
    if (formal.empty() || std::ranges::find(known, formal) == known.end() || isOther)
      refuse(given.span, fmt::format("{} has no parameter {}", name, formal.empty() ? written(given.span) : given.name),
             Syntax::CallList);
    if (given.value == nullptr) refuse(given.span, fmt::format("{} has no value", given.name), Syntax::SclText);
  }
  const Spot spot = placeOf(*number->value);
  const Area area = row.isCounter ? Area::C : Area::T;
  const bool isFormalOfKind = spot.bound.type && spot.bound.type->kind == (row.isCounter ? Kind::Counter : Kind::Timer);
  if (!isFormalOfKind && (spot.bound.operand.area != area || !spot.bound.operand.isMemory()))
    refuse(number->span, fmt::format("{} takes a {}", name, row.isCounter ? "counter" : "timer"), Syntax::SclType);
  const Operand& element = spot.operand;
  const auto scanned = [&](std::string_view formal) {
    const iec::Argument* given = argument(expr, formal);
    if (given == nullptr) return false;
    const SclValue asked = valueAs(*given->value, Kind::Bool);
    span_ = given->span;
    scan(asked);
    return true;
  };
  if (row.isCounter) {
    if (scanned("CU")) emit("CU", element);
    if (scanned("CD")) emit("CD", element);
  }
  const std::string_view preset = row.isCounter ? "PV" : "TV";
  if (const iec::Argument* start = argument(expr, "S")) {
    const iec::Argument* given = argument(expr, preset);
    if (given == nullptr) refuse(start->span, fmt::format("{} needs {} beside S", name, preset), Syntax::CallList);
    // The preset first: it may need the RLO.
    SclValue wanted = value(*given->value);
    if (!row.isCounter && wanted.kind == Kind::Time && wanted.operand.form == OperandForm::Constant)
      wanted = s5TimeOfLiteral(wanted, given->value->span);
    wanted = as(wanted, row.isCounter ? Kind::Word : Kind::S5Time, given->value->span);
    const SclValue held = wanted.isPlain ? wanted : inTemporary(wanted);
    scanned("S");
    load(held);
    emit(row.isCounter ? "S" : row.start, element);
  }
  if (scanned("R")) emit("R", element);
  span_ = expr.span;
  if (const iec::Argument* count = argument(expr, row.isCounter ? "CV" : "BI")) {
    emit("L", element);
    SclValue now = inTemporary(inRegister(Kind::Word, count->span));
    now.isUntyped = true;
    giveOut(*count, now);
  }
  if (const iec::Argument* state = argument(expr, "Q")) {
    SclValue now = inRegister(Kind::Bool, state->span);
    now.isPlain = true;
    now.operand = element;
    giveOut(*state, now);
  }
  span_ = expr.span;
  if (isStatement) return inRegister(Kind::Void, expr.span);
  emit("LC", element);
  return inRegister(row.isCounter ? Kind::Word : Kind::S5Time, expr.span);
}

}  // namespace rungproof::step7
