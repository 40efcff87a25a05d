// The naive interpreter: bit logic, control, timers and counters.
#include "naive.hpp"

#include <bit>
#include <cmath>
#include <cstdlib>

#include "ir/s7200/cpu.hpp"
#include "ir/s7200/isa.hpp"

namespace rungproof::naive {

Interpreter::Interpreter(const Program& program) : program_(program) {
  for (const Area area : {Area::I, Area::Q, Area::V, Area::M, Area::S, Area::SM, Area::L, Area::AI, Area::AQ})
    memory[area].assign(isSmart(program.target) ? 32768 : area == Area::V ? 10240 + 512 : 1024, 0);  // 0 behind its end
  memory[Area::SM][0] = 3;                                                                           // SM0.0, SM0.1
  pidHistory.fill(true);                                                                             // 001:5295
}

void Interpreter::scan(int ticks10, int ticks100) {
  ticks100_ = ticks100;
  refresh(10, ticks10);
  for (const Pou& pou : program_.pous) {
    if (pou.kind != PouKind::Main) continue;
    stack.fill(false);
    scr_ = true;
    run(pou);
  }
  firstScan = false;
  memory[Area::SM][0] = 1;
}

void Interpreter::run(const Pou& pou) {
  std::vector<Element> code;
  for (const Network& network : pou.networks) {
    for (const Instruction& i : network.instructions) code.push_back({&i, std::string(i.desc->stl)});
  }
  for (std::size_t at = 0; at < code.size() && !stopped;) at = step(code, at);
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
  ++executed[name];
  followed_.clear();
  if (name == "JMP") return power() ? find("LBL", i.operands[0].value) : at + 1;
  if (name == "LBL" || name == "NOP") return at + 1;
  if (name == "MEND" || name == "RET") return code.size();
  if (name == "END" || name == "CRET") return power() ? code.size() : at + 1;
  if (name == "FOR" || name == "NEXT") return loop(code, at);
  if (name == "STOP") {
    stopped = power();
    if (power()) told.emplace_back("stop");
  } else if (name == "CALL") {
    eno = power();  // a call that nests no deeper than allowed is a box without error
    if (!power()) return at + 1;
    const auto saved = stack;
    const bool scr = scr_;
    stack.fill(false);
    stack[0] = true;
    scr_ = true;
    run(*program_.subroutine(static_cast<int>(i.operands[0].value)));
    stack = saved;
    scr_ = scr;
  } else if (name == "LSCR") {
    segment_ = i.operands[0];
    scr_ = stack[0] = readBit(segment_);
  } else if (name == "SCRE") {
    scr_ = true;
  } else if (name == "CSCRE") {
    if (!power()) return at + 1;
    while (code[at].name != "SCRE") ++at;
    return at;
  } else if (name == "SCRT") {
    if (!power()) return at + 1;
    writeBit(segment_, false);
    writeBit(i.operands[0], true);
  } else if (name == "TP.IEC" || (name.starts_with("TO") && !name.starts_with("TOD"))) {
    timerBox(i, name);
  } else if (name.starts_with("CT")) {
    name.ends_with(".IEC") ? iecCounter(i, name) : counterBox(i, name);
  } else if (name == "PID") {
    pid(i);
  } else if (!logic(i, name) && !compareInstruction(i, name) && !bistable(i, name)) {
    // Without power flow a box does nothing, and what follows it sees no ENO (001:2276; the engine's default choice).
    const bool hasEno =
        name != "WDR" && name != "DLED" && name != "BITIM" && name != "CITIM";  // no ENO is printed for them
    if (!power()) --executed[name];
    if (hasEno) eno = power();
    if (power()) box(i, name);
  }
  return at + 1;
}

/// FOR copies INIT and leaves out the body of an empty loop; NEXT counts and goes back while INDX is not above FINAL.
std::size_t Interpreter::loop(const std::vector<Element>& code, std::size_t at) {
  const auto depthOf = [&](std::size_t k) { return code[k].name == "FOR" ? 1 : code[k].name == "NEXT" ? -1 : 0; };
  std::size_t other = at;
  int depth = depthOf(at);
  while (depth != 0) {
    other = code[at].name == "FOR" ? other + 1 : other - 1;
    depth += depthOf(other);
  }
  const Instruction& head = *code[code[at].name == "FOR" ? at : other].instruction;
  const auto number = [&](std::size_t operand) { return static_cast<std::int16_t>(read(head.operands[operand], 2)); };
  if (code[at].name == "FOR") {
    eno = power();
    if (!power()) return other + 1;
    write(head.operands[0], 2, read(head.operands[1], 2));
    return number(0) > number(2) ? other + 1 : at + 1;
  }
  const int next = number(0) + 1;
  write(head.operands[0], 2, static_cast<std::uint16_t>(next));
  stack[0] = true;
  return next > number(2) ? at + 1 : other + 1;
}

void Interpreter::push(bool value) {
  for (std::size_t k = 8; k > 0; --k) stack[k] = stack[k - 1];
  stack[0] = value;
}
bool Interpreter::pop() {
  const bool top = stack[0];
  for (std::size_t k = 0; k < 8; ++k) stack[k] = stack[k + 1];
  stack[8] = false;  // unknown in the manual; the engine's choice is 0
  return top;
}

bool Interpreter::logic(const Instruction& i, const std::string& name) {
  const auto terminal = [&] { return (inputs[i.operands[0].offset] >> i.operands[0].bit & 1) != 0; };
  if (name == "LD")
    push(readBit(i.operands[0]));
  else if (name == "LDI")
    push(terminal());
  else if (name == "LDNI")
    push(!terminal());
  else if (name == "AI")
    stack[0] = stack[0] && terminal();
  else if (name == "ANI")
    stack[0] = stack[0] && !terminal();
  else if (name == "OI")
    stack[0] = stack[0] || terminal();
  else if (name == "ONI")
    stack[0] = stack[0] || !terminal();
  else if (name == "LDN")
    push(!readBit(i.operands[0]));
  else if (name == "A")
    stack[0] = stack[0] && readBit(i.operands[0]);
  else if (name == "AN")
    stack[0] = stack[0] && !readBit(i.operands[0]);
  else if (name == "O")
    stack[0] = stack[0] || readBit(i.operands[0]);
  else if (name == "ON")
    stack[0] = stack[0] || !readBit(i.operands[0]);
  else if (name == "NOT")
    stack[0] = !stack[0];
  else if (name == "=")
    writeBit(i.operands[0], power());
  else if (name == "=I") {
    writeBit(i.operands[0], power());
    const auto mask = static_cast<std::uint8_t>(1U << i.operands[0].bit);
    std::uint8_t& terminal = outputs[i.operands[0].offset];
    terminal = static_cast<std::uint8_t>(power() ? terminal | mask : terminal & ~mask);
  } else if (name == "ALD") {
    const bool a = pop();
    stack[0] = a && stack[0];
  } else if (name == "OLD") {
    const bool a = pop();
    stack[0] = a || stack[0];
  } else if (name == "LPS")
    push(stack[0]);
  else if (name == "LRD")
    stack[0] = stack[1];
  else if (name == "LPP")
    pop();
  else if (name == "LDS")
    push(stack[static_cast<std::size_t>(i.operands[0].value)]);
  else if (name == "AENO")
    stack[0] = stack[0] && eno;
  else if (name == "EU" || name == "ED") {
    const bool now = stack[0], before = edge_[&i];
    edge_[&i] = now;
    stack[0] = !firstScan && (name == "EU" ? now && !before : !now && before);
  } else
    return false;
  return true;
}

/// SR, RS: set on level 1, reset on top, which OUT replaces (001:2897-2908).
bool Interpreter::bistable(const Instruction& i, const std::string& name) {
  if (name != "SR" && name != "RS") return false;
  const bool reset = power(), set = stack[1] && scr_, old = readBit(i.operands[0]);
  const bool now = name == "SR" ? set || (!reset && old) : !reset && (set || old);
  writeBit(i.operands[0], now);
  pop();
  stack[0] = now;
  return true;
}

void Interpreter::joinResult(const std::string& joint, bool holds) {
  if (joint == "LD")
    push(holds);
  else if (joint == "A")
    stack[0] = stack[0] && holds;
  else
    stack[0] = stack[0] || holds;
}

/// Equal length and equal characters; a string that is too long or leaves its area stops the CPU (001:3417).
bool Interpreter::compareStrings(const Instruction& i, bool& equal) {
  const std::optional<std::string> a = stringAt(i.operands[0]), b = stringAt(i.operands[1]);
  if (!a || !b) return fatal("F0014");
  equal = *a == *b;
  return true;
}

bool Interpreter::compareInstruction(const Instruction& i, const std::string& name) {
  const std::size_t letters = name.find_first_of("<>=");
  if (letters == std::string::npos || letters < 2 || name.substr(0, 3) == "FND") return false;
  const std::string relation = name.substr(letters), joint = name.substr(0, letters - 1);
  const char type = name[letters - 1];
  if (!follow(i, *signatureOf(name))) return fatal("F0011");
  if (type == 'S') {
    bool equal = false;
    compareStrings(i, equal);
    if (!stopped) joinResult(joint, equal == (relation == "="));
    return true;
  }
  const int bytes = type == 'B' ? 1 : type == 'W' ? 2 : 4;
  const std::uint32_t x = read(i.operands[0], bytes), y = read(i.operands[1], bytes);
  // Bytes are unsigned, words, double words and REAL signed (001:3371); a double holds them all.
  const auto number = [&](std::uint32_t v) -> double {
    if (type == 'B') return v;
    if (type == 'W') return static_cast<std::int16_t>(v);
    if (type == 'R') return std::bit_cast<float>(v);
    return static_cast<std::int32_t>(v);
  };
  const double a = number(x), b = number(y);
  if (!std::isfinite(a) || !std::isfinite(b)) {
    if (!isSmart(program_.target)) return fatal("F0012");
    fail("000F");  // no comparison of an S7-200 SMART stops it
    joinResult(joint, false);
    return true;
  }
  joinResult(joint, relation == "="    ? a == b
                    : relation == "<>" ? a != b
                    : relation == "<"  ? a < b
                    : relation == "<=" ? a <= b
                    : relation == ">"  ? a > b
                                       : a >= b);
  return true;
}

// Table 6-73: TON and TONR run on to 32767, TOF stops at its preset; IEC boxes stop there too (001:6693-6706).
void Interpreter::timerBox(const Instruction& i, const std::string& name) {
  const std::uint32_t n = i.operands[0].offset;
  TimerState& t = timers_[n];
  const bool input = power(), rises = input && !t.input, wasCounting = t.counting;
  t.kind = name;
  t.preset = static_cast<std::int16_t>(read(i.operands[1], 2));
  const auto start = [&](bool bit) {
    timerBit[n] = bit;
    timer[n] = 0;
  };
  if (name.starts_with("TOF")) {
    if (!scr_) {  // in an inactive segment it stands at 0 and does not time (001:6575)
      start(false);
      t.counting = t.input = false;
    } else if (input) {
      start(true);
      t.counting = false;
    } else if (t.input) {
      t.counting = true;
    }
  } else if (name == "TP.IEC") {
    if (!t.counting && !input) start(false);
    if (!t.counting && rises) {
      start(true);
      t.counting = true;
    }
  } else {
    t.counting = input;
    if (name != "TONR" && !input) start(false);
  }
  t.input = input;
  // Only what passes after a timer was enabled counts (001:6590); each execution compares (001:6611).
  if (timerResolution(static_cast<int>(n)) == 100 && (scr_ || !name.starts_with("TOF")))
    refresh(-static_cast<int>(n), wasCounting ? ticks100_ : 0);
  if (!name.ends_with(".IEC")) return;
  if (i.operands.size() > 2) writeBit(i.operands[2], timerBit[n]);
  if (i.operands.size() > 3) write(i.operands[3], 2, static_cast<std::uint16_t>(timer[n]));
}

/// Positive: all timers of that resolution; negative: one timer by number.
void Interpreter::refresh(int resolution, int ticks) {
  for (auto& [n, t] : timers_) {
    if (resolution > 0 ? timerResolution(static_cast<int>(n)) != resolution
                       : n != static_cast<std::uint32_t>(-resolution))
      continue;
    if (!t.counting) continue;
    const int old = timer[n], sum = old + ticks;
    timer[n] = static_cast<std::int16_t>(sum > 32767 ? 32767 : sum);
    if (timer[n] < t.preset) continue;
    if (resolution > 0 && old < t.preset) expired.insert(n);
    const bool ends = t.kind.starts_with("TOF") || t.kind == "TP.IEC";
    timerBit[n] = !ends;
    if (ends) t.counting = false;
    if (ends || t.kind == "TON.IEC") timer[n] = static_cast<std::int16_t>(t.preset);
  }
}

// CTU: reset on top, count below; CTD: load on top; CTUD: reset, down, up from the top (001:3994-4004, 000:3378).
void Interpreter::counterBox(const Instruction& i, const std::string& name) {
  const std::uint32_t n = i.operands[0].offset;
  const int preset = static_cast<std::int16_t>(read(i.operands[1], 2));
  const bool control = stack[0] && scr_, second = stack[1] && scr_, third = stack[2] && scr_;
  auto& [up, down] = countInputs_[n];
  const bool upNow = name == "CTU" ? second : name == "CTUD" ? third : false;
  const bool downNow = name == "CTU" ? false : second;
  // The manual gives no rule for the first scan; the engine's default follows that of EU: no edge there.
  const bool risesUp = !firstScan && upNow && !up, risesDown = !firstScan && downNow && !down;
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

/// IEC counters stop at PV, and write their outputs (001:4090-4117). R has priority over LD by default.
void Interpreter::iecCounter(const Instruction& i, const std::string& name) {
  const std::uint32_t n = i.operands[0].offset;
  const int preset = static_cast<std::int16_t>(read(i.operands[1], 2));
  const auto level = [&](std::size_t k) { return stack[k] && scr_; };
  const bool both = name == "CTUD.IEC";
  const bool load = name == "CTU.IEC" ? false : level(0), reset = name == "CTU.IEC" ? level(0) : both && level(1);
  auto& [up, down] = countInputs_[n];
  const bool upNow = name == "CTU.IEC" ? level(1) : both && level(3),
             downNow = name == "CTD.IEC" ? level(1) : both && level(2);
  const bool rises = !firstScan && upNow && !up, falls = !firstScan && downNow && !down;
  up = upNow;
  down = downNow;
  int value = counter[n];
  if (rises && !falls && value < preset) ++value;
  if (falls && !rises && value > 0) --value;
  if (load) value = preset;
  if (reset) value = 0;
  counter[n] = static_cast<std::int16_t>(value);
  const bool full = both ? value == preset : value >= preset, empty = value == 0;
  counterBit[n] = name == "CTD.IEC" ? empty : full;
  const std::size_t flags = both ? 2 : 1;
  if (i.operands.size() > 2) writeBit(i.operands[2], counterBit[n]);
  if (both && i.operands.size() > 3) writeBit(i.operands[3], empty);
  if (i.operands.size() > 2 + flags) write(i.operands[2 + flags], 2, static_cast<std::uint16_t>(value));
}

/// S and R of N bits, all inside the area or none (001:2796); R of timers and counters clears their values.
void Interpreter::setOrReset(const Instruction& i, bool value, bool immediate) {
  const Operand& first = i.operands[0];
  const std::uint32_t count = read(i.operands[1], 1);
  const bool numbered = first.area == Area::T || first.area == Area::C;
  const std::uint32_t start = numbered ? first.offset : first.offset * 8 + first.bit;
  static const std::map<Area, std::uint32_t> bytes = {{Area::I, 16}, {Area::Q, 16},    {Area::M, 32},  {Area::S, 32},
                                                      {Area::L, 64}, {Area::V, 10240}, {Area::SM, 550}};
  if (start + count > (numbered ? 256 : bytes.at(first.area) * 8)) {
    fail("0091");
    return;
  }
  for (std::uint32_t at = start; at < start + count; ++at) {
    if (!numbered) {
      putBit(first.area, at / 8, at % 8, value);
      const auto mask = static_cast<std::uint8_t>(1U << at % 8);
      if (immediate)
        outputs[at / 8] = static_cast<std::uint8_t>(value ? outputs[at / 8] | mask : outputs[at / 8] & ~mask);
      continue;
    }
    (first.area == Area::T ? timerBit : counterBit)[at] = value;
    if (value) continue;
    (first.area == Area::T ? timer : counter)[at] = 0;
    const auto t = timers_.find(at);
    // A timer that runs off a signal needs a new edge (001:6586); the others go on from 0 while they are enabled.
    if (first.area == Area::T && t != timers_.end() &&
        (t->second.kind.starts_with("TOF") || t->second.kind == "TP.IEC"))
      t->second.counting = false;
  }
}

}  // namespace rungproof::naive
