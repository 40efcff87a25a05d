// Time, traces that are set apart, and what is kept for them: from time to time the state of all traces, and what has
// come from outside since.
#include "engine/lanes/many_traces.hpp"

#include <algorithm>
#include <bit>

#include "engine/cell_value.hpp"
#include "engine/compiled/recording.hpp"
#include "engine/compiled/reduce.hpp"
#include "ir/check.hpp"
#include "ir/families/run.hpp"
#include "ir/s7200/event.hpp"
#include "ir/s7200/pulse_output.hpp"

namespace rungproof {

namespace {

/// Scans between two checkpoints: a trace that is set apart repeats so many at most. Where the state is large, so many
/// more that keeping it takes little of the time.
constexpr std::size_t leastBetweenCheckpoints = 64, mostBetweenCheckpoints = 512, bytesByScan = 2048;
constexpr std::uint32_t tenNsPerUs = 100, tenNsPerMs = 1000 * tenNsPerUs;

class QuietOutside final : public Outside {
 public:
  std::uint64_t external(const ExternalSite&, int) override { return 0; }
  void report(Hazard, const Instruction*) override {}
};
QuietOutside quietOutside;

/// Whether recorded code writes what all traces have in common, or the bits of SM4 that the CPU itself resets.
bool writesCommon(const compiled::Code& code, const std::vector<bool>& isNeeded, const Concrete::Store& model) {
  const auto isCpus = [](Area area, std::uint32_t byte) { return lanes::isCommon(area, byte); };
  for (std::size_t i = 0; i < code.steps.size(); ++i) {
    const compiled::Step& s = code.steps[i];
    if (!isNeeded[i]) continue;
    const bool isBit = s.op == compiled::CodeOp::StoreBit;
    if (isBit || s.op == compiled::CodeOp::StoreSlots) {
      const compiled::SlotByte& slot = code.slots[s.value / 8];
      const bool isQueueBit =
          slot.area == Area::SM && slot.byte == 4 && (!isBit || s.value % 8 <= 2 || s.value % 8 == 7);
      if (isQueueBit || isCpus(slot.area, slot.byte)) return true;
    }
    if (s.op == compiled::CodeOp::StoreRegister && lanes::isCommon(model, s.value)) return true;
    if (s.op != compiled::CodeOp::StoreMemory || s.area != Area::SM) continue;
    for (std::uint32_t k = 0; k < s.width / 8U; ++k) {
      const std::uint32_t byte = static_cast<std::uint32_t>(s.value) + k;
      if (byte == 4 || isCpus(s.area, byte)) return true;
    }
  }
  return std::ranges::any_of(code.reached, [](const auto& r) { return r.isWritten && r.area == Area::SM; });
}

}  // namespace

ManyTraces::ManyTraces(const Program& program, const SimulatorOptions& options, std::size_t count, lanes::Vectors most)
    : program_(program),
      options_(options),
      lead_(program, options),
      count_(count),
      sideBySide_(count),
      common_(lead_.store()),
      domain_(quietOutside),
      cpu_(domain_, common_, lead_.plan()),
      running_((count + 255) / 256 * 4),
      apart_(count) {
  options_.choices = choicesFor(program.target, options.choices);
  for (std::size_t trace = 0; trace < count; ++trace) running_[trace / 64] |= std::uint64_t{1} << (trace % 64);
  cpu_.guard = true;
  hindrance_ = hindranceOf(most);
  if (hindrance_.empty()) {
    const Plan& plan = lead_.plan();
    compiled::InstructionTimes times;
    for (const std::uint32_t time : lead_.longestTimes()) times.push_back({time, time});
    recorded_ = compiled::recorded(plan, common_, times, false, compiled::Extent::WholeScan);
    const std::vector<bool> isNeeded = compiled::neededSteps(recorded_, common_.registers().size());
    if (recorded_.expectsAlwaysOn && common_.load(Area::SM, 0, 1) == 0) {
      hindrance_ = "SM0.0 is off";
    } else if (writesCommon(recorded_, isNeeded, common_)) {
      hindrance_ = "the program writes what belongs to the CPU";
    } else if (code_ = lanes::translatedForLanes(recorded_, isNeeded, common_, most); code_ == nullptr) {
      hindrance_ = "there is no vector code for it";
    } else {
      groups_ = std::make_unique<lanes::LaneGroups>(recorded_, *code_, common_, cpu_.terminals(), count);
      recorded_.steps = {};
      scansBetween_ = std::clamp(code_->layout.stateEnd / bytesByScan, leastBetweenCheckpoints, mostBetweenCheckpoints);
      checkpoint();
      return;
    }
  }
  beginEntry();
  setAllApart();
}

ManyTraces::~ManyTraces() = default;

std::string ManyTraces::hindranceOf(lanes::Vectors most) const {
  const Plan& plan = lead_.plan();
  if (std::min(most, lanes::vectorsHere()) == lanes::Vectors::None) return "the processor has no AVX2";
  if (plan.form() == StatementForm::Expressions)
    return fmt::format("programs of {} have no vector code", plan.dialect().title);
  if (!plan.dialect().run.runsWithoutMain && plan.main() == nullptr) return "there is no main program";
  if (!options_.choices.is(Choice::UnknownBits, "zero")) return "bits that the manual calls unknown are not 0";
  if (lead_.asksInputModules()) return "modules are asked at once for what the image of the inputs has";
  const auto isAttached = [&](int event) {
    return event >= 0 && common_.get(Reg::EventRoutine, static_cast<std::uint32_t>(event)) != 0;
  };
  for (const std::uint32_t timer : plan.timedEvents) {
    if (isAttached(eventOfTimed(timer))) return "events in time are attached from the start";
  }
  for (const EdgeInput& edge : edgeInputs) {
    if (isAttached(edge.rising) || isAttached(edge.rising + 1)) return "events of inputs are attached from the start";
  }
  return {};
}

void ManyTraces::checkpoint() {
  groups_->take(image_);
  commonThen_ = common_;
  momentThen_ = moment_;
  entries_ = 0;
  beginEntry();
}

void ManyTraces::beginEntry() {
  if (entries_ == since_.size()) since_.emplace_back();
  since_[entries_++].clear();
}

void ManyTraces::giveInput(Simulator& simulator, std::uint32_t byte, std::uint32_t bit, bool isOn) const {
  simulator.write(direct(Area::I, Width::Bit, byte, bit), isOn ? 1 : 0);
}

/// From the checkpoint on, with what came since, up to before the scan of the last entry.
void ManyTraces::setApart(std::size_t trace) {
  apart_[trace] = std::make_unique<Simulator>(program_, options_);
  Simulator& simulator = *apart_[trace];
  running_[trace / 64] &= ~(std::uint64_t{1} << (trace % 64));
  --sideBySide_;
  if (groups_ == nullptr) return;
  errorsBefore_[trace] = groups_->errorsOf(trace, image_);
  simulator.goOnFrom(withOutputs(groups_->store(trace, commonThen_, image_)), momentThen_);
  for (const Entry& entry : std::span(since_).first(entries_)) {
    for (const Entry::Input& input : entry.inputs) {
      const bool isOn = (entry.traces[input.firstWord + trace / 64] >> (trace % 64) & 1) != 0;
      giveInput(simulator, input.byte, input.bit, isOn);
    }
    for (const Entry::Write& write : entry.writes) {
      if (write.trace == trace) simulator.write(write.operand, write.value);
    }
    if (&entry != &since_[entries_ - 1]) simulator.scan({.lengthUs = entry.lengthUs});
  }
}
void ManyTraces::setAllApart() {
  for (std::size_t trace = 0; trace < count_; ++trace) {
    if (apart_[trace] == nullptr) setApart(trace);
  }
}

void ManyTraces::setInput(std::uint32_t byte, std::uint32_t bit, const TraceSet& traces) {
  if (sideBySide_ < count_) {
    for (std::size_t trace = 0; trace < count_; ++trace) {
      if (apart_[trace] != nullptr) giveInput(*apart_[trace], byte, bit, lanes::contains(traces, trace));
    }
  }
  if (sideBySide_ == 0) return;
  groups_->setInput(8 * byte + bit, traces);
  Entry& entry = since_[entries_ - 1];
  entry.inputs.push_back({byte, bit, entry.traces.size()});
  entry.traces.insert(entry.traces.end(), traces.begin(), traces.end());
}

void ManyTraces::write(std::size_t trace, const Operand& operand, std::uint64_t value) {
  CHECK(!lanes::isCommon(operand.area, operand.offset), "what the CPU itself writes into all traces");
  if (apart_[trace] != nullptr) return apart_[trace]->write(operand, value);
  groups_->write(trace, operand, value, common_);
  since_[entries_ - 1].writes.push_back({trace, operand, value});
}

void ManyTraces::scan(std::uint32_t lengthUs) {
  if (lengthUs == 0) lengthUs = options_.scanUs;
  if (sideBySide_ > 0) {
    const std::optional<std::uint64_t> most = lead_.quietTime(lengthUs, moment_.sinceTick);
    const bool isLong = lengthUs / 1000 >= longestStep || (!recorded_.hasLoops && most && recorded_.mostTime > *most);
    if (!most || isLong) setAllApart();
    const std::uint64_t sinceTick = moment_.sinceTick + std::uint64_t{lengthUs} * tenNsPerUs;
    const auto ticks = static_cast<std::uint32_t>(sinceTick / tenNsPerMs);
    lanes::LaneLayout::Head head{{0, 0, ticks}, most.value_or(0)};
    const Ticks<Concrete> gathered = takeTicks(cpu_);
    head.ticks[0] = static_cast<std::uint32_t>(gathered.hundred);
    head.ticks[1] = static_cast<std::uint32_t>(gathered.ten);
    beginStatus(cpu_);
    endFirstScanBits(cpu_);
    TraceSet left(running_.size());
    if (sideBySide_ > 0) left = groups_->scan(head, common_, running_);
    advanceClocks(cpu_, ticks);
    refreshSpecialMemory(cpu_, lengthUs / 1000);
    const bool isAnyLeft = std::ranges::any_of(left, [](std::uint64_t word) { return word != 0; });
    for (std::size_t trace = 0; isAnyLeft && trace < count_; ++trace) {
      if (lanes::contains(left, trace)) setApart(trace);
    }
    moment_.timeUs += lengthUs;
    moment_.clockMs += ticks;
    moment_.sinceTick = static_cast<std::uint32_t>(sinceTick % tenNsPerMs);
  }
  ++moment_.scanCount;
  for (std::size_t trace = 0; sideBySide_ < count_ && trace < count_; ++trace) {
    if (apart_[trace] != nullptr) apart_[trace]->scan({.lengthUs = lengthUs});
  }
  if (sideBySide_ == 0) return;
  since_[entries_ - 1].lengthUs = lengthUs;
  beginEntry();
  if (entries_ > scansBetween_) checkpoint();
}

/// The terminals of outputs follow from their image.
Concrete::Store ManyTraces::withOutputs(Concrete::Store store) const {
  Concrete domain(quietOutside);
  Machine<Concrete> machine(domain, store, lead_.plan());
  machine.guard = true;
  writeOutputs(machine);
  return store;
}

Concrete::Store ManyTraces::store(std::size_t trace) const {
  if (apart_[trace] != nullptr) return apart_[trace]->store();
  return withOutputs(groups_->store(trace, common_));
}

std::uint64_t ManyTraces::read(std::size_t trace, const Operand& operand) const {
  return cellValue(store(trace), operand);
}

ManyTraces::TraceSet ManyTraces::whereOn(const Operand& bit) const {
  TraceSet on(running_.size());
  const auto row = sideBySide_ > 0 ? groups_->whereOn(bit.area, bit.offset, bit.bit) : std::nullopt;
  if (row) on = *row;
  for (std::size_t trace = 0; trace < count_; ++trace) {
    if (row && apart_[trace] == nullptr) continue;
    const std::uint64_t one = std::uint64_t{1} << (trace % 64);
    on[trace / 64] = read(trace, bit) != 0 ? on[trace / 64] | one : on[trace / 64] & ~one;
  }
  return on;
}

std::vector<std::pair<Hazard, const Instruction*>> ManyTraces::errors(std::size_t trace) const {
  std::vector<std::pair<Hazard, const Instruction*>> list;
  const auto add = [&](Hazard hazard, const Instruction* place) {
    if (std::ranges::find(list, std::pair(hazard, place)) == list.end()) list.emplace_back(hazard, place);
  };
  const auto sites = [&](const lanes::TraceSet& happened) {
    for (std::size_t site = 0; site < recorded_.sites.size(); ++site) {
      if (lanes::contains(happened, site)) add(recorded_.sites[site].hazard, recorded_.sites[site].place);
    }
  };
  if (apart_[trace] == nullptr) {
    sites(groups_->errorsOf(trace));
    return list;
  }
  if (const auto before = errorsBefore_.find(trace); before != errorsBefore_.end()) sites(before->second);
  for (const RunTimeError& error : apart_[trace]->errors().list()) add(error.hazard, error.place);
  return list;
}

}  // namespace rungproof
