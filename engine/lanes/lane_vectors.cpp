// Values in vector registers: from form to form, constants, and the choice by masks.
#include <cstring>

#include "engine/lanes/lane_emitter.hpp"
#include "engine/lanes/vector_forms.hpp"
#include "ir/check.hpp"

namespace rungproof::lanes {

using namespace asmjit;  // its Operand: by its full name
namespace Inst = x86::Inst;

namespace {

std::uint64_t formKey(ValueId id, Rep rep, bool isMask) {
  return std::uint64_t{id} << 4 | static_cast<std::uint64_t>(rep) << 1 | (isMask ? 1 : 0);
}

}  // namespace

void LaneEmitter::hold(ValueId id, Rep rep, bool isMask, const Vec& value) {
  if (!values_.try_emplace(formKey(id, rep, isMask), value).second) return;
  for (std::size_t i = 0; i < pieceCount(rep); ++i) ymms_.hold(value.piece[i]);
}

/// Behind a step: what nobody needs any more is free.
void LaneEmitter::release() {
  for (const ValueId id : flow_.endsAt[step_]) {
    for (const bool isMask : {false, true}) {
      for (int rep = 0; rep <= static_cast<int>(Rep::Quad); ++rep) {
        const auto found = values_.find(formKey(id, static_cast<Rep>(rep), isMask));
        if (found == values_.end()) continue;
        for (std::size_t i = 0; i < pieceCount(found->second.rep); ++i) ymms_.drop(found->second.piece[i]);
        values_.erase(found);
      }
    }
  }
  ymms_.endStep();
}

void LaneEmitter::forgetAll() {
  values_.clear();
  ymms_.clear();
}

x86::Ymm LaneEmitter::load(std::size_t offset) {
  const Ymm reg = fresh();
  c_.vmovdqa(reg, at(offset));
  return reg;
}
void LaneEmitter::save(std::size_t offset, const Ymm& value) { c_.vmovdqa(at(offset), value); }
void LaneEmitter::save(std::size_t offset, const Vec& value) {
  for (std::size_t i = 0; i < pieceCount(value.rep); ++i) save(offset + rowBytes * i, value.piece[i]);
}

x86::Ymm LaneEmitter::op(InstId id, const asmjit::Operand& a, const asmjit::Operand& b) {
  const Ymm to = fresh();
  c_.emit(id, to, a, b);
  return to;
}
Vec LaneEmitter::each(InstId id, const Vec& a, const Vec& b) {
  Vec to{a.rep};
  for (std::size_t i = 0; i < pieceCount(a.rep); ++i) to.piece[i] = op(id, a.piece[i], b.piece[i]);
  return to;
}
Vec LaneEmitter::each(InstId id, const Vec& a, const Mem& b) {
  Vec to{a.rep};
  for (std::size_t i = 0; i < pieceCount(a.rep); ++i) to.piece[i] = op(id, a.piece[i], b);
  return to;
}

Vec LaneEmitter::loaded(Row row) {
  Vec value{row.rep};
  for (std::size_t i = 0; i < pieceCount(row.rep); ++i) value.piece[i] = load(row.at + rowBytes * i);
  return value;
}

/// The same number for every trace.
x86::Mem LaneEmitter::constantRow(std::uint64_t value, Rep rep) {
  if (rep == Rep::Truth) value = value != 0 ? 0xFF : 0;
  std::array<std::uint8_t, rowBytes> row;
  const std::size_t bytes = rep == Rep::Truth ? 1 : static_cast<std::size_t>(bitsOf(rep)) / 8;
  for (std::size_t i = 0; i < rowBytes; i += bytes) std::memcpy(row.data() + i, &value, bytes);
  return c_.newConst(ConstPoolScope::kGlobal, row.data(), rowBytes);
}
Vec LaneEmitter::constant(std::uint64_t value, Rep rep) {
  const Ymm reg = fresh();
  if (value == 0)
    c_.vpxor(reg, reg, reg);
  else
    c_.vmovdqa(reg, constantRow(value, rep));
  Vec all{rep};
  for (std::size_t i = 0; i < pieceCount(rep); ++i) all.piece[i] = reg;
  return all;
}

Vec LaneEmitter::widened(const Vec& value, bool isMask) {
  static constexpr std::array<std::array<InstId, 2>, 3> unpack = {{{Inst::kIdVpunpcklbw, Inst::kIdVpunpckhbw},
                                                                   {Inst::kIdVpunpcklwd, Inst::kIdVpunpckhwd},
                                                                   {Inst::kIdVpunpckldq, Inst::kIdVpunpckhdq}}};
  const auto& [low, high] = unpack[static_cast<std::size_t>(value.rep) - 1];
  Vec to{wider(value.rep)};
  const Ymm zero = isMask ? Ymm{} : constant(0, value.rep).piece[0];
  for (std::size_t i = 0; i < pieceCount(value.rep); ++i) {
    const Ymm& above = isMask ? value.piece[i] : zero;
    to.piece[2 * i] = op(low, value.piece[i], above);
    to.piece[2 * i + 1] = op(high, value.piece[i], above);
  }
  return to;
}

/// Numbers must have room in the narrower form; of 64 bits the low half is taken.
Vec LaneEmitter::narrowed(const Vec& value, bool isMask) {
  Vec to{narrower(value.rep)};
  for (std::size_t i = 0; i < pieceCount(to.rep); ++i) {
    const Ymm &first = value.piece[2 * i], &second = value.piece[2 * i + 1];
    if (value.rep == Rep::Quad) {
      to.piece[i] = fresh();
      c_.vshufps(to.piece[i], first, second, 0x88);
    } else if (value.rep == Rep::Double) {
      to.piece[i] = op(isMask ? Inst::kIdVpackssdw : Inst::kIdVpackusdw, first, second);
    } else {
      to.piece[i] = op(isMask ? Inst::kIdVpacksswb : Inst::kIdVpackuswb, first, second);
    }
  }
  return to;
}
Vec LaneEmitter::toTruth(Vec mask) {
  while (mask.rep > Rep::Byte) mask = narrowed(mask, true);
  mask.rep = Rep::Truth;
  return mask;
}

Vec LaneEmitter::isOne(const Vec& number) {
  return toTruth(each(formOf(forms::equality, number.rep), number, constantRow(1, number.rep)));
}

Vec LaneEmitter::cut(const Vec& value, int width) {
  return width >= bitsOf(value.rep) ? value
                                    : each(Inst::kIdVpand, value, constantRow(Concrete::mask(width), value.rep));
}

Vec LaneEmitter::fit(Vec value, Rep rep, int width) {
  value = cut(value, width);
  while (value.rep > rep) value = narrowed(value, false);
  return value;
}

Vec LaneEmitter::shifted(const Vec& value, bool isLeft, std::uint32_t count) {
  CHECK(value.rep >= Rep::Word, "bytes are shifted as words");
  Vec to{value.rep};
  for (std::size_t i = 0; i < pieceCount(value.rep); ++i) {
    to.piece[i] = fresh();
    c_.emit(formOf(isLeft ? forms::shiftLeft : forms::shiftRight, value.rep), to.piece[i], value.piece[i], imm(count));
  }
  return to;
}

x86::Ymm LaneEmitter::inverted(const Ymm& truth) { return op(Inst::kIdVpxor, truth, constantRow(1, Rep::Truth)); }

x86::Ymm LaneEmitter::chosen(const Ymm& mask, const Ymm& ifOn, const Ymm& ifOff) {
  if (layout_.form == Form::Bits)
    return op(Inst::kIdVpxor, op(Inst::kIdVpand, op(Inst::kIdVpxor, ifOn, ifOff), mask), ifOff);
  const Ymm to = fresh();
  c_.vpblendvb(to, ifOff, ifOn, mask);
  return to;
}

/// As it was made, or as an earlier block kept it.
Vec LaneEmitter::made(ValueId id) {
  const Step& s = code_.steps[id];
  if (s.op == CodeOp::Constant) return constant(s.value, repFor(std::max<int>(s.width, 1)));
  const Rep rep = repFor(widthOf(s));
  const auto found = values_.find(formKey(id, rep, false));
  if (found != values_.end()) return found->second;
  Vec value;
  if (s.op == CodeOp::False || s.op == CodeOp::True) {
    value = constant(id, Rep::Truth);
  } else {
    value = flow_.readAgain.contains(id) ? valueOf(s) : loaded(ofEarlierBlock(id));
  }
  hold(id, rep, false, value);
  return value;
}

Vec LaneEmitter::use(ValueId id, Rep rep, bool isMask) {
  const Step& s = code_.steps[id];
  if (s.op == CodeOp::Constant) return constant(rep == Rep::Truth ? s.value & 1 : s.value, rep);
  const Rep own = repFor(widthOf(s));
  if (rep == own) return made(id);
  const auto found = values_.find(formKey(id, rep, isMask));
  if (found != values_.end()) return found->second;
  Vec value;
  if (rep > own) {
    value = rep == Rep::Byte ? made(id) : use(id, narrower(rep), isMask);
    if (rep == Rep::Byte) {
      value.rep = Rep::Byte;
      if (!isMask) value = each(Inst::kIdVpand, value, constantRow(1, Rep::Byte));
    } else {
      value = widened(value, isMask);
    }
  } else if (rep == Rep::Truth) {
    value = made(id);
    value = isOne(each(Inst::kIdVpand, value, constantRow(1, value.rep)));
  } else {
    value = fit(use(id, wider(rep)), rep, bitsOf(rep));
  }
  hold(id, rep, isMask, value);
  return value;
}

void LaneEmitter::value(ValueId id) {
  const Step& s = code_.steps[id];
  if (s.op == CodeOp::False || s.op == CodeOp::True || s.op == CodeOp::Constant) return;
  const Vec made = valueOf(s);
  CHECK(made.rep == repFor(widthOf(s)), "a value in a form that is not its own");
  hold(id, made.rep, false, made);
  keep(id, made);
}

}  // namespace rungproof::lanes
