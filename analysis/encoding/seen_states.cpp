// The runs are the same each time: what is found of a program must not depend on chance.
#include "analysis/encoding/seen_states.hpp"

#include <random>
#include <set>

#include "engine/replay.hpp"
#include "engine/start_up.hpp"

namespace rungproof {

namespace {

constexpr std::size_t seenScans = 40;
/// In a scan, by run: few events leave time to what the main program does.
constexpr std::uint32_t mostEvents[] = {12, 1, 4, 2, 12, 1, 4, 2, 1, 2};
constexpr std::size_t mostInstructionsRun = 4000;  ///< of a program: longer ones are seen at power-up only

}  // namespace

std::uint64_t valueAt(const Place& place, const Concrete::Store& state) {
  if (place.isRegister) return state.get(place.reg, place.at);
  std::uint64_t value = 0;
  for (std::uint32_t i = 0; i < place.width; ++i)
    value = value << 1 | state.load(place.area, (place.at + i) / 8 * 8 + 7 - (place.at + i) % 8, 1);
  return value;
}

std::vector<std::map<Place, std::uint64_t>> seenStates(const Plan& plan, const std::vector<int>& events,
                                                       const std::vector<Place>& places) {
  std::set<std::vector<std::uint64_t>> seen;
  std::vector<std::map<Place, std::uint64_t>> states;
  const auto note = [&](const Concrete::Store& store) {
    std::vector<std::uint64_t> values;
    for (const Place& place : places) values.push_back(valueAt(place, store));
    if (!seen.insert(values).second) return;
    std::map<Place, std::uint64_t>& state = states.emplace_back();
    for (std::size_t i = 0; i < places.size(); ++i) state.emplace(places[i], values[i]);
  };
  const Program& program = *plan.program;
  const Choices choices = choicesFor(program.target, {});
  std::vector<std::uint32_t> instructions;
  for (const Flow& flow : plan.flows) {
    for (const FlowStep& step : flow.steps) instructions.push_back(step.instruction->id);
  }
  // What the first scan sets up is there when events come.
  if (instructions.size() > mostInstructionsRun || events.empty()) note(powerUpState(plan, choices));
  if (!states.empty()) return states;
  std::mt19937_64 random(1);
  for (const std::uint32_t most : mostEvents) {
    ReplayRun engine(program, choices);
    for (std::size_t scan = 0; scan < seenScans && engine.isRunning(); ++scan) {
      ReplayScan given;
      given.lengthMs = 1 + static_cast<std::uint32_t>(random() % 100);
      for (std::uint32_t byte = 0; byte < 4; ++byte)
        given.inputs.push_back({direct(Area::I, Width::Byte, byte), random() & random() & 0xFF});
      given.script.needsCauses = true;
      const std::uint64_t count = random() % (most + 1);
      for (std::uint64_t i = 0; i < count; ++i) {
        ScanPlace place;
        if (random() % 2 == 0) place.instruction = instructions[random() % instructions.size()];
        given.script.events.push_back({place, events[random() % events.size()]});
      }
      engine.load(given);
      note(engine.scan());
    }
  }
  return states;
}

}  // namespace rungproof
