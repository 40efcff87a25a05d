// Monitor<D>: the exact meaning of properties, over a domain of values. It is asked once at every scan end; over
// Graph it becomes part of the transition system that is proved, over Concrete it judges the replay of a
// counterexample. Both therefore mean the same by construction; tests/property checks it against hand-written traces.
//
// Time: a clock counts ticks of Property::timeBase between scan ends, on the grid of absolute time, and remembers the
// digits below the grid at its start: with ticks k since then, digits r0 then and r now, exactly base * k + r - r0 ms
// have passed. In base 1 the ticks are ms and there are no digits. A clock on the grid of the program's timers runs in
// step with them, which makes proofs that relate the two easy. There is no edge in the first scan.
#pragma once

#include <algorithm>

#include "analysis/property.hpp"
#include "analysis/unsigned_number.hpp"
#include "ir/check.hpp"
#include "ir/domain.hpp"
#include "ir/long_real_order.hpp"

namespace rungproof {

/// What a monitor sees of one scan end (or of one instruction boundary).
template <class D>
struct Moment {
  typename D::Bool firstScan;
  typename D::Bits dt;  ///< ticks of the property's time base since the previous scan end
  int dtWidth = 16;
  typename D::Bits digits{};  ///< ms above the last tick of the time base, 8 bits; unused if that is 1 ms
};

/// Leaf: Bits leaf(const Operand&, int width): the value at this moment, `width` bits as the operand has them.
template <class D, class Leaf>
class Monitor {
 public:
  using Bool = typename D::Bool;
  using Bits = typename D::Bits;

  /// `before`: cell values at the previous scan end; `after` receives the new ones. Both have Property::cells.size()
  /// entries.
  Monitor(D& domain, const Property& property, Leaf& leaf, const Moment<D>& moment, const std::vector<Bits>& before,
          std::vector<Bits>& after)
      : d(domain), p(property), leaf_(leaf), now(moment), before_(before), after_(after) {}

  /// Assume, Pulse: whether the run may go on. Goals: whether this scan end is bad; Reach: whether it is reached.
  Bool evaluate() {
    const Bool first = truth(p.first);
    const Bool second = p.second.empty() ? d.constant(true) : truth(p.second);
    switch (p.kind) {
      case PropertyKind::Assume:
      case PropertyKind::Reach:
      case PropertyKind::Never: return first;
      case PropertyKind::Always: return d.lnot(first);
      case PropertyKind::LeadsToScans: return leadsToScans(first, second);
      case PropertyKind::LeadsToTime: return leadsToTime(first, second);
      case PropertyKind::OnlyAfter: return d.land(first, d.lnot(latch(p.patternCell, second)));
      case PropertyKind::Unless: {
        const Bool owed = cell(p.patternCell);
        setCell(p.patternCell, d.land(first, d.lnot(second)));
        return d.land(owed, d.lnot(d.lor(first, second)));
      }
      case PropertyKind::HeldImplies: return d.land(held(first, p.bound, p.patternCell), d.lnot(second));
      case PropertyKind::Pulse: return pulse(first);
    }
    return d.constant(false);
  }

 private:
  // ---- Expressions --------------------------------------------------------------------------------

  Bool truth(const Expr& expr) {
    std::vector<Bits> value(expr.nodes.size());
    for (std::size_t i = 0; i < expr.nodes.size(); ++i) value[i] = node(expr, expr.nodes[i], value);
    return d.bit(value.back(), 0);
  }

