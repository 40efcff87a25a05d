// The same evaluation of the encoding serves for all three: start, set the inputs of a scan, compute, go on.
#include "analysis/witness/question_witness.hpp"

#include <algorithm>
#include <chrono>
#include <map>
#include <random>

#include "analysis/schedule/schedule.hpp"
#include "analysis/witness/scan_run.hpp"

namespace rungproof {

namespace {

using Clock = std::chrono::steady_clock;

std::string nameIn(const TransitionSystem& system, Node variable) {
  return system.graph->variables()[(*system.graph)[variable].value].name;
}

/// Variables of the system in which a run was found that mean what variables of the exact one do: within one graph
/// the same ones, since several may have one name (the visits of an instruction); else those of the same name.
class FoundVariables {
 public:
  FoundVariables(const TransitionSystem& found, const TransitionSystem& exact) : found_(found), exact_(exact) {}
  void add(Node variable) {
    bySelf_.emplace(variable, count_);
    byName_[nameIn(found_, variable)] = count_++;
  }
  std::optional<std::size_t> indexOfSame(Node variable) const {
    if (const auto self = bySelf_.find(variable); found_.graph == exact_.graph && self != bySelf_.end())
      return self->second;
    const auto named = byName_.find(nameIn(exact_, variable));
    return named == byName_.end() ? std::nullopt : std::optional(named->second);
  }

