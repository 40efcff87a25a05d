// The concept Domain: what a kind of value must offer so that instruction meanings can be executed over it.
// Instances: Concrete (engine/concrete.hpp, plain numbers, the reference) and Graph (analysis/graph/graph.hpp, shared
// expression nodes for solvers and exports). Meanings in ir/s7200/isa/*.hpp see nothing but this interface.
//
// Laws (tests/differential/domain_laws_test.cpp compares every instance with Concrete):
//   values of width w lie in 0 .. 2^w - 1; add, sub, mul wrap; sdiv truncates toward zero and srem has the
//   dividend's sign; the divisor 0 may give anything, callers guard it; shifts by w or more give 0;
//   real operations take and give IEEE 754 single patterns in 32 bits, round to nearest even; those of LREAL double
//   patterns in 64 bits.
#pragma once

#include <concepts>
#include <cstdint>
#include <optional>

namespace rungproof {

template <class D>
concept Domain = requires(D d, typename D::Bool p, typename D::Bits v, int w, std::uint64_t n) {
  // Truth values.
  { d.constant(true) } -> std::same_as<typename D::Bool>;
  { d.lnot(p) } -> std::same_as<typename D::Bool>;
  { d.land(p, p) } -> std::same_as<typename D::Bool>;
  { d.lor(p, p) } -> std::same_as<typename D::Bool>;
  { d.lxor(p, p) } -> std::same_as<typename D::Bool>;
  { d.select(p, p, p) } -> std::same_as<typename D::Bool>;
  { d.truth(p) } -> std::same_as<std::optional<bool>>;  ///< the value if it is known
  // Bit vectors of width w, 1 to 64.
  { d.literal(n, w) } -> std::same_as<typename D::Bits>;
  { d.known(v) } -> std::same_as<std::optional<std::uint64_t>>;  ///< the value if it is known
  { d.add(v, v, w) } -> std::same_as<typename D::Bits>;
  { d.sub(v, v, w) } -> std::same_as<typename D::Bits>;
  { d.mul(v, v, w) } -> std::same_as<typename D::Bits>;
  { d.udiv(v, v, w) } -> std::same_as<typename D::Bits>;
  { d.urem(v, v, w) } -> std::same_as<typename D::Bits>;
  { d.sdiv(v, v, w) } -> std::same_as<typename D::Bits>;
  { d.srem(v, v, w) } -> std::same_as<typename D::Bits>;
  { d.band(v, v, w) } -> std::same_as<typename D::Bits>;
  { d.bor(v, v, w) } -> std::same_as<typename D::Bits>;
  { d.bxor(v, v, w) } -> std::same_as<typename D::Bits>;
  { d.bnot(v, w) } -> std::same_as<typename D::Bits>;
  { d.shl(v, v, w) } -> std::same_as<typename D::Bits>;  ///< both operands have width w
  { d.lshr(v, v, w) } -> std::same_as<typename D::Bits>;
  { d.equal(v, v, w) } -> std::same_as<typename D::Bool>;
  { d.ult(v, v, w) } -> std::same_as<typename D::Bool>;
  { d.ule(v, v, w) } -> std::same_as<typename D::Bool>;
  { d.slt(v, v, w) } -> std::same_as<typename D::Bool>;
  { d.sle(v, v, w) } -> std::same_as<typename D::Bool>;
  { d.select(p, v, v, w) } -> std::same_as<typename D::Bits>;
  { d.zext(v, w, w) } -> std::same_as<typename D::Bits>;  ///< value, from, to
  { d.sext(v, w, w) } -> std::same_as<typename D::Bits>;
  { d.extract(v, w, w) } -> std::same_as<typename D::Bits>;    ///< value, highest bit, lowest bit
  { d.concat(v, w, v, w) } -> std::same_as<typename D::Bits>;  ///< high, its width, low, its width
  { d.bit(v, w) } -> std::same_as<typename D::Bool>;           ///< value, bit number
  { d.fromBool(p, w) } -> std::same_as<typename D::Bits>;
  // REAL numbers as 32-bit patterns.
  { d.radd(v, v) } -> std::same_as<typename D::Bits>;
  { d.rsub(v, v) } -> std::same_as<typename D::Bits>;
  { d.rmul(v, v) } -> std::same_as<typename D::Bits>;
  { d.rdiv(v, v) } -> std::same_as<typename D::Bits>;
  { d.rfunction(n, v) } -> std::same_as<typename D::Bits>;  ///< RealFunction as number
  { d.requal(v, v) } -> std::same_as<typename D::Bool>;
  { d.rless(v, v) } -> std::same_as<typename D::Bool>;
  { d.rlegal(v) } -> std::same_as<typename D::Bool>;        ///< neither NaN nor infinite
  { d.rfromInt(v) } -> std::same_as<typename D::Bits>;      ///< signed 32-bit to REAL
  { d.rtoInt(v, true) } -> std::same_as<typename D::Bits>;  ///< REAL to signed 64-bit; true: round, false: truncate
  // LREAL numbers as 64-bit patterns.
  { d.longReal(n, v, v, w) } -> std::same_as<typename D::Bits>;  ///< LongRealOperation as number; width of the result
  { d.longReal(n, v, w) } -> std::same_as<typename D::Bits>;     ///< of one number
};

/// Functions of section "numeric functions" (001:4938-4995).
enum class RealFunction : std::uint64_t { Sqrt, Sin, Cos, Tan, Ln, Exp, ArcSin, ArcCos, ArcTan };

/// Operations whose numbers are LREAL where nothing else is said. Comparisons need none: the order of the patterns
/// tells.
enum class LongRealOperation : std::uint64_t {
  Add,
  Sub,
  Mul,
  Div,
  Power,
  ArcTan2,
  Sqrt,
  Sin,
  Cos,
  Tan,
  Ln,
  Log,
  Exp,
  ArcSin,
  ArcCos,
  ArcTan,
  Truncate,   ///< to a whole number, as an LREAL
  RoundEven,  ///< halves to the even number
  RoundAway,  ///< halves away from zero
  Floor,
  Ceil,
  FromReal,      ///< of a REAL
  ToReal,        ///< gives a REAL
  FromSigned,    ///< of a signed number of 64 bits; gives an LREAL or a REAL
  FromUnsigned,  ///< of an unsigned one
  ToSigned,      ///< of a whole number; what does not fit saturates
  ToUnsigned
};

}  // namespace rungproof