  Bits node(const Expr& expr, const ExprNode& n, const std::vector<Bits>& value) {
    const auto arg = [&](std::size_t i) { return value[n.args[i]]; };
    const auto flag = [&](std::size_t i) { return d.bit(value[n.args[i]], 0); };
    const auto bits = [&](Bool b) { return d.fromBool(b, 1); };
    const auto argNode = [&](std::size_t i) -> const ExprNode& { return expr.nodes[n.args[i]]; };
    const auto widened = [&](std::size_t i, int to) { return number(value[n.args[i]], argNode(i), to); };
    switch (n.op) {
      case ExprOp::Constant: return d.literal(static_cast<std::uint64_t>(n.value), n.width);
      case ExprOp::Address: return address(n);
      case ExprOp::FirstScan: return bits(now.firstScan);
      case ExprOp::Not: return bits(d.lnot(flag(0)));
      case ExprOp::And: return bits(d.land(flag(0), flag(1)));
      case ExprOp::Or: return bits(d.lor(flag(0), flag(1)));
      case ExprOp::Xor: return bits(d.lxor(flag(0), flag(1)));
      case ExprOp::Implies: return bits(d.lor(d.lnot(flag(0)), flag(1)));
      case ExprOp::Equal:
      case ExprOp::NotEqual:
      case ExprOp::Less:
      case ExprOp::LessEqual:
      case ExprOp::Greater:
      case ExprOp::GreaterEqual: return bits(compare(expr, n, value));
      case ExprOp::Add:
        return isLong(n)                  ? longReal(LongRealOperation::Add, expr, n, value)
               : n.type == ExprType::Real ? d.radd(real(0, expr, n, value), real(1, expr, n, value))
                                          : d.add(widened(0, n.width), widened(1, n.width), n.width);
      case ExprOp::Sub:
        return isLong(n)                  ? longReal(LongRealOperation::Sub, expr, n, value)
               : n.type == ExprType::Real ? d.rsub(real(0, expr, n, value), real(1, expr, n, value))
                                          : d.sub(widened(0, n.width), widened(1, n.width), n.width);
      case ExprOp::Mul:
        return isLong(n)                  ? longReal(LongRealOperation::Mul, expr, n, value)
               : n.type == ExprType::Real ? d.rmul(real(0, expr, n, value), real(1, expr, n, value))
                                          : d.mul(widened(0, n.width), widened(1, n.width), n.width);
      case ExprOp::Negate:
        return isLong(n)                  ? d.bxor(arg(0), d.literal(LongRealOrder<D>::sign, 64), 64)
               : n.type == ExprType::Real ? d.bxor(arg(0), d.literal(0x80000000U, 32), 32)
                                          : d.sub(d.literal(0, n.width), widened(0, n.width), n.width);
      case ExprOp::Rises: {
        const Bool was = cell(n.cell), is = flag(0);
        setCell(n.cell, is);
        return bits(d.land(d.lnot(now.firstScan), d.land(is, d.lnot(was))));
      }
      case ExprOp::Falls: {
        const Bool was = cell(n.cell), is = flag(0);
        setCell(n.cell, is);
        return bits(d.land(d.lnot(now.firstScan), d.land(was, d.lnot(is))));
      }
      case ExprOp::Prev: {
        const Bits was = before_[own(n.cell)];
        after_[n.cell] = arg(0);
        return d.select(now.firstScan, arg(0), was, n.width);
      }
      case ExprOp::Once: return bits(latch(n.cell, flag(0)));
      case ExprOp::Since: {
        const Bool since = d.lor(flag(1), d.land(cell(n.cell), flag(0)));
        setCell(n.cell, since);
        return bits(since);
      }
      case ExprOp::Held: return bits(held(flag(0), n.milliseconds, n.cell));
    }
    CHECK(false, "expression operator without meaning");
    return d.literal(0, 1);
  }

  /// Number leaves are widened to a signed value one bit wider than an unsigned byte; REAL leaves keep the pattern.
  Bits address(const ExprNode& n) {
    const int raw = n.type == ExprType::Truth ? 1 : numberBits(n.operand);
    const Bits value = leaf_(n.operand, raw);
    if (n.type != ExprType::Number) return value;
    if (n.width == raw) return value;
    const bool isUnsigned = raw == 8 || n.operand.form == ConstantForm::Hex;
    return isUnsigned ? d.zext(value, raw, n.width) : d.sext(value, raw, n.width);
  }
  Bits number(Bits value, const ExprNode& n, int to) { return n.width == to ? value : d.sext(value, n.width, to); }
  Bits real(std::size_t i, const Expr& expr, const ExprNode& n, const std::vector<Bits>& value) {
    return asReal(value[n.args[i]], expr.nodes[n.args[i]]);
  }
  Bits asReal(Bits value, const ExprNode& n) {
    if (n.type == ExprType::Real) return value;
    if (n.width <= 32) return d.rfromInt(number(value, n, 32));
    return d.longReal(static_cast<std::uint64_t>(LongRealOperation::FromSigned), number(value, n, 64), 32);
  }

