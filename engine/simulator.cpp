// The run of a program: switches, environment, one scan. What happens at instruction boundaries is in
// simulator_time.cpp.
#include "engine/simulator.hpp"

#include <charconv>

#include "engine/cell_value.hpp"
#include "engine/device_end.hpp"
#include "engine/simulator_hooks.hpp"
#include "engine/splitmix.hpp"
#include "ir/s7200/error_codes.hpp"
#include "ir/s7200/special_memory.hpp"

namespace rungproof {

namespace {

constexpr std::uint64_t defaultStation = 2;  // of a CPU as delivered (not in the manual text)

/// Of the error that came last for the first time; 0: none.
std::uint64_t lastErrorCode(const std::vector<RunTimeError>& errors) {
  for (auto error = errors.rbegin(); error != errors.rend(); ++error) {
    const HazardInfo& info = hazardInfo(error->hazard);
    std::uint64_t code = 0;
    if (info.kind != HazardClass::NonFatal) continue;
    std::from_chars(info.code.data(), info.code.data() + info.code.size(), code, 16);
    return code;
  }
  return 0;
}

}  // namespace

void Simulator::powerCycle() {
  store_ = powerCycledState(plan_, options_.choices, store_, *options_.retentive);
  isCalm_ = false;
  queue_.clear();
  errors_.clear();
  devices_.reset();
  starts_.reset();
  lastEdge_ = {};
  stoppedBy_ = nullptr;
}

void Simulator::run() {
  if (isRunning()) return;
  enterRun(plan_, store_, options_.choices, *options_.retentive);
  isCalm_ = false;
  queue_.clear();
  errors_.clear();
  devices_.reset();
  starts_.reset();
  lastEdge_ = {};
  stoppedBy_ = nullptr;
}

void Simulator::startClock(Reg clock, std::uint32_t ms, std::uint32_t bit) {
  if (clock == Reg::PhaseHundred) setTickPhase(store_, ms);
  if (clock == Reg::PhaseSecond) store_.set(clock, 0, ms % 1000, true);
  if (clock == Reg::PhaseMinute) store_.set(clock, 0, ms % 60000, true);
  if (clock == Reg::ClockPhase) store_.set(clock, bit, ms % clockPeriods[bit], true);
}

void Simulator::goOnFrom(const Concrete::Store& store, const Moment& moment) {
  setStore(store);
  scanCount_ = moment.scanCount;
  now_ = moment.timeUs;
  clockMs_ = moment.clockMs;
  sinceTick_ = moment.sinceTick;
  forgetInputEdges();
}

void Simulator::stop() {
  isCalm_ = false;
  store_.set(Reg::Running, 0, 0, true);
}

void Simulator::scan(const ScanRequest& request) {
  const std::uint32_t lengthUs = request.lengthUs != 0 ? request.lengthUs : options_.scanUs;
  if (isRunning()) {
    scanInRun(request, lengthUs);
  } else {
    scanInStop(lengthUs);
  }
}

/// Inputs are read and time passes, but nothing that belongs to the program goes on.
void Simulator::scanInStop(std::uint32_t lengthUs) {
  ++scanCount_;
  script_ = nullptr;
  position_ = 0;
  startMs_ = clockMs_;
  machine_.guard = true;
  machine_.halted = machine_.faulted = false;
  beginStatus(machine_);
  endFirstScanBits(machine_);
  takeTicks(machine_);  // nobody counts them
  readInputs(machine_);
  for (const Area area : {Area::I, Area::AI}) forced_.apply(area, store_);
  finishScan(lengthUs);
}

void Simulator::scanInRun(const ScanRequest& request, std::uint32_t lengthUs) {
  Hooks hooks{*this};
  Runner runner(machine_, hooks);
  ++scanCount_;
  ++moment_;
  script_ = request.script;
  position_ = watchdogFrom_ = pending_ = 0;
  loop_.begin();
  hasTimeError_ = false;
  startMs_ = clockMs_;
  nextMs_ = script_ == nullptr ? Cost::perMs - sinceTick_ : isScriptQuiet() ? quietTime() : 0;
  scanTicks_ = scriptedTicks_ = 0;
  showInputsToModules();
  isCalm_ = staysCalm(request, lengthUs);
  if (isCalm_) {
    beginCalmly(lengthUs);
    isCalm_ = runCompiled(lengthUs);
    if (isCalm_) return endCalmly(lengthUs);
    lookAtInputs(lengthUs);
    runProgram(runner);
    passRest(runner, lengthUs);
    return finishScan(lengthUs);
  }
  if (script_ != nullptr) beginScript(lengthUs / 1000);

  Ticks<Concrete> ticks = takeTicks(machine_);
  if (script_ != nullptr && script_->ticks10) ticks.ten = *script_->ticks10;
  if (script_ != nullptr && script_->ticks100) ticks.hundred = *script_->ticks100;
  machine_.guard = true;
  if (script_ == nullptr) {
    endSave();
    lookAtInputs(lengthUs);
  }
  if (script_ != nullptr) scriptedWrites({ScanPlace::startOfScan});
  beginScan(machine_, ticks);
  for (const Area area : {Area::I, Area::AI}) forced_.apply(area, store_);
  for (const int event : request.events) raiseByStimulus(event);
  const bool isCompiled = !machine_.halted && runCompiled(lengthUs);
  if (!isCompiled) runProgram(runner);
  if (observer_ != nullptr) observer_->programEnded(machine_);
  passRest(runner, lengthUs);
  finishScan(lengthUs);
  isCalm_ = isCompiled && script_ == nullptr && becomesCalm();
}

void Simulator::lookAtInputs(std::uint32_t lengthUs) {
  raiseInputEdges();
  devices_.counters.beginScan(store_, std::max(lengthUs / 1000, 1U), [this](int event) { raise(event); });
}

void Simulator::finishScan(std::uint32_t lengthUs) {
  const auto spentUs = static_cast<std::uint32_t>((position_ + Cost::perUs - 1) / Cost::perUs);
  lastScanUs_ = script_ != nullptr ? lengthUs : std::max(lengthUs, spentUs);
  const std::uint64_t total = sinceTick_ + static_cast<std::uint64_t>(lastScanUs_) * Cost::perUs;
  scanTicks_ = static_cast<std::uint32_t>(total / Cost::perMs);
  sinceTick_ = static_cast<std::uint32_t>(total % Cost::perMs);
  machine_.guard = true;
  if (machine_.halted) store_.set(Reg::Running, 0, 0, true);
  store_.set(Reg::Fault, 0, machine_.faulted ? 1 : 0, true);
  std::ranges::fill(store_.area(Area::L), std::uint8_t{0});  // no block runs: local memory holds nothing (001:1373)
  for (const Area area : {Area::V, Area::M, Area::Q, Area::AQ}) forced_.apply(area, store_);
  std::uint32_t left = scanTicks_;
  for (; left > longestStep; left -= longestStep) advanceClocks(machine_, longestStep);
  advanceClocks(machine_, left);
  endScanOfTimers(machine_, scanTicks_);
  refreshSpecialMemory(machine_, std::min(lastScanUs_ / 1000, 0xFFFFU));
  writeOutputs(machine_);
  store_.save(Area::SM, 4 * 8 + 7, 1, forced_.empty() ? 0 : 1, true);
  if (script_ == nullptr) devices_.network.endScan(machine_);
  now_ += lastScanUs_;
  clockMs_ = startMs_ + scanTicks_;
  if (script_ != nullptr) endScript();
  if (!isRunning()) queue_.clear();
  starts_.scanEnded(lastScanUs_ / 1000);
}

/// A byte of the start information: what a stimulus says before what the run says, before any value.
std::uint64_t Simulator::startByte(int block, std::uint32_t byte, std::uint64_t unknown) const {
  if (const auto given = devices_.startInformation(block, byte)) return *given;
  return starts_.byteOf(block, byte, store_, devices_.clock, clockMs_).value_or(static_cast<std::uint8_t>(unknown));
}

std::uint64_t Simulator::read(const Operand& operand) const { return cellValue(store_, operand); }
void Simulator::write(const Operand& operand, std::uint64_t value) {
  if (operand.area == Area::HC && !takesCounts(store_, operand)) return;
  setCell(store_, operand, value);
  if (operand.area != Area::PI && operand.area != Area::AI) return;
  const auto isGiven = [&](std::uint32_t byte) {
    return byte >= operand.offset && byte < operand.offset + static_cast<std::uint32_t>(bytes(operand.width));
  };
  std::erase_if(askedModules_, isGiven);
}

/// A module says at a direct access what it says when the image is read.
void Simulator::showInputsToModules() {
  const auto& terminals = store_.terminals(Reg::PhysicalInput);
  for (const std::uint32_t byte : askedModules_)
    store_.area(Area::AI)[byte] = byte < terminals.size() ? terminals[byte] : store_.area(Area::I)[byte];
}

void Simulator::writeByDevice(const Operand& operand, std::uint64_t value) {
  isCalm_ = false;
  machine_.guard = true;
  setCell(store_, operand, value);
  const std::optional<DeviceEnd> end = endShownBy(machine_, operand, value);
  if (end && end->event) raise(*end->event);
}

/// The value has been saved at the end of the scan before (001:1649-1651).
void Simulator::endSave() {
  if (savesMemory_) store_.save(Area::SM, 31 * 8 + 7, 1, 0, true);
}

bool Simulator::force(const Operand& operand, std::uint64_t value) { return forced_.set(operand, value); }
void Simulator::unforce(const Operand& operand) { forced_.remove(operand); }

std::uint64_t Simulator::unknown(int width) {
  if (options_.choices.is(Choice::UnknownBits, "zero")) return 0;
  if (options_.choices.is(Choice::UnknownBits, "one")) return Concrete::mask(width);
  random_ += splitmixStep;
  return splitmix(random_) & Concrete::mask(width);
}

std::uint64_t Simulator::external(const ExternalSite& site, int width) {
  const std::uint64_t value = externalValue(site, width);
  loop_.disturb();
  if (observer_ != nullptr) observer_->external(site, value);
  return value;
}

/// Of a block without text a stimulus says what its outputs are; everything else stays as it is.
std::uint64_t Simulator::kept(const LibraryEffect& effect) const {
  if (effect.area == Area::AC)
    return effect.at == LibraryEffect::eno ? store_.get(Reg::Eno, 0) : store_.get(Reg::Accumulator, effect.at);
  return effect.bit ? store_.load(effect.area, effect.at * 8 + *effect.bit, 1)
                    : store_.load(effect.area, effect.at * 8, 8);
}

std::uint64_t Simulator::externalValue(const ExternalSite& site, int width) {
  switch (site.kind) {
    case External::StackBottom:
    case External::LocalMemory:
    case External::UnknownStatus:
    case External::UnknownResult:
      if (outside_ == nullptr && site.index == errorCodeIndex) return lastErrorCode(errors().list());
      if (unknownIsZero_) return 0;
      if (outside_ == nullptr) return unknown(width);
      break;
    case External::ImmediateInput:
      if (const std::optional<bool> forced = forced_.bit(Area::I, site.index)) return *forced ? 1 : 0;
      if (outside_ == nullptr)
        return site.index < store_.count(Reg::PhysicalInput) ? store_.get(Reg::PhysicalInput, site.index)
                                                             : store_.load(Area::I, site.index, 1);
      break;
    case External::AnalogInput:
      // What was read last is what traces show.
      if (outside_ != nullptr && options_.choices.is(Choice::AnalogSampling, "each-read"))
        store_.save(Area::AI, site.index * 8, width, outside_->external(site, width), true);
      return store_.load(Area::AI, site.index * 8, width);
    case External::ClockByte:
      if (outside_ == nullptr) return devices_.clock.byteAt(site.index, clockMs_);
      break;
    case External::IntervalClock:
      if (outside_ == nullptr) return clockMs_;
      break;
    case External::CalendarDay:
      if (outside_ == nullptr) return devices_.clock.dayAt(clockMs_);
      break;
    case External::TimeOfDay:
      if (outside_ == nullptr) return devices_.clock.timeOfDayAt(clockMs_);
      break;
    case External::StationAddress:
      if (outside_ == nullptr) return defaultStation;
      break;
    case External::LibraryOutput:
      if (outside_ == nullptr)
        return libraryEffect(site.index) ? kept(*libraryEffect(site.index))
                                         : devices_.libraryOutput(*calledBlock_, site.index);
      break;
    default: break;
  }
  return outside_ == nullptr ? 0 : outside_->external(site, width);
}

void Simulator::report(Hazard hazard, const Instruction* place) {
  errors_.add(hazard, place, scanCount_, now_ + position_ / Cost::perUs);
  if (outside_ != nullptr) outside_->report(hazard, place);
}

}  // namespace rungproof
