// Bits of local data, and outputs, that are written on every path and on some.
#include "analysis/flow/step7_locals.hpp"

#include <algorithm>
#include <set>

#include "analysis/flow/conditional_paths.hpp"
#include "analysis/flow/logic_string.hpp"
#include "ir/s7300/block.hpp"

namespace rungproof {

namespace {

constexpr std::uint32_t mostLocalBytes = 1024;  ///< longer local data is mostly arrays, which are filled in loops
constexpr std::uint32_t startInformationBytes = 20;

/// Bits in words of 64.
class AssignedBits {
 public:
  explicit AssignedBits(std::size_t count) : words_((count + 63) / 64, 0) {}
  void set(std::size_t first, std::size_t count) {
    for (std::size_t i = first; i < first + count && i / 64 < words_.size(); ++i)
      words_[i / 64] |= std::uint64_t{1} << i % 64;
  }
  bool has(std::size_t i) const { return i / 64 < words_.size() && (words_[i / 64] >> i % 64 & 1) != 0; }
  bool keepOnly(const AssignedBits& other) {
    bool isChanged = false;
    for (std::size_t w = 0; w < words_.size(); ++w) {
      isChanged = isChanged || (words_[w] & ~other.words_[w]) != 0;
      words_[w] &= other.words_[w];
    }
    return isChanged;
  }
  bool add(const AssignedBits& other) {
    bool isChanged = false;
    for (std::size_t w = 0; w < words_.size(); ++w) {
      isChanged = isChanged || (other.words_[w] & ~words_[w]) != 0;
      words_[w] |= other.words_[w];
    }
    return isChanged;
  }

 private:
  std::vector<std::uint64_t> words_;
};

struct Written {
  AssignedBits onAllPaths, onSomePath;
  bool join(const Written& other) {
    const bool isFewer = onAllPaths.keepOnly(other.onAllPaths);
    return onSomePath.add(other.onSomePath) || isFewer;
  }
};

struct LocalRange {
  std::size_t first, count;
};

class Temps {
 public:
  Temps(const Facts& facts, std::uint32_t block)
      : facts_(facts), flow_(facts.plan().flows[block]), bits_(flow_.pou->localBytes * std::size_t{8}) {}

  /// Whether places are written that the text does not name.
  bool writesThroughPointers() const {
    return std::ranges::any_of(flow_.steps, [&](const FlowStep& step) {
      return std::ranges::any_of(facts_.accesses().of(step.id()), [&](const Access& access) {
        if (!access.write || !access.viaPointer || access.operand >= step.instruction->operands.size()) return false;
        const Operand& operand = step.instruction->operands[access.operand];
        return operand.reach != nullptr && (operand.reach->way == Way::Crossing || operand.area == Area::L);
      });
    });
  }

  std::vector<TempRead> unwritten() const {
    Written entry{AssignedBits(bits_), AssignedBits(bits_)};
    if (flow_.pou->type == BlockType::Ob) {
      entry.onAllPaths.set(0, startInformationBytes * 8);
      entry.onSomePath.set(0, startInformationBytes * 8);
    }
    const auto write = [&](Written& state, const FlowStep& step) { apply(state, step); };
    std::vector<TempRead> reads = readsIn(statesOf(flow_, entry, write));
    // Conditions are followed where it matters: a LAD box runs only where the one before it did.
    if (!reads.empty()) reads = readsIn(statesOnConditionalPaths(facts_, flow_, entry, write));
    return reads;
  }

 private:
  std::vector<TempRead> readsIn(const std::vector<std::optional<Written>>& states) const {
    std::vector<TempRead> reads;
    std::set<std::size_t> told;
    for (std::size_t at = 0; at < flow_.steps.size(); ++at) {
      if (states[at]) findReads(*states[at], *flow_.steps[at].instruction, told, reads);
    }
    return reads;
  }
  static LocalRange rangeOf(const Access& access) {
    if (access.width == Width::Bit) return {access.offset * std::size_t{8} + access.bit, 1};
    return {access.offset * std::size_t{8}, access.certainLength() * std::size_t{8}};
  }
  /// The declared variable that begins or lies at the operand's place.
  LocalRange variableAt(const Operand& operand) const {
    for (const LocalVariable& local : flow_.pou->locals) {
      if (local.section != VarSection::Temp) continue;
      const std::size_t first = local.address.offset;
      if (operand.offset >= first && operand.offset < first + std::max(local.size, 1U))
        return {first * 8 + (local.size == 0 ? local.address.bit : 0),
                local.size == 0 ? 1 : local.size * std::size_t{8}};
    }
    return {operand.offset * std::size_t{8}, 8};
  }
  /// The block that is called, or nullptr.
  const Pou* calleeOf(const Instruction& call) const {
    const auto sites = facts_.calls().sites();
    const auto calls = facts_.calls().callsIn(facts_.blockOf(call.id));  // in the order of the program
    const auto found =
        std::ranges::lower_bound(calls, call.id, {}, [&](std::uint32_t site) { return sites[site].instruction->id; });
    if (found == calls.end() || sites[*found].instruction->id != call.id || sites[*found].callee == noBlock)
      return nullptr;
    return &facts_.program().pous[sites[*found].callee];
  }
  /// Whether the parameter is handed on by a pointer, through which the call may write it.
  bool isHandedOn(const Instruction& call, std::size_t operand) const {
    if (call.desc->control != Control::BlockCall || operand == 0) return false;
    const Pou* callee = calleeOf(call);
    if (callee == nullptr) return true;
    std::size_t i = hasInstance(*callee) ? 2 : 1;
    for (const LocalVariable& local : callee->locals) {
      if (local.section == VarSection::Temp || local.section == VarSection::Static) continue;
      if (i++ == operand) return local.type == DataType::Any || local.type == DataType::Pointer || local.size > 4;
    }
    return true;
  }
  void apply(Written& state, const FlowStep& step) const {
    const Instruction& instruction = *step.instruction;
    for (std::size_t i = 0; i < instruction.operands.size(); ++i) {
      const Operand& operand = instruction.operands[i];
      const bool isNamed = operand.kind == OperandKind::Address || isHandedOn(instruction, i);
      if (operand.area != Area::L || operand.kind == OperandKind::Constant || !isNamed) continue;
      const LocalRange variable = variableAt(operand);
      state.onAllPaths.set(variable.first, variable.count);
      state.onSomePath.set(variable.first, variable.count);
    }
    const bool isLatch = statementRole(instruction) == StatementRole::Latch;
    for (const Access& access : facts_.accesses().of(instruction.id)) {
      if (access.area != Area::L || !access.write || access.viaPointer) continue;
      const LocalRange range = rangeOf(access);
      if (!isLatch) state.onAllPaths.set(range.first, range.count);
      state.onSomePath.set(range.first, range.count);
    }
  }
  void findReads(const Written& state, const Instruction& instruction, std::set<std::size_t>& told,
                 std::vector<TempRead>& reads) const {
    if (statementRole(instruction) == StatementRole::Edge) return;
    for (const Access& access : facts_.accesses().of(instruction.id)) {
      if (access.area != Area::L || access.write || access.viaPointer || access.maybe ||
          access.operand >= instruction.operands.size() || isHandedOn(instruction, access.operand))
        continue;
      const LocalRange range = rangeOf(access);
      bool isMissing = false, isNever = false;
      for (std::size_t bit = range.first; bit < range.first + range.count; ++bit) {
        isMissing = isMissing || !state.onAllPaths.has(bit);
        isNever = isNever || !state.onSomePath.has(bit);
      }
      const Operand& operand = instruction.operands[access.operand];
      if (isMissing && told.insert(variableAt(operand).first).second)
        reads.push_back({&instruction, &operand, isNever});
    }
  }

