// Values of recorded code: simplification, and what leaves the compiled form.
#include "engine/compiled/recorder.hpp"

#include <algorithm>

#include "ir/check.hpp"
#include "ir/s7200/error_codes.hpp"

namespace rungproof::compiled {

namespace {

/// Computes with constants; nothing else is asked of it.
class NoOutside final : public Outside {
 public:
  std::uint64_t external(const ExternalSite&, int) override { return 0; }
  void report(Hazard, const Instruction*) override {}
};

const Concrete& numbers() {
  static NoOutside outside;
  static const Concrete domain(outside);
  return domain;
}

std::uint64_t computed(CodeOp op, int w, std::uint64_t a, std::uint64_t b, std::uint64_t value) {
  const Concrete& d = numbers();
  switch (op) {
    case CodeOp::Add: return d.add(a, b, w);
    case CodeOp::Sub: return d.sub(a, b, w);
    case CodeOp::Mul: return d.mul(a, b, w);
    case CodeOp::DivideUnsigned: return d.udiv(a, b, w);
    case CodeOp::RemainderUnsigned: return d.urem(a, b, w);
    case CodeOp::DivideSigned: return d.sdiv(a, b, w);
    case CodeOp::RemainderSigned: return d.srem(a, b, w);
    case CodeOp::BitAnd: return d.band(a, b, w);
    case CodeOp::BitOr: return d.bor(a, b, w);
    case CodeOp::BitXor: return d.bxor(a, b, w);
    case CodeOp::BitNot: return d.bnot(a, w);
    case CodeOp::ShiftLeft: return d.shl(a, b, w);
    case CodeOp::ShiftRight: return d.lshr(a, b, w);
    case CodeOp::Signed: return d.sext(a, static_cast<int>(value), w);
    case CodeOp::Extract: return d.extract(a, static_cast<int>(value) + w - 1, static_cast<int>(value));
    case CodeOp::Join: return d.concat(a, w, b, static_cast<int>(value));
    case CodeOp::RealAdd: return d.radd(a, b);
    case CodeOp::RealSub: return d.rsub(a, b);
    case CodeOp::RealMul: return d.rmul(a, b);
    case CodeOp::RealDiv: return d.rdiv(a, b);
    case CodeOp::RealFunction: return d.rfunction(value, a);
    case CodeOp::RealFromInt: return d.rfromInt(a);
    case CodeOp::RealToInt: return d.rtoInt(a, value != 0);
    default: CHECK(false, "no operation on words");
  }
  return 0;
}

bool isTrueOf(CodeOp op, int w, std::uint64_t a, std::uint64_t b) {
  const Concrete& d = numbers();
  switch (op) {
    case CodeOp::Equal: return d.equal(a, b, w);
    case CodeOp::Less: return d.ult(a, b, w);
    case CodeOp::LessSigned: return d.slt(a, b, w);
    case CodeOp::AddOverflows: return d.sext(d.add(a, b, w), w, 64) != d.add(d.sext(a, w, 64), d.sext(b, w, 64), 64);
    case CodeOp::SubOverflows: return d.sext(d.sub(a, b, w), w, 64) != d.sub(d.sext(a, w, 64), d.sext(b, w, 64), 64);
    case CodeOp::RealEqual: return d.requal(a, b);
    case CodeOp::RealLess: return d.rless(a, b);
    case CodeOp::RealLegal: return d.rlegal(a);
    default: CHECK(false, "no comparison");
  }
  return false;
}

}  // namespace

Recorder::Recorder() { code.steps = {{.op = CodeOp::False}, {.op = CodeOp::True}}; }

std::size_t Recorder::StepHash::operator()(const Step& s) const {
  std::uint64_t mixed = static_cast<std::uint64_t>(s.op) << 8 | s.width;
  for (const std::uint64_t part : {std::uint64_t{s.a}, std::uint64_t{s.b}, std::uint64_t{s.c}, s.value})
    mixed = (mixed ^ part) * 0x9E3779B97F4A7C15ULL, mixed ^= mixed >> 29;
  return mixed;
}
bool Recorder::StepEqual::operator()(const Step& x, const Step& y) const {
  return x.op == y.op && x.width == y.width && x.a == y.a && x.b == y.b && x.c == y.c && x.value == y.value;
}

ValueId Recorder::add(const Step& step) {
  code.steps.push_back(step);
  const bool isStore = step.op == CodeOp::StoreMemory || step.op == CodeOp::StoreAt;
  if (step.op == CodeOp::Mark || (isStore && place_ && place_->area == step.area)) place_.reset();
  return static_cast<ValueId>(code.steps.size() - 1);
}

ValueId Recorder::make(const Step& step) {
  const auto [place, isNew] = known_.try_emplace(step, 0);
  if (isNew) place->second = add(step);
  return place->second;
}

void Recorder::takeBack(std::size_t first, std::size_t site) {
  code.steps.resize(first);
  code.sites.resize(site);
  place_.reset();
  forgetValues();
  std::erase_if(constants_, [&](const auto& constant) { return constant.second >= first; });
  store->forget();
}

void Recorder::branch(CodeOp op, Bool condition, std::uint64_t mark) {
  const bool isNot = at(condition.id).op == CodeOp::Not;
  const CodeOp opposite = op == CodeOp::BranchIf ? CodeOp::BranchUnless : CodeOp::BranchIf;
  add({.op = isNot ? opposite : op, .a = isNot ? at(condition.id).a : condition.id, .value = mark});
  assume(condition, op == CodeOp::BranchUnless);
}

Recorder::Part Recorder::beginPart(Bool condition) {
  Part part{code.steps.size(), replaced_, code.marks++};
  branch(CodeOp::BranchUnless, condition, part.mark);
  return part;
}
void Recorder::endPart(Part part) {
  add({.op = CodeOp::Mark, .value = part.mark});
  forgetKnown();
  replaced_ = std::move(part.replaced);
  store->forgetSince(part.first);
}

void Recorder::leave(Bool condition) {
  condition.id = resolved(condition.id);
  if (condition.id == 0) return;
  add({.op = CodeOp::Leave, .a = condition.id});
  assume(condition, false);
}

Recorder::Bits Recorder::literal(std::uint64_t v, int w) {
  const std::uint64_t value = v & Concrete::mask(w);
  const auto [place, isNew] = constants_.try_emplace(value, 0);
  if (isNew) place->second = add({.op = CodeOp::Constant, .width = static_cast<std::uint8_t>(w), .value = value});
  return {place->second};
}

std::optional<std::uint64_t> Recorder::known(Bits a) const {
  const Step& step = at(a.id);
  return step.op == CodeOp::Constant ? std::optional(step.value) : std::nullopt;
}

Recorder::Bits Recorder::word(CodeOp op, int w, Bits a, Bits b, std::uint64_t value) {
  const bool isUnary = operandCount(op) == 1;
  if (const auto x = known(a), y = isUnary ? x : known(b); x && y) {
    const int width = op == CodeOp::Join ? w + static_cast<int>(value) : op == CodeOp::RealToInt ? 64 : w;
    return literal(computed(op, w, *x, *y, value), width);
  }
  return {make({.op = op, .width = static_cast<std::uint8_t>(w), .a = a.id, .b = isUnary ? 0 : b.id, .value = value})};
}

Recorder::Bool Recorder::compare(CodeOp op, int w, Bits a, Bits b) {
  const auto x = known(a), y = operandCount(op) == 1 ? x : known(b);
  if (x && y) return constant(isTrueOf(op, w, *x, *y));
  return {make({.op = op, .width = static_cast<std::uint8_t>(w), .a = a.id, .b = b.id})};
}

Recorder::Bits Recorder::add(Bits a, Bits b, int w) {
  if (known(a) == 0U) return b;
  if (known(b) == 0U) return a;
  return word(CodeOp::Add, w, a, b);
}
Recorder::Bits Recorder::sub(Bits a, Bits b, int w) { return known(b) == 0U ? a : word(CodeOp::Sub, w, a, b); }
Recorder::Bits Recorder::mul(Bits a, Bits b, int w) { return word(CodeOp::Mul, w, a, b); }
Recorder::Bits Recorder::udiv(Bits a, Bits b, int w) { return word(CodeOp::DivideUnsigned, w, a, b); }
Recorder::Bits Recorder::urem(Bits a, Bits b, int w) { return word(CodeOp::RemainderUnsigned, w, a, b); }
Recorder::Bits Recorder::sdiv(Bits a, Bits b, int w) { return word(CodeOp::DivideSigned, w, a, b); }
Recorder::Bits Recorder::srem(Bits a, Bits b, int w) { return word(CodeOp::RemainderSigned, w, a, b); }
/// Numbers of one bit, as expressions of IEC 61131-3 have them, are truth values.
Recorder::Bits Recorder::band(Bits a, Bits b, int w) {
  if (w == 1) return fromBool(land(bit(a, 0), bit(b, 0)), 1);
  if (known(b) == Concrete::mask(w)) return a;
  if (known(a) == Concrete::mask(w)) return b;
  if (known(a) == 0U || known(b) == 0U) return literal(0, w);
  return word(CodeOp::BitAnd, w, a, b);
}
Recorder::Bits Recorder::bor(Bits a, Bits b, int w) {
  if (w == 1) return fromBool(lor(bit(a, 0), bit(b, 0)), 1);
  if (known(b) == 0U) return a;
  return known(a) == 0U ? b : word(CodeOp::BitOr, w, a, b);
}
Recorder::Bits Recorder::bxor(Bits a, Bits b, int w) {
  return w == 1 ? fromBool(lxor(bit(a, 0), bit(b, 0)), 1) : word(CodeOp::BitXor, w, a, b);
}
Recorder::Bits Recorder::bnot(Bits a, int w) {
  return w == 1 ? fromBool(lnot(bit(a, 0)), 1) : word(CodeOp::BitNot, w, a, {});
}
Recorder::Bits Recorder::shl(Bits a, Bits n, int w) { return known(n) == 0U ? a : word(CodeOp::ShiftLeft, w, a, n); }
Recorder::Bits Recorder::lshr(Bits a, Bits n, int w) { return known(n) == 0U ? a : word(CodeOp::ShiftRight, w, a, n); }

/// A sum or difference of numbers of half its width or less, of which the signs are continued.
std::optional<Recorder::NarrowSum> Recorder::narrowSum(Bits wide) {
  const Step step = at(wide.id);
  if (step.op != CodeOp::Add && step.op != CodeOp::Sub) return std::nullopt;
  const auto widthOf = [&](ValueId id) { return at(id).op == CodeOp::Signed ? static_cast<int>(at(id).value) : 0; };
  const int width = std::max(widthOf(step.a), widthOf(step.b));
  if (width < 2 || 2 * width > step.width) return std::nullopt;
  const auto narrow = [&](ValueId id) -> std::optional<Bits> {
    if (widthOf(id) == width) return Bits{at(id).a};
    const auto value = known({id});
    if (!value) return std::nullopt;
    const std::uint64_t low = *value & Concrete::mask(width);
    if (numbers().sext(low, width, step.width) != *value) return std::nullopt;
    return literal(low, width);
  };
  const auto x = narrow(step.a), y = narrow(step.b);
  if (!x || !y) return std::nullopt;
  return NarrowSum{*x, *y, width};
}

/// Whether `continued` is the low half of the sum `exact` with its sign, which differ where the low half overflows.
std::optional<Recorder::Bool> Recorder::fits(Bits continued, Bits exact) {
  const Step sign = at(continued.id), step = at(exact.id);
  if (sign.op != CodeOp::Signed || sign.width != step.width) return std::nullopt;
  const auto sum = narrowSum(exact);
  if (!sum || sum->width != static_cast<int>(sign.value) || (sum->width != 16 && sum->width != 32)) return std::nullopt;
  if (word(step.op, sum->width, sum->a, sum->b).id != sign.a) return std::nullopt;
  const CodeOp op = step.op == CodeOp::Add ? CodeOp::AddOverflows : CodeOp::SubOverflows;
  return lnot(compare(op, sum->width, sum->a, sum->b));
}

Recorder::Bool Recorder::equal(Bits a, Bits b, int w) {
  if (a.id == b.id) return constant(true);
  if (w == 1) return lnot(lxor(bit(a, 0), bit(b, 0)));
  if (w == at(b.id).width) {
    if (const auto fitting = fits(a, b)) return *fitting;
  }
  if (known(a) && !known(b)) std::swap(a, b);
  if (at(a.id).op == CodeOp::FromBit && known(b)) {
    const Bool truth{resolved(at(a.id).a)};
    return *known(b) == 0 ? lnot(truth) : *known(b) == 1 ? truth : constant(false);
  }
  return compare(CodeOp::Equal, w, a, b);
}
Recorder::Bool Recorder::ult(Bits a, Bits b, int w) {
  if (a.id == b.id || known(b) == 0U || known(a) == Concrete::mask(w)) return constant(false);
  return compare(CodeOp::Less, w, a, b);
}
Recorder::Bool Recorder::slt(Bits a, Bits b, int w) {
  return a.id == b.id ? constant(false) : compare(CodeOp::LessSigned, w, a, b);
}

/// The low word of `whole`, where `patched` is the same number with another low word.
std::optional<Recorder::Bits> Recorder::onlyLowDiffers(Bits whole, Bits patched) {
  const Step join = at(patched.id);
  if (join.op != CodeOp::Join || join.value != 16 || join.width != 16) return std::nullopt;
  const Step high = at(join.a);
  if (high.op != CodeOp::Extract || high.a != whole.id || high.value != 16) return std::nullopt;
  return extract(whole, 15, 0);
}

Recorder::Bits Recorder::select(Bool c, Bits a, Bits b, int w) {
  c.id = resolved(c.id);
  if (c.id == 1 || a.id == b.id) return a;
  if (c.id == 0) return b;
  if (w == 1) return fromBool(select(c, bit(a, 0), bit(b, 0)), 1);
  if (at(c.id).op == CodeOp::Not) return select({at(c.id).a}, b, a, w);
  if (at(a.id).op == CodeOp::Select && at(a.id).a == c.id) return select(c, {at(a.id).b}, b, w);
  if (code.isWholeScan) {
    if (const auto low = onlyLowDiffers(a, b))
      return concat({at(b.id).a}, w - 16, select(c, *low, {at(b.id).b}, 16), 16);
    if (const auto low = onlyLowDiffers(b, a))
      return concat({at(a.id).a}, w - 16, select(c, {at(a.id).b}, *low, 16), 16);
  }
  if (const Step below = at(b.id); below.op == CodeOp::Select) {
    if (below.a == c.id) return select(c, a, {below.c}, w);
    for (const auto& [part, rest] : partsOf(c.id)) {
      if (part == below.a) return select({below.a}, select({rest}, a, {below.b}, w), {below.c}, w);
      if (code.isWholeScan && isOpposite(part, below.a))
        return select({below.a}, {below.b}, select({rest}, a, {below.c}, w), w);
    }
    if (const auto way = code.isWholeScan ? forked(c.id, below.a) : std::nullopt)
      return select(way->common, select(way->own, a, {below.b}, w), {below.c}, w);
  }
  const ValueId id =
      make({.op = CodeOp::Select, .width = static_cast<std::uint8_t>(w), .a = c.id, .b = a.id, .c = b.id});
  selects_[pairOf(c.id, b.id)] = id;
  return {id};
}

Recorder::Bits Recorder::sext(Bits a, int from, int to) {
  return from == to ? a : word(CodeOp::Signed, to, a, {}, static_cast<std::uint64_t>(from));
}

Recorder::Bits Recorder::extract(Bits a, int high, int low) {
  const Step step = at(a.id);
  const int w = high - low + 1;
  if (low == 0 && step.op != CodeOp::Constant && step.width != 0 && step.op != CodeOp::Join && step.width <= w)
    return a;
  if (step.op == CodeOp::Join) {
    const int below = static_cast<int>(step.value);
    if (high < below) return extract({step.b}, high, low);
    if (low >= below) return extract({step.a}, high - below, low - below);
  }
  const bool isNarrow = step.op != CodeOp::Join && step.op != CodeOp::Constant && step.width != 0;
  if (isNarrow && low >= step.width) return literal(0, w);
  const bool isBitwise = step.op == CodeOp::BitAnd || step.op == CodeOp::BitOr || step.op == CodeOp::BitXor;
  if (isBitwise && known({step.b})) {
    const Bits a = extract({step.a}, high, low), b = extract({step.b}, high, low);
    return step.op == CodeOp::BitAnd ? band(a, b, w) : step.op == CodeOp::BitOr ? bor(a, b, w) : bxor(a, b, w);
  }
  if (step.op == CodeOp::Signed && high < static_cast<int>(step.value)) return extract({step.a}, high, low);
  if (step.op == CodeOp::Select && code.isWholeScan && (at(step.b).op == CodeOp::Join || at(step.c).op == CodeOp::Join))
    return select({step.a}, extract({step.b}, high, low), extract({step.c}, high, low), w);
  if (const auto sum = narrowSum(a); sum && low == 0 && w <= sum->width)
    return extract(word(step.op, sum->width, sum->a, sum->b), high, low);
  if (step.op == CodeOp::Extract) {
    const int from = static_cast<int>(step.value);
    return extract({step.a}, std::min(high, step.width - 1) + from, low + from);
  }
  return word(CodeOp::Extract, w, a, {}, static_cast<std::uint64_t>(low));
}

Recorder::Bits Recorder::concat(Bits high, int highWidth, Bits low, int lowWidth) {
  if (known(high) == 0U) return low;
  return word(CodeOp::Join, highWidth, high, low, static_cast<std::uint64_t>(lowWidth));
}

/// Whether the form of the step alone says that the bit is 0.
bool Recorder::isZeroAt(ValueId id, int i) const {
  const Step& step = at(id);
  const auto isMasked = [&](ValueId mask) { return known({mask}) && (*known({mask}) >> i & 1) == 0; };
  switch (step.op) {
    case CodeOp::Constant: return isMasked(id);
    case CodeOp::FromBit: return i > 0;
    case CodeOp::BitAnd: return isMasked(step.a) || isMasked(step.b);
    case CodeOp::ShiftLeft: return known({step.b}) > static_cast<std::uint64_t>(i);
    default: return false;
  }
}

/// What has the same bit `i` as a byte in which other bits have been replaced; at most so many of them are looked at.
Recorder::Bits Recorder::behindPatches(Bits a, int i) const {
  constexpr int mostLooks = 32;
  const auto isOneAt = [&](ValueId id) { return at(id).op == CodeOp::Constant && !isZeroAt(id, i); };
  for (int look = 0; look < mostLooks; ++look) {
    const Step& step = at(a.id);
    if ((step.op == CodeOp::BitOr && isZeroAt(step.a, i)) || (step.op == CodeOp::BitAnd && isOneAt(step.a)))
      a = {step.b};
    else if ((step.op == CodeOp::BitOr && isZeroAt(step.b, i)) || (step.op == CodeOp::BitAnd && isOneAt(step.b)))
      a = {step.a};
    else
      break;
  }
  return a;
}

Recorder::Bool Recorder::bit(Bits a, int i) {
  a = behindPatches(a, i);
  const Step step = at(a.id);
  if (step.op == CodeOp::Constant) return constant((step.value >> i & 1) != 0);
  if (step.op == CodeOp::FromBit) return i == 0 ? Bool{resolved(step.a)} : constant(false);
  if (step.op == CodeOp::Extract && i < step.width) return bit({step.a}, i + static_cast<int>(step.value));
  if (step.op == CodeOp::Join) {
    const int below = static_cast<int>(step.value);
    return i < below ? bit({step.b}, i) : bit({step.a}, i - below);
  }
  if (const auto sum = narrowSum(a); sum && i < sum->width) return bit(word(step.op, sum->width, sum->a, sum->b), i);
  if (const auto left = step.op == CodeOp::ShiftLeft ? known({step.b}) : std::nullopt; left && i < step.width)
    return i < static_cast<int>(*left) ? constant(false) : bit({step.a}, i - static_cast<int>(*left));
  return {make({.op = CodeOp::TestBit, .width = 1, .a = a.id, .value = static_cast<std::uint64_t>(i)})};
}

Recorder::Bits Recorder::fromBool(Bool a, int w) {
  a.id = resolved(a.id);
  if (a.id <= 1) return literal(a.id, w);
  return {make({.op = CodeOp::FromBit, .width = 1, .a = a.id})};
}

Recorder::Bits Recorder::freshFromBool(Bool a, int w) {
  a.id = resolved(a.id);
  if (a.id <= 1) return literal(a.id, w);
  return {add({.op = CodeOp::FromBit, .width = 1, .a = a.id})};
}

Recorder::Bits Recorder::radd(Bits a, Bits b) { return word(CodeOp::RealAdd, 32, a, b); }
Recorder::Bits Recorder::rsub(Bits a, Bits b) { return word(CodeOp::RealSub, 32, a, b); }
Recorder::Bits Recorder::rmul(Bits a, Bits b) { return word(CodeOp::RealMul, 32, a, b); }
Recorder::Bits Recorder::rdiv(Bits a, Bits b) { return word(CodeOp::RealDiv, 32, a, b); }
Recorder::Bits Recorder::rfunction(std::uint64_t f, Bits a) { return word(CodeOp::RealFunction, 32, a, {}, f); }
Recorder::Bool Recorder::requal(Bits a, Bits b) { return compare(CodeOp::RealEqual, 32, a, b); }
Recorder::Bool Recorder::rless(Bits a, Bits b) { return compare(CodeOp::RealLess, 32, a, b); }
Recorder::Bool Recorder::rlegal(Bits a) { return compare(CodeOp::RealLegal, 32, a, {}); }
Recorder::Bits Recorder::rfromInt(Bits a) { return word(CodeOp::RealFromInt, 32, a, {}); }
Recorder::Bits Recorder::rtoInt(Bits a, bool round) { return word(CodeOp::RealToInt, 64, a, {}, round ? 1 : 0); }

Recorder::Bits Recorder::external(const ExternalSite& site, int width) {
  switch (site.kind) {
    case External::StackBottom:
    case External::LocalMemory:
    case External::UnknownStatus:
    case External::UnknownResult:
      if (site.index == errorCodeIndex) return cannotFollow(width);  // the engine knows which error it was
      return literal(0, width);                                      // by Choice::UnknownBits, or nothing is compiled
    case External::RegisterAtStart:
    case External::AccessError:
    case External::TimerPhase: code.takesFree = true; return literal(0, width);
    case External::ImmediateInput: code.asksOutside = true; return store->get(Reg::PhysicalInput, site.index);
    case External::AnalogInput: code.asksOutside = true; return store->load(Area::AI, site.index * 8, width);
    default: return cannotFollow(width);
  }
}

void Recorder::report(Hazard hazard, Bool condition, const Instruction* place) {
  add({.op = CodeOp::Count, .a = resolved(condition.id), .value = code.sites.size()});
  code.sites.push_back({hazard, place});
}

Recorder::Bits Recorder::cannotFollow(int width) {
  leave(*guard);
  return literal(0, width);
}

}  // namespace rungproof::compiled
