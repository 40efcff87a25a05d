// What the files of ir/s7300/isa share: the operands of the instruction that runs, the status bits, and the forms of
// operands. Effects on the status word: one row each in the descriptions of the families (general knowledge where no
// line is given).
#pragma once

#include "ir/machine/instruction_group.hpp"
#include "ir/s7300/cpu.hpp"
#include "ir/s7300/handed_pointer.hpp"

namespace rungproof::isa::step7 {

namespace form7 {
inline constexpr Forms I = form::I, Q = form::Q, M = form::M, L = form::L, DB = form::area(Area::DB),
                       PI = form::area(Area::PI), PQ = form::area(Area::PQ), T = form::T, C = form::C,
                       Const = form::Const;
inline constexpr Forms memory = I | Q | M | L | DB;
inline constexpr Forms scanned = memory | T | C | Const;  ///< Const: the conditions of the status word
}  // namespace form7

/// The operands and registers that an instruction of an S7-300/400 works on.
template <class D>
struct Step7Args {
  using Bool = typename D::Bool;
  using Bits = typename D::Bits;

  Step7Args(Machine<D>& machine, const Instruction& of)
      : m(machine), d(machine.d), s(machine.step7), instruction(of), places(machine) {}

  Machine<D>& m;
  D& d;
  Step7Registers<D>& s;
  const Instruction& instruction;
  Step7Places<D> places;

  bool hasOperand() const { return !instruction.operands.empty(); }
  const Operand& operand() const { return instruction.operands[0]; }
  bool is400() const { return step7Row(m.target.cpu).is400; }
  bool hasFourAccumulators() const { return step7Row(m.target.cpu).accumulators == 4; }

  Bool yes() { return d.constant(true); }
  Bool no() { return d.constant(false); }
  Bits number(std::uint64_t value, int width = 32) { return d.literal(value, width); }

  Bits accu1() const { return s.accu[0]; }
  Bits accu2() const { return s.accu[1]; }
  Bits low1() { return d.extract(s.accu[0], 15, 0); }
  Bits low2() { return d.extract(s.accu[1], 15, 0); }
  void setAccu1(Bits value) { m.put(s.accu[0], value, 32); }
  /// ACCU1-L; ACCU1-H stays.
  void setLow1(Bits value) { setAccu1(d.concat(d.extract(s.accu[0], 31, 16), 16, value, 16)); }
  /// A new value in ACCU1, the old one in ACCU2 (002:1458-1466).
  void push(Bits value) {
    m.put(s.accu[1], s.accu[0], 32);
    setAccu1(value);
  }
  /// After an operation of ACCU1 with ACCU2: four accumulators move up (002:1444).
  void moveUp() {
    if (!hasFourAccumulators()) return;
    m.put(s.accu[1], s.accu[2], 32);
    m.put(s.accu[2], s.accu[3], 32);
  }

  void setBit(Bool& to, Bool value) { m.put(to, value); }
  void setConditions(Bool cc1, Bool cc0) {
    m.put(s.cc1, cc1);
    m.put(s.cc0, cc0);
  }
  /// OV, and OS where it is 1.
  void setOverflow(Bool ov) {
    m.put(s.ov, ov);
    m.put(s.os, d.lor(s.os, ov));
  }
  /// CC1 and CC0 by the sign of a number.
  void setSign(Bits value, int width) {
    const Bool negative = d.bit(value, width - 1), zero = d.equal(value, number(0, width), width);
    setConditions(d.land(d.lnot(negative), d.lnot(zero)), negative);
  }
  /// Status bits of an instruction that ends a logic string: OR, STA, /FC.
  void endString(Bool sta) {
    m.put(s.orBit, no());
    m.put(s.sta, sta);
    m.put(s.firstCheck, no());
  }

  /// Whether a master control relay is off here.
  Bool isRelayOff() {
    Bool on = yes();
    for (const Bool& level : s.mcr) on = d.land(on, level);
    return d.land(s.mcrActive, d.lnot(on));
  }

  Bool conditionCode(bool cc1, bool cc0) { return d.land(cc1 ? s.cc1 : d.lnot(s.cc1), cc0 ? s.cc0 : d.lnot(s.cc0)); }
};

/// Runs one instruction of type Op.
template <class Op, class D>
void executeStep7(Machine<D>& m, const Instruction& instruction) {
  Step7Args<D> args(m, instruction);
  Op::run(args);
}

/// The conditions of the status word that A, O, X and their negations scan (002:1570-1581), in the order of the numbers
/// that an operand holds.
enum class StatusScan : std::uint8_t { Br, Ov, Os, Unordered, Zero, NotZero, Plus, Minus, NotNegative, NotPositive };

template <class D>
typename D::Bool statusScan(Step7Args<D>& a, StatusScan which) {
  switch (which) {
    case StatusScan::Br: return a.s.br;
    case StatusScan::Ov: return a.s.ov;
    case StatusScan::Os: return a.s.os;
    case StatusScan::Unordered: return a.conditionCode(true, true);
    case StatusScan::Zero: return a.conditionCode(false, false);
    case StatusScan::NotZero: return a.d.lxor(a.s.cc1, a.s.cc0);
    case StatusScan::Plus: return a.conditionCode(true, false);
    case StatusScan::Minus: return a.conditionCode(false, true);
    case StatusScan::NotNegative: return a.d.lnot(a.s.cc0);
    case StatusScan::NotPositive: return a.d.lnot(a.s.cc1);
  }
  return a.no();
}

}  // namespace rungproof::isa::step7
