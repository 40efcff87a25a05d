// Inputs are what the surroundings write: terminals, analog inputs, memory declared as external.
#include "analysis/testing/test_signals.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>

#include "ir/dialect.hpp"
#include "ir/iec/expression_role.hpp"
#include "ir/iec/variables.hpp"
#include "ir/machine/plan.hpp"
#include "ir/overlap.hpp"
#include "ir/written_operand.hpp"

namespace rungproof {

namespace {

constexpr std::size_t mostValues = 13;
constexpr std::size_t linesOfComparison = 3;  ///< of a list: LD, and the operators that may compare

bool isWithin(const Operand& operand, const ExternalRange& range) {
  if (operand.area != range.first.area) return false;
  const auto bitOf = [](const Operand& o) { return o.offset * 8 + (o.width == Width::Bit ? o.bit : 0U); };
  const auto endOf = [&](const Operand& o) { return bitOf(o) + static_cast<std::uint32_t>(bits(o.width)); };
  return bitOf(operand) >= bitOf(range.first) && endOf(operand) <= endOf(range.last);
}

/// Constants of instructions that name the operand too, which compares or computes with it, and all others of
/// expressions, whose comparisons take both from the stack.
std::vector<TraceNumber> valuesFor(const Program& program, const TraceSignal& signal) {
  if (signal.type == SignalType::Bool) return {0, 1};
  std::set<TraceNumber> constants;
  const StatementForm form = formOf(program.target);
  const bool isStack = form != StatementForm::Rungs, isOfExpressions = form == StatementForm::Expressions;
  for (const Pou& pou : program.pous) {
    if (isOfExpressions && pou.isBuiltIn) continue;
    std::size_t sinceNamed = linesOfComparison;  // networks since the operand was named; of a list each is a line
    for (const Network& network : pou.networks) {
      const bool names = std::ranges::any_of(network.instructions, [&](const Instruction& i) {
        return std::ranges::any_of(i.operands, [&](const Operand& o) { return overlaps(o, signal.operand); });
      });
      sinceNamed = names ? 0 : sinceNamed + 1;
      const bool isNear = isOfExpressions && sinceNamed < linesOfComparison;
      if (!names && !isNear) continue;
      for (const Instruction& i : network.instructions) {
        const bool namesIt =
            std::ranges::any_of(i.operands, [&](const Operand& o) { return overlaps(o, signal.operand); });
        if (!isStack && !namesIt) continue;
        const bool isWidthOnly = isOfExpressions && expressionRole(i) != ExpressionRole::Constant;
        if (isWidthOnly) continue;
        for (const Operand& o : i.operands) {
          const bool isWidth = isOfExpressions && &o != i.operands.data();
          if (o.kind == OperandKind::Constant && !isWidth)
            constants.insert(numberOf(static_cast<std::uint64_t>(o.value), signal.type, signal.width()));
        }
      }
    }
  }
  std::vector<TraceNumber> values{0};
  const TraceNumber range = std::exp2l(signal.width()), low = signal.type == SignalType::Signed ? -range / 2 : 0,
                    high = signal.type == SignalType::Signed ? range / 2 - 1 : range - 1;
  const auto add = [&](TraceNumber value) {
    const bool fits = signal.isReal() || (value >= low && value <= high && value == std::floor(value));
    if (fits && std::isfinite(value) && std::ranges::find(values, value) == values.end() && values.size() < mostValues)
      values.push_back(value);
  };
  for (const TraceNumber constant : constants) {
    for (const TraceNumber value : {constant, constant - 1, constant + 1}) add(value);
  }
  if (values.size() == 1) add(1);
  return values;
}

/// In which scan a task begins: a variable that reading has added, so that the text where it is declared does not name
/// it, and that nobody can set.
bool isTaskPhase(const Program& program, const TraceSignal& signal) {
  constexpr std::string_view ending = ".PHASE";
  if (!program.taskMs || !signal.name.ends_with(ending)) return false;
  const Symbol* const symbol = program.symbolOf(signal.operand);
  if (symbol == nullptr) return false;
  std::string declared(program.sources->text(symbol->span));
  std::ranges::transform(declared, declared.begin(),
                         [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return declared.find(ending.substr(1)) == std::string::npos;
}

}  // namespace

TestSignals testSignalsOf(const Program& program, const PropertySet& set) {
  TestSignals result;
  const bool isOfVariables = dialectOf(program.target).memory.isOfVariables;
  const ProgramOutputs given(program);
  for (TraceSignal& signal : touchedSignals(program)) {
    const Operand& operand = signal.operand;
    if (isOfVariables && signal.name.find("__") != std::string::npos) continue;  // of a chart
    if (isOfVariables && isTaskPhase(program, signal)) continue;
    const bool isExternal =
        std::ranges::any_of(set.externals, [&](const ExternalRange& r) { return isWithin(operand, r); });
    const bool isTerminal = operand.area == Area::I || operand.area == Area::AI || operand.area == Area::PI;
    if (isExternal || (isTerminal && !isWritten(program, operand, Actuals::Read))) {
      const bool isKnown = std::ranges::any_of(
          result.inputs, [&](const TestInput& input) { return overlaps(input.signal.operand, operand); });
      if (!isKnown) result.inputs.push_back({signal, valuesFor(program, signal)});
      continue;
    }
    const bool isOutput = isOfVariables
                              ? given.contains(operand)
                              : operand.area == Area::Q || operand.area == Area::AQ || operand.area == Area::PQ;
    if (isOutput && isWritten(program, operand, Actuals::Written)) result.outputs.push_back(signal);
    const bool isMemory = operand.area != Area::T && operand.area != Area::SM && operand.area != Area::HC &&
                          operand.area != Area::AC && !signal.isReal();
    if (isMemory) result.memory.push_back(signal);
  }
  // Of a part of a program what it writes stands for its outputs: bits, or numbers where there are none.
  for (const bool isBit : {true, false}) {
    if (!result.outputs.empty()) break;
    for (const TraceSignal& signal : result.memory) {
      if ((signal.type == SignalType::Bool) == isBit && isWritten(program, signal.operand, Actuals::Written))
        result.outputs.push_back(signal);
    }
  }
  return result;
}

bool dependsOnTime(const Program& program) {
  const Plan plan(program);
  if (!plan.timers.empty() || !plan.iecTimers.empty() || program.clockMemory) return true;
  std::set<std::uint32_t> loaded;  // IEC 61131-3: first bytes of variables that are read
  for (const Pou& pou : program.pous) {
    for (const Network& network : pou.networks) {
      for (const Instruction& i : network.instructions) {
        if (expressionRole(i) == ExpressionRole::Load) loaded.insert(i.operands[0].offset);
      }
    }
  }
  for (const Pou& pou : program.pous) {
    for (const Network& network : pou.networks) {
      for (const Instruction& i : network.instructions) {
        const bool passes = expressionRole(i) == ExpressionRole::PassTime && i.operands.size() > 1 &&
                            loaded.contains(i.operands[1].offset);
        const bool readsTimer = std::ranges::any_of(i.operands, [](const Operand& o) {
          const bool isClock = o.kind == OperandKind::Direct && o.area == Area::SM &&
                               ((o.offset == 0 && (o.bit == 4 || o.bit == 5)) || (o.offset >= 22 && o.offset <= 26));
          return (o.kind == OperandKind::Direct && o.area == Area::T) || isClock;
        });
        if (passes || readsTimer || roleOf(i) == Role::Todr) return true;
      }
    }
  }
  return false;
}

namespace {

bool hasRole(const Program& program, Role first, Role last) {
  return std::ranges::any_of(program.pous, [&](const Pou& pou) {
    return std::ranges::any_of(pou.networks, [&](const Network& network) {
      return std::ranges::any_of(network.instructions,
                                 [&](const Instruction& i) { return roleOf(i) >= first && roleOf(i) <= last; });
    });
  });
}

}  // namespace

bool hasDevices(const Program& program) {
  return hasRole(program, Role::Hdef, Role::Rcv) || hasRole(program, Role::Todw, Role::Todw);
}

bool hasEventsOrDevices(const Program& program) {
  const Plan plan(program);
  // The timed events 10 and 11 of an S7-200 come only once ATCH has attached them.
  if (dialectOf(program.target).run.startsBlocks && !plan.timedEvents.empty()) return true;
  const bool hasRoutine =
      std::ranges::any_of(program.pous, [](const Pou& pou) { return pou.kind == PouKind::Interrupt; });
  return hasRoutine || hasRole(program, Role::Atch, Role::Disi) || hasDevices(program);
}

}  // namespace rungproof
