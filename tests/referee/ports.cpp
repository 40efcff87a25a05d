// RCV, XMT, NETR, NETW: what the ports do from the request until it is completed (001:3022-3342).
#include <algorithm>

#include "machine.hpp"

namespace rungproof::referee {
namespace {

constexpr std::uint8_t byUser = 0x80, badParameter = 0x40, endCharacter = 0x20, timerExpired = 0x04, fullCount = 0x02,
                       parityError = 0x01;

/// Bytes of port 0; those of port 1 stand 100 further on (001:3213).
int systemByte(int port, int byte) { return byte + 100 * port; }

}  // namespace

void Machine::receive(const Instruction& i) {
  const int number = static_cast<int>(i.b.value);
  Port& port = ports_[static_cast<std::size_t>(number)];
  const auto byte = [&](int at) { return load(Area::SM, systemByte(number, at), 1); };
  const std::uint32_t mode = byte(30);
  const std::uint32_t control = byte(87);
  if ((mode & 3U) != 1) return;  // not in freeport mode: ENO = 0 (001:3147)
  if (port.transmitting) return runTimeError();
  if ((control & 0x80U) == 0) {
    if (port.receiving) finishReception(port, number, byUser);
    return;
  }
  if (port.receiving) return;  // the reception goes on
  const std::uint32_t most = byte(94);
  const bool starts = (control & 0x52U) != 0;
  if (!starts || most == 0) {
    store(Area::SM, systemByte(number, 86), 1, badParameter);
    return;
  }
  store(Area::SM, systemByte(number, 86), 1, 0);
  tell("RCV begins");
  port = Port();
  port.receiving = true;
  port.buffer = i.a;
  port.countEach = random_.chance(50);
  port.earliest = now_;
  // How this reception will end.
  std::vector<std::uint8_t> reasons = {fullCount};
  if ((control & 0x20U) != 0) reasons.push_back(endCharacter);
  if ((control & 0x20U) != 0) reasons.push_back(endCharacter);
  if ((control & 0x04U) != 0) reasons.push_back(timerExpired);
  if (mode >> 6U == 1 || mode >> 6U == 3) reasons.push_back(parityError);
  port.reason = random_.any(reasons);
  const bool startCharacter = (control & 0x40U) != 0;
  const auto full = static_cast<int>(std::min<std::uint32_t>(most, 40));
  int length = port.reason == fullCount ? static_cast<int>(most) : random_.between(1, std::min(full, 6));
  if (port.reason == endCharacter && startCharacter) length = std::max(length, std::min(2, full));
  if (port.reason == timerExpired) {
    port.earliest = now_ + load(Area::SM, systemByte(number, 92), 2) + 1;
    length = std::min(length, full);
  }
  const auto end = static_cast<std::uint8_t>(byte(89));
  for (int n = 0; n < length; ++n) {
    auto character = static_cast<std::uint8_t>(
        random_.chance(80) ? random_.any(program_.pool) + (random_.chance(10) ? 1 : 0) : random_.below(256));
    if ((control & 0x20U) != 0 && character == end) ++character;
    if (n == 0 && startCharacter) character = static_cast<std::uint8_t>(byte(88));
    if (n == length - 1 && port.reason == endCharacter) character = end;
    port.characters.push_back(character);
  }
}

/// Characters arrive one by one (001:3202); with the last one the reception ends, and its event comes.
void Machine::freeportProgress() {
  for (int number = 0; number < 2; ++number) {
    Port& port = ports_[static_cast<std::size_t>(number)];
    const bool freeport = (load(Area::SM, systemByte(number, 30), 1) & 3U) == 1;
    if (!port.receiving) {
      // Without RCV each character comes as an event with the character in SMB2 (001:3324).
      if (freeport && !port.transmitting && random_.chance(30)) {
        raise(number == 0 ? 8 : 25);
        if (!interruptsEnabled_) store(Area::SM, 2, 1, static_cast<std::uint32_t>(random_.any(program_.pool)));
      }
      continue;
    }
    for (int n = random_.between(1, 12); n > 0 && port.arrived < port.characters.size(); --n) {
      ++port.arrived;
      if (port.buffer.offset + static_cast<int>(port.arrived) < static_cast<int>(bytesOf(port.buffer.area).size()))
        store(port.buffer.area, port.buffer.offset + static_cast<int>(port.arrived), 1,
              port.characters[port.arrived - 1]);
      if (port.countEach) store(port.buffer.area, port.buffer.offset, 1, static_cast<std::uint32_t>(port.arrived));
    }
    if (port.arrived == port.characters.size() && now_ >= port.earliest) finishReception(port, number, port.reason);
  }
}

void Machine::finishReception(Port& port, int number, std::uint8_t reason) {
  port.receiving = false;
  store(Area::SM, systemByte(number, 86), 1, reason);
  store(port.buffer.area, port.buffer.offset, 1, static_cast<std::uint32_t>(port.arrived));
  if (telling_) {
    std::string text;
    for (std::size_t n = 0; n < port.arrived; ++n) text += " " + std::to_string(port.characters[n]);
    tell("RCV ends, status " + std::to_string(reason) + ", characters" + text);
  }
  // Whether a reception that RCV itself ends has an event is not stated.
  if (reason != byUser) raise(number == 0 ? 23 : 24);
}

void Machine::transmit(const Instruction& i) {
  static constexpr std::array<int, 8> baud = {38400, 19200, 9600, 4800, 2400, 1200, 115200, 57600};
  const int number = static_cast<int>(i.b.value);
  Port& port = ports_[static_cast<std::size_t>(number)];
  const std::uint32_t mode = load(Area::SM, systemByte(number, 30), 1);
  if ((mode & 3U) != 1) return;
  if (port.receiving) return runTimeError();
  if (port.transmitting) return;
  const int characters = static_cast<int>(load(i.a.area, i.a.offset, 1));
  const int bits = characters == 0 ? 16 : characters * 10;
  const int milliseconds = bits * 1000 / baud.at(mode >> 2U & 7U);
  port.transmitting = true;
  port.sentFrom = now_ + milliseconds;
  port.sentBy = now_ + milliseconds * 12 / 10 + 2;
  setSystemBit(4, 5 + number, false);
  tell("XMT begins");
}

/// The last character has left: the transmitter is idle (001:3187).
void Machine::transmissionTime() {
  for (std::size_t n = 0; n < ports_.size(); ++n) {
    Port& port = ports_[n];
    if (!port.transmitting || now_ < port.sentBy) continue;
    port.transmitting = false;
    setSystemBit(4, static_cast<int>(5 + n), true);
    tell("message sent");
    raise(n == 0 ? 9 : 26);
  }
}

// Status byte of the table: done, active, error, 0, four bits of error code (000:1113).
void Machine::network(const Instruction& i) {
  const int port = static_cast<int>(i.b.value);
  const bool again = std::any_of(requests_.begin(), requests_.end(), [&](const Request& r) {
    return r.table.area == i.a.area && r.table.offset == i.a.offset;
  });
  if (again) return;
  const std::uint32_t length = load(i.a.area, i.a.offset + 6, 1);
  std::uint32_t error = 0;
  if ((load(Area::SM, systemByte(port, 30), 1) & 3U) != 2) {
    error = 5;
  } else if (length == 0 || length > 16) {
    error = 6;
  } else if (requests_.size() >= 8) {
    error = 4;
  }
  store(i.a.area, i.a.offset, 1, error != 0 ? 0x20U | error : 0x40U);
  if (error == 0) requests_.push_back({i.a, i.op == Op::NetRead});
  tell("NETR or NETW begins");
}

/// Between the program and the writing of the outputs (001:1246): done, with data or with an error.
void Machine::networkProgress() {
  if (requests_.empty()) return;
  const auto at = requests_.begin() + random_.below(static_cast<int>(requests_.size()));
  const Request request = *at;
  requests_.erase(at);
  static const std::vector<std::uint32_t> errors = {1, 2, 3, 7, 8, 9};
  const Operand& table = request.table;
  if (random_.chance(30)) {
    store(table.area, table.offset, 1, 0xA0U | random_.any(errors));
    tell("NETR or NETW ends with an error");
    return;
  }
  store(table.area, table.offset, 1, 0x80U);
  tell("NETR or NETW done");
  if (!request.reads) return;
  const auto length = static_cast<int>(load(table.area, table.offset + 6, 1));
  for (int n = 0; n < std::min(length, 16); ++n) {
    const int value =
        random_.chance(80) ? random_.any(program_.pool) + (random_.chance(10) ? 1 : 0) : random_.below(256);
    store(table.area, table.offset + 7 + n, 1, static_cast<std::uint32_t>(value));
  }
}

}  // namespace rungproof::referee
