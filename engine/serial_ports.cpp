// Characters in and out.
#include "engine/serial_ports.hpp"

namespace rungproof {

namespace {

struct PortBytes {
  std::uint32_t control, status;
  int received, transmitted, message;  ///< events
  std::uint32_t idleBit;               ///< of SM4
};
constexpr std::array<PortBytes, 2> ports = {{{30, 86, 8, 9, 23, 5}, {130, 186, 25, 26, 24, 6}}};
constexpr std::array<std::uint64_t, 8> baud = {38400, 19200, 9600, 4800, 2400, 1200, 115200, 57600};  // 001:14177
constexpr std::uint64_t breakBits = 16;                                                               // 001:3194

// Offsets from the status byte (001:14286-14294).
constexpr std::uint32_t controlAt = 1, startAt = 2, endAt = 3, idleTimeAt = 4, timeOutAt = 6, maximumAt = 8;
// Bits of the control byte and of the status byte (001:3217-3223).
constexpr unsigned useStart = 0x40, useEnd = 0x20, useIdle = 0x10, messageTimer = 0x08, useTimer = 0x04,
                   useBreak = 0x02;
constexpr std::uint8_t endedByCharacter = 0x20, endedByTimer = 0x04, endedByCount = 0x02;

std::uint64_t byteOf(const Concrete::Store& store, std::uint32_t at) { return store.load(Area::SM, at * 8, 8); }
std::uint64_t wordOf(const Concrete::Store& store, std::uint32_t at) { return store.load(Area::SM, at * 8, 16); }

/// One byte of a table that PortTable points to.
struct TableByte {
  Area area;
  std::uint32_t bit;
};
TableByte tableByte(const Concrete::Store& store, std::uint32_t entry, std::uint32_t index) {
  const auto pointer = static_cast<std::uint32_t>(store.get(Reg::PortTable, entry));
  return {pointer::areaOf(pointer).value_or(Area::V), (pointer::offsetOf(pointer) + index) * 8};
}

}  // namespace

void SerialPorts::reset() {
  for (Line& line : lines_) line = Line{std::move(line.incoming), std::move(line.sent)};
}

/// Start, data, parity and stop bits of a character at the rate of the port (001:14177-14179).
std::uint64_t SerialPorts::characterUs(const Concrete::Store& store, std::uint32_t port) {
  const std::uint64_t control = byteOf(store, ports[port].control);
  const std::uint64_t bits = 2 + ((control & 0x20) != 0 ? 7 : 8) + ((control & 0x40) != 0 ? 1 : 0);
  return bits * 1000000 / baud[control >> 2 & 7];
}

void SerialPorts::transmitStarted(const Concrete::Store& store, std::uint32_t port) {
  Line& line = lines_[port];
  const TableByte head = tableByte(store, port * 2, 0);
  const auto length = static_cast<std::uint32_t>(store.load(head.area, head.bit, 8));
  for (std::uint32_t i = 1; i <= length; ++i) {
    const TableByte at = tableByte(store, port * 2, i);
    line.sent.push_back(static_cast<std::uint8_t>(store.load(at.area, at.bit, 8)));
  }
  const std::uint64_t control = byteOf(store, ports[port].control);
  line.transmitLeftUs = length == 0 ? breakBits * 1000000 / baud[control >> 2 & 7] : length * characterUs(store, port);
}

void SerialPorts::receiveStarted(const Concrete::Store& store, std::uint32_t port) {
  Line& line = lines_[port];
  const unsigned control = static_cast<unsigned>(byteOf(store, ports[port].status + controlAt));
  line.isMessageOpen = false;
  line.sawBreak = false;
  line.sawIdle = (control & useIdle) != 0 && wordOf(store, ports[port].status + idleTimeAt) == 0;
  line.stored = 0;
  line.quietMs = 0;
  line.messageMs = 0;
}

void SerialPorts::receiveEnded(std::uint32_t port, const RaiseEvent& raise) {
  lines_[port].isMessageOpen = false;
  raise(ports[port].message);
}

void SerialPorts::passMillisecond(Concrete::Store& store, const RaiseEvent& raise) {
  for (std::uint32_t port = 0; port < ports.size(); ++port) {
    Line& line = lines_[port];
    if (store.get(Reg::PortBusy, port) == 0 && line.incoming.empty()) continue;
    if ((store.get(Reg::PortBusy, port) & 1) != 0) {
      line.transmitLeftUs -= line.transmitLeftUs > 1000 ? 1000 : line.transmitLeftUs;
      if (line.transmitLeftUs == 0) {
        store.set(Reg::PortBusy, port, store.get(Reg::PortBusy, port) & ~1ULL, true);
        store.save(Area::SM, 4 * 8 + ports[port].idleBit, 1, 1, true);
        raise(ports[port].transmitted);
      }
    }
    ++line.quietMs;
    const bool receives = (store.get(Reg::PortBusy, port) & 2) != 0;
    const unsigned control = static_cast<unsigned>(byteOf(store, ports[port].status + controlAt));
    if (receives && (control & useIdle) != 0 && line.quietMs >= wordOf(store, ports[port].status + idleTimeAt))
      line.sawIdle = true;
    if (receives && line.isMessageOpen) {
      ++line.messageMs;
      const std::uint64_t timed = (control & messageTimer) != 0 ? line.messageMs : line.quietMs;
      if ((control & useTimer) != 0 && timed >= wordOf(store, ports[port].status + timeOutAt))
        endMessage(store, port, endedByTimer, raise);
    }
    const bool isFreeport = (byteOf(store, ports[port].control) & 3) == 1;
    line.arrivalUs = line.incoming.empty() || !isFreeport ? 0 : line.arrivalUs + 1000;
    while (!line.incoming.empty() && line.arrivalUs >= characterUs(store, port)) {
      line.arrivalUs -= characterUs(store, port);
      const int character = line.incoming.front();
      line.incoming.pop_front();
      arrive(store, port, character, raise);
      line.quietMs = 0;
    }
  }
}

void SerialPorts::arrive(Concrete::Store& store, std::uint32_t port, int character, const RaiseEvent& raise) {
  Line& line = lines_[port];
  if ((store.get(Reg::PortBusy, port) & 2) == 0) {
    if (character == breakSignal) return;
    store.save(Area::SM, 2 * 8, 8, static_cast<std::uint64_t>(character), true);
    store.save(Area::SM, 3 * 8, 1, 0, true);
    raise(ports[port].received);
    return;
  }
  const std::uint32_t status = ports[port].status;
  if (!line.isMessageOpen && !meetsStart(store, port, character)) return;
  if (!line.isMessageOpen) line.messageMs = 0;
  line.isMessageOpen = true;
  if (character == breakSignal) return;
  const TableByte at = tableByte(store, port * 2 + 1, ++line.stored);
  const TableByte head = tableByte(store, port * 2 + 1, 0);
  store.save(at.area, at.bit, 8, static_cast<std::uint64_t>(character), true);
  store.save(head.area, head.bit, 8, line.stored, true);
  const unsigned control = static_cast<unsigned>(byteOf(store, status + controlAt));
  unsigned end = 0;
  if ((control & useEnd) != 0 && static_cast<std::uint64_t>(character) == byteOf(store, status + endAt))
    end |= endedByCharacter;
  if (line.stored >= byteOf(store, status + maximumAt)) end |= endedByCount;
  if (end != 0) endMessage(store, port, static_cast<std::uint8_t>(end), raise);
}

/// Start conditions 1 to 6 (001:3244-3285); a character that does not fit restarts the search.
bool SerialPorts::meetsStart(const Concrete::Store& store, std::uint32_t port, int character) {
  Line& line = lines_[port];
  const std::uint32_t status = ports[port].status;
  const unsigned control = static_cast<unsigned>(byteOf(store, status + controlAt));
  const bool waitsForIdle = (control & useIdle) != 0, waitsForBreak = (control & useBreak) != 0,
             waitsForCharacter = (control & useStart) != 0;
  const bool isReady = (!waitsForIdle || line.sawIdle) && (!waitsForBreak || line.sawBreak);
  if (character == breakSignal) {
    line.sawBreak = true;
    return false;
  }
  const bool fits = !waitsForCharacter || static_cast<std::uint64_t>(character) == byteOf(store, status + startAt);
  if (isReady && fits) return true;
  line.sawBreak = false;
  line.sawIdle = waitsForIdle && wordOf(store, status + idleTimeAt) == 0;
  return false;
}

void SerialPorts::endMessage(Concrete::Store& store, std::uint32_t port, std::uint8_t status, const RaiseEvent& raise) {
  lines_[port].isMessageOpen = false;
  store.set(Reg::PortBusy, port, store.get(Reg::PortBusy, port) & ~2ULL, true);
  store.save(Area::SM, ports[port].status * 8, 8, status, true);
  raise(ports[port].message);
}

}  // namespace rungproof
