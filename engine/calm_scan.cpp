// Calm scans: nothing but the program, inputs and the clocks has a part in them. Once machine code has run a scan in
// which no event is attached and no device works, only the reference engine can change that, or somebody outside who is
// looked for in front of each scan; what the CPU does around the program is then these few steps, the same as in
// Simulator::scanInRun. A scan that machine code gives up goes on as any other does. Covered by
// tests/compiled/calm_scans_test.cpp.
#include <algorithm>

#include "engine/simulator_hooks.hpp"

namespace rungproof {

namespace {

/// Special memory tells of full queues in SM4.0 to SM4.2, and of forced values in SM4.7.
bool hasQueueBits(const Plan& plan) { return plan.dialect().memory.hasSpecialMemory; }

}  // namespace

/// Of the scan that has ended: whether those to come are calm until the reference engine runs again.
bool Simulator::becomesCalm() const {
  if (outside_ != nullptr || hasFineTimers_ || touchesQueueBits_ || !isRunning()) return false;
  const auto areFree = [&](Reg reg) {
    for (std::uint32_t i = 0; i < store_.count(reg); ++i) {
      if (store_.get(reg, i) != 0) return false;
    }
    return true;
  };
  for (const Reg reg :
       {Reg::EventRoutine, Reg::HscMode, Reg::PulseBusy, Reg::PortBusy, Reg::NetTable, Reg::FirstScan}) {
    if (!areFree(reg)) return false;
  }
  return queue_.empty() && devices_.areIdle(store_) && watchdogTime() < longestStep * Cost::perMs;
}

bool Simulator::staysCalm(const ScanRequest& request, std::uint32_t lengthUs) const {
  return isCalm_ && request.script == nullptr && request.events.empty() && observer_ == nullptr && forced_.empty() &&
         isRunning() && scanCount_ > referenceUntil_ && devices_.ports.areIdle(store_) &&
         (!hasQueueBits(plan_) || (store_.area(Area::SM)[4] & 7U) == 0) &&
         static_cast<std::uint64_t>(lengthUs) * Cost::perUs <= longestCalm_;
}

void Simulator::beginCalmly(std::uint32_t lengthUs) {
  if (!devices_.counters.hasSeen(store_)) lookAtInputs(lengthUs);
  const Ticks<Concrete> ticks = takeTicks(machine_);
  endSave();
  beginScan(machine_, ticks);
}

/// Of a program that has ended at position_.
void Simulator::endCalmly(std::uint32_t lengthUs) {
  lastScanUs_ = std::max(lengthUs, static_cast<std::uint32_t>((position_ + Cost::perUs - 1) / Cost::perUs));
  const std::uint32_t total = sinceTick_ + lastScanUs_ * Cost::perUs;
  scanTicks_ = total / Cost::perMs;
  sinceTick_ = total % Cost::perMs;
  moment_ += scanTicks_;
  clockMs_ = startMs_ + scanTicks_;
  now_ += lastScanUs_;
  advanceClocks(machine_, scanTicks_);
  endScanOfTimers(machine_, scanTicks_);
  refreshSpecialMemory(machine_, lastScanUs_ / 1000);
  starts_.scanEnded(lastScanUs_ / 1000);
  if (plan_.dialect().memory.numbersArePointers)
    std::ranges::fill(store_.area(Area::L), std::uint8_t{0});  // computed addresses lead there too
  if (hasQueueBits(plan_)) store_.area(Area::SM)[4] &= 0x7F;
  const auto& image = store_.area(Area::Q);
  std::copy_n(image.begin(), machine_.terminals() / 8, store_.terminals(Reg::PhysicalOutput).begin());
}

}  // namespace rungproof