  /// LREAL: a number of 64 bits.
  static bool isLong(const ExprNode& n) { return n.type == ExprType::Real && n.width == 64; }
  Bits asLongReal(Bits value, const ExprNode& n) {
    if (isLong(n)) return value;
    const bool isReal = n.type == ExprType::Real;
    const auto which = isReal ? LongRealOperation::FromReal : LongRealOperation::FromSigned;
    return d.longReal(static_cast<std::uint64_t>(which), isReal ? value : number(value, n, 64), 64);
  }
  Bits longReal(LongRealOperation which, const Expr& expr, const ExprNode& n, const std::vector<Bits>& value) {
    const auto arg = [&](std::size_t i) { return asLongReal(value[n.args[i]], expr.nodes[n.args[i]]); };
    return d.longReal(static_cast<std::uint64_t>(which), arg(0), arg(1), 64);
  }

  Bool compare(const Expr& expr, const ExprNode& n, const std::vector<Bits>& value) {
    const ExprNode &left = expr.nodes[n.args[0]], &right = expr.nodes[n.args[1]];
    const Bits a = value[n.args[0]], b = value[n.args[1]];
    if (isLong(left) || isLong(right)) {
      const Bits x = asLongReal(a, left), y = asLongReal(b, right);
      LongRealOrder<D> order{d};
      return relation(n.op, order.equal(x, y), order.less(x, y), order.less(y, x));
    }
    if (left.type == ExprType::Real || right.type == ExprType::Real) {
      const Bits x = asReal(a, left), y = asReal(b, right);
      const Bool less = d.rless(x, y), more = d.rless(y, x), same = d.requal(x, y);
      return relation(n.op, same, less, more);
    }
    if (left.type == ExprType::Truth) return relation(n.op, d.equal(a, b, 1), d.ult(a, b, 1), d.ult(b, a, 1));
    const int w = std::max(left.width, right.width);
    const Bits x = number(a, left, w), y = number(b, right, w);
    const bool isFirst = isUnsigned64(expr, left), isSecond = isUnsigned64(expr, right);
    if (!isFirst && !isSecond) return relation(n.op, d.equal(x, y, w), d.slt(x, y, w), d.slt(y, x, w));
    // A negative number is less than any without a sign.
    const Bool isBelow = isFirst ? d.constant(false) : d.bit(x, w - 1),
               isAbove = isSecond ? d.constant(false) : d.bit(y, w - 1);
    const Bool haveSign = d.lor(isBelow, isAbove);
    return relation(n.op, d.land(d.lnot(haveSign), d.equal(x, y, w)),
                    d.lor(isBelow, d.land(d.lnot(haveSign), d.ult(x, y, w))),
                    d.lor(isAbove, d.land(d.lnot(haveSign), d.ult(y, x, w))));
  }
  /// NaN makes every relation but "not equal" false.
  Bool relation(ExprOp op, Bool same, Bool less, Bool more) {
    switch (op) {
      case ExprOp::Equal: return same;
      case ExprOp::NotEqual: return d.lnot(same);
      case ExprOp::Less: return less;
      case ExprOp::LessEqual: return d.lor(less, same);
      case ExprOp::Greater: return more;
      default: return d.lor(more, same);
    }
  }

  // ---- Cells and patterns ---------------------------------------------------------------------------

  /// A function that looks back without a cell of its own would share that of another (layoutCells()).
  std::uint32_t own(std::uint32_t i) const {
    CHECK(i < p.cells.size(), "a function that looks back has no cell");
    return i;
  }
  Bool cell(std::uint32_t i) { return d.bit(before_[own(i)], 0); }
  void setCell(std::uint32_t i, Bool value) { after_[own(i)] = d.fromBool(value, 1); }
  /// True from the first scan with `set` on.
  Bool latch(std::uint32_t i, Bool set) {
    const Bool now_ = d.lor(cell(i), set);
    setCell(i, now_);
    return now_;
  }

