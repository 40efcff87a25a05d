// The naive interpreter: bit logic, control, timers and counters. Words are in naive_words.cpp.
#include "naive.hpp"

#include <cstdlib>

#include "ir/isa.hpp"

namespace rungproof::naive {

Interpreter::Interpreter(const Program& program) : program_(program) {
  for (const Area area : {Area::I, Area::Q, Area::V, Area::M, Area::S, Area::SM, Area::L}) memory[area].assign(12000, 0);
  memory[Area::SM][0] = 3;  // SM0.0, SM0.1
}

void Interpreter::scan(int ticks10, int ticks100) {
  ticks100_ = ticks100;
  refresh(10, ticks10);
  for (const Pou& pou : program_.pous) {
    if (pou.kind != PouKind::Main) continue;
    stack_.fill(false);
    scr_ = true;
    run(pou);
  }
  firstScan_ = false;
  memory[Area::SM][0] = 1;
}

void Interpreter::run(const Pou& pou) {
  std::vector<Element> code;
  for (const Network& network : pou.networks) {
    for (const Instruction& i : network.instructions) code.push_back({&i, std::string(i.desc->stl)});
  }
  for (std::size_t at = 0; at < code.size();) at = step(code, at);
}

/// Executes one instruction and says which comes next.
std::size_t Interpreter::step(const std::vector<Element>& code, std::size_t at) {
  const Instruction& i = *code[at].instruction;
  const std::string& name = code[at].name;
  const auto find = [&](const std::string& wanted, std::int64_t number) {
    for (std::size_t k = 0; k < code.size(); ++k) {
      if (code[k].name == wanted && code[k].instruction->operands[0].value == number) return k;
    }
    std::abort();
  };
  if (name == "JMP") return power() ? find("LBL", i.operands[0].value) : at + 1;
  if (name == "LBL" || name == "NOP" || name == "MEND" || name == "RET") return at + 1;
  if (name == "END" || name == "CRET") return power() ? code.size() : at + 1;
  if (name == "FOR" || name == "NEXT") {
    std::size_t head = at, tail = at;
    int depth = 0;
    if (name == "FOR") {
      for (tail = at + 1; depth > 0 || code[tail].name != "NEXT"; ++tail) depth += code[tail].name == "FOR" ? 1 : code[tail].name == "NEXT" ? -1 : 0;
      eno_ = power();
      if (!power()) return tail + 1;
      write(i.operands[0], 2, read(i.operands[1], 2));
      return static_cast<std::int16_t>(read(i.operands[0], 2)) > static_cast<std::int16_t>(read(i.operands[2], 2)) ? tail + 1 : at + 1;
    }
    for (head = at - 1; depth > 0 || code[head].name != "FOR"; --head) depth += code[head].name == "NEXT" ? 1 : code[head].name == "FOR" ? -1 : 0;
    const Instruction& loop = *code[head].instruction;
    const int index = static_cast<std::int16_t>(read(loop.operands[0], 2));
    write(loop.operands[0], 2, static_cast<std::uint16_t>(index + 1));
    stack_[0] = true;
    return index + 1 > static_cast<std::int16_t>(read(loop.operands[2], 2)) ? at + 1 : head + 1;
  }
  if (name == "CALL") {
    eno_ = power();  // a call that nests no deeper than allowed is a box without error
    if (!power()) return at + 1;
    const auto saved = stack_;
    const bool scr = scr_;
    stack_.fill(false);
    stack_[0] = true;
    scr_ = true;
    run(*program_.subroutine(static_cast<int>(i.operands[0].value)));
    stack_ = saved;
    scr_ = scr;
    return at + 1;
  }
  if (name == "LSCR") {
    segment_ = i.operands[0];
    scr_ = stack_[0] = readBit(segment_);
    return at + 1;
  }
  if (name == "SCRE") {
    scr_ = true;
    return at + 1;
  }
  if (name == "SCRT") {
    if (power()) {
      writeBit(segment_, false);
      writeBit(i.operands[0], true);
    }
    return at + 1;
  }
  if (name == "TON" || name == "TOF" || name == "TONR") timerBox(i, name);
  else if (name == "CTU" || name == "CTD" || name == "CTUD") counterBox(i, name);
  else if (!logic(i, name) && !compareInstruction(i, name)) {
    // Without power flow a box does nothing, and what follows it sees no ENO (001:2276; the engine's default choice).
    if (power()) box(i, name);
    else eno_ = false;
  }
  return at + 1;
}

void Interpreter::push(bool value) {
  for (std::size_t k = 8; k > 0; --k) stack_[k] = stack_[k - 1];
  stack_[0] = value;
}
bool Interpreter::pop() {
  const bool top = stack_[0];
  for (std::size_t k = 0; k < 8; ++k) stack_[k] = stack_[k + 1];
  stack_[8] = false;  // unknown in the manual; the engine's choice is 0
  return top;
}

bool Interpreter::logic(const Instruction& i, const std::string& name) {
  if (name == "LD") push(readBit(i.operands[0]));
  else if (name == "LDN") push(!readBit(i.operands[0]));
  else if (name == "A") stack_[0] = stack_[0] && readBit(i.operands[0]);
  else if (name == "AN") stack_[0] = stack_[0] && !readBit(i.operands[0]);
  else if (name == "O") stack_[0] = stack_[0] || readBit(i.operands[0]);
  else if (name == "ON") stack_[0] = stack_[0] || !readBit(i.operands[0]);
  else if (name == "NOT") stack_[0] = !stack_[0];
  else if (name == "=") writeBit(i.operands[0], power());
  else if (name == "ALD") { const bool a = pop(); stack_[0] = a && stack_[0]; }
  else if (name == "OLD") { const bool a = pop(); stack_[0] = a || stack_[0]; }
  else if (name == "LPS") push(stack_[0]);
  else if (name == "LRD") stack_[0] = stack_[1];
  else if (name == "LPP") pop();
  else if (name == "LDS") push(stack_[static_cast<std::size_t>(i.operands[0].value)]);
  else if (name == "AENO") stack_[0] = stack_[0] && eno_;
  else if (name == "EU" || name == "ED") {
    const bool now = stack_[0], before = edge_[&i];
    edge_[&i] = now;
    stack_[0] = !firstScan_ && (name == "EU" ? now && !before : !now && before);
  } else return false;
  return true;
}

bool Interpreter::compareInstruction(const Instruction& i, const std::string& name) {
  std::size_t letters = name.find_first_of("<>=");
  if (letters == std::string::npos || letters < 2 || name.substr(0, 3) == "FND") return false;
  const std::string relation = name.substr(letters), joint = name.substr(0, letters - 1);
  const char type = name[letters - 1];
  const int bytes = type == 'B' ? 1 : type == 'W' ? 2 : 4;
  const std::uint32_t x = read(i.operands[0], bytes), y = read(i.operands[1], bytes);
  // Bytes are unsigned, words and double words signed (001:3371).
  const auto number = [&](std::uint32_t v) -> std::int64_t {
    if (type == 'B') return v;
    if (type == 'W') return static_cast<std::int16_t>(v);
    return static_cast<std::int32_t>(v);
  };
  const std::int64_t a = number(x), b = number(y);
  const bool holds = relation == "=" ? a == b : relation == "<>" ? a != b : relation == "<" ? a < b : relation == "<=" ? a <= b : relation == ">" ? a > b : a >= b;
  if (joint == "LD") push(holds);
  else if (joint == "A") stack_[0] = stack_[0] && holds;
  else stack_[0] = stack_[0] || holds;
  return true;
}

// Table 6-73: TON and TONR run on to 32767, TOF stops at its preset.
void Interpreter::timerBox(const Instruction& i, const std::string& name) {
  const std::uint32_t n = i.operands[0].offset;
  TimerState& t = timers_[n];
  const bool input = power();
  t.kind = name;
  t.preset = static_cast<std::int16_t>(read(i.operands[1], 2));
  if (name == "TOF") {
    if (input) {
      timerBit[n] = true;
      timer[n] = 0;
      t.counting = false;
    } else if (t.input) {
      t.counting = true;
    }
  } else {
    t.counting = input;
    if (name == "TON" && !input) {
      timerBit[n] = false;
      timer[n] = 0;
    }
  }
  t.input = input;
  if (timerResolution(static_cast<int>(n)) == 100) refresh(-static_cast<int>(n), ticks100_);
}

/// Positive: all timers of that resolution; negative: one timer by number.
void Interpreter::refresh(int resolution, int ticks) {
  for (auto& [n, t] : timers_) {
    if (resolution > 0 ? timerResolution(static_cast<int>(n)) != resolution : n != static_cast<std::uint32_t>(-resolution)) continue;
    if (!t.counting) continue;
    const int sum = timer[n] + ticks;
    timer[n] = static_cast<std::int16_t>(sum > 32767 ? 32767 : sum);
    if (timer[n] < t.preset) continue;
    timerBit[n] = t.kind != "TOF";
    if (t.kind == "TOF") {
      timer[n] = static_cast<std::int16_t>(t.preset);
      t.counting = false;
    }
  }
}

// CTU: reset on top, count below; CTD: load on top; CTUD: reset, down, up from the top (001:3994-4004, 000:3378).
void Interpreter::counterBox(const Instruction& i, const std::string& name) {
  const std::uint32_t n = i.operands[0].offset;
  const int preset = static_cast<std::int16_t>(read(i.operands[1], 2));
  const bool control = stack_[0] && scr_, second = stack_[1] && scr_, third = stack_[2] && scr_;
  auto& [up, down] = countInputs_[n];
  const bool upNow = name == "CTU" ? second : name == "CTUD" ? third : false;
  const bool downNow = name == "CTU" ? false : second;
  // The manual gives no rule for the first scan; the engine's default follows that of EU: no edge there.
  const bool risesUp = !firstScan_ && upNow && !up, risesDown = !firstScan_ && downNow && !down;
  up = upNow;
  down = downNow;
  if (control) {
    counter[n] = static_cast<std::int16_t>(name == "CTD" ? preset : 0);
    counterBit[n] = false;
    return;
  }
  if (name == "CTU" && risesUp && counter[n] < 32767) ++counter[n];
  if (name == "CTD" && risesDown && counter[n] > 0) --counter[n];
  if (name == "CTUD") counter[n] = static_cast<std::int16_t>(counter[n] + (risesUp ? 1 : 0) - (risesDown ? 1 : 0));
  counterBit[n] = name == "CTD" ? counter[n] == 0 : counter[n] >= preset;
}

void Interpreter::setOrReset(const Instruction& i, bool value) {
  const Operand& first = i.operands[0];
  const std::uint32_t count = read(i.operands[1], 1);
  for (std::uint32_t k = 0; k < count; ++k) {
    if (first.area == Area::T || first.area == Area::C) {
      const std::uint32_t n = first.offset + k;
      (first.area == Area::T ? timerBit : counterBit)[n] = value;
      if (!value) (first.area == Area::T ? timer : counter)[n] = 0;
      if (!value && first.area == Area::T) timers_[n].counting = false;
    } else {
      const std::uint32_t at = first.offset * 8 + first.bit + k;
      putBit(first.area, at / 8, at % 8, value);
    }
  }
}

bool Interpreter::bitAt(Area area, std::uint32_t byte, unsigned bit) const { return (memory.at(area)[byte] >> bit & 1) != 0; }
void Interpreter::putBit(Area area, std::uint32_t byte, unsigned bit, bool value) {
  std::uint8_t& cell = memory[area][byte];
  cell = static_cast<std::uint8_t>(value ? cell | 1U << bit : cell & ~(1U << bit));
}
bool Interpreter::readBit(const Operand& o) {
  if (o.area == Area::T) return timerBit[o.offset];
  if (o.area == Area::C) return counterBit[o.offset];
  return bitAt(o.area, o.offset, o.bit);
}
void Interpreter::writeBit(const Operand& o, bool value) {
  if (o.area == Area::T) timerBit[o.offset] = value;
  else if (o.area == Area::C) counterBit[o.offset] = value;
  else putBit(o.area, o.offset, o.bit, value);
}

}  // namespace rungproof::naive
