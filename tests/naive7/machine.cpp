// The naive interpreter's bit logic, loads and transfers, jumps, blocks and their calls.
#include "tests/naive7/machine.hpp"

#include <utility>

namespace naive7 {

Machine::Machine(const Program& program, bool isS7400)
    : inputs(128),
      outputs(128),
      memory(8192),
      peripheralIn(1024),
      peripheralOut(1024),
      dataBlocks(program.dataBlocks),
      program_(&program),
      is400_(isS7400) {}

std::string Machine::statusText() const {
  std::string text;
  for (bool bit : {br, cc1, cc0, ov, os, orBit, sta, rlo, fc}) text += bit ? '1' : '0';
  return text;
}

void Machine::setStatus(const std::string& nine) {
  bool* bits[] = {&br, &cc1, &cc0, &ov, &os, &orBit, &sta, &rlo, &fc};
  for (std::size_t i = 0; i < 9; ++i) *bits[i] = nine[i] == '1';
}

void Machine::run(const std::string& block) {
  const auto found = program_->blocks.find(block);
  if (found == program_->blocks.end()) throw Stop{block.starts_with("FB") ? 0x3E : 0x3C, "no block " + block};
  runStatements(found->second);
}

void Machine::runStatements(const Block& block) {
  frames_.clear();
  steps_ = 0;
  running_ = 1;
  frames_.emplace_back();
  frame().block = &block;
  std::size_t next = 0;
  while (next < block.statements.size()) {
    const Statement& s = block.statements[next++];
    if (!step(s, next)) break;
  }
}

void Machine::enter(const Block& block, int instance, std::uint32_t base,
                    const std::map<std::string, Place>& references) {
  const int savedDb = db, savedDi = di;
  if (frames_.size() >= (is400_ ? 24U : 8U)) throw Stop{0xFF, "blocks nested too deep"};
  frames_.emplace_back();
  frame().block = &block;
  frame().instance = instance;
  frame().base = base;
  frame().references = references;
  if (instance != 0) {
    db = savedDi;  // CALL exchanges the registers around an FB
    di = instance;
  }
  os = orBit = fc = false;
  sta = true;
  std::size_t next = 0;
  while (next < block.statements.size()) {
    const Statement& s = block.statements[next++];
    if (!step(s, next)) break;
  }
  os = orBit = fc = false;
  sta = true;
  frames_.pop_back();
  db = instance != 0 ? instance : savedDb;
  di = savedDi;
}

void Machine::call(const Statement& s) {
  std::string target = s.operand, instanceText;
  if (const std::size_t comma = target.find(','); comma != std::string::npos) {
    instanceText = target.substr(comma + 1);
    target = target.substr(0, comma);
  }
  if (const std::size_t open = target.find('['); open != std::string::npos) {  // FC[MW10]
    target = target.substr(0, open) + std::to_string(read(place(target.substr(open + 1, target.size() - open - 2))));
  }
  int instance = 0;
  std::uint32_t base = 0;
  if (target.starts_with("#")) {  // a multi-instance
    for (const Variable& v : frame().block->variables) {
      if (v.name != target.substr(1)) continue;
      const Place p = local(v.name);
      instance = p.number;
      base = p.bit;
      target = v.type;
      break;
    }
  } else if (!instanceText.empty()) {
    instance = std::atoi(instanceText.c_str() + 2);
    if (!dataBlocks.contains(instance)) throw Stop{0x3A, "no instance block"};
  }
  if (systemBlock(target, s)) {
    if (instance != 0) db = instance;
    return;
  }
  const auto found = program_->blocks.find(target);
  if (found == program_->blocks.end()) throw Stop{target.starts_with("FB") ? 0x3E : 0x3C, "no block " + target};
  const Block& block = found->second;
  std::map<std::string, Place> references;
  std::vector<std::pair<Place, std::uint8_t>> handed;  // bytes of pointers, and where they go
  std::uint32_t nextPointer = 900 * 8;                 // in the local data of this block, behind all that it uses
  std::vector<std::pair<Place, Place>> results;        // from the instance to the actual parameter
  for (const auto& [name, actual] : s.actuals) {
    for (const Variable& v : block.variables) {
      if (v.name != name) continue;
      Place outside;
      if (v.type == "ANY" || v.type == "POINTER") {
        Place inside;
        inside.area = block.name.starts_with("FB") ? 'D' : 'L';
        inside.number = inside.area == 'D' ? instance : static_cast<int>(frames_.size()) - 1;
        inside.bit = inside.area == 'D' ? base + v.bit : nextPointer;
        nextPointer += 80;
        inside.width = widthOfType(v.type);
        if (inside.area == 'L') references[name] = inside;
        for (std::uint8_t byte : handedBytes(actual, v.type == "ANY")) {
          inside.width = 8;
          handed.emplace_back(inside, byte);
          inside.bit += 8;
        }
        continue;
      }
      if (v.type == "TIMER" || v.type == "COUNTER") {
        outside.isConstant = true;
        outside.value = static_cast<std::uint32_t>(objectNumber(actual, v.type[0]));
      } else if (isConstantText(actual)) {
        outside.isConstant = true;
        outside.value = constantValue(actual);
        outside.width = widthOfType(v.type);
      } else if (actual == "TRUE" || actual == "FALSE") {
        outside.isConstant = true;
        outside.value = actual == "TRUE" ? 1 : 0;
        outside.width = 1;
      } else {
        outside = place(actual);
      }
      if (!block.name.starts_with("FB")) {
        references[name] = outside;
        continue;
      }
      Place inside;
      inside.area = 'D';
      inside.number = instance;
      inside.bit = base + v.bit;
      inside.width = widthOfType(v.type);
      if (v.section == Section::In || v.section == Section::InOut) write(inside, read(outside));
      if (v.section == Section::Out || v.section == Section::InOut) results.emplace_back(inside, outside);
    }
  }
  for (const auto& [inside, byte] : handed) write(inside, byte);
  if (!handed.empty()) accu[0] = accu[1] = ar[0] = 0;  // the statements that make pointers use them
  enter(block, instance, base, references);
  for (const auto& [inside, outside] : results) write(outside, read(inside));
}

void Machine::interrupt(int block) {
  const auto source = program_->blocks.find("OB" + std::to_string(block));
  if (block <= running_ || source == program_->blocks.end()) return;
  const Block& found = source->second;
  const int interrupted = std::exchange(running_, block);
  const std::string status = statusText();
  const std::vector<std::uint32_t> registers = {accu[0], accu[1], accu[2], accu[3], ar[0], ar[1]};
  const int savedDb = db, savedDi = di;
  std::vector<Frame> frames = std::move(frames_);
  setStatus("000000000");
  for (std::uint32_t& each : accu) each = 0;
  ar[0] = ar[1] = 0;
  db = di = 0;
  frames_.clear();
  frames_.emplace_back();
  frame().block = &found;
  std::size_t next = 0;
  while (next < found.statements.size()) {
    const Statement& s = found.statements[next++];
    if (!step(s, next)) break;
  }
  frames_ = std::move(frames);
  running_ = interrupted;
  setStatus(status);
  for (std::size_t i = 0; i < 4; ++i) accu[i] = registers[i];
  ar[0] = registers[4];
  ar[1] = registers[5];
  db = savedDb;
  di = savedDi;
}

bool Machine::step(const Statement& s, std::size_t& next) {
  if (++steps_ > 2000000) throw Stop{0xFF, "endless program"};
  const std::string& op = s.op;
  if (op == "@") return mark(), true;
  if (op == "BLD" && (s.operand == "235" || s.operand == "240")) return interrupt(std::stoi(s.operand) - 200), true;
  if (op == "BE" || op == "BEU") return false;
  if (op == "BEC") {
    const bool isEnd = rlo;
    endString();
    sta = rlo = true;
    return !isEnd;
  }
  if (jump(s, next)) return true;
  if (bitStatement(s) || loadStatement(s) || timerStatement(s) || blockStatement(s) || wordStatement(s)) return true;
  throw Stop{0xFF, "no statement: " + op + " " + s.operand};
}

bool Machine::jump(const Statement& s, std::size_t& next) {
  const std::string& op = s.op;
  if (op != "LOOP" && (op.empty() || op[0] != 'J')) return false;
  const auto found = frame().block->labels.find(s.operand);
  if (found == frame().block->labels.end()) throw Stop{0xFF, "no label " + s.operand};
  const bool isZero = !cc1 && !cc0, isPlus = cc1 && !cc0, isMinus = !cc1 && cc0;
  bool take = false;
  if (op == "JU") take = true;
  if (op == "JC" || op == "JCB") take = rlo;
  if (op == "JCN" || op == "JNB") take = !rlo;
  if (op == "JBI") take = br;
  if (op == "JNBI") take = !br;
  if (op == "JO") take = ov;
  if (op == "JOS") take = os, os = false;
  if (op == "JZ") take = isZero;
  if (op == "JN") take = isPlus || isMinus;
  if (op == "JP") take = isPlus;
  if (op == "JM") take = isMinus;
  if (op == "JPZ") take = isPlus || isZero;
  if (op == "JMZ") take = isMinus || isZero;
  if (op == "JUO") take = cc1 && cc0;
  if (op == "LOOP") {
    const std::uint32_t rest = (accu[0] - 1) & 0xFFFF;
    accu[0] = (accu[0] & 0xFFFF0000U) | rest;
    take = rest != 0;
  }
  if (op == "JCB" || op == "JNB") br = rlo;
  if (op == "JC" || op == "JCN" || op == "JCB" || op == "JNB") {
    endString();
    sta = rlo = true;
  }
  if (op == "JBI" || op == "JNBI") {
    endString();
    sta = true;
  }
  if (op == "JL") {
    const std::size_t entry = accu[0] & 0xFF, entries = found->second - next;
    next = entry < entries ? next + entry : found->second;
    return true;
  }
  if (take) next = found->second;
  return true;
}

bool Machine::operandBit(const std::string& operand) {
  if (operand == "BR") return br;
  if (operand == "OV") return ov;
  if (operand == "OS") return os;
  if (operand == "UO") return cc1 && cc0;
  if (operand == "==0") return !cc1 && !cc0;
  if (operand == "<>0") return cc1 != cc0;
  if (operand == ">0") return cc1 && !cc0;
  if (operand == "<0") return !cc1 && cc0;
  if (operand == ">=0") return !cc0;
  if (operand == "<=0") return !cc1;
  if (operand[0] == 'T' && operand != "TRUE") return timerBit(objectNumber(operand, 'T'));
  if (operand[0] == 'C') {
    const auto found = counters.find(objectNumber(operand, 'C'));
    return found != counters.end() && found->second.value > 0;
  }
  if (operand[0] == '#') {
    for (const Variable& v : frame().block->variables) {
      if (v.name != operand.substr(1)) continue;
      if (v.type == "TIMER") return timerBit(objectNumber(operand, 'T'));
      if (v.type == "COUNTER") return counters[objectNumber(operand, 'C')].value > 0;
    }
  }
  openFor(operand);
  return read(place(operand)) != 0;
}

/// A bit combined with the logic string so far.
static void combine(const std::string& kind, bool value, bool r, bool o, bool f, bool& rlo, bool& orBit) {
  if (kind[0] == 'A') {
    rlo = ((r || !f) && value) || (o && f);
    orBit = o && f;
  } else if (kind[0] == 'O') {
    rlo = (r && f) || value;
    orBit = false;
  } else {
    rlo = (r && f) != value;
    orBit = false;
  }
}

bool Machine::relayOff() {
  if (!frame().relayActive) return false;
  for (bool on : frame().relay) {
    if (!on) return true;
  }
  return false;
}

bool Machine::bitStatement(const Statement& s) {
  const std::string& op = s.op;
  const bool isScan = op == "A" || op == "AN" || op == "O" || op == "ON" || op == "X" || op == "XN";
  if (op == "O" && s.operand.empty()) {
    const bool o = (rlo || orBit) && fc, f = rlo && fc;
    orBit = o;
    fc = f;
    sta = true;
    return true;
  }
  if (isScan) {
    sta = operandBit(s.operand);
    combine(op, op.back() == 'N' ? !sta : sta, rlo, orBit, fc, rlo, orBit);
    fc = true;
    return true;
  }
  if (op == "A(" || op == "AN(" || op == "O(" || op == "ON(" || op == "X(" || op == "XN(") {
    frame().nesting.push_back({op, rlo, orBit, fc});
    endString();
    sta = true;
    return true;
  }
  if (op == ")") {
    if (frame().nesting.empty()) throw Stop{0xFF, ") without ("};
    const Nested n = frame().nesting.back();
    frame().nesting.pop_back();
    const bool value = n.kind.size() == 3 ? !rlo : rlo;
    combine(n.kind, value, n.rlo, n.isOr, n.first, rlo, orBit);
    fc = sta = true;
    return true;
  }
  if (op == "=" || ((op == "S" || op == "R") && s.operand[0] != 'T' && s.operand[0] != 'C')) {
    bool isBit = true;  // of a counter or timer parameter R and S do not speak of a bit
    if (s.operand[0] == '#') {
      for (const Variable& v : frame().block->variables) {
        if (v.name == s.operand.substr(1) && (v.type == "TIMER" || v.type == "COUNTER")) isBit = false;
      }
    }
    if (!isBit) return false;
    openFor(s.operand);
    const Place p = place(s.operand);
    if (op == "=") {
      sta = rlo && !relayOff();
      write(p, sta ? 1 : 0);
    } else if (rlo && !relayOff()) {
      sta = op == "S";
      write(p, sta ? 1 : 0);
    } else {
      sta = read(p) != 0;
    }
    endString();
    return true;
  }
  if (op == "FP" || op == "FN") {
    openFor(s.operand);
    const Place p = place(s.operand);
    const bool old = read(p) != 0, now = rlo;
    write(p, now ? 1 : 0);
    rlo = op == "FP" ? now && !old : !now && old;
    orBit = false;
    sta = now;
    fc = true;
    return true;
  }
  if (op == "NOT") {
    rlo = !rlo;
    sta = true;
    return true;
  }
  if (op == "SET" || op == "CLR") {
    rlo = sta = op == "SET";
    endString();
    return true;
  }
  if (op == "SAVE") {
    br = rlo;
    return true;
  }
  return false;
}

void Machine::load(std::uint32_t value) {
  accu[1] = accu[0];
  accu[0] = value;
}

bool Machine::loadStatement(const Statement& s) {
  const std::string& op = s.op;
  const std::string& o = s.operand;
  if (op == "L") {
    if (o == "STW") {
      std::uint32_t value = 0;
      for (bool bit : {br, cc1, cc0, ov, os, orBit && is400_, sta && is400_, rlo, fc && is400_}) {
        value = value << 1 | (bit ? 1U : 0U);
      }
      return load(value), true;
    }
    if (o.starts_with("P##")) return load(addressOfParameter(o.substr(3))), true;
    if (o == "DBNO") return load(static_cast<std::uint32_t>(db)), true;
    if (o == "DINO") return load(static_cast<std::uint32_t>(di)), true;
    if (o == "DBLG") return load(static_cast<std::uint32_t>(dataBlocks[db].size())), true;
    if (o == "DILG") return load(static_cast<std::uint32_t>(dataBlocks[di].size())), true;
    if (isConstantText(o)) return load(constantValue(o)), true;
    bool isObject = o[0] == 'T' || o[0] == 'C';
    if (o[0] == '#') {
      for (const Variable& v : frame().block->variables) {
        if (v.name == o.substr(1) && (v.type == "TIMER" || v.type == "COUNTER")) isObject = true;
      }
    }
    if (isObject) return false;
    openFor(o);
    return load(read(place(o))), true;
  }
  if (op == "T") {
    if (o == "STW") {
      const std::uint32_t v = accu[0];
      br = v >> 8 & 1, cc1 = v >> 7 & 1, cc0 = v >> 6 & 1, ov = v >> 5 & 1, os = v >> 4 & 1, rlo = v >> 1 & 1;
      if (is400_) orBit = v >> 3 & 1, sta = v >> 2 & 1, fc = v & 1;
      return true;
    }
    openFor(o);
    write(place(o), relayOff() ? 0 : accu[0]);
    return true;
  }
  if (op == "LAR1" || op == "LAR2") {
    std::uint32_t& target = ar[op[3] - '1'];
    if (o.empty()) {
      target = accu[0];
    } else if (o == "AR2") {
      target = ar[1];
    } else {
      target = isConstantText(o) ? constantValue(o) : read(place(o));
    }
    return true;
  }
  if (op == "TAR1" || op == "TAR2") {
    const std::uint32_t value = ar[op[3] - '1'];
    if (o.empty()) {
      load(value);
    } else if (o == "AR2") {
      ar[1] = value;
    } else {
      write(place(o), value);
    }
    return true;
  }
  if (op == "CAR") return std::swap(ar[0], ar[1]), true;
  if (op == "+AR1" || op == "+AR2") {
    std::uint32_t& target = ar[op[3] - '1'];
    const std::uint32_t added =
        o.empty() ? static_cast<std::uint32_t>(static_cast<std::int16_t>(accu[0] & 0xFFFF)) : constantValue(o);
    target = (target & 0xFF000000U) | ((target + added) & 0x00FFFFFFU);
    return true;
  }
  if (op == "TAK") return std::swap(accu[0], accu[1]), true;
  if (op == "PUSH") {
    if (is400_) accu[3] = accu[2], accu[2] = accu[1];
    accu[1] = accu[0];
    return true;
  }
  if (op == "POP") {
    accu[0] = accu[1];
    if (is400_) accu[1] = accu[2], accu[2] = accu[3];
    return true;
  }
  if (op == "ENT") return accu[3] = accu[2], accu[2] = accu[1], true;
  if (op == "LEAVE") return accu[1] = accu[2], accu[2] = accu[3], true;
  return op == "NOP 0" || op == "NOP 1" || op == "BLD";
}

bool Machine::blockStatement(const Statement& s) {
  const std::string& op = s.op;
  const std::string& o = s.operand;
  if (op == "CALL" || op == "UC") return call(s), true;
  if (op == "CC") {
    const bool take = rlo;
    os = false;
    endString();
    sta = rlo = true;
    if (take) call(s);
    return true;
  }
  if (op == "OPN") {
    int number = std::atoi(o.c_str() + 2);
    if (o[2] == '[') number = static_cast<int>(read(place(o.substr(3, o.size() - 4))));
    if (o[0] == '#') number = static_cast<int>(local(o.substr(1)).value);
    if (number != 0 && !dataBlocks.contains(number)) throw Stop{0x3A, "no data block"};  // 0: none is open
    (o[1] == 'I' ? di : db) = number;
    return true;
  }
  if (op == "CDB") return std::swap(db, di), true;
  if (op == "MCRA" || op == "MCRD") return frame().relayActive = op == "MCRA", true;
  if (op == "MCR(" || op == ")MCR") {
    if (op == "MCR(") {
      frame().relay.push_back(rlo);
    } else {
      if (frame().relay.empty()) throw Stop{0xFF, ")MCR without MCR("};
      frame().relay.pop_back();
    }
    endString();
    sta = true;
    return true;
  }
  return false;
}

}  // namespace naive7
