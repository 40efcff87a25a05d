// Statements of SCL. FOR computes its limit and its step once and asks before each pass. A run leaves its variable one
// step beyond the limit; proofs leave it open. A jump back is bounded as every jump back is.
#include <fmt/format.h>

#include <algorithm>

#include "frontend/step7/cursor.hpp"
#include "frontend/step7/scl_lowering.hpp"
#include "frontend/stl/syntax_sink.hpp"
#include "ir/s7300/index_check.hpp"

namespace rungproof::step7 {

using iec::StatementKind;
using s7300::ConstantKind;
using s7300::TypeKind;

namespace {

constexpr std::size_t mostCopies = 512;

Constant sclNumber(std::int64_t value) {
  Constant made;
  made.value = value;
  return made;
}

/// OK, and ENO as TIA Portal calls it: what the block hands back.
bool isOkFlag(const iec::Expr& target) {
  if (target.parts.size() != 1) return false;
  const std::string name = iec::foldedName(target.parts[0].name);
  return name == "OK" || name == "ENO";
}

/// Whether OK or ENO stands on the left of an assignment somewhere.
bool writesOk(const iec::Statements& all) {
  return std::ranges::any_of(all, [](const iec::Statement& one) {
    return (one.kind == StatementKind::Assign && isOkFlag(*one.target)) || writesOk(one.otherwise) ||
           std::ranges::any_of(one.branches, [](const iec::Branch& branch) { return writesOk(branch.body); });
  });
}

/// What nobody executes is bound for its names. Labels that the lowering made may be missing where it broke off.
void leaveUnread(NetworkSyntax& network) {
  network.isUnread = true;
  std::erase_if(network.statements, [](const Statement& statement) {
    const std::string& label = statement.operand.name;
    return statement.operand.form == OperandForm::Word && !label.empty() && isDecimal(label[0]);
  });
}

}  // namespace

std::vector<NetworkSyntax> SclLowering::lower(const SclBody& body, const NetworkSyntax& whole) {
  body_ = &body;
  isWhole_ = body.isWhole;
  endLabel_ = freshLabel();
  std::vector<NetworkSyntax> networks;
  networks.reserve(body.statements.size() + 2);
  const auto add = [&](Span span) {
    network_ = &networks.emplace_back();
    network_->number = static_cast<int>(networks.size());
    network_->span = span_ = span;
    network_->isStructured = true;
  };
  const bool hasOk = !isLocal("OK") && writesOk(body.statements);
  for (const iec::Statement& one : body.statements) {
    add(one.span);
    try {
      if (hasOk && !ok_) {
        ok_ = temporary(Kind::Bool);
        emit("SET");
        emit("=", *ok_);
      }
      const std::uint32_t free = next_;
      isNameMissing_ = false;
      statement(one);
      next_ = free;
    } catch (const Refused& refused) {
      missed(refused);
    }
    if (!isNameMissing_) continue;
    network_->keepsStores = !hasOk && keepStores(one);
    isWhole_ = isWhole_ && network_->keepsStores;
    leaveUnread(*network_);
  }
  // What the block hands back as ENO; an organization block has nobody to hand it to.
  if (isLeft_ || ok_ || scope_.key.kind != BlockKind::Ob) {
    if (networks.empty()) add(whole.span);
    span_ = {networks.back().span.file, networks.back().span.offset + networks.back().span.length, 0};
    if (isLeft_) mark(endLabel_);
    if (scope_.key.kind != BlockKind::Ob) {
      if (ok_) {
        emit("A", *ok_);
        emit("SAVE");
      } else {
        emit(std::string(bodyEnd), sclConstant(sclNumber(mayOverflow_ && effects_ > 0 ? 1 : 0), span_));
      }
    }
  }
  if (!networks.empty()) {
    for (const Remark& remark : whole.remarks) {
      const auto behind = std::ranges::find_if(networks, [&](const NetworkSyntax& network) {
        return network.span.offset + network.span.length > remark.span.offset;
      });
      (behind == networks.end() ? networks.back() : *behind).remarks.push_back(remark);
    }
  }
  if (!isWhole_) {
    for (NetworkSyntax& network : networks) {
      leaveUnread(network);
      network.keepsStores = false;
    }
  }
  return networks;
}

/// For a statement that was refused: the stores that it may make, so that everything else of the block is known. False
/// where it may do more than store at places whose addresses are known.
bool SclLowering::keepStores(const iec::Statement& one) {
  const auto hasCall = [](const auto& self, const iec::Expr& expr) -> bool {
    const bool isConversion =
        expr.parts.size() == 1 && iec::foldedName(expr.parts[0].name).find("_TO_") != std::string::npos;
    if (expr.kind == iec::ExprKind::Call && !isConversion) return true;
    const auto isInArgument = [&](const iec::Argument& argument) {
      return argument.value && self(self, *argument.value);
    };
    if (std::ranges::any_of(expr.arguments, isInArgument)) return true;
    const auto inPart = [&](const iec::PathPart& part) {
      return std::ranges::any_of(part.indices, [&](const iec::ExprPtr& index) { return self(self, *index); });
    };
    return std::ranges::any_of(expr.parts, inPart) ||
           std::ranges::any_of(expr.operands, [&](const iec::ExprPtr& operand) { return self(self, *operand); });
  };
  const auto isPlain = [&](const iec::ExprPtr& expr) { return expr == nullptr || !hasCall(hasCall, *expr); };
  const auto all = [&](const iec::Statements& list) {
    return std::ranges::all_of(list, [&](const iec::Statement& inside) { return keepStores(inside); });
  };
  if (!isPlain(one.value) || !isPlain(one.target)) return false;
  if (one.kind == iec::StatementKind::If || one.kind == iec::StatementKind::Case)
    return all(one.otherwise) && std::ranges::all_of(one.branches, [&](const iec::Branch& branch) {
             return isPlain(branch.condition) && all(branch.body);
           });
  const bool isPlaced = one.kind == iec::StatementKind::Assign && !unplaced_.contains(&one);
  if (!isPlaced || one.target->kind != iec::ExprKind::Path) return false;
  try {
    const Spot to = placeOf(*one.target);
    if (!to.indices.empty() || to.bound.constant || (to.bound.type && sclBits(to.bound.type->kind) == 0)) return false;
    bool isUntyped = false;
    const Kind kind = kindOf(to.bound, one.target->span, isUntyped);
    // What the expression would have done to the accumulators and the status bits.
    for (const char* operation : {"L", "L"}) emit(operation, sclConstant(sclNumber(0), one.span));
    emit("+I");
    emit("SET");
    store(to.operand, kind);
  } catch (const Refused&) {
    return false;
  }
  return true;
}

void SclLowering::lowerInto(const SclBody& body, NetworkSyntax& network) {
  body_ = &body;
  isWhole_ = body.isWhole;
  isPart_ = true;
  network_ = &network;
  network.isStructured = true;
  span_ = network.span;
  statements(body.statements);
  if (!isWhole_) leaveUnread(network);
}

void SclLowering::missed(const Refused& refused) {
  isNameMissing_ = isNameMissing_ || refused.isNameMissing;
  isWhole_ = isWhole_ && refused.isNameMissing && !isPart_;
}

void SclLowering::statements(const iec::Statements& all) {
  for (const iec::Statement& one : all) {
    const std::uint32_t free = next_;
    try {
      statement(one);
    } catch (const Refused& refused) {  // the others are looked at all the same
      missed(refused);
    }
    next_ = free;
  }
}

void SclLowering::statement(const iec::Statement& one) {
  const Span before = std::exchange(span_, one.span);
  switch (one.kind) {
    case StatementKind::Assign: assign(one); break;
    case StatementKind::Call:
      if (const SclValue unused = call(*one.target, true); unused.kind == Kind::Bool && !unused.isPlain)
        inTemporary(unused);  // ends the logic string
      break;
    case StatementKind::If: ifStatement(one); break;
    case StatementKind::Case: caseStatement(one); break;
    case StatementKind::For: forStatement(one); break;
    case StatementKind::While: whileStatement(one); break;
    case StatementKind::Repeat: repeatStatement(one); break;
    case StatementKind::Exit:
    case StatementKind::Continue: leaveLoop(one); break;
    case StatementKind::Return:
      if (isPart_) return emit("BEU");
      isLeft_ = true;
      emitJump("JU", endLabel_);
      break;
    case StatementKind::Jump:
    case StatementKind::Label: {
      const std::string& label = one.target->parts[0].name;
      if (one.target->kind != iec::ExprKind::Path || one.target->parts.size() != 1 || label.starts_with('"') ||
          label.starts_with('#'))
        refuse(one.target->span, fmt::format("{} is no label", written(one.target->span)), Syntax::SclText);
      if (one.kind == StatementKind::Label)
        mark(iec::foldedName(label));
      else
        emitJump("JU", iec::foldedName(label));
      break;
    }
    default: throw Refused{};  // has its finding
  }
  span_ = before;
}

void SclLowering::assign(const iec::Statement& one) {
  const iec::Expr& target = *one.target;
  unplaced_.insert(&one);
  if (ok_ && isOkFlag(target)) {
    const SclValue given = valueAs(*one.value, Kind::Bool);
    scan(given);
    return store(*ok_, Kind::Bool);
  }
  if (target.kind != iec::ExprKind::Path)
    refuse(target.span, fmt::format("{} cannot be written", written(target.span)));
  // FC5 := value; in FC5 itself.
  iec::Expr own;
  const bool isOwn = scope_.key.kind == BlockKind::Fc && target.parts.size() == 1 && !isLocal(target.parts[0].name) &&
                     iec::foldedName(target.parts[0].name) == toString(scope_.key);
  if (isOwn) {
    own.kind = iec::ExprKind::Path;
    own.span = target.span;
    own.parts.push_back({iec::PathPart::Kind::Name, "#RET_VAL", {}, 0, 1, target.span});
  }
  const Spot to = placeOrSlice(isOwn ? own : target);
  if (to.bound.constant) refuse(target.span, fmt::format("{} is a constant", written(target.span)), Syntax::SclType);
  if (to.bound.type && sclBits(to.bound.type->kind) == 0) {
    if (one.value->kind != iec::ExprKind::Path || !to.indices.empty())
      refuse(one.span, fmt::format("{} is {}: such a value is not covered", written(target.span),
                                   s7300::toString(*to.bound.type)));
    const Spot from = placeOf(*one.value);
    if (!from.bound.type || !from.indices.empty() || !s7300::isSameType(*to.bound.type, *from.bound.type))
      refuse(one.value->span, fmt::format("{} is no {}", written(one.value->span), s7300::toString(*to.bound.type)),
             Syntax::SclType);
    return copyWhole(to.operand, from.operand, *to.bound.type, one.span);
  }
  bool isUntyped = false;
  const Kind kind = kindOf(to.bound, target.span, isUntyped);
  if (to.slice != nullptr) return storeSlice(to, kind, *one.value);
  unplaced_.erase(&one);
  SclValue given = value(*one.value);
  if (isUntyped && !given.isLiteral && sclBits(given.kind) == sclBits(kind))
    given.isUntyped = true;            // an address takes any value of its width
  if (isUntyped && given.isLiteral) {  // MW10 := -1
    if (const auto number = literalAs(given, kind == Kind::Word ? Kind::Int : Kind::DInt);
        number && kind != Kind::Byte) {
      given = *number;
      given.isUntyped = true;
    }
  }
  given = as(given, kind, one.value->span);
  span_ = one.span;
  store(to, given, target.span);
}

/// Arrays and structures element by element.
void SclLowering::copyWhole(const Operand& to, const Operand& from, const s7300::Type& type, Span span) {
  if (network_->statements.size() > 2 * mostCopies)
    refuse(span, fmt::format("more than {} values in one assignment are not covered", mostCopies));
  if (sclBits(type.kind) != 0) {
    SclValue value = inRegister(type.kind, span);
    value.isPlain = true;
    value.operand = from;
    if (type.kind == Kind::Bool)
      scan(value);
    else
      load(value);
    return store(to, type.kind);
  }
  Operand partOfTo = to, partOfFrom = from;
  if (type.kind == Kind::Struct) {
    for (const s7300::Field& field : type.structure->fields) {
      partOfTo.path = to.path;
      partOfFrom.path = from.path;
      partOfTo.path.push_back({field.name, {}, span});
      partOfFrom.path.push_back({field.name, {}, span});
      copyWhole(partOfTo, partOfFrom, field.type, span);
    }
    return;
  }
  if (type.kind != Kind::Array || type.element == nullptr)
    refuse(span, fmt::format("a value of type {} is not covered", s7300::toString(type)));
  std::vector<std::int64_t> indices;
  for (const s7300::Bounds& bounds : type.bounds) indices.push_back(bounds.first);
  for (bool isMore = true; isMore;) {
    partOfTo.path.back().indices = partOfFrom.path.back().indices = indices;
    copyWhole(partOfTo, partOfFrom, *type.element, span);
    isMore = false;
    for (std::size_t i = indices.size(); i-- > 0 && !isMore;) {
      isMore = ++indices[i] <= type.bounds[i].last;
      if (!isMore) indices[i] = type.bounds[i].first;
    }
  }
}

void SclLowering::jumpUnless(const iec::Expr& condition, const std::string& label) {
  const SclValue asked = valueAs(condition, Kind::Bool);
  const Span before = std::exchange(span_, condition.span);
  scan(asked);
  emitJump("JCN", label);
  span_ = before;
}

void SclLowering::ifStatement(const iec::Statement& one) {
  const std::string end = freshLabel();
  for (std::size_t i = 0; i < one.branches.size(); ++i) {
    const iec::Branch& branch = one.branches[i];
    const bool isLast = i + 1 == one.branches.size() && one.otherwise.empty();
    const std::string next = isLast ? end : freshLabel();
    const std::uint32_t free = next_;
    jumpUnless(*branch.condition, next);
    next_ = free;
    statements(branch.body);
    if (isLast) break;
    span_ = branch.condition->span;
    emitJump("JU", end);
    mark(next);
  }
  statements(one.otherwise);
  mark(end);
}

/// Whole numbers made of literals and constants.
std::optional<std::int64_t> SclLowering::numberOf(const iec::Expr& expr, int depth) {
  if (depth > 50) return std::nullopt;
  if (expr.kind == iec::ExprKind::Literal) {
    const bool isPlain = expr.prefix.empty() || expr.prefix == "INT" || expr.prefix == "DINT";
    if (!isPlain || expr.text.find_first_not_of("0123456789_") != std::string::npos || expr.text.size() > 12)
      return std::nullopt;
    std::int64_t value = 0;
    for (const char c : expr.text) value = c == '_' ? value : value * 10 + (c - '0');
    return value;
  }
  if (expr.kind == iec::ExprKind::Unary && expr.text == "-") {
    const auto inner = numberOf(*expr.operands[0], depth + 1);
    return inner ? std::optional(-*inner) : std::nullopt;
  }
  if (expr.kind == iec::ExprKind::Binary) {
    if (expr.text != "+" && expr.text != "-" && expr.text != "*") return std::nullopt;
    const auto left = numberOf(*expr.operands[0], depth + 1), right = numberOf(*expr.operands[1], depth + 1);
    if (!left || !right) return std::nullopt;
    const std::int64_t made = expr.text == "+" ? *left + *right : expr.text == "-" ? *left - *right : *left * *right;
    return made >= -2147483648LL && made <= 2147483647LL ? std::optional(made) : std::nullopt;
  }
  if (expr.kind != iec::ExprKind::Path || expr.parts.size() != 1) return std::nullopt;
  std::string_view name = expr.parts[0].name;
  if (!isLocal(name)) {
    for (const SclConstant& constant : body_->constants) {
      if (s7300::isSameName(constant.name, name)) return numberOf(*constant.value, depth + 1);
    }
  }
  if (name.starts_with('#')) name.remove_prefix(1);
  const s7300::Field* field = scope_.constants->field(name);
  const bool isNumber =
      field != nullptr && field->initial.size() == 1 &&
      (field->type.kind == Kind::Int || field->type.kind == Kind::DInt) &&
      (field->initial[0].kind == ConstantKind::Integer || field->initial[0].kind == ConstantKind::Long);
  return isNumber ? std::optional(field->initial[0].value) : std::nullopt;
}

std::int64_t SclLowering::constantNumber(const iec::Expr& expr) {
  const std::optional<std::int64_t> number = numberOf(expr);
  if (!number) refuse(expr.span, fmt::format("{} is no constant number", written(expr.span)), Syntax::SclType);
  return *number;
}

void SclLowering::caseStatement(const iec::Statement& one) {
  const Span selectorSpan = one.value->span;
  SclValue selector = value(*one.value);
  if (selector.kind != Kind::Int && selector.kind != Kind::DInt)
    refuse(selectorSpan, fmt::format("{} is no INT or DINT, which CASE asks for", written(selectorSpan)),
           Syntax::SclType);
  const bool isWide = selector.kind == Kind::DInt;
  span_ = selectorSpan;
  selector = inTemporary(selector);
  const auto number = [&](std::int64_t value, Span span) {
    if (!isWide && (value < -32768 || value > 32767)) refuse(span, fmt::format("{} is no INT", value), Syntax::SclType);
    Constant constant = sclNumber(value);
    if (isWide) constant.kind = ConstantKind::Long;
    return sclConstant(constant, span);
  };
  const auto compare = [&](const char* relation, std::int64_t value, Span span) {
    span_ = span;
    emit("L", selector.operand);
    emit("L", number(value, span));
    emit(std::string(relation) + (isWide ? "D" : "I"));
  };
  const std::string end = freshLabel();
  for (const iec::Branch& branch : one.branches) {
    const std::string body = freshLabel(), next = freshLabel();
    for (std::size_t i = 0; i < branch.labels.size(); ++i) {
      const iec::CaseLabel& label = branch.labels[i];
      const std::int64_t low = constantNumber(*label.low);
      const bool isLast = i + 1 == branch.labels.size();
      if (label.high == nullptr) {
        compare("==", low, label.low->span);
      } else {
        compare(">=", low, label.low->span);
        const std::string beyond = isLast ? next : freshLabel();
        emitJump("JCN", beyond);
        compare("<=", constantNumber(*label.high), label.high->span);
        if (!isLast) {
          emitJump("JC", body);
          mark(beyond);
          continue;
        }
      }
      emitJump(isLast ? "JCN" : "JC", isLast ? next : body);
    }
    if (branch.labels.size() > 1) mark(body);
    statements(branch.body);
    const bool isLastBranch = &branch == &one.branches.back() && one.otherwise.empty();
    span_ = branch.labels.empty() ? selectorSpan : branch.labels.front().low->span;
    if (!isLastBranch) emitJump("JU", end);
    mark(next);
  }
  statements(one.otherwise);
  mark(end);
}

void SclLowering::forStatement(const iec::Statement& one) {
  const Span head{one.span.file, one.span.offset,
                  (one.by != nullptr ? one.by : one.last)->span.offset +
                      (one.by != nullptr ? one.by : one.last)->span.length - one.span.offset};
  const Spot counter = placeOf(*one.target);
  bool isUntyped = false;
  const Kind kind = kindOf(counter.bound, one.target->span, isUntyped);
  if (isUntyped || (kind != Kind::Int && kind != Kind::DInt) || !counter.indices.empty())
    refuse(one.target->span, fmt::format("{} is no variable of type INT or DINT", written(one.target->span)),
           Syntax::SclType);
  span_ = head;
  store(counter, valueAs(*one.value, kind), one.target->span);
  const auto held = [&](const iec::Expr& expr) {
    SclValue made = valueAs(expr, kind);
    return made.isPlain && made.operand.form == OperandForm::Constant ? made : inTemporary(made);
  };
  const SclValue last = held(*one.last);
  SclValue by = inRegister(kind, head);
  std::int64_t step = 1;
  by.isPlain = true;
  if (one.by != nullptr) {
    const std::optional<std::int64_t> number = numberOf(*one.by);
    if (!number) refuse(one.by->span, "a step of FOR that is no constant is not covered");
    step = *number;
    if (step == 0) refuse(one.by->span, "the step of FOR is 0", Syntax::SclType);
  }
  Constant stepConstant = sclNumber(step);
  by.isLiteral = true;
  by.operand = sclConstant(stepConstant, head);
  by = as(by, kind, head);
  const std::int64_t most = kind == Kind::Int ? 32767 : 2147483647LL;
  if (last.operand.form == OperandForm::Constant) {
    const std::int64_t limit = last.operand.constant.value;
    if (step > 0 ? limit > most - step : limit < -most - 1 - step)
      refuse(one.last->span, "whether FOR ends at a limit that its variable cannot pass is not covered");
  }
  const std::string again = freshLabel(), next = freshLabel(), over = freshLabel(), end = freshLabel();
  const std::string suffix = kind == Kind::Int ? "I" : "D";
  mark(again);
  emit("L", counter.operand);
  emit("L", last.operand);
  emit((step > 0 ? "<=" : ">=") + suffix);
  emitJump("JCN", over);
  loops_.push_back({next, end});
  statements(one.otherwise);
  loops_.pop_back();
  span_ = head;
  mark(next);
  emit("L", counter.operand);
  emit("L", by.operand);
  emit("+" + suffix);
  emit("T", counter.operand);
  emitJump("JU", again);
  mark(over);
  leaveOpen(counter.operand, kind);
  mark(end);
}

void SclLowering::whileStatement(const iec::Statement& one) {
  const std::string again = freshLabel(), end = freshLabel();
  mark(again);
  jumpUnless(*one.value, end);
  loops_.push_back({again, end});
  statements(one.otherwise);
  loops_.pop_back();
  span_ = one.value->span;
  emitJump("JU", again);
  mark(end);
}

void SclLowering::repeatStatement(const iec::Statement& one) {
  const std::string again = freshLabel(), next = freshLabel(), end = freshLabel();
  mark(again);
  loops_.push_back({next, end});
  statements(one.otherwise);
  loops_.pop_back();
  mark(next);
  jumpUnless(*one.value, again);
  mark(end);
}

void SclLowering::leaveLoop(const iec::Statement& one) {
  const bool isExit = one.kind == StatementKind::Exit;
  if (loops_.empty())
    refuse(one.span, fmt::format("{} stands in no loop", isExit ? "EXIT" : "CONTINUE"), Syntax::SclText);
  emitJump("JU", isExit ? loops_.back().end : loops_.back().next);
}

}  // namespace rungproof::step7
