// The operations and their changes; the numbers are positions in changesOf (mutant.cpp), from 1.
#include "tests/mutation/mutated.hpp"

namespace rungproof::mutation {

namespace {

int change(Op op, const Where& at) { return Mutation::instance().change(op, at); }
std::uint64_t upTo(std::uint64_t v, int w) { return v & Concrete::mask(w); }

}  // namespace

Mutated::Bits Mutated::Store::load(Area area, std::uint32_t bitOffset, int width, Where at) const {
  return inner_->load(area, bitOffset, width) ^ (change(Op::Load, at) != 0 ? Concrete::mask(width) : 0);
}
void Mutated::Store::save(Area area, std::uint32_t bitOffset, int width, Bits value, Bool guard, Where at) {
  const int c = change(Op::Save, at);
  if (c != 1) inner_->save(area, bitOffset, width, c == 2 ? value ^ Concrete::mask(width) : value, guard);
}
Mutated::Bits Mutated::Store::get(Reg reg, std::uint32_t index, Where at) const {
  return inner_->get(reg, index) ^ (change(Op::Get, at) != 0 ? Concrete::mask(regInfo(reg).width) : 0);
}
void Mutated::Store::set(Reg reg, std::uint32_t index, Bits value, Bool guard, Where at) {
  const int c = change(Op::Set, at);
  if (c != 1) inner_->set(reg, index, c == 2 ? value ^ Concrete::mask(regInfo(reg).width) : value, guard);
}
bool Mutated::constant(bool v, Where at) const { return change(Op::Constant, at) == 1 ? !v : v; }
bool Mutated::lnot(bool a, Where at) const { return change(Op::Not, at) == 1 ? a : !a; }
bool Mutated::land(bool a, bool b, Where at) const {
  switch (change(Op::And, at)) {
    case 1: return !(a && b);
    case 2: return a || b;
    default: return a && b;
  }
}
bool Mutated::lor(bool a, bool b, Where at) const {
  switch (change(Op::Or, at)) {
    case 1: return !(a || b);
    case 2: return a && b;
    default: return a || b;
  }
}
bool Mutated::lxor(bool a, bool b, Where at) const {
  switch (change(Op::Xor, at)) {
    case 1: return a == b;
    case 2: return a || b;
    default: return a != b;
  }
}
bool Mutated::select(bool c, bool a, bool b, Where at) const {
  return change(Op::SelectBool, at) == 1 ? c ? b : a : c ? a : b;
}
Mutated::Bits Mutated::literal(std::uint64_t v, int w, Where at) const {
  return change(Op::Literal, at) == 1 ? upTo(v + 1, w) : upTo(v, w);
}
Mutated::Bits Mutated::add(Bits a, Bits b, int w, Where at) const {
  switch (change(Op::Add, at)) {
    case 1: return plain_.sub(a, b, w);
    case 2: return upTo(plain_.add(a, b, w) + 1, w);
    default: return plain_.add(a, b, w);
  }
}
Mutated::Bits Mutated::sub(Bits a, Bits b, int w, Where at) const {
  switch (change(Op::Sub, at)) {
    case 1: return plain_.add(a, b, w);
    case 2: return plain_.sub(b, a, w);
    default: return plain_.sub(a, b, w);
  }
}
Mutated::Bits Mutated::mul(Bits a, Bits b, int w, Where at) const {
  switch (change(Op::Mul, at)) {
    case 1: return plain_.add(a, b, w);
    case 2: return upTo(plain_.mul(a, b, w) + 1, w);
    default: return plain_.mul(a, b, w);
  }
}
Mutated::Bits Mutated::udiv(Bits a, Bits b, int w, Where at) const {
  switch (change(Op::UDiv, at)) {
    case 1: return plain_.urem(a, b, w);
    case 2: return upTo(plain_.udiv(a, b, w) + 1, w);
    default: return plain_.udiv(a, b, w);
  }
}
Mutated::Bits Mutated::urem(Bits a, Bits b, int w, Where at) const {
  switch (change(Op::URem, at)) {
    case 1: return plain_.udiv(a, b, w);
    case 2: return upTo(plain_.urem(a, b, w) + 1, w);
    default: return plain_.urem(a, b, w);
  }
}
Mutated::Bits Mutated::sdiv(Bits a, Bits b, int w, Where at) const {
  switch (change(Op::SDiv, at)) {
    case 1: return plain_.udiv(a, b, w);
    case 2: return upTo(plain_.sdiv(a, b, w) + 1, w);
    default: return plain_.sdiv(a, b, w);
  }
}
Mutated::Bits Mutated::srem(Bits a, Bits b, int w, Where at) const {
  switch (change(Op::SRem, at)) {
    case 1: return plain_.urem(a, b, w);
    case 2: return upTo(plain_.srem(a, b, w) + 1, w);
    default: return plain_.srem(a, b, w);
  }
}
Mutated::Bits Mutated::band(Bits a, Bits b, int, Where at) const {
  switch (change(Op::BitAnd, at)) {
    case 1: return a | b;
    case 2: return a ^ b;
    default: return a & b;
  }
}
Mutated::Bits Mutated::bor(Bits a, Bits b, int, Where at) const { return change(Op::BitOr, at) == 1 ? a & b : a | b; }
Mutated::Bits Mutated::bxor(Bits a, Bits b, int, Where at) const {
  switch (change(Op::BitXor, at)) {
    case 1: return a | b;
    case 2: return a & b;
    default: return a ^ b;
  }
}
Mutated::Bits Mutated::bnot(Bits a, int w, Where at) const {
  switch (change(Op::BitNot, at)) {
    case 1: return a;
    case 2: return upTo(0 - a, w);
    default: return upTo(~a, w);
  }
}
Mutated::Bits Mutated::shl(Bits a, Bits n, int w, Where at) const {
  switch (change(Op::ShiftLeft, at)) {
    case 1: return plain_.lshr(a, n, w);
    case 2: return plain_.shl(a, n + 1, w);
    default: return plain_.shl(a, n, w);
  }
}
Mutated::Bits Mutated::lshr(Bits a, Bits n, int w, Where at) const {
  switch (change(Op::ShiftRight, at)) {
    case 1: return plain_.shl(a, n, w);
    case 2: return plain_.lshr(a, n + 1, w);
    default: return plain_.lshr(a, n, w);
  }
}
bool Mutated::equal(Bits a, Bits b, int, Where at) const {
  switch (change(Op::Equal, at)) {
    case 1: return a != b;
    case 2: return a >= b;
    default: return a == b;
  }
}
bool Mutated::ult(Bits a, Bits b, int, Where at) const {
  switch (change(Op::ULess, at)) {
    case 1: return a >= b;
    case 2: return a <= b;
    default: return a < b;
  }
}
bool Mutated::ule(Bits a, Bits b, int, Where at) const {
  switch (change(Op::ULessEqual, at)) {
    case 1: return a > b;
    case 2: return a < b;
    default: return a <= b;
  }
}
bool Mutated::slt(Bits a, Bits b, int w, Where at) const {
  switch (change(Op::SLess, at)) {
    case 1: return !plain_.slt(a, b, w);
    case 2: return plain_.sle(a, b, w);
    case 3: return a < b;
    default: return plain_.slt(a, b, w);
  }
}
bool Mutated::sle(Bits a, Bits b, int w, Where at) const {
  switch (change(Op::SLessEqual, at)) {
    case 1: return !plain_.sle(a, b, w);
    case 2: return plain_.slt(a, b, w);
    case 3: return a <= b;
    default: return plain_.sle(a, b, w);
  }
}
Mutated::Bits Mutated::select(bool c, Bits a, Bits b, int, Where at) const {
  return change(Op::Select, at) == 1 ? c ? b : a : c ? a : b;
}
Mutated::Bits Mutated::zext(Bits a, int, int, Where at) const { return change(Op::ZeroExtend, at) == 1 ? a ^ 1 : a; }
Mutated::Bits Mutated::sext(Bits a, int from, int to, Where at) const {
  switch (change(Op::SignExtend, at)) {
    case 1: return a;
    case 2: return plain_.sext(a, from, to) ^ 1;
    default: return plain_.sext(a, from, to);
  }
}
Mutated::Bits Mutated::extract(Bits a, int high, int low, Where at) const {
  switch (change(Op::Extract, at)) {
    case 1: return plain_.extract(a, high, low) ^ 1;
    case 2: return plain_.extract(a, high, low) ^ (1ULL << (high - low));
    default: return plain_.extract(a, high, low);
  }
}
Mutated::Bits Mutated::concat(Bits high, int highWidth, Bits low, int lowWidth, Where at) const {
  switch (change(Op::Concat, at)) {
    case 1: return upTo(~high, highWidth) << lowWidth | low;
    case 2: return high << lowWidth | upTo(~low, lowWidth);
    default: return high << lowWidth | low;
  }
}
bool Mutated::bit(Bits a, int i, Where at) const {
  return change(Op::Bit, at) == 1 ? !plain_.bit(a, i) : plain_.bit(a, i);
}
Mutated::Bits Mutated::fromBool(bool a, int, Where at) const {
  return change(Op::FromBool, at) == 1 ? a ? 0 : 1 : a ? 1 : 0;
}
Mutated::Bits Mutated::radd(Bits a, Bits b, Where at) const {
  switch (change(Op::RealAdd, at)) {
    case 1: return plain_.rsub(a, b);
    case 2: return plain_.rmul(a, b);
    default: return plain_.radd(a, b);
  }
}
Mutated::Bits Mutated::rsub(Bits a, Bits b, Where at) const {
  switch (change(Op::RealSub, at)) {
    case 1: return plain_.radd(a, b);
    case 2: return plain_.rsub(b, a);
    default: return plain_.rsub(a, b);
  }
}
Mutated::Bits Mutated::rmul(Bits a, Bits b, Where at) const {
  switch (change(Op::RealMul, at)) {
    case 1: return plain_.rdiv(a, b);
    case 2: return plain_.radd(a, b);
    default: return plain_.rmul(a, b);
  }
}
Mutated::Bits Mutated::rdiv(Bits a, Bits b, Where at) const {
  switch (change(Op::RealDiv, at)) {
    case 1: return plain_.rmul(a, b);
    case 2: return plain_.rdiv(b, a);
    default: return plain_.rdiv(a, b);
  }
}
Mutated::Bits Mutated::rfunction(std::uint64_t f, Bits a, Where at) const {
  switch (change(Op::RealFunction, at)) {
    case 1: return plain_.rfunction((f + 1) % 6, a);
    case 2: return a;
    default: return plain_.rfunction(f, a);
  }
}
bool Mutated::requal(Bits a, Bits b, Where at) const {
  switch (change(Op::RealEqual, at)) {
    case 1: return !plain_.requal(a, b);
    case 2: return plain_.requal(a, b) || plain_.rless(b, a);
    default: return plain_.requal(a, b);
  }
}
bool Mutated::rless(Bits a, Bits b, Where at) const {
  switch (change(Op::RealLess, at)) {
    case 1: return !plain_.rless(a, b);
    case 2: return plain_.rless(a, b) || plain_.requal(a, b);
    default: return plain_.rless(a, b);
  }
}
bool Mutated::rlegal(Bits a, Where at) const {
  return change(Op::RealLegal, at) == 1 ? !plain_.rlegal(a) : plain_.rlegal(a);
}
Mutated::Bits Mutated::rfromInt(Bits a, Where at) const {
  switch (change(Op::RealFromInt, at)) {
    case 1: return plain_.rfromInt(a + 1);
    case 2: return Concrete::pattern(static_cast<float>(a));
    default: return plain_.rfromInt(a);
  }
}
Mutated::Bits Mutated::rtoInt(Bits a, bool round, Where at) const {
  switch (change(Op::RealToInt, at)) {
    case 1: return plain_.rtoInt(a, !round);
    case 2: return plain_.rtoInt(a, round) + 1;
    default: return plain_.rtoInt(a, round);
  }
}

Mutated::Bits Mutated::external(const ExternalSite& site, int width, Where at) {
  return upTo(outside_->external(site, width) ^ (change(Op::External, at) != 0 ? 1U : 0U), width);
}
void Mutated::report(Hazard hazard, bool, const Instruction* place, Where at) {
  if (change(Op::Report, at) != 1) outside_->report(hazard, place);
}
void Mutated::signal(Signal which, std::uint32_t index, bool guard, Where at) {
  const int c = change(Op::Signal, at);
  if (guard && c != 1) outside_->signal(which, c == 2 ? index + 1 : index);
}

}  // namespace rungproof::mutation
