// Instructions from nodes.
#include "analysis/drawing/code.hpp"

#include <bit>
#include <string>

#include "ir/check.hpp"
#include "ir/s7200/isa.hpp"
#include "ir/s7200/special_memory.hpp"

namespace rungproof {

namespace {

Operand editorOperand(unsigned bit) { return direct(Area::L, Width::Bit, 60 + bit / 8, bit % 8); }

}  // namespace

std::optional<unsigned> EditorBitPool::takeLowest() {
  if (taken_ == ~EditorBits{0}) return std::nullopt;
  const auto bit = static_cast<unsigned>(std::countr_one(taken_));
  taken_ |= 1U << bit;
  return bit;
}

std::optional<unsigned> EditorBitPool::takeHighest() {
  if (taken_ == ~EditorBits{0}) return std::nullopt;
  const auto bit = 31U - static_cast<unsigned>(std::countl_one(taken_));
  taken_ |= 1U << bit;
  return bit;
}

void CircuitCode::add(const Desc* desc, Operands operands, Span span) {
  CHECK(desc != nullptr, "stack operations are in the table");
  Instruction instruction;
  instruction.desc = desc;
  instruction.operands = std::move(operands);
  instruction.span = span;
  instruction.mnemonicLength = span.length;
  lowered_.instructions.push_back(std::move(instruction));
}

void CircuitCode::mark(std::uint32_t n) {
  const std::uint32_t element = node(n).element;
  if (element != noElement)
    lowered_.instructionOf[element] = static_cast<std::uint32_t>(lowered_.instructions.size() - 1);
}

void CircuitCode::contact(std::uint32_t n, Role form) {
  add(s7200Instructions().joinedForm(*node(n).desc, form), *node(n).operands, node(n).span);
  mark(n);
}

void CircuitCode::power(Role form, Span span) {
  add(&s7200Instructions().bitContact(form), {s7200SystemBits.alwaysOn.operand()}, span);
}

void CircuitCode::operation(Role role, std::uint32_t n) { add(&s7200Instructions().only(role), {}, node(n).span); }

void CircuitCode::store(unsigned bit, std::uint32_t n) {
  add(&s7200Instructions().plainAssign(), {editorOperand(bit)}, node(n).span);
}

void CircuitCode::recall(unsigned bit, Role form, std::uint32_t n) {
  add(&s7200Instructions().bitContact(form), {editorOperand(bit)}, node(n).span);
}

void CircuitCode::instruction(std::uint32_t n) {
  add(node(n).desc, node(n).operands == nullptr ? Operands{} : *node(n).operands, node(n).span);
  mark(n);
}

void CircuitCode::call(std::uint32_t n, const std::vector<unsigned>& bits) {
  Operands operands = *node(n).operands;
  std::size_t next = 0;
  for (Operand& operand : operands) {
    if (operand.kind != OperandKind::Missing) continue;
    const Span span = operand.span;
    operand = editorOperand(bits[next++]);
    operand.span = span;
  }
  add(node(n).desc, std::move(operands), node(n).span);
  mark(n);
}

bool CircuitCode::iecOutput(std::uint32_t n) {
  constexpr std::size_t q = iecOutputOperand;
  Operands& operands = lowered_.instructions.back().operands;
  if (operands.size() <= q) operands.resize(q + 1);
  if (operands[q].kind == OperandKind::Missing) {
    const std::optional<unsigned> bit = pool_.takeLowest();
    if (!bit) return false;
    operands[q] = editorOperand(*bit);
    pool_.give(*bit);  // read by the next instruction and never again
    lowered_.usesEditorBits = true;
  }
  add(&s7200Instructions().bitContact(Role::Load), {operands[q]}, node(n).span);
  return true;
}

}  // namespace rungproof
