// When machine code runs the program of a scan: where nothing but the program itself decides what the scan leaves. No
// event waits, nobody looks, nothing is forced, no script names a place in the scan, and no tick of the 1 ms clock that
// falls into the program makes a difference there. Whatever else happens, the machine code gives up and the reference
// engine makes the scan. A simulator owns its machine code, so that it is made and ends here too. Covered by
// tests/compiled.
#include "engine/compiled/compiled_program.hpp"
#include "engine/simulator_hooks.hpp"
#include "ir/s7200/special_memory.hpp"

namespace rungproof {

namespace {

/// With what the CPU makes of choices that nobody has made.
SimulatorOptions optionsFor(const Program& program, SimulatorOptions options) {
  options.choices = choicesFor(program.target, options.choices);
  options.retentive = retentiveRanges(program, options.retentive);
  return options;
}

/// Whether an instruction may write the bits that tell of full queues, which the CPU resets (001:14113).
bool touchesQueueBits(const Plan& plan) {
  constexpr std::uint32_t byte = 4;
  const auto mayTouch = [](const FlowStep& step) {
    const Operands& operands = step.instruction->operands;
    return std::ranges::any_of(operands, [&](const Operand& o) {
      if (o.kind != OperandKind::Direct || o.area != Area::SM) return false;
      const bool isRow = operands.size() > 1;
      return o.offset <= byte && (isRow || o.offset + static_cast<std::uint32_t>(bytes(o.width)) > byte);
    });
  };
  return std::ranges::any_of(plan.flows, [&](const Flow& flow) { return std::ranges::any_of(flow.steps, mayTouch); });
}

/// Analog modules have their addresses from there on, where nothing else is configured.
constexpr std::uint32_t firstAnalogModule = 256;

/// The bytes of PI that instructions name and that the image of the inputs has too.
std::vector<std::uint32_t> modulesAskedBy(const Program& program) {
  std::vector<std::uint32_t> found;
  for (const Pou& pou : program.pous) {
    for (const Network& network : pou.networks) {
      for (const Instruction& instruction : network.instructions) {
        for (const Operand& operand : instruction.operands) {
          if (operand.kind != OperandKind::Direct || operand.area != Area::PI) continue;
          for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(bytes(operand.width)); ++i)
            found.push_back(operand.offset + i);
        }
      }
    }
  }
  std::ranges::sort(found);
  const auto rest = std::ranges::unique(found);
  found.erase(rest.begin(), rest.end());
  const std::uint32_t end = std::min(areaSize(program.target, Area::I), firstAnalogModule);
  std::erase_if(found, [&](std::uint32_t byte) { return byte >= end; });
  return found;
}

/// Scans after which a run is taken for long enough to pay for machine code.
constexpr std::uint64_t scansBefore = 100;
/// After so many doublings the pause behind an attempt that gave up grows no more.
constexpr std::uint32_t mostDoublings = 10;

}  // namespace

Simulator::Simulator(const Program& program, SimulatorOptions options, Outside* outside)
    : plan_(program),
      contracts_(std::make_shared<const CallContracts>(program)),
      options_(optionsFor(program, std::move(options))),
      outside_(outside),
      domain_(*this),
      store_(powerUpState(plan_, options_.choices, options_.dataLost)),
      machine_(domain_, store_, plan_),
      queue_(program.target),
      devices_(options_.clock, program.target),
      unknownIsZero_(outside == nullptr && options_.choices.is(Choice::UnknownBits, "zero")),
      random_(options_.seed) {
  touchesQueueBits_ = touchesQueueBits(plan_);
  if (outside_ == nullptr && !plan_.dialect().memory.hasTerminals) askedModules_ = modulesAskedBy(program);
  readsStart_ = outside_ == nullptr && mayReadStartOfMain(plan_);
  startClock(Reg::PhaseHundred, options_.phaseMs);
  const RunModel& run = plan_.dialect().run;
  hasWatchdog_ = run.hasWatchdog;
  watchdogTime_ = static_cast<std::uint64_t>(run.watchdogMs(program, options_.choices)) * Cost::perMs;
  longestScan_ = static_cast<std::uint64_t>(run.longestScanMs(program.target, options_.choices)) * Cost::perMs;
  prepareCosts();
  savesMemory_ = savesMemory(target());
  longestCalm_ = watchdogTime();
  const bool hasClocks = !plan_.iecTimers.empty() || program.clockMemory ||
                         std::ranges::any_of(plan_.timers, [](const TimerUse& use) { return use.resolution == 1; });
  hasFineTimers_ =
      hasClocks && !(plan_.counting() == Counting::Elements && options_.choices.is(Choice::S5Time, "synchronous"));
}

Simulator::~Simulator() = default;

const RunTimeErrors& Simulator::errors() const {
  for (const std::unique_ptr<compiled::CompiledProgram>& code : compiled_) {
    if (code != nullptr) code->tellErrors(errors_);
  }
  return errors_;
}

bool Simulator::mayRunCompiled() {
  if (isCalm_) return true;
  if (options_.engine == EngineKind::Reference) return false;
  if (observer_ != nullptr || (script_ != nullptr && !isScriptQuiet())) return false;
  if (!unknownIsZero_ || !forced_.empty() || !queue_.empty() || devices_.hasStartInformation() || readsStart_)
    return false;
  if (!isRunning() || store_.get(Reg::FirstScan, 0) != 0 || scanCount_ <= referenceUntil_) return false;
  return options_.engine == EngineKind::Compiled || scanCount_ > scansBefore;
}

compiled::CompiledProgram* Simulator::machineCode(bool countsTime) {
  const std::size_t which = countsTime ? 1 : 0;
  if (!isCompileTried_[which]) {
    isCompileTried_[which] = true;
    compiled::InstructionTimes times;
    for (const Cost& cost : costs_) times.push_back(cost.time);
    compiled_[which] = compiled::CompiledProgram::of(plan_, store_, times, countsTime);
  }
  return compiled_[which].get();
}

/// False: nothing has happened.
bool Simulator::runCompiled(std::uint32_t lengthUs) {
  if (!mayRunCompiled()) return false;
  compiled::CompiledProgram* code = machineCode(false);
  if (code == nullptr) return false;
  const std::uint64_t asked = static_cast<std::uint64_t>(lengthUs) * Cost::perUs;
  if (outside_ != nullptr && (code->asksOutside() || (code->takesFree() && !freeIsZero_))) return false;
  const auto takesAtMost = [&](std::uint64_t time) { return code->mostTime() && *code->mostTime() <= time; };
  std::uint64_t most = nextMs_ - 1;  // nothing before the program ends
  if (script_ == nullptr && !takesAtMost(most) && !hasFineTimers_ && (isCalm_ || isQuietUntil(0))) most = longestCalm_;
  if (!takesAtMost(script_ != nullptr ? most : std::min(asked, most))) code = machineCode(true);  // its end matters
  if (code == nullptr) return false;
  const std::optional<std::uint64_t> time = code->run(store_, machine_.ticks100, most, errors_);
  if (!time) {
    referenceUntil_ = scanCount_ + (1ULL << std::min(givenUp_++, mostDoublings)) - 1;
    return false;
  }
  givenUp_ = 0;
  ++compiledScans_;
  position_ = *time;
  pending_ = 0;
  return true;
}

}  // namespace rungproof
