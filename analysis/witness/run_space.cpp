// Inputs are bits of I, words of AI, fast counters and external memory; everything else that is named is state.
#include "analysis/witness/run_space.hpp"

#include <algorithm>
#include <set>

#include "ir/families/run.hpp"
#include "ir/machine/reading.hpp"
#include "ir/s7300/clock_memory.hpp"

namespace rungproof {

namespace {

/// Gives the choice that a cell of Reg::Reading stands for another reading than the one that is in force.
void turnReading(RunSpace& space, std::uint32_t index) {
  const Choice choice = choiceOfReading(index);
  if (space.choices.isFixed(choice)) return;
  if (!space.otherReadings) space.otherReadings = space.choices;
  const std::uint8_t value = valueOfReading(index);
  space.otherReadings->value[static_cast<std::size_t>(choice)] = space.choices[choice] == value ? 0 : value;
}

/// ms: of SM0.4, SM0.5, or the slowest bit of a clock memory.
std::uint32_t slowestClockOf(const Program& program) {
  std::uint32_t slowest = program.clockMemory ? clockPeriods.back() : 0;
  for (const Pou& pou : program.pous) {
    for (const Network& network : pou.networks) {
      for (const Instruction& instruction : network.instructions) {
        for (const Operand& o : instruction.operands) {
          if (o.kind != OperandKind::Direct || o.area != Area::SM || o.offset != 0) continue;
          const bool isMinute = o.width != Width::Bit || o.bit == 4;
          slowest = std::max(slowest, isMinute ? minuteClock : o.bit == 5 ? secondClock : 0);
        }
      }
    }
  }
  return slowest;
}

}  // namespace

RunSpace runSpaceOf(const EncodedScan& encoding) {
  RunSpace space{encoding.options().choices,
                 std::nullopt,
                 encoding.options().time,
                 slowestClockOf(*encoding.plan().program),
                 {},
                 {}};
  std::vector<Node> nodes;
  for (const ScanInput& input : scanInputsOf(encoding)) {
    const auto at = std::find(nodes.begin(), nodes.end(), input.node);
    const auto index = static_cast<std::size_t>(at - nodes.begin());
    if (at == nodes.end()) {
      nodes.push_back(input.node);
      space.inputs.push_back({encoding.graph()[input.node].width, {}});
    }
    space.inputs[index].operands.push_back(input);
  }
  for (const Cell& cell : encoding.cells()) {
    if (cell.kind == CellKind::State) space.state.push_back(cell.place);
    if (cell.place.isRegister && cell.place.reg == Reg::Reading) turnReading(space, cell.place.at);
  }
  return space;
}

namespace {

class NamedPlaces {
 public:
  NamedPlaces(const Program& program, const PropertySet& set) {
    for (const ExternalRange& range : set.externals) addExternal(range);
    for (const Pou& pou : program.pous) {
      for (const Network& network : pou.networks) {
        for (const Instruction& instruction : network.instructions) {
          for (const Operand& operand : instruction.operands) add(operand);
        }
      }
    }
    for (const Property& property : set.properties) {
      for (const Operand* operand : addressesOf(property)) add(*operand);
    }
  }

  void put(RunSpace& space) const {
    for (const auto& [area, at, width] : inputs_) {
      const Operand operand =
          width == 1 ? direct(area, Width::Bit, at / 8, at % 8) : direct(area, widthOfBits(width), at / 8);
      space.inputs.push_back({width, {{operand, noNode}}});
    }
    space.state.assign(state_.begin(), state_.end());
  }

 private:
  void addExternal(const ExternalRange& range) {
    const bool areBits = range.first.width == Width::Bit;
    const std::uint32_t first = range.first.offset * 8 + (areBits ? range.first.bit : 0);
    const std::uint32_t end = areBits ? range.last.offset * 8 + range.last.bit + 1
                                      : (range.last.offset + static_cast<std::uint32_t>(bytes(range.last.width))) * 8;
    for (std::uint32_t bit = first; bit < end;) {
      const bool isByte = bit % 8 == 0 && bit + 8 <= end;
      inputs_.insert({range.first.area, bit, isByte ? 8 : 1});
      if (isByte) external_.insert({range.first.area, bit / 8});
      bit += isByte ? 8 : 1;
    }
  }
  void add(const Operand& o) {
    if (o.kind != OperandKind::Direct) return;
    switch (o.area) {
      case Area::I:
        for (int i = 0; i < bits(o.width); ++i) {
          const auto bit = static_cast<std::uint32_t>(i);
          inputs_.insert({o.area, o.width == Width::Bit ? o.offset * 8 + o.bit : o.offset * 8 + bit, 1});
        }
        break;
      case Area::PI:
        for (std::uint32_t byte = 0; byte < static_cast<std::uint32_t>(bytes(o.width)); byte += 2)
          inputs_.insert({o.area, (o.offset + byte) * 8, 16});
        break;
      case Area::AI: inputs_.insert({o.area, o.offset * 8, 16}); break;
      case Area::HC: inputs_.insert({o.area, o.offset * 8, 32}); break;
      case Area::T:
        for (const Reg reg : {Reg::TimerBit, Reg::TimerCurrent, Reg::TimerRunning, Reg::S5Rest})
          state_.insert(registerPlace(reg, o.offset));
        break;
      case Area::C:
        for (const Reg reg : {Reg::CounterBit, Reg::CounterCurrent}) state_.insert(registerPlace(reg, o.offset));
        break;
      case Area::AC: state_.insert(registerPlace(Reg::Accumulator, o.offset)); break;
      case Area::SM:
      case Area::L: break;
      default:
        if (!external_.contains({o.area, o.offset})) state_.insert(memoryPlace(o.area, o.offset, o.width, o.bit));
    }
  }

  std::set<std::tuple<Area, std::uint32_t, int>> inputs_;  ///< area, bit address, width
  std::set<std::pair<Area, std::uint32_t>> external_;
  std::set<Place> state_;
};

}  // namespace

RunSpace runSpaceOf(const Program& program, const PropertySet& set, const Choices& choices, const TimeRange& time) {
  RunSpace space{choices, std::nullopt, time, slowestClockOf(program), {}, {}};
  NamedPlaces(program, set).put(space);
  return space;
}

}  // namespace rungproof
