// Plays rows in front of the scans they belong to.
#include "engine/stimulus.hpp"

#include "ir/s7200/special_memory.hpp"

namespace rungproof {

ScanRequest StimulusPlayer::next() {
  ScanRequest request;
  const std::uint64_t scan = simulator_.scanCount() + 1;
  const std::uint64_t start = simulator_.timeUs();
  script_.events.clear();
  script_.writes.clear();
  const auto isDue = [&](const StimulusRow& row) {
    return stimulus_.isByTime ? row.timeUs <= start : row.scan <= scan;
  };
  while (!isDone() && isDue(stimulus_.rows[row_])) apply(stimulus_.rows[row_++], request);
  request.lengthUs = scanUs_;
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
    act(column, value);
  }
  for (const auto& [port, character] : row.characters) simulator_.devices().ports.send(port, character);
}

void StimulusPlayer::act(const StimulusColumn& column, std::uint64_t value) {
  Devices& devices = simulator_.devices();
  const auto number = static_cast<std::uint32_t>(value);
  switch (column.target) {
    case StimulusTarget::Memory: {
      const Operand& operand = column.signal.operand;
      const bool isStatus = operand.area == Area::SM &&
                            smRow(simulator_.target(), operand.offset, operand.bit).source == SmSource::Device;
      if (isStatus)
        simulator_.writeByDevice(operand, value);
      else
        simulator_.write(operand, value);
      break;
    }
    case StimulusTarget::LibraryOutput: devices.setLibraryOutput(column.block, column.position, value); break;
    case StimulusTarget::Pulses:
      devices.counters.setPulses(column.position, number, devices.counters.pulses(column.position)[1]);
      break;
    case StimulusTarget::DownPulses:
      devices.counters.setPulses(column.position, devices.counters.pulses(column.position)[0], number);
      break;
    case StimulusTarget::TickPhase: simulator_.startClock(Reg::PhaseHundred, number); break;
    case StimulusTarget::SecondPhase: simulator_.startClock(Reg::PhaseSecond, number); break;
    case StimulusTarget::MinutePhase: simulator_.startClock(Reg::PhaseMinute, number); break;
    case StimulusTarget::ClockBitPhase: simulator_.startClock(Reg::ClockPhase, number, column.position); break;
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
