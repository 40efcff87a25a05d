// The scan cycle (001:1205), the passing of time and what may happen between two instructions.
#include "machine.hpp"

#include <algorithm>

namespace rungproof::referee {

Machine::Machine(const Program& program, std::uint64_t seed, const OpenPoints& open)
    : program_(program),
      random_(seed),
      open_(open),
      i_(16),
      q_(16),
      m_(32),
      v_(2048),
      s_(32),
      sm_(600),
      ai_(64),
      edgeMemory_(static_cast<std::size_t>(program.edges)),
      timers_(256),
      counters_(256) {
  startOfRun();
}

int Machine::lengthOfScan() {
  static const std::vector<int> mixed = {1, 1, 2, 3, 5, 9, 10, 11, 20, 30, 50, 99, 100, 101, 250, 499, 500};
  switch (temper_.lengths) {
    case 0: return random_.between(1, 12);
    case 1: return random_.any(mixed);
    case 2: return random_.between(50, watchdog);
    default: return temper_.fixedLength;
  }
}

bool Machine::scan() {
  if (runEnds_) return false;
  ++scanNumber_;
  startOfScan();
  executed_ = 0;
  runBlock(program_.main);
  if (noScanEnd_) return false;
  scanEnds_ = false;
  endOfScan();
  return !noScanEnd_;
}

void Machine::startOfScan() {
  lastScanStart_ = scanStart_;
  scanStart_ = now_;
  systemBits();
  if (scanNumber_ > 1) {
    while (random_.chance(temper_.devices / 2)) networkProgress();
    while (random_.chance(temper_.devices / 2)) freeportProgress();
    if (random_.chance(temper_.devices)) count();
    pulseTime();
    transmissionTime();
  }
  length_ = left_ = lengthOfScan();
  if (telling_) tell("scan " + std::to_string(scanNumber_) + ", " + std::to_string(length_) + " ms");
  for (const int input : usedInputs_) {
    if (scanNumber_ == 1 ? random_.chance(50) : random_.chance(temper_.inputs)) changeInput(input);
  }
  for (int n = 0; n < 16; ++n) {
    const auto byte = static_cast<std::size_t>(n / 8);
    const auto mask = static_cast<std::uint8_t>(1U << (n % 8));
    i_[byte] = static_cast<std::uint8_t>(terminals_[static_cast<std::size_t>(n)] ? i_[byte] | mask : i_[byte] & ~mask);
  }
  for (std::size_t n = 0; n < ai_.size(); n += 2) {
    if (random_.chance(temper_.inputs)) ai_[n + 1] = static_cast<std::uint8_t>(random_.any(program_.pool));
  }
  for (int n = 0; n < 256; ++n) {
    TimerState& t = timers_[static_cast<std::size_t>(n)];
    if (!t.timing || ((n % 64 < 1 || n % 64 > 4) && (n % 64 < 33 || n % 64 > 36)) || n > 100) continue;
    // All intervals since the start of the scan before, for every timer that is enabled (004:4584).
    refresh(t, n, ticksBetween(10, lastScanStart_, scanStart_));
  }
}

void Machine::endOfScan() {
  // Part 3 of the scan: messages from the port (001:1246).
  if (open_.portsBeforeEnd) {
    while (random_.chance(temper_.devices / 2)) networkProgress();
    while (random_.chance(temper_.devices / 2)) freeportProgress();
  }
  while (left_ > 0) {
    pass(1);
    if (executed_ < busy && random_.chance(temper_.events)) happen();
    serve();
  }
  for (int n = 0; n < 20 && random_.chance(temper_.events); ++n) happen();
  serve();
  shortest_ = scanNumber_ == 1 ? length_ : std::min(shortest_, length_);
  longest_ = std::max(longest_, length_);
}

void Machine::pass(int milliseconds) {
  for (; milliseconds > 0 && left_ > 0 && !noScanEnd_; --milliseconds) {
    --left_;
    ++now_;
    tick();
    serve();
  }
}

/// One millisecond: timers of 1 ms (001:6607), timed interrupts (001:5472), what takes a known time.
void Machine::tick() {
  for (const int n : {0, 32, 64, 96}) {
    TimerState& t = timers_[static_cast<std::size_t>(n)];
    if (!t.timing) continue;
    const int before = t.current;
    refresh(t, n, 1);
    if (t.current == t.preset && before != t.current && (n == 32 || n == 96)) raise(n == 32 ? 21 : 22);
  }
  for (std::size_t n = 0; n < 2; ++n) {
    if (attached_[10 + n] == 0 || period_[n] == 0) continue;
    if (++elapsed_[n] < period_[n]) continue;
    elapsed_[n] = 0;
    raise(static_cast<int>(10 + n));
  }
  if (open_.countersInScan) pulseTime();
  if (open_.portsInScan) transmissionTime();
}

/// Before an instruction and after the last one (001:5439: not within one).
void Machine::boundary() {
  if (noScanEnd_ || ++executed_ > busy) return;
  // A routine is short: hardly ever does a millisecond pass in it.
  switch (inRoutine_ ? (random_.chance(5) ? 3 : 0) : temper_.ticks) {
    case 0: break;
    case 1: pass(left_); break;
    case 2:
      if (left_ > 0 && random_.chance(25)) pass(random_.between(1, left_));
      break;
    default:
      if (random_.chance(30)) pass(1);
      break;
  }
  for (int n = 0; n < 20 && random_.chance(temper_.events); ++n) happen();
  serve();
}

/// One thing that the outside world does.
void Machine::happen() {
  switch (random_.below(4)) {
    case 0:
      if (!usedInputs_.empty()) changeInput(random_.any(usedInputs_));
      break;
    case 1:
      if (open_.portsInScan) freeportProgress();
      break;
    case 2:
      if (open_.countersInScan) count();
      break;
    default:
      for (Port& port : ports_) {
        if (port.transmitting && now_ >= port.sentFrom) port.sentBy = now_;
      }
      break;
  }
}

void Machine::runBlock(const std::vector<Instruction>& block) {
  for (const Instruction& i : block) {
    boundary();
    if (noScanEnd_ || scanEnds_ || routineEnds_ || subroutineEnds_) return;
    execute(i);
    if (noScanEnd_ || scanEnds_ || routineEnds_ || subroutineEnds_) return;
  }
  if (!inRoutine_) boundary();
}

void Machine::tell(const std::string& what) {
  if (telling_) told_.push_back(what);
}

std::vector<std::uint8_t>& Machine::bytesOf(Area area) {
  return const_cast<std::vector<std::uint8_t>&>(static_cast<const Machine*>(this)->bytesOf(area));
}

const std::vector<std::uint8_t>& Machine::bytesOf(Area area) const {
  switch (area) {
    case Area::I: return i_;
    case Area::Q: return q_;
    case Area::M: return m_;
    case Area::V: return v_;
    case Area::S: return s_;
    case Area::AI: return ai_;
    default: return sm_;
  }
}

// The lower address is the more significant byte (001:14372).
std::uint32_t Machine::load(Area area, int offset, int bytes) const {
  std::uint32_t value = 0;
  for (int n = 0; n < bytes; ++n) value = value << 8U | bytesOf(area).at(static_cast<std::size_t>(offset + n));
  return value;
}

void Machine::store(Area area, int offset, int bytes, std::uint32_t value) {
  for (int n = bytes - 1; n >= 0; --n, value >>= 8U)
    bytesOf(area).at(static_cast<std::size_t>(offset + n)) = static_cast<std::uint8_t>(value);
}

void Machine::setSystemBit(int byte, int bit, bool value) {
  const std::uint32_t old = load(Area::SM, byte, 1);
  store(Area::SM, byte, 1, value ? old | 1U << bit : old & ~(1U << bit));
}

}  // namespace rungproof::referee
