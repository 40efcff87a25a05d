// Records a program twice: the first time to see which bytes are used bit by bit.
#include "engine/compiled/recording.hpp"

#include "engine/compiled/recorded_walk.hpp"
#include "ir/families/run.hpp"
#include "ir/s7200/pulse_output.hpp"
#include "ir/s7200/special_memory.hpp"

namespace rungproof::compiled {

namespace {

/// Steps that one instruction may need; a longer one is left to the reference engine.
constexpr std::size_t mostOfOne = 1000;
/// Steps of a whole program, calls in place.
constexpr std::size_t mostOfAll = 2'000'000;

struct RecordingHooks {
  /// The step that has added time and through which all and only those runs have gone that are where the code is.
  using TimeAt = std::optional<std::size_t>;

  Recorder& d;
  const InstructionTimes& times;
  bool isInPart = false;
  TimeAt timeAt{};

  void before(Machine<Recorder>& m, const FlowStep& step) {
    const std::array<std::uint32_t, 2>& time = times[step.id()];
    d.code.mostTime += std::max(time[0], time[1]);
    if (!d.code.countsTime) return;
    const std::uint32_t least = std::min(time[0], time[1]);
    if (!isInPart) addTime(least);
    if (time[0] == time[1]) return;
    const Recorder::Bool runs = m.powerFlow();
    if (d.truth(runs) == true) return addTime(time[1] - least);
    d.add({.op = CodeOp::AddTimeIf, .a = runs.id, .value = time[1] - least});
  }
  /// A part begins that only some runs go through: all of them take the time that its instructions take without power.
  void skip(std::span<const FlowStep> part) {
    for (const FlowStep& step : part) addTime(std::min(times[step.id()][0], times[step.id()][1]));
    isInPart = true;
  }
  void goOn() { isInPart = false; }

  /// Within a block of the system that others may interrupt.
  template <class Runner>
  void before(Runner&, const FlowStep&) {
    d.leave(*d.guard);
  }

  template <class Body>
  void run(Machine<Recorder>& m, const FlowStep& step, Body&& body) {
    const bool isPlain = step.instruction->desc->control == Control::None;
    if (d.code.steps.size() > mostOfAll) return d.leave(d.constant(true));
    const std::size_t first = d.code.steps.size(), sites = d.code.sites.size();
    const auto stack = m.stack;
    const auto registers = m.step7;
    auto evaluation = m.evaluation;
    body();
    if (!isPlain || d.code.steps.size() - first <= mostOfOne) return;
    d.takeBack(first, sites);
    m.stack = stack;
    m.step7 = registers;
    if (m.plan.form() == StatementForm::Expressions) {  // as many values as it leaves; no run goes on to use them
      evaluation.resize(m.evaluation.size(), d.literal(0, 1));
      m.evaluation = std::move(evaluation);
    }
    const Desc& desc = *step.instruction->desc;
    if (desc.execution != Execution::Conditional) return d.leave(d.constant(true));
    if (desc.eno) m.when(d.lnot(m.powerFlow()), [&] { m.enoAfter(d.constant(false)); });
    d.leave(m.powerFlow());
  }

  template <class Runner>
  void callWithoutBody(Runner&, const Instruction&) {
    d.leave(*d.guard);
  }

  /// Fresh local memory is 0, by Choice::UnknownBits, or nothing is compiled.
  template <class Runner>
  void freshBytes(Runner&, std::uint32_t base, std::uint32_t count) {
    d.store->clear(Area::L, base, count);
  }

 private:
  void addTime(std::uint64_t time) {
    if (!d.code.countsTime || time == 0) return;
    if (timeAt)
      d.code.steps[*timeAt].value += time;
    else
      timeAt = d.add({.op = CodeOp::AddTime, .value = time});
  }
};

/// What the CPU does to timers before the program of a scan and behind it.
struct AroundProgram {
  Machine<Recorder>& m;

