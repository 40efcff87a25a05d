// Runs machine code on a state, and takes back what it wrote when it gives up.
#include "engine/compiled/compiled_program.hpp"

#include <algorithm>
#include <cstring>
#include <new>
#include <utility>

#include "engine/compiled/reduce.hpp"

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

}  // namespace

std::unique_ptr<CompiledProgram> CompiledProgram::of(const Plan& plan, const Concrete::Store& model,
                                                     const InstructionTimes& times, bool countsTime) {
  const bool hasProgram = plan.isStep7() || plan.main() != nullptr;
  if (!hasProgram || !canTranslate()) return nullptr;
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
      keptCounts_(code_.sites.size()) {
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
    if (s.op == CodeOp::StoreBit || s.op == CodeOp::StoreSlots) {
      const SlotByte& slots = code_.slots[s.value / 8];
      isWritten(slots.area, slots.byte);
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
  if (std::exchange(workspace().hasCounted, 0) != 0)
    std::memcpy(keptCounts_.data(), errorCounts(), keptCounts_.size() * sizeof(std::uint64_t));
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
  std::memcpy(errorCounts(), keptCounts_.data(), keptCounts_.size() * sizeof(std::uint64_t));
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
  for (const Written& w : writtenBytes_) {
    if (w.area == Area::L) std::memset(store.area(Area::L).data() + w.first, 0, w.count);
  }
}

/// Nothing of a new list is known.
void CompiledProgram::startErrors(const RunTimeErrors& errors) {
  if (std::exchange(clearings_, errors.clearings()) == errors.clearings()) return;
  workspace().hasCounted = 1;  // other counts than those that are kept
  std::fill_n(errorCounts(), code_.sites.size(), 0);
  std::fill_n(news(), code_.sites.size(), std::uint8_t{1});
}

/// Whether all errors of this scan have happened before; the first time is told by the reference engine.
bool CompiledProgram::areListed(const RunTimeErrors& errors) {
  const std::vector<RunTimeError>& list = errors.list();
  for (std::size_t site = 0; site < code_.sites.size(); ++site) {
    if (news()[site] == 0 || errorCounts()[site] == keptCounts_[site]) continue;
    const auto found = std::ranges::find_if(list, [&](const RunTimeError& e) {
      return e.hazard == code_.sites[site].hazard && e.place == code_.sites[site].place;
    });
    if (found == list.end()) return false;
    listedAt_[site] = static_cast<std::size_t>(found - list.begin());
    news()[site] = 0;
  }
  return true;
}

void CompiledProgram::tellErrors(RunTimeErrors& errors) {
  startErrors(errors);
  workspace().hasCounted = 1;
  for (std::size_t site = 0; site < code_.sites.size(); ++site) {
    if (const std::uint64_t times = std::exchange(errorCounts()[site], 0); times != 0)
      errors.repeat(listedAt_[site], times);
  }
}

std::optional<std::uint64_t> CompiledProgram::run(Concrete::Store& store, std::uint64_t ticks100,
                                                  std::uint64_t mostTime, const RunTimeErrors& errors) {
  if (code_.expectsAlwaysOn && (store.area(Area::SM)[0] & 1U) == 0) return std::nullopt;
  startErrors(errors);
  if (canLeave_) keep(store);
  Workspace& w = workspace();
  for (const Area area : usedAreas_) w.area[static_cast<std::size_t>(area)] = bytesOf(store, area, code_.hasTerminals);
  w.registers = store.registers().data();
  w.ticks100 = ticks100;
  w.mostTime = mostTime;
  const bool isDone = machineCode_->run(w) && (w.hasErrors == 0 || areListed(errors));
  if (!isDone) takeBack(store);
  if (!isDone) return std::nullopt;
  clearLocal(store);
  return code_.countsTime ? w.position : 0;
}

}  // namespace rungproof::compiled
