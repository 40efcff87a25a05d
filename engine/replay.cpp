// The engine asks the given values for what is not in its memory; scans that are alike ask the same ones.
#include "engine/replay.hpp"

#include "engine/simulator.hpp"

namespace rungproof {

struct ReplayRun::Parts {
  GivenValues script;
  Simulator simulator;
  ScanScript scanScript{};
  std::uint32_t lengthUs = 0;
  bool isWatched;

  Parts(const Program& program, const Choices& choices, bool hasWatcher)
      : script(choices), simulator(program, optionsOf(choices), &script), isWatched(hasWatcher) {
    script.setState(simulator.store());
  }
  static SimulatorOptions optionsOf(const Choices& choices) {
    SimulatorOptions options;
    options.choices = choices;
    options.engine = EngineKind::Reference;  // what it repeats shall count
    return options;
  }
};

ReplayRun::ReplayRun(const Program& program, const Choices& choices, const Concrete::Store* initial,
                     InstructionObserver* watcher)
    : parts_(std::make_unique<Parts>(program, choices, watcher != nullptr)) {
  if (initial != nullptr) parts_->simulator.setStore(*initial);
  if (watcher != nullptr) parts_->simulator.observe(watcher);
}

ReplayRun::~ReplayRun() = default;

void ReplayRun::load(const ReplayScan& scan) {
  Parts& parts = *parts_;
  parts.scanScript = scan.script;
  parts.scanScript.needsCauses = true;
  parts.lengthUs = scan.lengthMs * 1000;
  for (const PresetValue& input : scan.inputs) parts.simulator.write(input.operand, input.value);
  parts.script.load(scan.externals);
  parts.simulator.readUnknownAsZero(!parts.isWatched && !parts.script.givesUnknownBits());
}

const Concrete::Store& ReplayRun::scan() {
  parts_->script.begin();
  parts_->simulator.scan({.lengthUs = parts_->lengthUs, .script = &parts_->scanScript});
  return parts_->simulator.store();
}

bool ReplayRun::isRunning() const { return parts_->simulator.isRunning(); }
const std::vector<RunTimeError>& ReplayRun::errors() const { return parts_->simulator.errors().list(); }
std::size_t ReplayRun::unusedExternals() const { return parts_->script.unused(); }

ReplayResult replay(const Program& program, const Choices& choices, const std::vector<ReplayScan>& scans,
                    const Concrete::Store* initial, const ReplayObserver& observer, InstructionObserver* watcher) {
  ReplayRun run(program, choices, initial, watcher);
  ReplayResult result;
  bool goesOn = true;
  for (std::size_t i = 0; i < scans.size() && goesOn; ++i) {
    run.load(scans[i]);
    for (std::uint32_t round = 0; round < scans[i].repeats && goesOn; ++round) {
      const Concrete::Store& state = run.scan();
      if (observer)
        goesOn = observer(state, i);
      else
        result.states.push_back(state);
      goesOn = goesOn && run.isRunning();
    }
  }
  result.errors = run.errors();
  result.unusedExternals = run.unusedExternals();
  return result;
}

}  // namespace rungproof
