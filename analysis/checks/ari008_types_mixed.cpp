// ARI008: a calculation with REAL takes a whole number or the reverse, or S5TIME meets TIME. The bits are taken as they
// are: nothing converts them. S7-200: what the boxes of one rung hand on. S7-300/400: constants and declared parameters
// and variables that stand right in front. Tested by its examples, tests/rules/data_rules_test.cpp and
// tests/rules/step7_data_rules_test.cpp.
#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "analysis/flow/declared_value.hpp"
#include "analysis/flow/statement_paths.hpp"
#include "analysis/flow/step7_blocks.hpp"
#include "analysis/rule.hpp"
#include "ir/s7300/block.hpp"
#include "ir/s7300/pointer_parameter.hpp"
#include "ir/s7300/statement_detail.hpp"

namespace rungproof {

namespace {

constexpr std::string_view conversionHelp =
    "convert it first: DTR makes a REAL of a DINT, ROUND, TRUNC and RND a DINT of a REAL, ITD a DINT of an INT";

// S7-200 ----------------------------------------------------------------------------------------------------------

/// A double word or an accumulator that a box has given a number.
struct HeldNumber {
  Area area;
  std::uint32_t offset;
  bool isReal;
  const Instruction* maker;
};

/// The boxes of one rung behind each other: they run with the same power flow, so what one leaves the next one finds.
class RungNumbers {
 public:
  RungNumbers(const Facts& facts, FindingSink& sink) : facts_(facts), sink_(sink) {}

  void step(const Instruction& instruction) {
    const Desc& desc = *instruction.desc;
    const bool isNewFlow = isLogic(desc.role) && desc.role != Role::Aeno;
    if (isNewFlow || desc.execution == Execution::Control || desc.operandCount == 0) {
      if (desc.role != Role::Aeno && desc.role != Role::Nop) held_.clear();
      return;
    }
    std::optional<HeldNumber> moved;
    for (const Access& access : facts_.accesses().of(instruction.id)) {
      if (access.write) continue;
      const HeldNumber* number = heldAt(access);
      if (number == nullptr || access.operand >= desc.operandCount) continue;
      if (desc.role == Role::Move) moved = *number;
      const std::optional<bool> wantsReal = isReal(desc.operands[access.operand].type);
      if (desc.role != Role::Move && wantsReal && *wantsReal != number->isReal) report(instruction, access, *number);
    }
    if (desc.role == Role::Move && !moved) moved = constantOf(instruction);
    for (const Access& access : facts_.accesses().of(instruction.id)) {
      if (access.write) write(instruction, access, moved);
    }
  }
  void clear() { held_.clear(); }

 private:
  static std::optional<bool> isReal(Type type) {
    if (type == Type::Real) return true;
    return type == Type::DInt ? std::optional(false) : std::nullopt;
  }
  /// MOVR 1.5 and MOVD 5; 0 is the same in both, and a pattern of bits may mean either.
  static std::optional<HeldNumber> constantOf(const Instruction& move) {
    if (move.operands.empty() || move.operands[0].kind != OperandKind::Constant || move.operands[0].value == 0)
      return {};
    const ConstantForm form = move.operands[0].form;
    if (form == ConstantForm::Real) return HeldNumber{Area::V, 0, true, &move};
    const bool isWhole = form == ConstantForm::Decimal || form == ConstantForm::SignedDecimal;
    return isWhole && isMoveOf(*move.desc, Type::DWord) ? std::optional(HeldNumber{Area::V, 0, false, &move})
                                                        : std::nullopt;
  }
  static bool isNumberPlace(const Access& access) {
    return !access.viaPointer && !access.maybe && access.most == 1 &&
           (access.area == Area::AC || (!access.byNumber() && access.width == Width::DWord));
  }
  const HeldNumber* heldAt(const Access& access) const {
    if (!isNumberPlace(access)) return nullptr;
    const auto found = std::ranges::find_if(
        held_, [&](const HeldNumber& number) { return number.area == access.area && number.offset == access.offset; });
    return found == held_.end() ? nullptr : &*found;
  }
  void write(const Instruction& instruction, const Access& access, const std::optional<HeldNumber>& moved) {
    if (access.viaPointer) return held_.clear();
    std::erase_if(held_, [&](const HeldNumber& number) {
      const std::uint32_t bytes = number.area == Area::AC ? 1 : 4;
      return number.area == access.area && number.offset < access.offset + std::max(access.possibleLength(), 1U) &&
             access.offset < number.offset + bytes;
    });
    if (!isNumberPlace(access) || access.operand >= instruction.desc->operandCount) return;
    if (moved) {
      held_.push_back({access.area, access.offset, moved->isReal, moved->maker});
    } else if (const auto real = isReal(instruction.desc->operands[access.operand].type);
               real && instruction.desc->role != Role::Move) {
      held_.push_back({access.area, access.offset, *real, &instruction});
    }
  }
  void report(const Instruction& instruction, const Access& access, const HeldNumber& number) {
    const Operand& operand = instruction.operands[access.operand];
    Finding& finding = sink_.report(
        instruction.span, fmt::format("{} takes {} as a {}, but {} has left a {} there", Facts::text(instruction),
                                      facts_.name(operand), number.isReal ? "whole number" : "REAL",
                                      Facts::text(*number.maker), number.isReal ? "REAL" : "whole number"));
    finding.address = toString(operand);
    finding.related.push_back({number.maker->span, "this makes the number"});
    finding.help = std::string(conversionHelp);
  }

