// What contacts, edges and outputs see, as nodes: read from the state in front of the instruction, without asking
// anything new. What cannot be read so stays open.
#include "analysis/encoding/execution_record.hpp"
#include "ir/iec/expression_role.hpp"
#include "ir/s7300/statement_detail.hpp"

namespace rungproof {

namespace {

bool isPlainPlace(const Operand& o) {
  return o.kind == OperandKind::Direct && o.area != Area::AI && o.area != Area::PI;
}

Graph::Bool bitOfPlace(Machine<Graph>& machine, const Operand& o) {
  if (hasBitAndWord(o.area)) return machine.getBit(o.area == Area::T ? Reg::TimerBit : Reg::CounterBit, o.offset);
  return machine.d.bit(machine.load(o.area, o.offset, Width::Bit, o.bit), 0);
}

Graph::Bool related(Graph& graph, Relation relation, Graph::Bool less, Graph::Bool equal, Graph::Bool greater) {
  switch (relation) {
    case Relation::Less: return less;
    case Relation::LessEqual: return graph.lor(less, equal);
    case Relation::Equal: return equal;
    case Relation::GreaterEqual: return graph.lor(greater, equal);
    case Relation::Greater: return greater;
    default: return graph.lnot(equal);
  }
}

Graph::Bool relatedNumbers(Graph& graph, Relation relation, Graph::Bits x, Graph::Bits y, int width, bool isSigned) {
  const auto less = [&](Graph::Bits a, Graph::Bits b) {
    return isSigned ? graph.slt(a, b, width) : graph.ult(a, b, width);
  };
  return related(graph, relation, less(x, y), graph.equal(x, y, width), less(y, x));
}

Graph::Bool relatedReals(Graph& graph, Relation relation, Graph::Bits x, Graph::Bits y) {
  return related(graph, relation, graph.rless(x, y), graph.requal(x, y), graph.rless(y, x));
}

/// A compare contact of an S7-200.
std::optional<Graph::Bool> compareContact(Machine<Graph>& machine, const Instruction& instruction) {
  const Type type = instruction.desc->operands[0].type;
  if (instruction.operands.size() != 2 || type == Type::String) return std::nullopt;
  const Width width = widthOf(type);
  std::array<Graph::Bits, 2> values{};
  for (std::size_t i = 0; i < 2; ++i) {
    const Operand& o = instruction.operands[i];
    if (o.kind == OperandKind::Constant)
      values[i] = machine.d.literal(static_cast<std::uint64_t>(o.value) & Graph::maskOf(bits(width)), bits(width));
    else if (isPlainPlace(o))
      values[i] = machine.load(o.area, o.offset, width, 0);
    else
      return std::nullopt;
  }
  const Relation relation = instruction.desc->relation;
  if (type == Type::Real) return relatedReals(machine.d, relation, values[0], values[1]);
  return relatedNumbers(machine.d, relation, values[0], values[1], bits(width), isSigned(type));
}

std::optional<Graph::Bool> bitOfStatement(Machine<Graph>& machine, const Instruction& instruction) {
  Graph& graph = machine.d;
  switch (statementRole(instruction)) {
    case StatementRole::AndScan:
    case StatementRole::OrScan:
    case StatementRole::XorScan:
      if (instruction.operands.empty() || !isPlainPlace(instruction.operands[0])) return std::nullopt;
      return bitOfPlace(machine, instruction.operands[0]);
    case StatementRole::Edge: {
      if (instruction.operands.empty() || !isPlainPlace(instruction.operands[0])) return std::nullopt;
      const Graph::Bool before = bitOfPlace(machine, instruction.operands[0]);
      return findsRise(instruction) ? graph.lnot(before) : before;
    }
    case StatementRole::Compare:
    case StatementRole::CompareRealEqual: {
      const Graph::Bits x = machine.step7.accu[1], y = machine.step7.accu[0];
      if (comparesReals(instruction)) return relatedReals(graph, relationOf(instruction), x, y);
      const int width = comparedBits(instruction);
      const auto low = [&](Graph::Bits v) { return width == 32 ? v : graph.extract(v, 15, 0); };
      return relatedNumbers(graph, relationOf(instruction), low(x), low(y), width, true);
    }
    default: return std::nullopt;
  }
}

std::optional<Graph::Bool> bitOfExpression(Machine<Graph>& machine, const Instruction& instruction) {
  Graph& graph = machine.d;
  if (expressionRole(instruction) == ExpressionRole::LoadBit) return bitOfPlace(machine, instruction.operands[0]);
  const std::size_t size = machine.evaluation.size();
  if (instruction.desc->relation == Relation::None || size < 2) return std::nullopt;
  const Graph::Bits x = machine.evaluation[size - 2], y = machine.evaluation[size - 1];
  if (instruction.operands.empty()) return relatedReals(graph, instruction.desc->relation, x, y);
  return relatedNumbers(graph, instruction.desc->relation, x, y, static_cast<int>(instruction.operands[0].value),
                        instruction.operands.size() > 1 && instruction.operands[1].value != 0);
}

}  // namespace

void ExecutionRecord::noteBits(Machine<Graph>& machine, const Instruction& instruction, Visit& visit) const {
  Graph& graph = machine.d;
  const Desc& desc = *instruction.desc;
  std::optional<Graph::Bool> bit;
  if (machine.plan.form() == StatementForm::Accumulators) {
    bit = bitOfStatement(machine, instruction);
    visit.result = machine.step7.rlo.node;
  } else if (machine.plan.form() == StatementForm::Expressions) {
    bit = bitOfExpression(machine, instruction);
    const bool hasTruth = expressionRole(instruction) == ExpressionRole::StoreBit || desc.control == Control::Jump;
    if (hasTruth && !machine.evaluation.empty()) visit.result = graph.bit(machine.evaluation.back(), 0).node;
  } else if (isEdge(desc.role)) {
    const Graph::Bool before = machine.getBit(Reg::EdgeMemory, machine.plan.edge[instruction.id]);
    bit = graph.land(graph.lnot(machine.getBit(Reg::FirstScan)), desc.role == Role::Eu ? graph.lnot(before) : before);
  } else if (desc.execution == Execution::Compare) {
    bit = compareContact(machine, instruction);
  } else if (isContact(desc.role) && !desc.immediate && isPlainPlace(instruction.operands[0])) {
    bit = bitOfPlace(machine, instruction.operands[0]);
  }
  if (bit) visit.bit = bit->node;
  for (std::size_t i = 0; i < instruction.operands.size() && i < desc.operandCount; ++i) {
    const Operand& o = instruction.operands[i];
    const bool isWritten = desc.operands[i].direction != Direction::In && isPlainPlace(o) && !hasBitAndWord(o.area);
    if (!isWritten || o.area == Area::AC || o.area == Area::HC) continue;
    const Width width = desc.operands[i].type == Type::Bool    ? Width::Bit
                        : desc.operands[i].type == Type::Value ? o.width
                                                               : widthOf(desc.operands[i].type);
    visit.target = machine.load(o.area, o.offset, width, o.bit).node;
    break;
  }
}

}  // namespace rungproof
