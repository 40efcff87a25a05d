// Numbers that all traces have in common, each in one general register, the bits above its width 0.
#include "engine/lanes/wide_emitter.hpp"
#include "ir/check.hpp"

namespace rungproof::lanes {

using namespace asmjit;  // its Operand: by its full name
namespace Inst = x86::Inst;

bool WideEmitter::isScalar(ValueId id) const {
  const Step& s = code_.steps[id];
  return s.op == CodeOp::Constant || (flow_.isCommon[id] && repFor(widthOf(s)) != Rep::Truth);
}

x86::Gp WideEmitter::scalar(ValueId id) {
  const Step& s = code_.steps[id];
  if (const auto found = scalars_.find(id); found != scalars_.end()) return found->second;
  const Gp value = freshGp();
  if (s.op == CodeOp::Constant) {
    c_.mov(value, imm(s.value));
    return value;
  }
  if (repFor(widthOf(s)) == Rep::Truth) {
    c_.mov(value, truth(id));
    c_.and_(value.r32(), 1);
    return value;
  }
  if (flow_.readAgain.contains(id)) {
    this->value(id);
    return scalars_.at(id);
  }
  c_.mov(value, at(ofEarlierBlock(id).at, 8));
  holdScalar(id, value);
  return value;
}

x86::Gp WideEmitter::copied(const Gp& value) {
  const Gp to = freshGp();
  c_.mov(to, value);
  return to;
}

/// Changes the register.
x86::Gp WideEmitter::cutScalar(const Gp& value, int width) {
  if (width == 32) {
    c_.mov(value.r32(), value.r32());
  } else if (width == 16) {
    c_.movzx(value.r32(), value.r16());
  } else if (width < 32) {
    c_.and_(value.r32(), imm(Concrete::mask(width)));
  } else if (width < 64) {
    c_.shl(value, imm(64 - width));
    c_.shr(value, imm(64 - width));
  }
  return value;
}

/// The number of the first trace.
x86::Gp WideEmitter::loadScalar(std::size_t offset, Rep rep) {
  const Gp value = freshGp();
  switch (rep) {
    case Rep::Byte: c_.movzx(value.r32(), at(offset, 1)); break;
    case Rep::Word: c_.movzx(value.r32(), at(offset, 2)); break;
    case Rep::Double: c_.mov(value.r32(), at(offset, 4)); break;
    default: c_.mov(value, at(offset, 8)); break;
  }
  return value;
}

x86::Gp WideEmitter::loadScalar(const Step& s) {
  if (s.op == CodeOp::LoadRegister) {
    if (const auto number = oneNumber(s.value)) return loadScalar(*number, Rep::Quad);
    const Row row = *layout_.reg(s.value);
    return loadScalar(row.at, row.rep);
  }
  if (s.op == CodeOp::LoadStateWord) {
    const Row row = layout_.state(s.value);
    return cutScalar(loadScalar(row.at, row.rep), s.width);
  }
  const auto byte = static_cast<std::uint32_t>(s.value);
  if (const auto row = layout_.cell(s.area, byte, s.width / 8)) return loadScalar(row->at, row->rep);
  Gp value;
  for (std::uint32_t k = 0; k < s.width / 8U; ++k) {
    const auto row = layout_.cell(s.area, byte + k, 1);
    CHECK(row.has_value(), "a byte without a row");
    const Gp next = loadScalar(row->at, Rep::Byte);
    if (k > 0) {
      c_.shl(value, 8);
      c_.or_(value, next);
    } else {
      value = next;
    }
  }
  return value;
}

x86::Gp WideEmitter::scalarOf(const Step& s) {
  const auto both = [&](InstId id) {
    const Gp to = copied(scalar(s.a));
    c_.emit(id, to, scalar(s.b));
    return to;
  };
  switch (s.op) {
    case CodeOp::Add: return cutScalar(both(Inst::kIdAdd), s.width);
    case CodeOp::Sub: return cutScalar(both(Inst::kIdSub), s.width);
    case CodeOp::BitAnd: return both(Inst::kIdAnd);
    case CodeOp::BitOr: return both(Inst::kIdOr);
    case CodeOp::BitXor: return both(Inst::kIdXor);
    case CodeOp::BitNot: {
      const Gp to = copied(scalar(s.a));
      c_.not_(to);
      return cutScalar(to, s.width);
    }
    case CodeOp::ShiftLeft:
    case CodeOp::ShiftRight: {
      const std::uint64_t count = code_.steps[s.b].value;
      const Gp to = copied(scalar(s.a));
      if (count >= 64)
        c_.xor_(to.r32(), to.r32());
      else if (s.op == CodeOp::ShiftLeft)
        c_.shl(to, imm(count));
      else
        c_.shr(to, imm(count));
      return cutScalar(to, s.width);
    }
    case CodeOp::Select: {
      const Gp to = copied(scalar(s.c)), condition = truth(s.a);
      c_.test(condition, condition);
      c_.cmovnz(to, scalar(s.b));
      return to;
    }
    case CodeOp::Signed: {
      const Gp to = copied(scalar(s.a));
      c_.shl(to, imm(64 - s.value));
      c_.sar(to, imm(64 - s.value));
      return cutScalar(to, s.width);
    }
    case CodeOp::Extract: {
      const Gp to = copied(scalar(s.a));
      if (s.value >= 64)
        c_.xor_(to.r32(), to.r32());
      else
        c_.shr(to, imm(s.value));
      return cutScalar(to, s.width);
    }
    case CodeOp::Join: {
      const Gp to = copied(scalar(s.a));
      c_.shl(to, imm(s.value));
      c_.or_(to, scalar(s.b));
      return to;
    }
    case CodeOp::LoadTicks: {
      const Gp to = freshGp();
      c_.movzx(to.r32(), at(offsetof(LaneLayout::Head, ticks) + 4 * s.value, 2));
      return to;
    }
    default: return loadScalar(s);
  }
}

/// All bits on, or none.
x86::Gp WideEmitter::scalarTruth(const Step& s) {
  const auto spread = [&](x86::CondCode condition) {
    const Gp to = freshGp();
    c_.mov(to, 0);  // leaves the flags alone
    c_.set(condition, to.r8());
    c_.neg(to);
    return to;
  };
  if (s.op == CodeOp::TestBit) {
    if (s.value >= 64) return truth(0);
    const Gp a = scalar(s.a);
    c_.bt(a, imm(s.value));
    return spread(x86::CondCode::kC);
  }
  const Gp a = scalar(s.a), b = scalar(s.b);
  if (s.op == CodeOp::Equal || s.op == CodeOp::Less) {
    c_.cmp(a, b);
    return spread(s.op == CodeOp::Equal ? x86::CondCode::kEqual : x86::CondCode::kUnsignedLT);
  }
  const Gp x = copied(a), y = copied(b);
  c_.shl(x, imm(64 - s.width));
  c_.shl(y, imm(64 - s.width));
  if (s.op == CodeOp::LessSigned) {
    c_.cmp(x, y);
    return spread(x86::CondCode::kSignedLT);
  }
  if (s.op == CodeOp::AddOverflows)
    c_.add(x, y);
  else
    c_.sub(x, y);
  return spread(x86::CondCode::kOverflow);
}

WideNumber WideEmitter::broadcast(const Gp& value, Rep rep) {
  const Zmm all = freshZmm();
  switch (rep) {
    case Rep::Byte: c_.vpbroadcastb(all, value.r32()); break;
    case Rep::Word: c_.vpbroadcastw(all, value.r32()); break;
    case Rep::Double: c_.vpbroadcastd(all, value.r32()); break;
    default: c_.vpbroadcastq(all, value); break;
  }
  Number to{rep};
  for (std::size_t i = 0; i < pieceCount(rep); ++i) to.piece[i] = all;
  return to;
}

}  // namespace rungproof::lanes
