// Runs machine code on a state, and takes back what it wrote when it gives up.
#include "engine/compiled/compiled_program.hpp"

#include <algorithm>
#include <cstring>
#include <new>
#include <span>
#include <utility>

#include "engine/compiled/reduce.hpp"
#include "ir/iec/expression_role.hpp"

namespace rungproof::compiled {

namespace {

/// Runs of written places that are kept as one if no more lies between them.
constexpr std::uint32_t nearby = 128;

/// The numbers for which `isWritten` holds as runs.
template <class Take>
void runsOf(const std::vector<bool>& isWritten, Take&& take) {
  const auto count = static_cast<std::uint32_t>(isWritten.size());
  for (std::uint32_t first = 0; first < count; ++first) {
    if (!isWritten[first]) continue;
    std::uint32_t last = first;
    for (std::uint32_t i = first; i < count && i <= last + nearby; ++i) last = isWritten[i] ? i : last;
    take(first, last - first + 1);
    first = last;
  }
}

/// The bytes of an area as recorded code names it.
template <class Store>
auto* bytesOf(Store& store, Area area, bool hasTerminals) {
  return hasTerminals && area == Area::PI   ? store.terminals(Reg::PhysicalInput).data()
         : hasTerminals && area == Area::PQ ? store.terminals(Reg::PhysicalOutput).data()
                                            : store.area(area).data();
}

/// IEC 61131-3: whether the evaluation stack is empty wherever ways part or meet, so that no value has to be kept from
/// block to block of the code. Calls are recorded in place: one with values on the stack may not branch.
bool branchesOnEmptyStack(const Plan& plan) {
  std::vector<std::optional<bool>> isStraight(plan.flows.size());
  const auto straight = [&](auto&& self, const Flow& flow) -> bool {
    std::optional<bool>& known = isStraight[static_cast<std::size_t>(&flow - plan.flows.data())];
    if (known) return *known;
    known = false;  // one that calls itself
    const bool has = std::ranges::all_of(flow.steps, [&](const FlowStep& step) {
      const Control control = step.instruction->desc->control;
      if (control != Control::Call) return control == Control::None;
      const Flow* callee = plan.subroutine(static_cast<int>(step.instruction->operands[0].value));
      return callee == nullptr || self(self, *callee);
    });
    return *(known = has);
  };
  return std::ranges::all_of(plan.flows, [&](const Flow& flow) {
    std::size_t depth = 0;
    for (const FlowStep& step : flow.steps) {
      const StackUse use = stackUse(*step.instruction);
      if (use.pops > depth) return false;
      depth -= use.pops;
      const Control control = step.instruction->desc->control;
      const Flow* callee =
          control == Control::Call ? plan.subroutine(static_cast<int>(step.instruction->operands[0].value)) : nullptr;
      const bool mayBranch =
          control == Control::Call ? callee != nullptr && !straight(straight, *callee) : control != Control::None;
      if (mayBranch && depth > 0) return false;
      depth += use.pushes;
    }
    return true;
  });
}

}  // namespace

std::unique_ptr<CompiledProgram> CompiledProgram::of(const Plan& plan, const Concrete::Store& model,
                                                     const InstructionTimes& times, bool countsTime) {
  const bool hasProgram = plan.dialect().run.runsWithoutMain || plan.main() != nullptr;
  if (!hasProgram || !canTranslate() || (plan.form() == StatementForm::Expressions && !branchesOnEmptyStack(plan)))
    return nullptr;
  Code code = recorded(plan, model, times, countsTime);
  const std::vector<bool> isNeeded = neededSteps(code, model.registers().size());
  std::unique_ptr<MachineCode> machineCode = translated(code, isNeeded);
  if (machineCode == nullptr) return nullptr;
  return std::unique_ptr<CompiledProgram>(
      new CompiledProgram(std::move(code), isNeeded, std::move(machineCode), model.registers().size()));
}

CompiledProgram::CompiledProgram(Code code, const std::vector<bool>& isNeeded, std::unique_ptr<MachineCode> machineCode,
                                 std::size_t registers)
    : code_(std::move(code)),
      machineCode_(std::move(machineCode)),
      memory_((machineCode_->layout.size + 7) / 8),
      listedAt_(code_.sites.size()),
      errorCounts_(code_.sites.size()) {
  new (memory_.data()) Workspace;
  for (std::size_t i = 0; i < code_.steps.size(); ++i) {
    const CodeOp op = code_.steps[i].op;
    canLeave_ = canLeave_ || (isNeeded[i] && (op == CodeOp::Leave || op == CodeOp::Count || op == CodeOp::CheckTime));
  }
  canLeave_ = canLeave_ || code_.countsTime;
  findWritten(isNeeded, registers);
  code_.steps.clear();
  code_.steps.shrink_to_fit();
}

void CompiledProgram::findWritten(const std::vector<bool>& isNeeded, std::size_t registers) {
  std::array<std::vector<bool>, areaCount> bytes;
  std::vector<bool> isRegisterWritten(registers);
  std::array<bool, areaCount> isUsed{};
  for (const SlotByte& slots : code_.slots) isUsed[static_cast<std::size_t>(slots.area)] = true;
  for (std::size_t i = 0; i < code_.steps.size(); ++i) {
    const Step& s = code_.steps[i];
    if (!isNeeded[i]) continue;
    const bool isAccess =
        s.op == CodeOp::LoadMemory || s.op == CodeOp::StoreMemory || s.op == CodeOp::LoadAt || s.op == CodeOp::StoreAt;
    if (isAccess) isUsed[static_cast<std::size_t>(s.area)] = true;
    const auto isWritten = [&](Area area, std::size_t byte) {
      std::vector<bool>& ofArea = bytes[static_cast<std::size_t>(area)];
      if (byte >= ofArea.size()) ofArea.resize(byte + 1);
      ofArea[byte] = true;
    };
    if (s.op == CodeOp::StoreRegister) isRegisterWritten[s.value] = true;
    if (s.op == CodeOp::StoreMemory) {
      for (std::size_t k = 0; k < s.width / 8U; ++k) isWritten(s.area, s.value + k);
    }
  }
  for (std::size_t a = 0; a < areaCount; ++a) {
    if (isUsed[a]) usedAreas_.push_back(static_cast<Area>(a));
  }
  for (const Reached& r : code_.reached) {
    if (!r.isWritten) continue;
    std::vector<bool>& ofArea = bytes[static_cast<std::size_t>(r.area)];
    if (ofArea.size() < r.first + r.count) ofArea.resize(r.first + r.count);
    std::fill_n(ofArea.begin() + r.first, r.count, true);
  }
  std::size_t kept = 0;
  for (std::size_t a = 0; a < areaCount; ++a) {
    const Area area = static_cast<Area>(a);
    runsOf(bytes[a], [&](std::uint32_t first, std::uint32_t count) {
      (area == Area::L ? writtenLocals_ : writtenBytes_).push_back({area, first, count});
      if (area != Area::L) kept += count;
    });
  }
  keptBytes_.resize(kept);
  kept = 0;
  runsOf(isRegisterWritten, [&](std::uint32_t first, std::uint32_t count) {
    writtenRegisters_.push_back({Area::V, first, count});
    kept += count;
  });
  keptRegisters_.resize(kept);
}

void CompiledProgram::keep(const Concrete::Store& store) {
  std::uint8_t* to = keptBytes_.data();
  for (const Written& w : writtenBytes_) {
    std::memcpy(to, bytesOf(store, w.area, code_.hasTerminals) + w.first, w.count);
    to += w.count;
  }
  std::uint32_t* next = keptRegisters_.data();
  for (const Written& w : writtenRegisters_) {
    std::memcpy(next, store.registers().data() + w.first, w.count * sizeof(std::uint32_t));
    next += w.count;
  }
}

void CompiledProgram::takeBack(Concrete::Store& store) {
  const std::uint8_t* from = keptBytes_.data();
  for (const Written& w : writtenBytes_) {
    std::memcpy(bytesOf(store, w.area, code_.hasTerminals) + w.first, from, w.count);
    from += w.count;
  }
  const std::uint32_t* next = keptRegisters_.data();
  for (const Written& w : writtenRegisters_) {
    std::memcpy(store.registers().data() + w.first, next, w.count * sizeof(std::uint32_t));
    next += w.count;
  }
}

/// Local memory holds nothing between scans.
void CompiledProgram::clearLocal(Concrete::Store& store) const {
  for (const Written& w : writtenLocals_) std::memset(store.area(Area::L).data() + w.first, 0, w.count);
}

/// The first time of an error is told by the reference engine. Nothing of a new list is known.
void CompiledProgram::learnErrors(const RunTimeErrors& errors) {
  if (std::exchange(clearings_, errors.clearings()) != errors.clearings()) {
    std::ranges::fill(errorCounts_, 0);
    std::fill_n(news(), code_.sites.size(), std::uint8_t{1});
    listed_ = 0;
  }
  for (; listed_ < errors.list().size(); ++listed_) {
    const RunTimeError& error = errors.list()[listed_];
    for (std::size_t site = 0; site < code_.sites.size(); ++site) {
      if (error.hazard != code_.sites[site].hazard || error.place != code_.sites[site].place) continue;
      listedAt_[site] = listed_;
      news()[site] = 0;
    }
  }
}

/// The errors of a scan have happened, or they have not.
void CompiledProgram::addErrors(bool areOfScan) {
  std::uint32_t* const times = numbers(machineCode_->layout.errors);
  const std::size_t count = std::exchange(workspace().happened, 0);
  for (const std::uint32_t site : std::span(numbers(machineCode_->layout.happened), count)) {
    if (areOfScan) errorCounts_[site] += times[site];
    times[site] = 0;
  }
}

void CompiledProgram::tellErrors(RunTimeErrors& errors) {
  learnErrors(errors);
  for (std::size_t site = 0; site < errorCounts_.size(); ++site) {
    if (const std::uint64_t times = std::exchange(errorCounts_[site], 0); times != 0)
      errors.repeat(listedAt_[site], times);
  }
}

std::optional<std::uint64_t> CompiledProgram::run(Concrete::Store& store, std::uint64_t ticks100,
                                                  std::uint64_t mostTime, const RunTimeErrors& errors) {
  if (code_.expectsAlwaysOn && (store.area(Area::SM)[0] & 1U) == 0) return std::nullopt;
  learnErrors(errors);
  if (canLeave_) keep(store);
  Workspace& w = workspace();
  for (const Area area : usedAreas_) w.area[static_cast<std::size_t>(area)] = bytesOf(store, area, code_.hasTerminals);
  w.registers = store.registers().data();
  w.ticks100 = ticks100;
  w.mostTime = mostTime;
  const bool isDone = machineCode_->run(w);
  if (w.happened != 0) addErrors(isDone);
  if (!isDone) takeBack(store);
  clearLocal(store);
  if (!isDone) return std::nullopt;
  return code_.countsTime ? w.position : 0;
}

}  // namespace rungproof::compiled
