// Truth values of recorded code, simplified by what is known of their parts. Instructions write status bits and ENO
// under their conditions one after the other; of what one writes, the next one with the same condition leaves nothing.
#include "engine/compiled/recorder.hpp"

namespace rungproof::compiled {

namespace {

/// How far a value is looked into for a condition that decides it.
constexpr int deepest = 4;

bool isOverflow(CodeOp op) { return op == CodeOp::AddOverflows || op == CodeOp::SubOverflows; }
bool isJoin(CodeOp op) { return op == CodeOp::And || op == CodeOp::Or; }

}  // namespace

std::optional<bool> Recorder::truth(Bool a) const {
  const ValueId id = resolved(a.id);
  return id <= 1 ? std::optional(id == 1) : std::nullopt;
}

void Recorder::assume(Bool condition, bool value) {
  const ValueId id = resolved(condition.id);
  if (id <= 1) return;
  replaced_[id] = value ? 1 : 0;
  const Step step = at(id);
  if (step.op == CodeOp::Not) assume({step.a}, !value);
  if (step.op != (value ? CodeOp::And : CodeOp::Or)) return;
  assume({step.a}, value);
  assume({step.b}, value);
}

Recorder::Bool Recorder::lnot(Bool a) {
  a.id = resolved(a.id);
  if (a.id <= 1) return {1 - a.id};
  if (at(a.id).op == CodeOp::Not) return {resolved(at(a.id).a)};
  return {make({.op = CodeOp::Not, .a = a.id})};
}

std::vector<std::pair<ValueId, ValueId>> Recorder::partsOf(ValueId condition) const {
  const Step& both = at(condition);
  if (both.op != CodeOp::And) return {};
  return {{both.a, both.b}, {both.b, both.a}};
}

std::optional<Recorder::Forked> Recorder::forked(ValueId first, ValueId second) const {
  for (const auto& [part, rest] : partsOf(first)) {
    for (const auto& [other, otherRest] : partsOf(second)) {
      if (part == other && isOpposite(rest, otherRest)) return Forked{{part}, {rest}};
    }
  }
  return std::nullopt;
}

/// `a` joined by `op` with `b`, which joins others: where one of these is `a` or its opposite. By example of And:
/// a(ax) = ax, a(a + x) = a, a(-a + x) = ax, a(-ax) = 0; a -(-ax) = a, a -(ax) = a(-x).
std::optional<Recorder::Bool> Recorder::absorbed(CodeOp op, ValueId a, ValueId b) {
  const Step inner = at(b);
  if (const Step negated = at(inner.a); inner.op == CodeOp::Not && negated.op == op) {
    for (const auto& [one, other] : {std::pair(negated.a, negated.b), std::pair(negated.b, negated.a)}) {
      if (isOpposite(one, a)) return Bool{a};
      if (one == a) return op == CodeOp::And ? land({a}, lnot({other})) : lor({a}, lnot({other}));
    }
  }
  if (!isJoin(inner.op)) return std::nullopt;
  for (const auto& [one, other] : {std::pair(inner.a, inner.b), std::pair(inner.b, inner.a)}) {
    if (one == a) return Bool{inner.op == op ? b : a};
    if (!isOpposite(one, a)) continue;
    if (inner.op == op) return constant(op == CodeOp::Or);
    return op == CodeOp::And ? land({a}, {other}) : lor({a}, {other});
  }
  return std::nullopt;
}

Recorder::Bool Recorder::land(Bool a, Bool b) {
  a.id = resolved(a.id);
  b.id = resolved(b.id);
  if (a.id > b.id) std::swap(a, b);
  if (a.id == 0 || a.id == b.id) return a;
  if (a.id == 1) return b;
  if (isOpposite(a.id, b.id)) return {0};
  if (const auto simple = absorbed(CodeOp::And, a.id, b.id)) return *simple;
  if (const auto simple = absorbed(CodeOp::And, b.id, a.id)) return *simple;
  return {make({.op = CodeOp::And, .a = a.id, .b = b.id})};
}

/// Equal or less is not greater.
std::optional<Recorder::Bool> Recorder::orderOf(ValueId a, ValueId b) {
  const Step equal = at(a), less = at(b);
  const bool isLess = less.op == CodeOp::LessSigned || less.op == CodeOp::Less;
  if (equal.op != CodeOp::Equal || !isLess || equal.width != less.width) return std::nullopt;
  const bool isSame = (equal.a == less.a && equal.b == less.b) || (equal.a == less.b && equal.b == less.a);
  if (!isSame) return std::nullopt;
  return lnot(compare(less.op, less.width, {less.b}, {less.a}));
}

Recorder::Bool Recorder::lor(Bool a, Bool b) {
  a.id = resolved(a.id);
  b.id = resolved(b.id);
  if (a.id > b.id) std::swap(a, b);
  if (a.id == 0) return b;
  if (a.id == 1 || a.id == b.id) return a;
  if (isOpposite(a.id, b.id)) return {1};
  if (const auto simple = absorbed(CodeOp::Or, a.id, b.id)) return *simple;
  if (const auto simple = absorbed(CodeOp::Or, b.id, a.id)) return *simple;
  if (const auto order = orderOf(a.id, b.id)) return *order;
  if (const auto order = orderOf(b.id, a.id)) return *order;
  if (const auto way = forked(a.id, b.id)) return way->common;
  for (const auto& [sum, last] : {std::pair(a.id, b.id), std::pair(b.id, a.id)}) {
    const Step before = at(sum);  // of all that have come before, one and the other side of a fork
    if (!code.isWholeScan || before.op != CodeOp::Or) continue;
    if (const auto way = forked(before.a, last)) return lor({before.b}, way->common);
    if (const auto way = forked(before.b, last)) return lor({before.a}, way->common);
  }
  return {make({.op = CodeOp::Or, .a = a.id, .b = b.id})};
}

Recorder::Bool Recorder::lxor(Bool a, Bool b) {
  a.id = resolved(a.id);
  b.id = resolved(b.id);
  if (a.id > b.id) std::swap(a, b);
  if (a.id == 0) return b;
  if (a.id == b.id) return {0};
  if (a.id == 1) return lnot(b);
  return {make({.op = CodeOp::Xor, .a = a.id, .b = b.id})};
}

/// A value where `condition` is known; the same value where that says nothing about it.
Recorder::Bool Recorder::under(Bool value, ValueId condition, bool isTrue, int depth) {
  value.id = resolved(value.id);
  if (value.id == condition) return constant(isTrue);
  if (value.id <= 1 || depth == 0) return value;
  const Step step = at(value.id);
  const auto part = [&](ValueId id) { return under({id}, condition, isTrue, depth - 1); };
  if (step.op == CodeOp::Not) {
    const Bool a = part(step.a);
    return a.id == resolved(step.a) ? value : lnot(a);
  }
  if (isJoin(step.op)) {
    const Bool a = part(step.a), b = part(step.b);
    if (a.id == resolved(step.a) && b.id == resolved(step.b)) return value;
    return step.op == CodeOp::And ? land(a, b) : lor(a, b);
  }
  if (step.op == CodeOp::SelectBit && step.a == condition) return part(isTrue ? step.b : step.c);
  return value;
}

Recorder::Bool Recorder::guardOfLocal(Bool guard, std::uint32_t byte) {
  for (const OpenCall& call : calls) {
    if (byte >= call.firstLocal) guard = under(guard, resolved(call.condition.id), true, deepest);
  }
  return guard;
}

/// What is known of `asked` where a condition holds.
std::optional<bool> Recorder::impliedBy(ValueId condition, ValueId asked) const {
  if (condition == asked) return true;
  if (isOpposite(condition, asked)) return false;
  const Step& both = at(condition);
  if (both.op != CodeOp::And) return std::nullopt;
  const auto first = impliedBy(both.a, asked);
  return first ? first : impliedBy(both.b, asked);
}

Recorder::Bits Recorder::ofGuard(Bits number) const {
  while (at(number.id).op == CodeOp::Select) {
    const auto isOn = impliedBy(resolved(guard->id), at(number.id).a);
    if (!isOn) break;
    number.id = *isOn ? at(number.id).b : at(number.id).c;
  }
  return number;
}

std::optional<Recorder::NumberTest> Recorder::numberTest(ValueId id) const {
  const Step& step = at(id);
  const auto isTest = [&](const Step& s) {
    return s.op == CodeOp::TestBit || (s.op == CodeOp::Equal && at(s.b).op == CodeOp::Constant);
  };
  if (isTest(step)) return NumberTest{step, 0};
  if (step.op != CodeOp::And) return std::nullopt;
  if (at(step.a).op == CodeOp::Not && isTest(at(step.b))) return NumberTest{at(step.b), at(step.a).a};
  if (at(step.b).op == CodeOp::Not && isTest(at(step.a))) return NumberTest{at(step.a), at(step.b).a};
  return std::nullopt;
}

/// Instructions write status bits that say whether their result is 0 or negative: the last result is chosen, and asked
/// once, sooner than each of them.
std::optional<Recorder::Bool> Recorder::oneTest(ValueId condition, ValueId on, ValueId off) {
  const auto x = numberTest(on), y = numberTest(off);
  if (!x || !y || x->test.op != y->test.op || x->test.b != y->test.b || x->test.value != y->test.value)
    return std::nullopt;
  const int width = at(x->test.a).width;
  const bool isWord = width == 16 || width == 32;
  if (!isWord || at(y->test.a).width != width || at(x->test.a).op == CodeOp::Join || at(y->test.a).op == CodeOp::Join)
    return std::nullopt;
  // Where the test does not count, another number may stand: one that is there anyway.
  const auto tested = [&](const NumberTest& t) {
    const auto other = selects_.find(pairOf(t.unless, t.test.a));
    return Bits{other == selects_.end() ? t.test.a : other->second};
  };
  const Bits number = select({condition}, tested(*x), tested(*y), width);
  const Bool test = x->test.op == CodeOp::TestBit ? bit(number, static_cast<int>(x->test.value))
                                                  : equal(number, {x->test.b}, x->test.width);
  return land(lnot(chosen({condition}, {x->unless}, {y->unless})), test);
}

Recorder::Bool Recorder::select(Bool c, Bool a, Bool b) {
  c.id = resolved(c.id);
  if (c.id == 1) return {resolved(a.id)};
  if (c.id == 0) return {resolved(b.id)};
  if (at(c.id).op == CodeOp::Not) return select({at(c.id).a}, b, a);
  a = under(a, c.id, true, deepest);
  b = under(b, c.id, false, deepest);
  if (a.id == b.id) return a;
  if (const Step both = at(c.id); both.op == CodeOp::And) {
    // What an instruction writes where it succeeds, over what it writes where it fails: its own condition decides.
    for (const auto& [outer, inner] : {std::pair(both.a, both.b), std::pair(both.b, both.a)}) {
      const Bool without = under(b, outer, false, deepest);
      if (without.id == b.id) continue;
      return select({outer}, select({inner}, a, under(b, outer, true, deepest)), without);
    }
  }
  if (code.isWholeScan && a.id > 1 && b.id > 1) {
    if (const auto one = oneTest(c.id, a.id, b.id)) return *one;
    // Of what was chosen before, the first of all is nobody's result: those after it are one chain.
    if (const Step before = at(b.id); before.op == CodeOp::SelectBit) {
      const auto one =
          isOverflow(at(a.id).op) ? std::optional(chosen(c, a, {before.b})) : oneTest(c.id, a.id, before.b);
      if (one) return chosen(lor(c, {before.a}), *one, {before.c});
    }
  }
  return chosen(c, a, b);
}

/// As it is, but for constants.
Recorder::Bool Recorder::chosen(Bool c, Bool a, Bool b) {
  if (a.id == b.id) return a;
  if (a.id == 1) return lor(c, b);
  if (a.id == 0) return land(lnot(c), b);
  if (b.id == 0) return land(c, a);
  if (b.id == 1) return lor(lnot(c), a);
  return {make({.op = CodeOp::SelectBit, .a = c.id, .b = a.id, .c = b.id})};
}

}  // namespace rungproof::compiled