  /// A clock in the cells i and, if the base is coarse, i + 1; it tells exactly whether `limit` ms have passed.
  struct Clock {
    std::uint32_t cell;
    std::int64_t limit;
    Bits ticks;   ///< since the start, up to now
    Bool passed;  ///< at least `limit` ms
  };
  Clock clock(std::uint32_t i, std::int64_t limit) {
    const int w = p.cells[own(i)].width;
    const int wide = std::max(w, now.dtWidth) + 1;
    const Bits sum = d.add(d.zext(before_[i], w, wide), d.zext(now.dt, now.dtWidth, wide), wide);
    const Bits cap = d.literal(static_cast<std::uint64_t>(clockCap(limit, p.timeBase)), wide);
    const Bits ticks = d.extract(d.select(d.ult(sum, cap, wide), sum, cap, wide), w - 1, 0);
    return {i, limit, ticks, hasPassed(i, limit, ticks)};
  }
  /// base * ticks + now - then >= limit, where now and then are digits below the base.
  Bool hasPassed(std::uint32_t i, std::int64_t limit, Bits ticks) {
    const int w = p.cells[i].width;
    const auto whole = static_cast<std::uint64_t>(limit / p.timeBase),
               rest = static_cast<std::uint64_t>(limit % p.timeBase);
    const auto atLeast = [&](std::uint64_t n) { return d.ule(d.literal(n, w), ticks, w); };
    if (p.timeBase == 1) return atLeast(whole);
    const Bits then = d.add(d.zext(before_[i + 1], 8, 9), d.literal(rest, 9), 9), here = d.zext(now.digits, 8, 9);
    const Bits further = d.add(here, d.literal(static_cast<std::uint64_t>(p.timeBase), 9), 9);
    return d.lor(atLeast(whole + 2), d.lor(d.land(atLeast(whole + 1), d.ule(then, further, 9)),
                                           d.land(atLeast(whole), d.ule(then, here, 9))));
  }
  /// The clock goes on where `runs`, else stands at 0; it starts now where `starts` as well.
  void setClock(const Clock& clock, Bool runs, Bool starts) {
    const int w = p.cells[clock.cell].width;
    after_[clock.cell] = d.select(runs, clock.ticks, d.literal(0, w), w);
    if (p.timeBase > 1)
      after_[clock.cell + 1] =
          d.select(runs, before_[clock.cell + 1], d.select(starts, now.digits, d.literal(0, 8), 8), 8);
  }

  /// e at every scan end from one at least `ms` ago until now.
  Bool held(Bool e, std::int64_t ms, std::uint32_t run) {
    const Bool goesOn = d.land(e, cell(run));
    const Clock time = clock(run + 1, ms);
    setCell(run, e);
    setClock(time, goesOn, e);
    return ms == 0 ? e : d.land(goesOn, time.passed);
  }

  Bool leadsToScans(Bool trigger, Bool answer) {
    const std::uint32_t pending = p.patternCell, scans = p.patternCell + 1;
    const int w = p.cells[scans].width;
    const Bool owed = cell(pending);
    const Bool open = d.land(d.lor(owed, trigger), d.lnot(answer));
    const Bits bound = d.literal(static_cast<std::uint64_t>(p.bound), w);
    const Bits next = d.select(d.ult(before_[scans], bound, w), d.add(before_[scans], d.literal(1, w), w), bound, w);
    const Bits age = d.select(d.land(open, owed), next, d.literal(0, w), w);
    setCell(pending, open);
    after_[scans] = age;
    return d.land(open, d.equal(age, bound, w));
  }

  Bool leadsToTime(Bool trigger, Bool answer) {
    const std::uint32_t pending = p.patternCell;
    const Bool owed = cell(pending);
    const Clock time = clock(pending + 1, p.bound + 1);
    const Bool late = d.land(owed, time.passed);
    const Bool open = d.land(d.lor(owed, trigger), d.lnot(answer));
    setCell(pending, open);
    setClock(time, d.land(open, owed), open);
    return late;
  }

  /// Rising edges at least `bound` ms apart, measured between scan ends.
  Bool pulse(Bool signal) {
    const std::uint32_t was = p.patternCell, risen = was + 1;
    const Bool rise = d.land(d.lnot(now.firstScan), d.land(signal, d.lnot(cell(was))));
    const Clock time = clock(was + 2, p.bound);
    const Bool tooSoon = d.land(rise, d.land(cell(risen), d.lnot(time.passed)));
    setCell(was, signal);
    setCell(risen, d.lor(cell(risen), rise));
    setClock(time, d.lnot(rise), rise);
    return d.lnot(tooSoon);
  }

  D& d;
  const Property& p;
  Leaf& leaf_;
  Moment<D> now;
  const std::vector<Bits>& before_;
  std::vector<Bits>& after_;
};

}  // namespace rungproof