 private:
  const TransitionSystem& found_;
  const TransitionSystem& exact_;
  std::map<Node, std::size_t> bySelf_;
  std::map<std::string, std::size_t> byName_;
  std::size_t count_ = 0;
};

/// Where the found run starts between two ticks of 100 ms, in ms (time_model.hpp).
std::uint32_t phaseOf(const TransitionSystem& found, const WordTrace& trace) {
  std::uint64_t phase = 0;
  for (std::size_t i = 0; i < found.states.size(); ++i) {
    const std::string name = nameIn(found, found.states[i].node);
    if (name == "time.tens.start") phase += trace.initial[i] % 10 * 10;
    if (name == "time.ones.start") phase += trace.initial[i] % 10;
  }
  return static_cast<std::uint32_t>(phase);
}

/// What a variable tells of the time.
enum class TimeDigit : std::uint8_t { None, Ms, Hundreds, Tens, Ones };

TimeDigit digitNamed(std::string_view name) {
  if (name == "time.ms") return TimeDigit::Ms;
  if (name == "time.hundreds") return TimeDigit::Hundreds;
  if (name == "time.tens") return TimeDigit::Tens;
  if (name == "time.ones") return TimeDigit::Ones;
  return TimeDigit::None;
}

/// The digit that the exact model chooses in a scan that lasts `length` ms and begins at the time `now`.
std::uint64_t digitOf(TimeDigit digit, std::uint64_t now, std::uint64_t length) {
  const std::uint64_t then = now + length;
  switch (digit) {
    case TimeDigit::Ms: return length;
    case TimeDigit::Hundreds: return then / 100 - now / 100;
    case TimeDigit::Tens: return then / 10 % 10;
    case TimeDigit::Ones: return then % 10;
    case TimeDigit::None: break;
  }
  return 0;
}

/// ms of each scan of a found run, from its time digits.
std::vector<std::uint32_t> lengthsOf(const TransitionSystem& found, const WordTrace& trace) {
  std::vector<TimeDigit> digits;
  for (const Node input : found.inputs) digits.push_back(digitNamed(nameIn(found, input)));
  std::vector<std::uint32_t> lengths;
  const std::uint32_t phase = phaseOf(found, trace);
  std::uint64_t tens = phase / 10, ones = phase % 10;
  for (const std::vector<std::uint64_t>& inputs : trace.inputs) {
    std::uint64_t hundreds = 0, nextTens = tens, nextOnes = ones;
    for (std::size_t i = 0; i < found.inputs.size(); ++i) {
      switch (digits[i]) {
        case TimeDigit::Ms: ones = 0, nextOnes = inputs[i]; break;
        case TimeDigit::Hundreds: hundreds = inputs[i]; break;
        case TimeDigit::Tens: nextTens = inputs[i]; break;
        case TimeDigit::Ones: nextOnes = inputs[i]; break;
        case TimeDigit::None: break;
      }
    }
    lengths.push_back(static_cast<std::uint32_t>(100 * hundreds + 10 * nextTens + nextOnes - 10 * tens - ones));
    tens = nextTens;
    ones = nextOnes;
  }
  return lengths;
}

void begin(ScanRun& run, const TransitionSystem& system, const ExactRun& given) {
  run.start();
  for (std::size_t i = 0; i < system.states.size(); ++i) {
    if (system.states[i].init == noNode) run.set(system.states[i].node, given.initial[i]);
  }
}
void setInputs(ScanRun& run, const TransitionSystem& system, const std::vector<std::uint64_t>& values) {
  for (std::size_t i = 0; i < system.inputs.size(); ++i) run.set(system.inputs[i], values[i]);
}

/// Whether the last scan of the run shows the question, all scans being ones.
bool isShown(ScanRun& run, const TransitionSystem& system, Node bad, const ExactRun& given) {
  begin(run, system, given);
  for (std::size_t scan = 0; scan < given.inputs.size(); ++scan) {
    setInputs(run, system, given.inputs[scan]);
    if (!run.evaluate()) return false;
    if (scan + 1 < given.inputs.size()) run.advance();
  }
  return run[bad] != 0;
}

}  // namespace

std::optional<ExactRun> QuestionWitness::runOf(const TransitionSystem& found, const WordTrace& trace,
                                               const TimeRange& range) const {
  FoundVariables inputs(found, system_), states(found, system_);
  for (const Node input : found.inputs) inputs.add(input);
  for (const StateVariable& state : found.states) states.add(state.node);
  ExactRun result;
  for (const StateVariable& state : system_.states) {
    const std::optional<std::size_t> given = states.indexOfSame(state.node);
    result.initial.push_back(given ? trace.initial[*given] : 0);
  }
  const std::vector<Node> watched{bad_};
  ScanRun run(encoding_, system_, watched);
  begin(run, system_, result);
  struct Source {
    TimeDigit digit;
    std::optional<std::size_t> given;  ///< of the found run
  };
  std::vector<Source> sources;
  for (const Node input : system_.inputs)
    sources.push_back({digitNamed(nameIn(system_, input)), inputs.indexOfSame(input)});
  const std::vector<std::uint32_t> lengths = lengthsOf(found, trace);
  std::uint64_t milliseconds = phaseOf(found, trace);
  for (std::size_t i = 0; i < trace.inputs.size(); ++i) {
    for (const Stretch& part : stretchOf(lengths[i], range)) {
      for (std::uint32_t k = 0; k < part.count; ++k) {
        std::vector<std::uint64_t>& values = result.inputs.emplace_back();
        values.reserve(sources.size());
        for (const Source& source : sources) {
          if (source.digit != TimeDigit::None)
            values.push_back(digitOf(source.digit, milliseconds, part.length));
          else
            values.push_back(source.given ? trace.inputs[i][*source.given] : 0);
        }
        result.lengths.push_back(part.length);
        setInputs(run, system_, values);
        if (!run.evaluate()) return std::nullopt;
        if (run[bad_] != 0) return result;
        run.advance();
        milliseconds += part.length;
      }
    }
  }
  return std::nullopt;
}

std::vector<QuestionWitness::Compared> QuestionWitness::comparedIn(
    const std::unordered_set<std::uint32_t>& cone) const {
  std::map<Node, std::size_t> stateOf;
  for (std::size_t i = 0; i < system_.states.size(); ++i) stateOf[system_.states[i].node] = i;
  std::vector<Compared> compared;
  for (const Cell& cell : encoding_.cells()) {
    const auto state = stateOf.find(cell.start);
    // The time model counts ticks by digits of its own; the phases that the engine counts them by mean nothing there.
    const bool isPhase =
        cell.place.isRegister && (cell.place.reg == Reg::PhaseTen || cell.place.reg == Reg::PhaseHundred);
    if (cell.kind == CellKind::State && state != stateOf.end() && !isPhase && cone.contains(indexOf(cell.start)))
      compared.push_back({cell.place, system_.states[state->second].next});
  }
  return compared;
}

std::optional<Witness> QuestionWitness::witness(const Program& program, const Choices& choices, const ExactRun& given,
                                                Kept kept, std::span<Other> others) const {
  std::vector<Node> watched{bad_};
  for (const Other& other : others) watched.push_back(other.bad);
  ScanRun run(encoding_, system_, watched);
  begin(run, system_, given);
  run.evaluate();
  Witness witness;
  const bool isFreeStart = std::any_of(system_.states.begin(), system_.states.end(),
                                       [](const StateVariable& s) { return s.init == noNode; });
  if (isFreeStart) witness.initial = run.initialState();
  const std::vector<Compared> compared = comparedIn(cone_);
  struct Beside {
    Other* other;
    std::vector<Compared> compared;
  };
  std::vector<Beside> beside;  // others that the run has not shown and may show
  for (Other& other : others) beside.push_back({&other, comparedIn(other.cone)});
  // Alike scans of a long run are one that is repeated: nobody looks at them one by one.
  const bool isLong = given.inputs.size() > schedule::minimisedScans;
  ReplayRun engine(program, choices, witness.initial ? &*witness.initial : nullptr);
  for (std::size_t scan = 0; scan < given.inputs.size(); ++scan) {
    setInputs(run, system_, given.inputs[scan]);
    if (!run.evaluate()) return std::nullopt;
    const bool isNew = run.isScriptNew() || given.lengths[scan] != given.lengths[scan - 1];
    if (isNew || !isLong) {
      if (kept == Kept::Length) witness.scans.clear();
      witness.scans.push_back(run.script());
      witness.scans.back().lengthMs = given.lengths[scan];
      engine.load(witness.scans.back());
    } else {
      ++witness.scans.back().repeats;
    }
    witness.milliseconds += given.lengths[scan];
    ++witness.scanCount;
    if (engine.isRunning()) {
      const Concrete::Store& state = engine.scan();
      const auto agrees = [&](const Compared& c) { return valueAt(c.place, state) == run[c.next]; };
      if (!std::ranges::all_of(compared, agrees)) return std::nullopt;
      std::erase_if(beside, [&](const Beside& b) {
        if (!std::ranges::all_of(b.compared, agrees)) return true;
        if (run[b.other->bad] == 0) return false;
        Witness& shown = b.other->witness.emplace();
        shown.initial = witness.initial;
        shown.scanCount = witness.scanCount;
        shown.milliseconds = witness.milliseconds;
        return true;
      });
    }
    if (scan + 1 < given.inputs.size()) run.advance();
  }
  if (run[bad_] == 0) return std::nullopt;
  if (kept == Kept::Length) witness.scans.clear();
  return witness;
}

bool QuestionWitness::dropIdle(ExactRun& given, std::vector<std::vector<bool>>& matters, double seconds,
                               std::uint64_t seed) const {
  struct Input {
    std::size_t scan, index;
    std::uint64_t highest;
  };
  const auto end = Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
  const auto isLate = [&] { return Clock::now() >= end; };
  std::map<Node, std::size_t> indexOfInput;
  for (std::size_t i = 0; i < system_.inputs.size(); ++i) indexOfInput[system_.inputs[i]] = i;
  const std::vector<Node> watched{bad_};
  ScanRun run(encoding_, system_, watched);
  ExactRun best = given;
  std::vector<Input> idle;
  const std::vector<ScanInput> presets = scanInputsOf(encoding_);
  std::vector<Node> variables;
  for (const ScanInput& preset : presets) {
    if (std::find(variables.begin(), variables.end(), preset.node) == variables.end()) variables.push_back(preset.node);
  }
  for (std::size_t scan = best.inputs.size(); scan-- > 0;) {
    for (const Node input : variables) {
      const auto at = indexOfInput.find(input);
      if (at == indexOfInput.end()) continue;
      if (isLate()) return false;
      std::uint64_t& value = best.inputs[scan][at->second];
      const std::uint64_t old = value, highest = Graph::maskOf((*system_.graph)[input].width);
      value = old == 0 ? highest : 0;
      const bool isIdle = isShown(run, system_, bad_, best);
      value = isIdle ? 0 : old;
      if (isIdle) idle.push_back({scan, at->second, highest});
    }
  }
  std::mt19937_64 random(seed);
  for (int trial = 0; trial < schedule::replayTrials && !idle.empty();) {
    ExactRun tried = best;
    for (const Input& input : idle)
      tried.inputs[input.scan][input.index] = trial == 0 ? input.highest : random() & input.highest;
    if (isLate()) return false;
    if (isShown(run, system_, bad_, tried)) {
      ++trial;
      continue;
    }
    // Back to 0 one after the other: the one that turns it matters.
    bool isFound = false;
    for (std::size_t k = 0; k < idle.size() && !isFound; ++k) {
      if (isLate()) return false;
      tried.inputs[idle[k].scan][idle[k].index] = 0;
      if (!isShown(run, system_, bad_, tried)) continue;
      idle.erase(idle.begin() + static_cast<std::ptrdiff_t>(k));
      isFound = true;
    }
    if (!isFound) return false;
  }
  matters.clear();
  for (std::size_t scan = 0; scan < best.inputs.size(); ++scan) {
    std::vector<bool>& row = matters.emplace_back();
    for (const ScanInput& preset : presets) {
      const auto at = indexOfInput.find(preset.node);
      row.push_back(at == indexOfInput.end() || std::none_of(idle.begin(), idle.end(), [&](const Input& input) {
                      return input.scan == scan && input.index == at->second;
                    }));
    }
  }
  given = std::move(best);
  return true;
}

}  // namespace rungproof