  Recorder::Bits ticks(std::uint64_t which) {
    return {m.d.add({.op = CodeOp::LoadTicks, .width = 16, .value = which})};
  }
  void begin() {
    m.d.isAround = true;
    if (m.store.size(Area::SM) > 31 && savesMemory(m.target)) m.setSm(31, 7, m.d.constant(false));
    refreshTimers(m, 10, ticks(1));
    beginScanOfTimers(m);
    m.d.isAround = false;
  }
  void end() {
    m.d.isAround = true;
    m.guard = m.d.constant(true);
    const Recorder::Bits elapsed = ticks(2);
    refreshTimers(m, 1, elapsed);
    endScanOfTimers(m, m.d.zext(elapsed, 16, restBits));
    m.d.isAround = false;
  }
};

struct Recording {
  Code code;
  std::vector<std::vector<AccessCount>> accesses;
};

Recording recordOnce(const Plan& plan, const Concrete::Store& model, const InstructionTimes& times, bool countsTime,
                     Extent extent, const std::vector<SlotByte>& slots, bool isStraight, bool isAlwaysOn,
                     LoopFacts& loops) {
  Recorder recorder;
  recorder.hasParts = extent == Extent::Program && plan.form() != StatementForm::Accumulators;
  recorder.isAlwaysOn = recorder.code.expectsAlwaysOn = isAlwaysOn;
  recorder.loops = &loops;
  recorder.code.isWholeScan = extent == Extent::WholeScan;
  recorder.code.hasTerminals = plan.dialect().memory.hasTerminals;
  recorder.code.countsTime = countsTime;
  recorder.code.isStraight = isStraight;
  Recorder::Store store(recorder, model, slots);
  Machine<Recorder> machine(recorder, store, plan);
  recorder.guard = &machine.guard;
  machine.ticks100 = {recorder.add({.op = CodeOp::LoadTicks, .width = 16})};
  RecordingHooks hooks{recorder, times};
  Scan<Recorder, RecordingHooks> scan(machine, hooks);
  if (extent == Extent::WholeScan) AroundProgram{machine}.begin();
  scan.program();
  if (extent == Extent::WholeScan) AroundProgram{machine}.end();
  return {std::move(recorder.code), store.accesses()};
}

Recording record(const Plan& plan, const Concrete::Store& model, const InstructionTimes& times, bool countsTime,
                 Extent extent, const std::vector<SlotByte>& slots, bool isStraight, bool isAlwaysOn) {
  LoopFacts loops;
  while (true) {
    loops.isComplete = true;
    Recording recording = recordOnce(plan, model, times, countsTime, extent, slots, isStraight, isAlwaysOn, loops);
    if (loops.isComplete) return recording;
  }
}

/// Accesses to bits of a byte from which on it pays to take it apart before the program and to put it together behind.
constexpr std::uint32_t leastBits = 4;

/// Bytes that are used bit by bit, more than otherwise. What a computed address reaches has no slots.
std::vector<SlotByte> slotsFor(const Recording& survey, Extent extent) {
  const bool isForManyScans = extent == Extent::WholeScan;
  std::vector<SlotByte> slots;
  for (std::size_t a = 0; a < areaCount; ++a) {
    std::vector<bool> isReached(survey.accesses[a].size(), false);
    for (const Reached& r : survey.code.reached) {
      if (r.area == static_cast<Area>(a)) std::fill_n(isReached.begin() + r.first, r.count, true);
    }
    for (std::uint32_t byte = 0; byte < survey.accesses[a].size(); ++byte) {
      const AccessCount& count = survey.accesses[a][byte];
      // Sixteen such bytes are moved at once. Local memory is cleared in rows, which slots would part.
      const bool isSingle = count.isSingle && count.words == 0 && static_cast<Area>(a) != Area::L;
      const std::uint32_t least = isForManyScans || isSingle ? 1 : leastBits;
      if (count.bits > count.words && count.bits >= least && !isReached[byte])
        slots.push_back({static_cast<Area>(a), byte});
    }
  }
  return slots;
}

}  // namespace

Code recorded(const Plan& plan, const Concrete::Store& model, const InstructionTimes& times, bool countsTime,
              Extent extent) {
  const Recording survey = record(plan, model, times, countsTime, extent, {}, false, false);
  const bool isStraight = std::ranges::none_of(survey.code.steps, [](const Step& s) { return isBranch(s.op); });
  const auto isStatus = [](const Step& s) { return s.op == CodeOp::StoreMemory && s.area == Area::SM && s.value == 0; };
  const bool isAlwaysOn = plan.dialect().memory.hasSpecialMemory && std::ranges::none_of(survey.code.steps, isStatus);
  return record(plan, model, times, countsTime || survey.code.hasLoops, extent, slotsFor(survey, extent), isStraight,
                isAlwaysOn)
      .code;
}

}  // namespace rungproof::compiled