  const Facts& facts_;
  FindingSink& sink_;
  std::vector<HeldNumber> held_;
};

void checkRungs(const Facts& facts, FindingSink& sink) {
  for (const Flow& flow : facts.plan().flows) {
    RungNumbers numbers(facts, sink);
    std::uint32_t network = 0;
    for (const FlowStep& step : flow.steps) {
      // A conversion may stand in a line that could not be read.
      if (step.network != std::exchange(network, step.network)) numbers.clear();
      if (!facts.isUnread(step.id())) numbers.step(*step.instruction);
    }
  }
}

// S7-300/400 ------------------------------------------------------------------------------------------------------

enum class NumberKind : std::uint8_t { Unknown, Whole, Real, S5Time, Time };

/// `Type`: DataType or s7300::TypeKind.
template <class Type>
NumberKind numberKindOf(Type type) {
  switch (type) {
    case Type::Int:
    case Type::DInt: return NumberKind::Whole;
    case Type::Real: return NumberKind::Real;
    case Type::S5Time: return NumberKind::S5Time;
    case Type::Time: return NumberKind::Time;
    default: return NumberKind::Unknown;
  }
}

/// Of a constant by its spelling, of what has a declaration by that.
NumberKind numberKindOf(const Facts& facts, const Flow& flow, const Operand& operand) {
  const std::string_view text = operand.text;
  if (operand.kind == OperandKind::Constant) {
    const auto begins = [&](std::string_view prefix) {
      return text.size() > prefix.size() && std::ranges::equal(text.substr(0, prefix.size()), prefix, {}, [](char c) {
               return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
             });
    };
    if (operand.value == 0) return NumberKind::Unknown;
    if (begins("S5T#") || begins("S5TIME#")) return NumberKind::S5Time;
    if (begins("T#") || begins("TIME#")) return NumberKind::Time;
    if (begins("L#")) return NumberKind::Whole;
    if (operand.form == ConstantForm::Real) return NumberKind::Real;
    const bool isPlain = !text.empty() && std::ranges::all_of(text, [](char c) {
      return (c >= '0' && c <= '9') || c == '-' || c == '+';
    });
    return isPlain ? NumberKind::Whole : NumberKind::Unknown;
  }
  return numberKindOf(declaredTypeOf(facts, flow, operand));
}

std::string_view numberKindName(NumberKind kind) {
  switch (kind) {
    case NumberKind::Whole: return "a whole number";
    case NumberKind::Real: return "a REAL";
    case NumberKind::S5Time: return "an S5TIME";
    case NumberKind::Time: return "a TIME";
    default: return "";
  }
}

/// Whether a value of that kind has no business with the statement; the kind that it takes.
std::optional<NumberKind> kindWantedBy(const Instruction& instruction, NumberKind kind) {
  const StatementRole role = statementRole(instruction);
  const bool isReal = role == StatementRole::RealMath || comparesReals(instruction);
  const bool isWhole = role == StatementRole::IntegerMath || role == StatementRole::IntegerStep ||
                       (isComparison(role) && !comparesReals(instruction));
  if (isReal && kind != NumberKind::Real && kind != NumberKind::Unknown) return NumberKind::Real;
  if (isWhole && kind == NumberKind::Real) return NumberKind::Whole;
  if (role == StatementRole::StartTimer && kind != NumberKind::S5Time &&
      (kind == NumberKind::Time || kind == NumberKind::Real))
    return NumberKind::S5Time;
  return std::nullopt;
}

bool areMixedKinds(NumberKind a, NumberKind b) {
  const auto isEither = [&](NumberKind one, NumberKind other) {
    return (a == one && b == other) || (a == other && b == one);
  };
  return isEither(NumberKind::Whole, NumberKind::Real) || isEither(NumberKind::S5Time, NumberKind::Time);
}

class StatementNumbers {
 public:
  StatementNumbers(const Facts& facts, FindingSink& sink, const Flow& flow) : facts_(facts), sink_(sink), flow_(flow) {}

