// A mutant is a copy of the program with one instruction changed; instructions keep their numbers.
#include "analysis/testing/kill.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "analysis/equivalence/output_name.hpp"
#include "analysis/testing/processor_clock.hpp"
#include "analysis/testing/test_signals.hpp"
#include "ir/dialect.hpp"
#include "ir/iec/expression_role.hpp"
#include "ir/instruction_slip.hpp"
#include "ir/s7300/statement_role.hpp"

namespace rungproof {

namespace {

std::string changedText(const Desc& desc, const Operands& operands) {
  std::string text(desc.stl);
  for (std::size_t i = 0; i < operands.size(); ++i) text += (i == 0 ? " " : ", ") + toString(operands[i]);
  return text;
}

class MutantFinder {
 public:
  explicit MutantFinder(const Program& program) : program_(program) {
    for (const Pou& pou : program.pous) {
      if (isForeign(pou)) continue;
      for (const Network& network : pou.networks) {
        for (const Instruction& i : network.instructions) {
          for (const Operand& o : i.operands) {
            const bool isBit = o.kind == OperandKind::Direct && o.width == Width::Bit && !hasBitAndWord(o.area);
            if (isBit && o.area != Area::SM && o.area != Area::L) bits_[o.area].insert({o.offset, o.bit});
          }
        }
      }
    }
  }

  std::vector<Mutant> run() {
    if (!isOfExpressions_) {
      for (Fault& fault : faultsOf(program_)) {
        std::string kind(faultKindName(fault.kind));
        mutants_.push_back({std::move(kind), std::move(fault)});
      }
    }
    for (pou_ = 0; pou_ < program_.pous.size(); ++pou_) {
      if (isForeign(program_.pous[pou_])) continue;
      const std::vector<Network>& networks = program_.pous[pou_].networks;
      for (network_ = 0; network_ < networks.size(); ++network_) {
        for (index_ = 0; index_ < networks[network_].instructions.size(); ++index_)
          at(networks[network_].instructions[index_]);
      }
    }
    return std::move(mutants_);
  }

 private:
  bool isForeign(const Pou& pou) const { return dialectOf(program_.target).text.isForeign(program_, pou); }

  void plant(std::string kind, const Instruction& given, const Desc& desc, Operands operands) {
    Fault fault;
    fault.text = fmt::format("{} for {}", changedText(desc, operands), changedText(*given.desc, given.operands));
    fault.pou = pou_;
    fault.network = network_;
    fault.instruction = index_;
    fault.desc = &desc;
    fault.operands = std::move(operands);
    mutants_.push_back({std::move(kind), std::move(fault)});
  }

  void at(const Instruction& instruction) {
    const bool isComparison = instruction.desc->relation != Relation::None;
    for (const Desc* slip : slipsOf(*instruction.desc, dialectOf(program_.target)))
      plant(isComparison ? "comparison" : "operator", instruction, *slip, instruction.operands);
    for (std::size_t i = 0; i < instruction.operands.size(); ++i) operand(instruction, i);
  }

  void operand(const Instruction& instruction, std::size_t index) {
    const Operand& given = instruction.operands[index];
    Operands changed = instruction.operands;
    if (given.kind == OperandKind::Direct && given.width == Width::Bit && bits_.contains(given.area) &&
        (!isOfExpressions_ || expressionRole(instruction) == ExpressionRole::LoadBit)) {
      const std::set<std::pair<std::uint32_t, std::uint8_t>>& others = bits_.at(given.area);
      auto next = others.upper_bound({given.offset, given.bit});
      if (next == others.end()) next = others.begin();
      if (*next == std::pair(given.offset, given.bit)) return;
      changed[index].offset = next->first;
      changed[index].bit = next->second;
      const Symbol* other =
          dialectOf(program_.target).memory.isOfVariables ? program_.symbolOf(changed[index]) : nullptr;
      changed[index].text = other == nullptr ? ShortText() : ShortText(other->name);
      plant("operand", instruction, *instruction.desc, std::move(changed));
      return;
    }
    const bool isNumber = given.kind == OperandKind::Constant && given.form != ConstantForm::Real &&
                          (instruction.desc->relation != Relation::None || instruction.desc->role == Role::Move ||
                           statementRole(instruction) == StatementRole::Load);
    const bool isConst =
        index == 0 && expressionRole(instruction) == ExpressionRole::Constant && !isOfTruth(instruction);
    if (!(isNumber && !isOfExpressions_) && !isConst) return;
    changed[index].value = given.value + 1;
    plant("constant", instruction, *instruction.desc, std::move(changed));
  }

  const Program& program_;
  const bool isOfExpressions_ = formOf(program_.target) == StatementForm::Expressions;
  std::map<Area, std::set<std::pair<std::uint32_t, std::uint8_t>>> bits_;
  std::uint32_t pou_ = 0, network_ = 0, index_ = 0;
  std::vector<Mutant> mutants_;
};

/// The first test that the mutant does not pass; empty: it passes all.
std::string noticedBy(const Program& mutant, const std::vector<TestTable>& tables, const TestPlayOptions& play) {
  for (const TestTable& table : tables) {
    for (const TestCase& test : table.tests) {
      Simulator simulator(mutant, play.engine);
      if (!playTest(simulator, table, test, play).failures.empty()) return test.name;
    }
  }
  return "";
}

}  // namespace

std::vector<Mutant> mutantsOf(const Program& program) { return MutantFinder(program).run(); }

Equivalence compareWithFault(const Program& program, const Program& mutant, const PropertySet& set,
                             const ProverOptions& prover) {
  EquivalenceOptions both;
  // A mutant keeps the places of variables.
  if (dialectOf(program.target).memory.isOfVariables) {
    for (const TraceSignal& output : testSignalsOf(program, set).outputs) both.observed.push_back(output.operand);
  }
  both.prover = prover;
  both.prover.checks = {};
  both.prover.evidence = false;
  both.prover.certificates = false;
  both.prover.jobs = 1;
  PropertySet surroundings = set;
  std::erase_if(surroundings.properties, [](const Property& p) { return p.isGoal(); });
  return compareBehaviour({&program, surroundings}, {&mutant, surroundings}, both);
}

std::vector<KillResult> killMutants(const Program& program, const PropertySet& set,
                                    const std::vector<TestTable>& tables, const KillOptions& options) {
  using Clock = ProcessorClock;
  const Clock::time_point end =
      Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(options.seconds));
  std::vector<Mutant> mutants = mutantsOf(program);
  const std::size_t step = mutants.size() / std::max<std::size_t>(options.most, 1) + 1;
  std::vector<KillResult> results;
  for (std::size_t i = 0; i < mutants.size(); i += step) {
    KillResult result{std::move(mutants[i]), FaultFate::Undecided, {}, {}};
    Program mutant = planted(program, result.mutant.fault);
    mutant.number();
    result.noticedBy = noticedBy(mutant, tables, options.play);
    if (!result.noticedBy.empty()) {
      result.fate = FaultFate::Noticed;
    } else if (Clock::now() < end) {
      ProverOptions prover = options.prover;
      prover.timeout = options.patience;
      const Equivalence found = compareWithFault(program, mutant, set, prover);
      result.fate = found.equality == Equality::Equal       ? FaultFate::NoEffect
                    : found.equality == Equality::Different ? FaultFate::Unnoticed
                                                            : FaultFate::Undecided;
      if (found.run)
        result.where = fmt::format("{} in scan {}", outputName(program, found.run->addressBefore, found.run->signal),
                                   found.run->scan);
    }
    results.push_back(std::move(result));
  }
  return results;
}

}  // namespace rungproof
