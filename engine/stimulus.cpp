// Plays rows in front of the scans they belong to.
#include "engine/stimulus.hpp"

#include "engine/start_up.hpp"
#include "ir/s7200/special_memory.hpp"

namespace rungproof {

SimulatorOptions wholeOptions(const Choices& choices) {
  SimulatorOptions options;
  options.choices = choices;
  options.engine = EngineKind::Reference;
  return options;
}

void beginWhole(Simulator& simulator, const Stimulus& stimulus, const Choices& choices) {
  if (stimulus.start.empty()) return;
  Concrete::Store store = powerUpState(simulator.plan(), choices);
  for (const StartValue& start : stimulus.start) {
    if (start.reg) {
      if (start.index < registerSize(store, *start.reg)) store.set(*start.reg, start.index, start.value, true);
    } else if (start.index < store.area(start.area).size()) {
      store.area(start.area)[start.index] = static_cast<std::uint8_t>(start.value);
    }
  }
  simulator.setStore(store);
}

std::uint32_t registerSize(const Concrete::Store& store, Reg reg) {
  return Concrete::Store::isTerminal(reg) ? static_cast<std::uint32_t>(store.terminals(reg).size() * 8)
                                          : store.count(reg);
}

ScanRequest StimulusPlayer::next() {
  ScanRequest request;
  const std::uint64_t scan = simulator_.scanCount() + 1;
  const std::uint64_t start = simulator_.timeUs();
  script_ = {};
  script_.needsCauses = stimulus_.isWhole;
  if (given_ != nullptr) given_->load({});
  const auto isDue = [&](const StimulusRow& row) {
    return stimulus_.isByTime ? row.timeUs <= start : row.scan <= scan;
  };
  while (!isDone() && isDue(stimulus_.rows[row_])) apply(stimulus_.rows[row_++], request);
  request.lengthUs = scanUs_;
  if (given_ != nullptr) {
    given_->begin();
    simulator_.readUnknownAsZero(!given_->givesUnknownBits());
  }
  if (!stimulus_.isScripted) return request;
  if (const Flow* main = simulator_.plan().main(); main != nullptr && !main->steps.empty()) {
    std::vector<ScanScript::Event> first;
    for (const int event : request.events) first.push_back({{main->steps.front().instruction->id, 0}, event});
    script_.events.insert(script_.events.begin(), first.begin(), first.end());
  }
  request.events.clear();
  request.script = &script_;
  return request;
}

void StimulusPlayer::apply(const StimulusRow& row, ScanRequest& request) {
  if (row.scanUs) scanUs_ = *row.scanUs;
  request.events.insert(request.events.end(), row.events.begin(), row.events.end());
  script_.events.insert(script_.events.end(), row.placed.begin(), row.placed.end());
  script_.writes.insert(script_.writes.end(), row.writes.begin(), row.writes.end());
  for (std::size_t i = 0; i < stimulus_.columns.size(); ++i) {
    const StimulusColumn& column = stimulus_.columns[i];
    if (!row.values[i]) continue;
    const std::uint64_t value = valueOf(*row.values[i], column.signal.type, column.signal.width());
    actOn(simulator_, column, value);
  }
  for (const PresetValue& preset : row.presets) simulator_.write(preset.operand, preset.value);
  script_.ticks1.insert(script_.ticks1.end(), row.ticks.begin(), row.ticks.end());
  if (row.ticks10) script_.ticks10 = row.ticks10;
  if (row.ticks100) script_.ticks100 = row.ticks100;
  if (given_ != nullptr) given_->load(row.externals);
  for (const auto& [port, character] : row.characters) simulator_.devices().ports.send(port, character);
}

void actOn(Simulator& simulator, const StimulusColumn& column, std::uint64_t value) {
  Devices& devices = simulator.devices();
  const auto number = static_cast<std::uint32_t>(value);
  switch (column.target) {
    case StimulusTarget::Memory: {
      const Operand& operand = column.signal.operand;
      const bool isStatus =
          operand.area == Area::SM && smRow(simulator.target(), operand.offset, operand.bit).source == SmSource::Device;
      if (isStatus)
        simulator.writeByDevice(operand, value);
      else
        simulator.write(operand, value);
      break;
    }
    case StimulusTarget::LibraryOutput: devices.setLibraryOutput(column.block, column.position, value); break;
    case StimulusTarget::Pulses:
      devices.counters.setPulses(column.position, number, devices.counters.pulses(column.position)[1]);
      break;
    case StimulusTarget::DownPulses:
      devices.counters.setPulses(column.position, devices.counters.pulses(column.position)[0], number);
      break;
    case StimulusTarget::TickPhase: simulator.startClock(Reg::PhaseHundred, number); break;
    case StimulusTarget::SecondPhase: simulator.startClock(Reg::PhaseSecond, number); break;
    case StimulusTarget::MinutePhase: simulator.startClock(Reg::PhaseMinute, number); break;
    case StimulusTarget::ClockBitPhase: simulator.startClock(Reg::ClockPhase, number, column.position); break;
    case StimulusTarget::StartField: {
      const s7300::StartField& field = column.field;
      if (field.width == Width::Bit) {
        const auto bit = static_cast<std::uint8_t>(1U << field.bit);
        devices.setStartInformation(field.block, field.byte, value != 0 ? bit : 0, bit);
        break;
      }
      const int count = bytes(field.width);
      for (int i = 0; i < count; ++i)
        devices.setStartInformation(field.block, field.byte + static_cast<std::uint32_t>(i),
                                    static_cast<std::uint8_t>(value >> (8 * (count - 1 - i))));
      break;
    }
    case StimulusTarget::NetworkError: devices.network.setError(static_cast<std::uint8_t>(value & 15)); break;
    case StimulusTarget::NetworkHold: devices.network.setHeld(value != 0); break;
    case StimulusTarget::Characters:
    case StimulusTarget::None: break;
  }
}

}  // namespace rungproof