  void step(std::uint32_t at) {
    const Instruction& instruction = *flow_.steps[at].instruction;
    const StatementRole role = statementRole(instruction);
    if (role == StatementRole::Transfer && !instruction.operands.empty()) return transfer(at, instruction);
    if (instruction.desc->control == Control::BlockCall) return call(instruction);
    const bool isPair = role == StatementRole::RealMath || role == StatementRole::IntegerMath || isComparison(role);
    const bool isSingle = role == StatementRole::IntegerStep || role == StatementRole::StartTimer;
    if (!isPair && !isSingle) return;
    const LoadsBefore loads = loadsBefore(flow_, at);
    for (const Instruction* load : {isPair ? loads.accu2 : nullptr, loads.accu1}) {
      if (load == nullptr || load->operands.empty()) continue;
      const NumberKind kind = numberKindOf(facts_, flow_, load->operands[0]);
      if (const auto wanted = kindWantedBy(instruction, kind))
        return report(instruction, *load,
                      fmt::format("{} takes {}, and {} is {}", Facts::text(instruction), numberKindName(*wanted),
                                  facts_.name(load->operands[0]), numberKindName(kind)),
                      kind);
    }
    if (!isPair || loads.accu1 == nullptr || loads.accu2 == nullptr || loads.accu1->operands.empty() ||
        loads.accu2->operands.empty())
      return;
    const NumberKind first = numberKindOf(facts_, flow_, loads.accu2->operands[0]),
                     second = numberKindOf(facts_, flow_, loads.accu1->operands[0]);
    if (!areMixedKinds(first, second)) return;
    report(instruction, *loads.accu2,
           fmt::format("{} joins {}, {}, with {}, {}", Facts::text(instruction), facts_.name(loads.accu2->operands[0]),
                       numberKindName(first), facts_.name(loads.accu1->operands[0]), numberKindName(second)),
           first);
  }

 private:
  /// Actual parameters have the type of the formal one (002:190).
  void call(const Instruction& instruction) {
    const std::uint32_t called = facts_.calls().calleeOf(facts_.blockOf(instruction.id), instruction);
    if (called == noBlock) return;
    const Pou& callee = facts_.program().pous[called];
    std::size_t operand = hasInstance(callee) ? 2 : 1;
    for (const LocalVariable& formal : callee.locals) {
      if (!isParameter(formal)) continue;
      if (operand >= instruction.operands.size()) break;
      const Operand& actual = instruction.operands[operand++];
      const NumberKind wanted = numberKindOf(formal.type), given = numberKindOf(declaredTypeOf(facts_, flow_, actual));
      if (!areMixedKinds(wanted, given)) continue;
      Finding& finding = sink_.report(
          actual.span, fmt::format("{} is {}, and {} of {} takes {}", facts_.name(actual), numberKindName(given),
                                   formal.name, callee.name, numberKindName(wanted)));
      finding.address = toString(actual);
      finding.help = std::string(helpFor(given));
    }
  }
  static std::string_view helpFor(NumberKind kind) {
    return kind == NumberKind::S5Time || kind == NumberKind::Time
               ? "convert it first: FC 33 makes a TIME of an S5TIME, FC 40 an S5TIME of a TIME"
               : "convert it first: ITD and DTR make a REAL of an INT, RND and TRUNC a DINT of a REAL";
  }
  void transfer(std::uint32_t at, const Instruction& instruction) {
    const NumberKind target = numberKindOf(facts_, flow_, instruction.operands[0]);
    if (target == NumberKind::Unknown) return;
    const LoadsBefore loads = loadsBefore(flow_, at);
    if (loads.accu1 == nullptr || loads.accu1->operands.empty()) return;
    const NumberKind source = numberKindOf(facts_, flow_, loads.accu1->operands[0]);
    if (!areMixedKinds(source, target)) return;
    report(instruction, *loads.accu1,
           fmt::format("{} stores {}, {}, in {}", Facts::text(instruction), facts_.name(loads.accu1->operands[0]),
                       numberKindName(source), numberKindName(target)),
           source);
  }
  void report(const Instruction& instruction, const Instruction& load, std::string message, NumberKind kind) {
    Finding& finding = sink_.report(instruction.span, std::move(message));
    finding.address = toString(load.operands[0]);
    finding.related.push_back({load.span, "it is loaded here"});
    finding.help = std::string(helpFor(kind));
  }

  const Facts& facts_;
  FindingSink& sink_;
  const Flow& flow_;
};

void checkAri008(const Facts& facts, FindingSink& sink) {
  if (facts.form() != StatementForm::Accumulators) return checkRungs(facts, sink);
  eachReadStretch(facts, [&](std::uint32_t, const Flow& flow) {
    StatementNumbers numbers(facts, sink, flow);
    for (std::uint32_t at = 0; at < flow.steps.size(); ++at) numbers.step(at);
  });
}

}  // namespace

extern constexpr Rule ari008_types_mixed = {
    .id = "ARI008",
    .title = "Numbers of two types mixed",
    .severity = Severity::Warning,
    .needs = Needs::Flow,
    .detects =
        "S7-200: a box that takes a REAL where a box of the same rung has just left a whole number, or the reverse; "
        "S7-300/400: INT or DINT taken as REAL, S5TIME taken as TIME, or the reverse, by a parameter of a call, or by "
        "a "
        "calculation, comparison, transfer or timer start right behind the load",
    .why = "nothing converts the bits: 5 taken as a REAL is nearly 0, and S5T#2S taken as a TIME is 512 ms",
    .manual = "001:3493, 002:1951-1978, 003:1016-1043",
    .bad = "Network 1\nLD SM0.0\nITD VW0, VD4\n*R 2.0, VD4\n",
    .good = "Network 1\nLD SM0.0\nITD VW0, VD4\nDTR VD4, VD4\n*R 2.0, VD4\n",
    .check = checkAri008,
};

}  // namespace rungproof