  const Facts& facts_;
  const Flow& flow_;
  std::size_t bits_;
};

/// Numbers of the block's parameters that the statement writes.
template <class Visit>
void eachWrittenParameter(const Facts& facts, const Instruction& instruction, Visit&& visit) {
  const auto parameterOf = [](const Operand& operand) {
    const bool isParameter = operand.reach != nullptr && operand.reach->way == Way::Parameter;
    return isParameter ? std::optional(operand.reach->parameter) : std::nullopt;
  };
  for (const Operand& operand : instruction.operands) {
    const auto parameter = parameterOf(operand);
    if (parameter && operand.kind == OperandKind::Address) visit(*parameter);
  }
  for (const Access& access : facts.accesses().of(instruction.id)) {
    if (!access.write || access.operand >= instruction.operands.size()) continue;
    if (const auto parameter = parameterOf(instruction.operands[access.operand])) visit(*parameter);
  }
}

}  // namespace

std::vector<TempRead> unwrittenTemps(const Facts& facts, std::uint32_t block) {
  const std::uint32_t localBytes = facts.program().pous[block].localBytes;
  const Temps temps(facts, block);
  if (localBytes == 0 || localBytes > mostLocalBytes || temps.writesThroughPointers()) return {};
  return temps.unwritten();
}

std::vector<OutputGap> unwrittenOutputs(const Facts& facts, std::uint32_t block) {
  const Flow& flow = facts.plan().flows[block];
  std::vector<const LocalVariable*> outputs;
  for (const LocalVariable& local : flow.pou->locals) {
    if (flow.pou->type == BlockType::Fc && local.section == VarSection::Output && local.address.reach != nullptr)
      outputs.push_back(&local);
  }
  if (outputs.empty()) return {};
  const std::size_t count = flow.pou->locals.size();
  const LogicStates logic = logicStates(flow);
  // S and R behind SET write as well as = does.
  const auto isConditional = [&](const FlowStep& step) {
    const std::optional<LogicState>& before = logic[static_cast<std::size_t>(&step - flow.steps.data())];
    return statementRole(*step.instruction) == StatementRole::Latch && before && before->rlo != mayBe1;
  };
  const auto states = statesOnConditionalPaths(
      facts, flow, Written{AssignedBits(count), AssignedBits(count)}, [&](Written& state, const FlowStep& step) {
        eachWrittenParameter(facts, *step.instruction, [&](std::uint32_t parameter) {
          if (!isConditional(step)) state.onAllPaths.set(parameter, 1);
          state.onSomePath.set(parameter, 1);
        });
      });
  std::vector<OutputGap> gaps;
  const auto end = static_cast<std::uint32_t>(flow.steps.size());
  if (!states[end]) return gaps;
  for (const LocalVariable* output : outputs) {
    const std::uint32_t parameter = output->address.reach->parameter;
    if (states[end]->onAllPaths.has(parameter)) continue;
    OutputGap gap{output, nullptr, true, true};
    for (const FlowStep& step : flow.steps)
      eachWrittenParameter(facts, *step.instruction, [&](std::uint32_t written) {
        if (written != parameter) return;
        gap.isNeverWritten = false;
        gap.isLatched = gap.isLatched && isConditional(step);
      });
    gap.isLatched = gap.isLatched && !gap.isNeverWritten;
    for (std::uint32_t at = 0; at < end && gap.exit == nullptr; ++at) {
      const StatementRole role = statementRole(*flow.steps[at].instruction);
      const bool leaves = role == StatementRole::End || role == StatementRole::EndByRlo;
      if (leaves && states[at] && !states[at]->onAllPaths.has(parameter)) gap.exit = flow.steps[at].instruction;
    }
    gaps.push_back(gap);
  }
  return gaps;
}

}  // namespace rungproof
