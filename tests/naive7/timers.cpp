// The naive interpreter's S5 timers, read synchronously (a timer of n units has run out when n units have passed since
// its start, seen at the start of a scan), and its counters.
#include "tests/naive7/machine.hpp"

namespace naive7 {
namespace {

std::uint32_t bcdOf(std::uint32_t value) { return value / 100 << 8 | value / 10 % 10 << 4 | value % 10; }

std::uint32_t fromBcd(std::uint32_t bcd) {
  std::uint32_t value = 0;
  for (int i = 2; i >= 0; --i) {
    const std::uint32_t digit = bcd >> 4 * i & 15;
    if (digit > 9) throw Stop{0x21, "BCD digit"};
    value = value * 10 + digit;
  }
  return value;
}

/// R: the start edge that was seen stays seen.
void setBack(Timer& t) {
  t.isRunning = t.isDone = t.input = false;
  t.rest = 0;
}

}  // namespace

void Machine::advance(std::int64_t milliseconds) {
  now += milliseconds;
  for (auto& [number, t] : timers) {
    if (!t.isRunning) continue;
    const std::int64_t passed = (now - t.startedAt) / t.base;
    t.rest = passed >= t.units ? 0 : t.units - static_cast<std::uint32_t>(passed);
    if (t.rest == 0) {
      t.isRunning = false;
      t.isDone = true;
    }
  }
}

bool Machine::timerBit(int number) const {
  const auto found = timers.find(number);
  if (found == timers.end()) return false;
  const Timer& t = found->second;
  if (t.kind == "SP") return t.isRunning && t.input;
  if (t.kind == "SE") return t.isRunning;
  if (t.kind == "SD") return t.isDone && t.input;
  if (t.kind == "SS") return t.isDone;
  if (t.kind == "SF") return t.isRunning || t.input;
  return false;
}

std::uint32_t Machine::timerValue(int number) const {
  const auto found = timers.find(number);
  return found == timers.end() ? 0 : found->second.rest;
}

void Machine::startTimer(const std::string& kind, Timer& t) {
  const bool rising = rlo && !t.lastStart, falling = !rlo && t.lastStart;
  if (kind == "SF" ? falling : rising) {
    t.units = fromBcd(accu[0] & 0xFFF);
    const std::uint32_t bases[] = {10, 100, 1000, 10000};
    t.baseCode = accu[0] >> 12 & 3;
    t.base = bases[t.baseCode];
    t.startedAt = now;
    t.rest = t.units;
    t.isRunning = t.units > 0;
    t.isDone = t.units == 0 || (kind == "SS" && t.isDone);
  } else if (kind == "SF" && rising) {
    t.isRunning = false;
    t.rest = 0;
  }
  if (!rlo && (kind == "SP" || kind == "SD")) {
    t.isRunning = t.isDone = false;  // the rest of the time stays readable
  }
  t.kind = kind;
  t.lastStart = t.input = rlo;
}

bool Machine::timerStatement(const Statement& s) {
  const std::string& op = s.op;
  if (op == "SP" || op == "SE" || op == "SD" || op == "SS" || op == "SF") {
    startTimer(op, timers[objectNumber(s.operand, 'T')]);
    endString();
    return true;
  }
  bool isTimer = s.operand[0] == 'T';
  if (s.operand[0] == '#') {
    for (const Variable& v : frame().block->variables) {
      if (v.name == s.operand.substr(1)) isTimer = v.type == "TIMER";
    }
  }
  if (op == "L" || op == "LC") {
    const int number = objectNumber(s.operand, isTimer ? 'T' : 'C');
    const auto value = isTimer ? timerValue(number) : static_cast<std::uint32_t>(counters[number].value);
    const std::uint32_t base = isTimer ? timers[number].baseCode << 12 : 0;
    load(op == "L" ? value : base | bcdOf(value));
    return true;
  }
  if (op == "R" || op == "FR") {
    const int number = objectNumber(s.operand, isTimer ? 'T' : 'C');
    if (op == "R" && rlo) {
      if (isTimer) {
        setBack(timers[number]);
      } else {
        counters[number].value = 0;
      }
    }
    if (op == "FR" && isTimer) {
      Timer& t = timers[number];
      if (rlo && !t.lastFree) t.lastStart = false;
      t.lastFree = rlo;
    } else if (op == "FR") {
      Counter& c = counters[number];
      if (rlo && !c.lastFree) c.lastUp = c.lastDown = c.lastSet = false;
      c.lastFree = rlo;
    }
    endString();
    return true;
  }
  if (op == "CU" || op == "CD" || op == "S") {
    Counter& c = counters[objectNumber(s.operand, 'C')];
    bool& last = op == "CU" ? c.lastUp : op == "CD" ? c.lastDown : c.lastSet;
    if (rlo && !last) {
      if (op == "S") c.value = static_cast<int>(fromBcd(accu[0] & 0xFFF));
      if (op == "CU" && c.value < 999) ++c.value;
      if (op == "CD" && c.value > 0) --c.value;
    }
    last = rlo;
    endString();
    return true;
  }
  return false;
}

}  // namespace naive7
