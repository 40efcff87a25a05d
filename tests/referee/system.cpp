// The start of RUN, the special memory bits that the system writes (001:14045-14163), the clock, the inputs.
#include <algorithm>

#include "machine.hpp"

namespace rungproof::referee {

void Machine::startOfRun() {
  detachDrops_ = open_.detach && random_.chance(50);
  stopAtOnce_ = !open_.stop || random_.chance(50);
  clockOn_ = open_.scanClock && random_.chance(50);
  edgeCounts_ = open_.counterEdge && random_.chance(50);
  phase_ = {random_.below(10), random_.below(100)};
  temper_.inputs = random_.any(std::vector<int>{5, 20, 50, 80});
  temper_.events = random_.any(std::vector<int>{0, 3, 10, 25, 50, 80, 92});
  temper_.devices = random_.any(std::vector<int>{10, 40, 80});
  temper_.ticks = random_.below(4);
  temper_.lengths = random_.below(4);
  temper_.fixedLength = random_.any(std::vector<int>{1, 5, 10, 50, 100, 500});
  for (const auto* block : {&program_.main}) {
    for (const Instruction& i : *block) {
      if (i.a.area == Area::I && i.a.bit >= 0 && i.a.offset < 2) usedInputs_.push_back(i.a.offset * 8 + i.a.bit);
      if (i.op == Op::Attach && i.b.value < 8) usedInputs_.push_back(static_cast<int>(i.b.value / 2));
    }
  }
  for (const auto& [number, block] : program_.interrupts) {
    for (const Instruction& i : block) {
      if (i.a.area == Area::I && i.a.bit >= 0 && i.a.offset < 2) usedInputs_.push_back(i.a.offset * 8 + i.a.bit);
      if (i.op == Op::Attach && i.b.value < 8) usedInputs_.push_back(static_cast<int>(i.b.value / 2));
    }
  }
  std::sort(usedInputs_.begin(), usedInputs_.end());
  usedInputs_.erase(std::unique(usedInputs_.begin(), usedInputs_.end()), usedInputs_.end());
  // RUN after power-up, with or without the loss of data, or after STOP (001:14052).
  const bool powerUp = random_.chance(50);
  setSystemBit(0, 0, true);
  setSystemBit(0, 1, true);
  setSystemBit(0, 2, powerUp && random_.chance(50));
  setSystemBit(0, 3, powerUp);
  setSystemBit(4, 5, true);
  setSystemBit(4, 6, true);
  setSystemBit(66, 7, true);
  setSystemBit(76, 7, true);
  store(Area::SM, 6, 1, 0x90);  // CPU 226 (001:14138)
  for (int n = 8; n <= 21; ++n) store(Area::SM, n, 1, static_cast<std::uint32_t>(random_.any(program_.pool)));
  for (int n = 200; n < 550; ++n) {
    if (random_.chance(30)) store(Area::SM, n, 1, static_cast<std::uint32_t>(random_.any(program_.pool)));
  }
  clockSeconds_ = random_.chance(50) ? 86400 - random_.between(0, 3) : random_.below(86400);
}

/// What the system writes between two scans (001:14045, 001:14151-14163, 001:1651, 001:14394).
void Machine::systemBits() {
  const bool first = scanNumber_ == 1;
  if (!first) {
    for (int bit = 1; bit <= 3; ++bit) setSystemBit(0, bit, false);
    store(Area::SM, 22, 2, static_cast<std::uint32_t>(length_));
    store(Area::SM, 24, 2, static_cast<std::uint32_t>(shortest_));
    store(Area::SM, 26, 2, static_cast<std::uint32_t>(longest_));
    if (systemBit(31, 7)) setSystemBit(31, 7, false);
  }
  setSystemBit(0, 4, (now_ / 30000 % 2 != 0) != clockOn_);
  setSystemBit(0, 5, (now_ / 500 % 2 != 0) != clockOn_);
  setSystemBit(0, 6, (scanNumber_ % 2 == 0) != clockOn_);
  if (first || random_.chance(temper_.inputs)) setSystemBit(0, 7, random_.chance(50));
  if (first || random_.chance(temper_.inputs)) setSystemBit(5, 0, random_.chance(30));
  for (const int byte : {28, 29}) {
    if (first || random_.chance(temper_.inputs))
      store(Area::SM, byte, 1,
            static_cast<std::uint32_t>(random_.chance(80) ? random_.any(program_.pool) : random_.below(256)));
  }
  while (!first && random_.chance(temper_.devices / 2))
    store(Area::SM, random_.between(216, 249), 1, static_cast<std::uint32_t>(random_.any(program_.pool)));
}

/// TODR: eight bytes of BCD (001:2935). The date is any valid one, the time runs.
void Machine::storeClock(const Operand& to) {
  const std::int64_t seconds = (clockSeconds_ + now_ / 1000) % 86400;
  const auto bcd = [](std::int64_t n) { return static_cast<std::uint32_t>(n / 10 * 16 + n % 10); };
  const bool midnight = clockSeconds_ + now_ / 1000 >= 86400;
  const std::array<std::uint32_t, 8> values = {
      bcd(24),           bcd(7), bcd(midnight ? 16 : 15), bcd(seconds / 3600), bcd(seconds / 60 % 60),
      bcd(seconds % 60), 0,      midnight ? 3U : 2U};
  for (std::size_t n = 0; n < 8; ++n) store(to.area, to.offset + static_cast<int>(n), 1, values[n]);
}

/// An input terminal changes; the edges of I0.0 to I0.3 are events (001:5460).
void Machine::changeInput(int number) {
  bool& terminal = terminals_.at(static_cast<std::size_t>(number));
  terminal = !terminal;
  if (telling_ && scanNumber_ > 0)
    tell("I" + std::to_string(number / 8) + "." + std::to_string(number % 8) + (terminal ? " on" : " off"));
  if (number < 4 && scanNumber_ > 0) raise(2 * number + (terminal ? 0 : 1));
}

}  // namespace rungproof::referee
