// Inputs are drawn once: each phase changes some of those of the phase before, in every trace others, and lasts from
// one scan to as many as a timer may need.
#include "analysis/selfcheck/side_by_side.hpp"

#include <algorithm>
#include <chrono>
#include <random>
#include <set>

#include "analysis/schedule/schedule.hpp"
#include "analysis/witness/follower.hpp"
#include "analysis/witness/state_pool.hpp"
#include "engine/cell_value.hpp"

namespace rungproof {

namespace {

constexpr std::size_t wordBits = 64;

/// Followed along one run: whether what is assumed still holds.
class Assumed {
 public:
  explicit Assumed(const std::vector<Property>& assumptions) : domain_(outside_) {
    for (const Property& assumption : assumptions) followers_.emplace_back(assumption);
  }
  bool holds(const Concrete::Store& state, const ReplayScan& scan) {
    const bool isFirst = std::exchange(isFirst_, false);
    return std::ranges::all_of(followers_, [&](Follower& f) { return f.evaluate(domain_, state, scan, isFirst); });
  }

 private:
  StillOutside outside_;
  Concrete domain_;
  std::vector<Follower> followers_;
  bool isFirst_ = true;
};

}  // namespace

SideBySide::SideBySide(const Program& program, const PropertySet& set, const ProverOptions& options)
    : program_(program), choices_(choicesFor(program.target, options.choices)), time_(options.time) {
  if (options.bound > 0) return;
  std::ranges::copy_if(set.properties, std::back_inserter(assumptions_), std::not_fn(&Property::isGoal));
  const RunSpace space = runSpaceOf(program, set, choices_, time_);
  for (const RunSpace::Input& input : space.inputs) {
    for (const ScanInput& part : input.operands) {
      const bool isBit = part.operand.area == Area::I && part.operand.width == Width::Bit;
      (isBit ? bits_ : words_).push_back(part.operand);
    }
  }
  PoolConstants constants;
  constants.add(program);
  constants_.assign(constants.values().begin(), constants.values().end());
  std::set<std::uint32_t> bits;
  for (const Place& place : space.state) {
    if (place.isRegister || place.area != Area::Q) continue;
    for (std::uint32_t i = 0; i < place.width; ++i) bits.insert(place.at + i);
  }
  phases_ = drawnPhases(options.seed);
  ManyTraces traces(program, stillOptions(choices_), schedule::sideBySideTraces);
  for (const std::uint32_t at : bits) {
    const Operand output = direct(Area::Q, Width::Bit, at / 8, 7 - at % 8);
    if (traces.hasRow(output)) watched_.push_back(output);
  }
  if (watched_.empty()) return;
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(schedule::sideBySideSeconds);
  for (const Phase& phase : phases_) {
    give(traces, phase);
    for (std::uint32_t i = 0; i < phase.repeats; ++i) {
      traces.scan(phase.lengthMs * 1000);
      if (traces.sideBySide() < traces.count() || std::chrono::steady_clock::now() > end) return;
      std::vector<TraceSet>& scan = outputs_.emplace_back();
      for (const Operand& output : watched_) scan.push_back(traces.whereOn(output));
    }
  }
}

std::vector<SideBySide::Phase> SideBySide::drawnPhases(std::uint64_t seed) const {
  std::mt19937_64 random(seed);
  const std::size_t count = schedule::sideBySideTraces;
  std::vector<Phase> phases;
  std::uint32_t scans = 0;
  while (scans < schedule::sideBySideScans) {
    Phase phase;
    const std::uint64_t kind = random() % 10;
    phase.lengthMs = kind == 0  ? time_.low
                     : kind < 3 ? std::clamp<std::uint32_t>(10, time_.low, time_.high)
                                : time_.high;
    phase.repeats = 1 + static_cast<std::uint32_t>(random() % (1ULL << (random() % schedule::sideBySideStretch)));
    scans += phase.repeats;
    for (std::size_t i = 0; i < bits_.size(); ++i) {
      TraceSet set(count / wordBits);
      for (std::size_t w = 0; w < set.size(); ++w)
        set[w] = phases.empty() ? random() : phases.back().bits[i][w] ^ (random() & random());
      phase.bits.push_back(std::move(set));
    }
    for (std::size_t i = 0; i < words_.size(); ++i) {
      std::vector<std::uint64_t> values(count);
      for (std::size_t t = 0; t < count; ++t) {
        const std::uint64_t value = random() % 4 == 0 ? random() : constants_[random() % constants_.size()];
        const bool stays = !phases.empty() && random() % 4 != 0;
        values[t] = stays ? phases.back().words[i][t] : value & Graph::maskOf(rungproof::bits(words_[i].width));
      }
      phase.words.push_back(std::move(values));
    }
    phases.push_back(std::move(phase));
  }
  return phases;
}

void SideBySide::give(ManyTraces& traces, const Phase& phase) const {
  for (std::size_t i = 0; i < bits_.size(); ++i) traces.setInput(bits_[i].offset, bits_[i].bit, phase.bits[i]);
  for (std::size_t i = 0; i < words_.size(); ++i) {
    for (std::size_t t = 0; t < traces.count(); ++t) traces.write(t, words_[i], phase.words[i][t]);
  }
}

/// The traces in which an output differs first, each with its first difference.
std::vector<SideBySide::Suspect> SideBySide::suspectsOf(ManyTraces& traces) const {
  std::vector<Suspect> suspects;
  TraceSet known(traces.count() / wordBits);
  std::size_t scan = 0;
  for (const Phase& phase : phases_) {
    if (scan < outputs_.size()) give(traces, phase);
    for (std::uint32_t i = 0; i < phase.repeats && scan < outputs_.size(); ++i, ++scan) {
      traces.scan(phase.lengthMs * 1000);
      if (traces.sideBySide() < traces.count()) return suspects;
      for (std::size_t o = 0; o < watched_.size(); ++o) {
        const TraceSet on = traces.whereOn(watched_[o]);
        for (std::size_t w = 0; w < on.size(); ++w) {
          const std::uint64_t differing = (on[w] ^ outputs_[scan][o][w]) & ~known[w];
          known[w] |= differing;
          for (std::uint64_t rest = differing; rest != 0; rest &= rest - 1) {
            suspects.push_back({w * wordBits + static_cast<std::size_t>(std::countr_zero(rest)), scan, o});
            if (suspects.size() == schedule::sideBySideSuspects) return suspects;
          }
        }
      }
    }
  }
  return suspects;
}

/// The first `count` scans of a trace for the reference engine.
std::vector<ReplayScan> SideBySide::scansOf(std::size_t trace, std::size_t count) const {
  std::vector<ReplayScan> scans;
  for (const Phase& phase : phases_) {
    if (count == 0) break;
    ReplayScan& scan = scans.emplace_back();
    scan.lengthMs = phase.lengthMs;
    scan.repeats = std::min(phase.repeats, static_cast<std::uint32_t>(count));
    count -= scan.repeats;
    for (std::size_t i = 0; i < bits_.size(); ++i)
      scan.inputs.push_back({bits_[i], lanes::contains(phase.bits[i], trace) ? 1U : 0U});
    for (std::size_t i = 0; i < words_.size(); ++i) scan.inputs.push_back({words_[i], phase.words[i][trace]});
  }
  return scans;
}

/// Whether the reference engine shows that difference, with all that is assumed kept in both runs.
bool SideBySide::isConfirmed(const Program& copy, const Suspect& suspect) const {
  const std::vector<ReplayScan> scans = scansOf(suspect.trace, suspect.scan + 1);
  const auto valueIn = [&](const Program& program) -> std::optional<std::uint64_t> {
    Assumed assumed(assumptions_);
    std::size_t made = 0;
    std::uint64_t value = 0;
    replay(program, choices_, scans, nullptr, [&](const Concrete::Store& state, std::size_t at) {
      if (!hasScanEnd(state) || !assumed.holds(state, scans[at])) return false;
      ++made;
      value = cellValue(state, watched_[suspect.output]);
      return true;
    });
    return made == suspect.scan + 1 ? std::optional(value) : std::nullopt;
  };
  const std::optional<std::uint64_t> before = valueIn(program_), after = valueIn(copy);
  return before && after && *before != *after;
}

/// Sought on the fastest engine, then shown by the reference engine.
std::string SideBySide::noticedIn(const Program& copy, std::size_t trace,
                                  const std::vector<const Property*>& asked) const {
  const std::vector<ReplayScan> scans = scansOf(trace, outputs_.size());
  StillOutside outside;
  Simulator simulator(copy, stillOptions(choices_), &outside);
  simulator.readUnknownAsZero(true);  // as `outside` says
  simulator.expectFreeZero();
  Concrete domain(outside);
  Assumed assumed(assumptions_);
  std::vector<Follower> goals;
  for (const Property* goal : asked) goals.emplace_back(*goal);
  bool isFirst = true;
  for (const ReplayScan& scan : scans) {
    for (const PresetValue& input : scan.inputs) simulator.write(input.operand, input.value);
    for (std::uint32_t i = 0; i < scan.repeats; ++i) {
      simulator.scan({.lengthUs = scan.lengthMs * 1000, .script = &scan.script});
      const Concrete::Store& state = simulator.store();
      if (!hasScanEnd(state) || !assumed.holds(state, scan)) return {};
      for (std::size_t g = 0; g < goals.size(); ++g) {
        if (goals[g].evaluate(domain, state, scan, isFirst) &&
            Judge(copy, choices_, assumptions_, *asked[g]).witness(scans, std::nullopt))
          return asked[g]->name;
      }
      if (!simulator.isRunning()) return {};
      isFirst = false;
    }
  }
  return {};
}

SideBySide::Seen SideBySide::look(const Program& copy, const std::vector<const Property*>& asked) const {
  if (outputs_.empty()) return {};
  ManyTraces traces(copy, stillOptions(choices_), schedule::sideBySideTraces);
  if (!std::ranges::all_of(watched_, [&](const Operand& output) { return traces.hasRow(output); })) return {};
  Seen seen;
  for (const Suspect& suspect : suspectsOf(traces)) {
    if (seen.where.empty() && isConfirmed(copy, suspect)) {
      const Operand& output = watched_[suspect.output];
      seen.where = nameOf(memoryPlace(output.area, output.offset, output.width, output.bit)) + " in scan " +
                   std::to_string(suspect.scan + 1);
    }
    seen.noticedBy = noticedIn(copy, suspect.trace, asked);
    if (!seen.noticedBy.empty()) break;
  }
  return seen;
}

}  // namespace rungproof
