// Runs machine code on a state, and takes back what it wrote when it gives up.
#include "engine/compiled/compiled_program.hpp"

#include <algorithm>
#include <cstring>

#include "engine/compiled/reduce.hpp"

namespace rungproof::compiled {

namespace {

/// Runs of written places that are kept as one if no more lies between them.
constexpr std::uint32_t nearby = 32;

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

}  // namespace

std::unique_ptr<CompiledProgram> CompiledProgram::of(const Plan& plan, const Concrete::Store& model,
                                                     const InstructionTimes& times, bool countsTime) {
  if (plan.isStep7() || plan.main() == nullptr || !canTranslate()) return nullptr;
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
      slots_(code_.slots.size() * 8),
      counts_(code_.sites.size()),
      isListed_(code_.sites.size()) {
  findWritten(isNeeded, registers);
  workspace_.slots = slots_.data();
  workspace_.counts = counts_.data();
  workspace_.isListed = isListed_.data();
  code_.steps.clear();
  code_.steps.shrink_to_fit();
}

void CompiledProgram::findWritten(const std::vector<bool>& isNeeded, std::size_t registers) {
  std::array<std::vector<bool>, areaCount> bytes;
  std::vector<bool> isRegisterWritten(registers);
  for (std::size_t i = 0; i < code_.steps.size(); ++i) {
    const Step& s = code_.steps[i];
    if (!isNeeded[i]) continue;
    if (s.op == CodeOp::StoreRegister) isRegisterWritten[s.value] = true;
    if (s.op != CodeOp::StoreMemory) continue;
    std::vector<bool>& area = bytes[static_cast<std::size_t>(s.area)];
    area.resize(std::max<std::size_t>(area.size(), s.value + s.width / 8U));
    for (std::size_t k = 0; k < s.width / 8U; ++k) area[s.value + k] = true;
  }
  std::size_t kept = 0;
  for (std::size_t a = 0; a < areaCount; ++a) {
    const Area area = static_cast<Area>(a);
    if (area == Area::V && code_.writesByPointer) continue;  // kept whole
    runsOf(bytes[a], [&](std::uint32_t first, std::uint32_t count) {
      writtenBytes_.push_back({area, first, count});
      kept += count;
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
  if (code_.writesByPointer && keptBytes_.size() < store.area(Area::V).size()) {
    writtenBytes_.push_back({Area::V, 0, static_cast<std::uint32_t>(store.area(Area::V).size())});
    keptBytes_.resize(keptBytes_.size() + store.area(Area::V).size());
    code_.writesByPointer = false;  // among the others from now on
  }
  std::uint8_t* to = keptBytes_.data();
  for (const Written& w : writtenBytes_) {
    std::memcpy(to, store.area(w.area).data() + w.first, w.count);
    to += w.count;
  }
  std::uint32_t* next = keptRegisters_.data();
  for (const Written& w : writtenRegisters_) {
    std::memcpy(next, store.registers().data() + w.first, w.count * sizeof(std::uint32_t));
    next += w.count;
  }
}

void CompiledProgram::takeBack(Concrete::Store& store) const {
  const std::uint8_t* from = keptBytes_.data();
  for (const Written& w : writtenBytes_) {
    std::memcpy(store.area(w.area).data() + w.first, from, w.count);
    from += w.count;
  }
  const std::uint32_t* next = keptRegisters_.data();
  for (const Written& w : writtenRegisters_) {
    std::memcpy(store.registers().data() + w.first, next, w.count * sizeof(std::uint32_t));
    next += w.count;
  }
}

/// Which errors have happened before.
void CompiledProgram::list(const RunTimeErrors& errors) {
  std::fill(isListed_.begin(), isListed_.end(), 0);
  for (std::size_t i = 0; i < code_.sites.size(); ++i)
    isListed_[i] = errors.has(code_.sites[i].hazard, code_.sites[i].place) ? 1 : 0;
  listed_ = errors.list().size();
}

std::optional<std::uint64_t> CompiledProgram::run(Concrete::Store& store, std::uint64_t ticks100,
                                                  std::uint64_t mostTime, RunTimeErrors& errors) {
  if (errors.list().size() != listed_) list(errors);
  keep(store);
  for (std::size_t a = 0; a < areaCount; ++a) workspace_.area[a] = store.area(static_cast<Area>(a)).data();
  workspace_.registers = store.registers().data();
  workspace_.ticks100 = ticks100;
  workspace_.mostTime = mostTime;
  workspace_.hasCounted = 0;
  const bool isDone = machineCode_->run(workspace_);
  if (!isDone) takeBack(store);
  if (workspace_.hasCounted != 0) {
    for (std::size_t i = 0; i < counts_.size(); ++i) {
      if (isDone && counts_[i] != 0) errors.repeat(code_.sites[i].hazard, code_.sites[i].place, counts_[i]);
      counts_[i] = 0;
    }
  }
  if (!isDone) return std::nullopt;
  return code_.countsTime ? workspace_.position : 0;
}

}  // namespace rungproof::compiled
