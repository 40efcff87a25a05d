// Values in registers of 512 bits, in mask registers and in general ones: from form to form.
#include <cstring>

#include "engine/lanes/vector_forms.hpp"
#include "engine/lanes/wide_emitter.hpp"
#include "ir/check.hpp"

namespace rungproof::lanes {

using namespace asmjit;  // its Operand: by its full name
namespace Inst = x86::Inst;

asmjit::Operand WideEmitter::truthSource(ValueId id) {
  if (code_.steps[id].op == CodeOp::LoadBit) readHere(id);
  const auto slot = slotOf_.find(id);
  if (slot != slotOf_.end() && !truths_.contains(id)) return at(slot->second, wideTruthBytes);
  return truth(id);
}

x86::Gp WideEmitter::truth(ValueId id) {
  const Step& s = code_.steps[id];
  if (const auto found = truths_.find(id); found != truths_.end()) return found->second;
  if (s.op == CodeOp::LoadBit) readHere(id);
  Gp value;
  const Rep own = s.op == CodeOp::Constant ? Rep::Truth : repFor(widthOf(s));
  if (s.op == CodeOp::False || s.op == CodeOp::True || s.op == CodeOp::Constant) {
    value = freshGp();
    const bool isOn = s.op == CodeOp::True || (s.op == CodeOp::Constant && (s.value & 1) != 0);
    if (isOn)
      c_.mov(value, -1);
    else
      c_.xor_(value.r32(), value.r32());
    return value;
  }
  if (const auto slot = slotOf_.find(id); slot != slotOf_.end()) {
    value = freshGp();
    c_.mov(value, at(slot->second, wideTruthBytes));
  } else if (own == Rep::Truth) {
    for (int r = static_cast<int>(Rep::Byte); r <= static_cast<int>(Rep::Quad) && !value.isValid(); ++r) {
      const auto masks = masks_.find(keyOf(id, static_cast<Rep>(r)));
      if (masks != masks_.end()) value = truthFrom(masks->second, static_cast<Rep>(r));
    }
    if (!value.isValid()) {
      value = freshGp();
      c_.mov(value, at(ofEarlierBlock(id).at, wideTruthBytes));
    }
  } else if (isScalar(id)) {
    value = copied(scalar(id));
    c_.and_(value.r32(), 1);
    c_.neg(value);
  } else {
    const Number bits = made(id);
    value = truthFrom(tested(bits, constant(1, bits.rep)), bits.rep);
  }
  holdTruth(id, value);
  return value;
}

/// What another block has read from memory and this one needs too.
void WideEmitter::readHere(ValueId id) {
  const bool isHere =
      slotOf_.contains(id) || truths_.contains(id) || numbers_.contains(keyOf(id, repFor(widthOf(code_.steps[id]))));
  if (flow_.readAgain.contains(id) && !isHere && flow_.blockOf[id] != flow_.blockOf[step_]) value(id);
}

/// A register with a truth value that may be changed: its own where it is used for the last time.
x86::Gp WideEmitter::writable(ValueId id) {
  const auto found = truths_.find(id);
  const auto& ends = flow_.endsAt[step_];
  const bool isLast = found != truths_.end() && gps_.holders(found->second) == 1 &&
                      std::find(ends.begin(), ends.end(), id) != ends.end();
  if (isLast) return found->second;
  const Gp to = freshGp();
  c_.emit(Inst::kIdMov, to, truthSource(id));
  return to;
}

WideEmitter::Masks WideEmitter::masksOf(ValueId id, Rep rep) {
  if (const auto found = masks_.find(keyOf(id, rep)); found != masks_.end()) return found->second;
  const Masks masks = masksFrom(truthSource(id), rep);
  holdMasks(id, rep, masks);
  return masks;
}

/// Each register of numbers has its part of the bits. What stands above that part in a mask has no effect.
WideEmitter::Masks WideEmitter::masksFrom(const asmjit::Operand& truth, Rep rep) {
  static constexpr std::array<InstId, 4> moves = {Inst::kIdKmovq, Inst::kIdKmovd, Inst::kIdKmovw, Inst::kIdKmovb};
  const InstId move = moves[static_cast<std::size_t>(rep) - 1];
  const auto bytes = static_cast<std::uint32_t>(wideTruthBytes / pieceCount(rep));
  Masks masks;
  for (std::size_t i = 0; i < pieceCount(rep); ++i) {
    masks[i] = freshMask();
    if (truth.isMem()) {
      Mem part = truth.as<Mem>().cloneAdjusted(static_cast<std::int64_t>(i * bytes));
      part.setSize(bytes);
      c_.emit(move, masks[i], part);
    } else if (i == 0) {
      c_.kmovq(masks[0], truth.as<Gp>());
    } else {
      c_.kshiftrq(masks[i], masks[0], imm(8 * bytes * i));
    }
  }
  return masks;
}

x86::Gp WideEmitter::truthFrom(const Masks& masks, Rep rep) {
  static constexpr std::array<InstId, 3> unpack = {Inst::kIdKunpckbw, Inst::kIdKunpckwd, Inst::kIdKunpckdq};
  std::array<Mask, mostPieces> parts = masks;
  std::size_t count = pieceCount(rep);
  for (std::size_t level = rep == Rep::Quad ? 0 : rep == Rep::Double ? 1 : 2; count > 1; ++level, count /= 2) {
    for (std::size_t i = 0; i < count / 2; ++i) {
      const Mask both = freshMask();
      c_.emit(unpack[level], both, parts[2 * i + 1], parts[2 * i]);
      parts[i] = both;
    }
  }
  const Gp value = freshGp();
  const Mask here = rep == Rep::Byte
                        ? freshMask()
                        : parts[0];  // the library would take a spilled one from memory, which this move cannot
  if (rep == Rep::Byte) c_.kmovq(here, parts[0]);
  c_.kmovq(value, here);
  return value;
}

/// The place of the state where a piece stands.
std::optional<std::size_t> WideEmitter::placeOf(const asmjit::Operand& piece) const {
  if (!piece.isMem() || piece.as<Mem>().baseId() != rows_.id() || piece.as<Mem>().hasIndex()) return std::nullopt;
  const auto place = static_cast<std::size_t>(piece.as<Mem>().offset());
  return place < layout_.stateEnd ? std::optional(place) : std::nullopt;
}

/// The register that has been read from there a short while ago, or the piece itself.
asmjit::Operand WideEmitter::source(const asmjit::Operand& piece) {
  const auto place = placeOf(piece);
  const auto copy = place ? copies_.find(*place) : copies_.end();
  if (copy == copies_.end()) return piece;
  copy->second.usedAt = step_;
  return copy->second.reg;
}

x86::Zmm WideEmitter::inRegister(const asmjit::Operand& piece) {
  const asmjit::Operand here = source(piece);
  if (here.isReg()) return here.as<Zmm>();
  const Zmm reg = freshZmm();
  c_.vmovdqa64(reg, piece.as<Mem>());
  if (const auto place = placeOf(piece)) holdCopy(*place, reg);
  return reg;
}

void WideEmitter::save(std::size_t offset, const Number& value) {
  for (std::size_t i = 0; i < pieceCount(value.rep); ++i)
    c_.vmovdqa64(at(offset + wideBytes * i), inRegister(value.piece[i]));
}

WideNumber WideEmitter::each(InstId id, const Number& a, const Number& b) {
  Number to{a.rep};
  for (std::size_t i = 0; i < pieceCount(a.rep); ++i) {
    const Zmm result = freshZmm();
    const Zmm first = inRegister(a.piece[i]);
    c_.emit(id, result, first, source(b.piece[i]));
    to.piece[i] = result;
  }
  return to;
}

WideEmitter::Masks WideEmitter::compared(InstId id, const Number& a, const Number& b, std::uint32_t how) {
  Masks masks;
  for (std::size_t i = 0; i < pieceCount(a.rep); ++i) {
    masks[i] = freshMask();
    const Zmm first = inRegister(a.piece[i]);
    c_.emit(id, masks[i], first, source(b.piece[i]), imm(how));
  }
  return masks;
}

/// Where any of these bits is on.
WideEmitter::Masks WideEmitter::tested(const Number& a, const Number& bits) {
  Masks masks;
  for (std::size_t i = 0; i < pieceCount(a.rep); ++i) {
    masks[i] = freshMask();
    c_.emit(formOf(forms::bitTest, a.rep), masks[i], inRegister(a.piece[i]), bits.piece[i]);
  }
  return masks;
}

/// The same number for every trace.
WideNumber WideEmitter::constant(std::uint64_t value, Rep rep) {
  Number all{rep};
  asmjit::Operand source;
  if (value == 0) {
    const Zmm zero = freshZmm();
    c_.vpxord(zero, zero, zero);
    source = zero;
  } else {
    std::array<std::uint8_t, wideBytes> row;
    const std::size_t bytes = static_cast<std::size_t>(bitsOf(rep)) / 8;
    for (std::size_t i = 0; i < wideBytes; i += bytes) std::memcpy(row.data() + i, &value, bytes);
    source = c_.newConst(ConstPoolScope::kGlobal, row.data(), wideBytes);
  }
  for (std::size_t i = 0; i < pieceCount(rep); ++i) all.piece[i] = source;
  return all;
}

WideNumber WideEmitter::loaded(Row row) {
  Number value{row.rep};
  for (std::size_t i = 0; i < pieceCount(row.rep); ++i) value.piece[i] = at(row.at + wideBytes * i);
  return value;
}

WideNumber WideEmitter::copyOf(Row row) {
  Number value = loaded(row);
  for (std::size_t i = 0; i < pieceCount(row.rep); ++i) value.piece[i] = inRegister(value.piece[i]);
  return value;
}

WideNumber WideEmitter::widened(const Number& value) {
  static constexpr std::array<InstId, 3> extend = {Inst::kIdVpmovzxbw, Inst::kIdVpmovzxwd, Inst::kIdVpmovzxdq};
  Number to{wider(value.rep)};
  for (std::size_t i = 0; i < pieceCount(value.rep); ++i) {
    const Zmm low = freshZmm(), high = freshZmm();
    const InstId id = extend[static_cast<std::size_t>(value.rep) - 1];
    if (value.piece[i].isMem()) {
      Mem half = value.piece[i].as<Mem>();
      half.setSize(wideBytes / 2);
      c_.emit(id, low, half);
      c_.emit(id, high, half.cloneAdjusted(wideBytes / 2));
    } else {
      const Zmm from = value.piece[i].as<Zmm>(), upper = freshZmm();
      c_.emit(id, low, from.ymm());
      c_.vextracti64x4(upper.ymm(), from, imm(1));
      c_.emit(id, high, upper.ymm());
    }
    to.piece[2 * i] = low;
    to.piece[2 * i + 1] = high;
  }
  return to;
}

/// What has no room in the narrower form is cut off.
WideNumber WideEmitter::narrowed(const Number& value) {
  static constexpr std::array<InstId, 3> truncate = {Inst::kIdVpmovwb, Inst::kIdVpmovdw, Inst::kIdVpmovqd};
  const InstId id = truncate[static_cast<std::size_t>(value.rep) - 1 - 1];
  Number to{narrower(value.rep)};
  for (std::size_t i = 0; i < pieceCount(to.rep); ++i) {
    const Zmm low = freshZmm(), high = freshZmm(), both = freshZmm();
    c_.emit(id, low.ymm(), inRegister(value.piece[2 * i]));
    c_.emit(id, high.ymm(), inRegister(value.piece[2 * i + 1]));
    c_.vinserti64x4(both, low, high.ymm(), imm(1));
    to.piece[i] = both;
  }
  return to;
}

WideNumber WideEmitter::cut(const Number& value, int width) {
  return width >= bitsOf(value.rep) ? value : each(Inst::kIdVpandq, value, constant(Concrete::mask(width), value.rep));
}

WideNumber WideEmitter::fit(Number value, Rep rep, int width) {
  while (value.rep > rep) value = narrowed(value);
  return cut(value, width);
}

WideNumber WideEmitter::shifted(const Number& value, bool isLeft, std::uint32_t count) {
  CHECK(value.rep >= Rep::Word, "bytes are shifted as words");
  Number to{value.rep};
  for (std::size_t i = 0; i < pieceCount(value.rep); ++i) {
    const Zmm result = freshZmm();
    c_.emit(formOf(isLeft ? forms::shiftLeft : forms::shiftRight, value.rep), result, inRegister(value.piece[i]),
            imm(count));
    to.piece[i] = result;
  }
  return to;
}

/// As it was made, or as an earlier block kept it.
WideNumber WideEmitter::made(ValueId id) {
  const Step& s = code_.steps[id];
  if (s.op == CodeOp::Constant) return constant(s.value, std::max(Rep::Byte, repFor(s.width)));
  const Rep rep = repFor(widthOf(s));
  if (rep == Rep::Truth) return use(id, Rep::Byte);
  if (s.op == CodeOp::LoadMemory) readHere(id);
  const auto found = numbers_.find(keyOf(id, rep));
  if (found != numbers_.end()) return found->second;
  Number value;
  if (isScalar(id)) {
    value = broadcast(scalar(id), rep);
  } else {
    value = loaded(ofEarlierBlock(id));
  }
  holdNumber(id, value);
  return value;
}

WideNumber WideEmitter::use(ValueId id, Rep rep) {
  const Step& s = code_.steps[id];
  CHECK(rep != Rep::Truth, "a truth value is no number");
  if (s.op == CodeOp::Constant) return constant(s.value, rep);
  const Rep own = repFor(widthOf(s));
  if (own == rep) return made(id);
  const auto found = numbers_.find(keyOf(id, rep));
  if (found != numbers_.end()) return found->second;
  Number value{rep};
  if (own == Rep::Truth) {
    const Masks masks = masksOf(id, rep);
    const Number one = constant(1, rep);
    for (std::size_t i = 0; i < pieceCount(rep); ++i) {
      const Zmm to = freshZmm();
      c_.k(masks[i]).z().emit(formOf(forms::maskedMove, rep), to, one.piece[i]);
      value.piece[i] = to;
    }
  } else if (isScalar(id)) {
    value = broadcast(scalar(id), rep);
  } else {
    value = rep > own ? widened(use(id, narrower(rep))) : narrowed(use(id, wider(rep)));
  }
  holdNumber(id, value);
  return value;
}

}  // namespace rungproof::lanes
