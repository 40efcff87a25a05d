// The one place where all instruction meanings are compiled for plain numbers. Besides the general form, contacts and
// coils are compiled once for each memory area: the compiler then folds the choice of the area away. Both forms are the
// same meaning from ir/s7200/isa; tests/engine/dispatch_test.cpp compares them.
#include "engine/dispatch_concrete.hpp"

#include <array>

#include "ir/families/instructions.hpp"

namespace rungproof {

namespace {

constexpr std::array<Area, 6> byteAreas = {Area::I, Area::Q, Area::V, Area::M, Area::S, Area::SM};
using AreaForms = std::array<Execute<Concrete>, byteAreas.size()>;

/// Contacts and "=": one bit operand, always executed, no ENO.
template <class Op>
constexpr bool isPlainBit() {
  constexpr const Desc& desc = Op::desc;
  const bool always = desc.execution == Execution::Stack || desc.execution == Execution::Coil;
  return always && desc.operandCount == 1 && desc.operands[0].type == Type::Bool && !desc.eno;
}

template <class Op, Area area>
[[gnu::flatten]] void executeAt(Machine<Concrete>& m, const Instruction& instruction) {
  Args<Concrete> args(m, instruction, Op::desc);
  args.bind(0, area);
  Op::run(m, args);
}

template <class Op>
constexpr AreaForms areaForms() {
  if constexpr (isPlainBit<Op>()) {
    return []<std::size_t... i>(std::index_sequence<i...>) { return AreaForms{&executeAt<Op, byteAreas[i]>...}; }
    (std::make_index_sequence<byteAreas.size()>{});
  } else {
    return {};
  }
}

template <class... Ops>
constexpr std::array<AreaForms, sizeof...(Ops)> makeAreaForms(isa::Group<Ops...>) {
  return {areaForms<Ops>()...};
}

template <class... Ops>
constexpr std::array<Execute<Concrete>, sizeof...(Ops)> makeGeneral(isa::Group<Ops...>) {
  return {&execute<Ops, Concrete>...};
}

}  // namespace

template <>
std::span<const Execute<Concrete>> dispatchTable<Concrete>() {
  static constexpr auto table = makeGeneral(isa::AllInstructions{});
  return table;
}

template <>
std::span<const Execute<Concrete>> step7DispatchTable<Concrete>() {
  static constexpr auto table = isa::step7::makeDispatch<Concrete>(isa::step7::AllInstructions{});
  return table;
}

template <>
std::span<const Execute<Concrete>> iecDispatchTable<Concrete>() {
  static constexpr auto table = isa::iec::makeDispatch<Concrete>(isa::iec::AllInstructions{});
  return table;
}

template <>
void runSystemBlock<Concrete>(Machine<Concrete>& machine, const std::function<void()>& between) {
  runSystemBlockOn(machine, between);
}
template <>
void actOnCpu<Concrete>(Machine<Concrete>& machine, const Instruction& call) {
  actOnCpuOf(machine, call);
}

Execute<Concrete> executionOf(const Instruction& instruction, StatementForm form) {
  static constexpr auto forms = makeAreaForms(isa::AllInstructions{});
  if (instruction.desc->control != Control::None) return nullptr;
  if (form == StatementForm::Expressions) return iecDispatchTable<Concrete>()[instruction.desc->opcode];
  if (form == StatementForm::Accumulators) return step7DispatchTable<Concrete>()[instruction.desc->opcode];
  const AreaForms& atAreas = forms[instruction.desc->opcode];
  if (instruction.operands.size() == 1 && instruction.operands[0].kind == OperandKind::Direct) {
    for (std::size_t i = 0; i < byteAreas.size(); ++i) {
      if (byteAreas[i] == instruction.operands[0].area && atAreas[i] != nullptr) return atAreas[i];
    }
  }
  return dispatchTable<Concrete>()[instruction.desc->opcode];
}

}  // namespace rungproof
