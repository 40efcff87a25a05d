// What the files of ir/iec/isa share: the evaluation stack and the numbers behind a mnemonic. A statement of the source
// becomes a row of instructions that push values, combine the topmost ones and store the result; between two statements
// the stack is empty, so that jumps never meet values. A width is 1 (BOOL), 8, 16, 32 or 64 bits.
#pragma once

#include "ir/machine/instruction_group.hpp"

namespace rungproof::isa::iec {

/// The operands of the instruction that runs, and the stack that it works on.
template <class D>
struct IecArgs {
  using Bool = typename D::Bool;
  using Bits = typename D::Bits;

  IecArgs(Machine<D>& machine, const Instruction& of) : m(machine), d(machine.d), instruction(of) {}

  Machine<D>& m;
  D& d;
  const Instruction& instruction;

  const Operand& operand(std::size_t i) const { return instruction.operands[i]; }
  std::int64_t number(std::size_t i) const { return operand(i).value; }
  int width(std::size_t i = 0) const { return static_cast<int>(number(i)); }
  bool flag(std::size_t i) const { return number(i) != 0; }
  Bits literal(std::uint64_t value, int width) { return d.literal(value, width); }

  /// A count of 32 bits as a number of another width.
  Bits asWide(Bits count, int width) {
    return width == 32 ? count : width > 32 ? d.zext(count, 32, width) : d.extract(count, width - 1, 0);
  }

  void push(Bits value) { m.evaluation.push_back(value); }
  void pushBool(Bool value) { push(d.fromBool(value, 1)); }
  Bits pop() {
    const Bits value = m.evaluation.back();
    m.evaluation.pop_back();
    return value;
  }
  Bool popBool() { return d.bit(pop(), 0); }

  Bits load(std::size_t i) {
    const Operand& o = operand(i);
    return m.load(o.area, o.offset, o.width, o.bit);
  }
  void save(std::size_t i, Bits value) {
    const Operand& o = operand(i);
    m.save(o.area, o.offset, o.width, value, o.bit);
  }
  Bool less(Bits a, Bits b, int width, bool isSigned) { return isSigned ? d.slt(a, b, width) : d.ult(a, b, width); }
};

/// Runs one instruction of type Op.
template <class Op, class D>
void executeIec(Machine<D>& m, const Instruction& instruction) {
  IecArgs<D> args(m, instruction);
  Op::run(args);
}

/// A number that belongs to the mnemonic: a width, whether values are signed.
constexpr OperandDesc part(std::string_view name) { return in(name, Type::DInt, form::Const); }
inline constexpr Forms variable = form::V;

constexpr Desc described(std::string_view mnemonic, std::string_view meaning, Role role = Role::Other) {
  Desc desc;
  desc.stl = mnemonic;
  desc.meaning = meaning;
  desc.group = "IEC 61131-3";
  desc.role = role;
  desc.execution = Execution::Always;
  return desc;
}

}  // namespace rungproof::isa::iec
