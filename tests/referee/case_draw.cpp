// Drawing programs and properties.
#include "case_draw.hpp"

#include <algorithm>

namespace rungproof::referee {
namespace {

std::string listed(const std::vector<Network>& networks) {
  std::string text = "BEGIN\n";
  for (std::size_t n = 0; n < networks.size(); ++n) {
    text += "Network " + std::to_string(n + 1) + "\n";
    for (const std::string& line : networks[n]) text += line + "\n";
  }
  return text;
}

}  // namespace

std::string Case::text() const {
  std::string text;
  for (const Block& block : blocks) {
    text += block.head + "\n";
    if (&block == &blocks.front()) {
      for (const std::string& property : properties) text += "//@ " + property + "\n";
    }
    text += listed(block.networks) + block.tail + "\n";
  }
  return text;
}

CaseDraw::CaseDraw(std::uint64_t seed, const std::vector<Topic>& topics) : random_(seed), topics_(topics) {
  bits_ = {"M0.0", "M0.1", "Q0.0"};
  cells_ = {{'B', "MB1", {0, 1, 2, 3}}, {'B', "MB2", {0, 1, 2, 3}}};
}

std::string CaseDraw::attach(int event) {
  interrupts_ = true;
  if (routines_.size() < 2 && (routines_.empty() || random_.chance(50))) routines_.emplace_back();
  const int routine = random_.below(static_cast<int>(routines_.size()));
  actions_.push_back("DTCH " + std::to_string(event));
  routineActions_.push_back("DTCH " + std::to_string(event));
  return "ATCH INT_" + std::to_string(routine) + ", " + std::to_string(event);
}

void CaseDraw::use(Topic topic) {
  switch (topic) {
    case Topic::Edges: return edges();
    case Topic::Timed: return timed();
    case Topic::Receive: return reception();
    case Topic::Transmit: return transmission();
    case Topic::Network: return netRequest();
    case Topic::HighSpeed: return highSpeed();
    case Topic::Pulses: return pulses();
    case Topic::Clock: return clock();
    case Topic::SystemBits: return systemBits();
    case Topic::Timers: return timers();
    case Topic::Counters: return counters();
    case Topic::Ends: return ends();
    case Topic::Save: return save();
    case Topic::Masking: return masking();
  }
}

void CaseDraw::edges() {
  const int count = random_.between(1, 2);
  for (int n = 0; n < count; ++n)
    setup_.push_back(
        attach(hasHighSpeed_ ? 6 + random_.below(2) : 2 * inputs_[static_cast<std::size_t>(n)] + random_.below(2)));
  routineBits_.push_back("SM4.1");
}

void CaseDraw::timed() {
  const int which = random_.below(2);
  setup_.push_back("MOVB " + std::to_string(random_.any(std::vector<int>{1, 5, 10, 50, 100, 250})) + ", SMB" +
                   std::to_string(34 + which));
  setup_.push_back(attach(10 + which));
  routineBits_.push_back("SM4.2");
}

void CaseDraw::reception() {
  setup_.push_back("MOVB 16#09, SMB30");
  const int control = random_.any(std::vector<int>{0xB0, 0xB0, 0x90, 0xE0, 0xC0, 0xB4, 0x9C});
  const int most = random_.any(std::vector<int>{1, 2, 3, 5, 10});
  setup_.push_back("MOVB " + std::to_string(control) + ", SMB87");
  setup_.push_back("MOVB " + std::to_string(most) + ", SMB94");
  if ((control & 0x40) != 0) setup_.push_back("MOVB 2, SMB88");
  if ((control & 0x20) != 0) setup_.push_back("MOVB 10, SMB89");
  if ((control & 0x04) != 0) setup_.push_back("MOVW 5, SMW92");
  if (random_.chance(60)) setup_.push_back(attach(23));
  const std::string request = "RCV VB100, 0";
  switch (random_.below(3)) {
    case 0: setup_.push_back(request); break;
    case 1: networkOf({"LD " + input(), "EU", request}); break;
    default:
      networkOf({"LDB<> SMB86, 0", request});
      setup_.push_back(request);
      break;
  }
  routineActions_.push_back(request);
  cells_.push_back({'B', "VB100", {0, 1, 2, most}});
  cells_.push_back({'B', "VB101", {1, 2, 10, 83}});
  cells_.push_back({'B', "VB102", {1, 2, 10, 84}});
  cells_.push_back({'B', "SMB86", {0, 2, 32, 4, 34}});
  bits_.emplace_back("V101.0");
  routineBits_.emplace_back("SM86.5");
}

void CaseDraw::transmission() {
  setup_.push_back("MOVB 16#09, SMB30");
  setup_.push_back("MOVB " + std::to_string(random_.below(4)) + ", VB120");
  if (random_.chance(60)) setup_.push_back(attach(9));
  Network lines = {"LD " + input()};
  if (random_.chance(50)) lines.emplace_back("A SM4.5");
  if (random_.chance(50)) lines.emplace_back("EU");
  lines.emplace_back("XMT VB120, 0");
  networkOf(lines);
  routineActions_.emplace_back("XMT VB120, 0");
  bits_.emplace_back("SM4.5");
}

void CaseDraw::netRequest() {
  setup_.emplace_back("MOVB 2, SMB30");
  setup_.emplace_back("MOVB 2, VB201");
  setup_.emplace_back("MOVD &VB100, VD202");
  setup_.emplace_back("MOVB 2, VB206");
  Network lines = {"LD " + input()};
  for (const char* guard : {"AN V200.6", "AN V200.5", "EU"}) {
    if (random_.chance(40)) lines.emplace_back(guard);
  }
  lines.emplace_back(random_.chance(75) ? "NETR VB200, 0" : "NETW VB200, 0");
  networkOf(lines);
  for (const char* status : {"V200.7", "V200.6", "V200.5"}) bits_.emplace_back(status);
  cells_.push_back({'B', "VB207", {0, 1, 2, 83}});
  cells_.push_back({'B', "VB208", {0, 1, 2, 84}});
  cells_.push_back({'B', "VB200", {0, 0x40, 0x80, 0xA1}});
}

void CaseDraw::highSpeed() {
  hasHighSpeed_ = true;
  const int mode = random_.any(std::vector<int>{0, 0, 1, 3});
  inputs_ = {3, 4};
  setup_.emplace_back("MOVB 16#F8, SMB37");
  setup_.push_back("HDEF 0, " + std::to_string(mode));
  setup_.emplace_back("MOVD 0, SMD38");
  setup_.push_back("MOVD " + std::to_string(random_.any(std::vector<int>{2, 3, 10})) + ", SMD42");
  if (random_.chance(70)) setup_.push_back(attach(12));
  if (mode == 1 && random_.chance(70)) setup_.push_back(attach(28));
  if (mode == 3 && random_.chance(70)) setup_.push_back(attach(27));
  setup_.emplace_back("HSC 0");
  cells_.push_back({'D', "HC0", {0, 1, 2, 3, 10}});
  routineActions_.emplace_back("HSC 0");
}

void CaseDraw::pulses() {
  setup_.emplace_back("MOVB 16#85, SMB67");
  setup_.push_back("MOVW " + std::to_string(random_.any(std::vector<int>{100, 500, 20000})) + ", SMW68");
  setup_.push_back("MOVD " + std::to_string(random_.between(1, 6)) + ", SMD72");
  if (random_.chance(70)) setup_.push_back(attach(19));
  Network lines = {"LD " + input(), "A SM66.7"};
  lines.emplace_back("PLS 0");
  networkOf(lines);
  routineActions_.emplace_back("PLS 0");
  bits_.emplace_back("SM66.7");
}

void CaseDraw::clock() {
  networkOf({"LD " + std::string(random_.chance(50) ? "SM0.0" : input()), "TODR VB20"});
  cells_.push_back({'B', "VB23", {0, 0x11, 0x23, 0x24, 0x30}});
  cells_.push_back({'B', "VB24", {0, 0x30, 0x59, 0x60}});
  cells_.push_back({'B', "VB25", {0, 0x30, 0x59, 0x60, 0x0A}});
  cells_.push_back({'B', "VB27", {1, 2, 7, 8}});
}

void CaseDraw::systemBits() {
  static const std::vector<std::string> names = {"SM0.1", "SM0.2", "SM0.3", "SM0.4",
                                                 "SM0.5", "SM0.6", "SM0.7", "SM5.0"};
  for (int n = 0; n < 3; ++n) bits_.push_back(random_.any(names));
  static const std::vector<Cell> bytes = {{'B', "SMB28", {0, 5, 200}},  {'B', "SMB29", {0, 5, 200}},
                                          {'W', "SMW22", {1, 10, 500}}, {'W', "SMW26", {1, 10, 500}},
                                          {'B', "SMB9", {0, 4}},        {'W', "SMW220", {0, 1, 258}},
                                          {'B', "SMB225", {0, 1, 2}}};
  cells_.push_back(random_.any(bytes));
  cells_.push_back(random_.any(bytes));
}

void CaseDraw::timers() {
  static const std::vector<std::string> numbers = {"T37", "T33", "T32", "T38", "T97", "T96"};
  const int count = random_.between(1, 2);
  for (int n = 0; n < count; ++n) {
    const std::string& t = random_.any(numbers);
    if (std::find(bits_.begin(), bits_.end(), t) != bits_.end()) continue;
    Network lines = {(random_.chance(20) ? "LDN " + t : "LD " + (random_.chance(30) ? "SM0.0" : input()))};
    const std::string kind = random_.chance(75) ? "TON " : "TOF ";
    const int preset = random_.between(1, 4);
    lines.push_back(kind + t + ", " + std::to_string(preset));
    networkOf(lines);
    bits_.push_back(t);
    cells_.push_back({'W', t, {0, 1, 2, preset}});
    if (t == "T32" && random_.chance(60)) setup_.push_back(attach(21));
    if (t == "T96" && random_.chance(60)) setup_.push_back(attach(22));
  }
}

void CaseDraw::counters() {
  const std::string kind = random_.any(std::vector<std::string>{"CTU", "CTU", "CTD", "CTUD"});
  const int preset = random_.between(1, 3);
  Network lines = {"LD " + bit()};
  if (kind == "CTUD") lines.push_back("LD " + input());
  lines.push_back("LD " + (random_.chance(50) ? std::string("SM0.1") : bit()));
  lines.push_back(kind + " C1, " + std::to_string(preset));
  networkOf(lines);
  bits_.emplace_back("C1");
  cells_.push_back({'W', "C1", {0, 1, 2, preset}});
}

void CaseDraw::ends() {
  switch (random_.below(3)) {
    case 0: actions_.emplace_back("END"); break;
    case 1:
      actions_.emplace_back("STOP");
      routineActions_.emplace_back("STOP");
      break;
    default: networkOf({"LD " + input(), "MOVD 16#7FC00000, VD400", "LDR= VD400, 1.0", "= M0.3"}); break;
  }
}

void CaseDraw::save() {
  networkOf({"LD " + input(), "AN SM31.7", "MOVB 16#81, SMB31", "INCB MB3"});
  bits_.emplace_back("SM31.7");
  cells_.push_back({'B', "MB3", {0, 1, 2, 3}});
}

void CaseDraw::masking() {
  actions_.emplace_back("DISI");
  actions_.emplace_back("ENI");
  if (random_.chance(50)) {
    networkOf({"LD " + input(), "DISI"});
    networkOf({"LDN " + input(), "ENI"});
  } else {
    networkOf({"LD SM0.0", "DISI", "MOVB MB1, MB2", "ENI"});
  }
  bits_.emplace_back("SM4.4");
}

std::string CaseDraw::bit() { return random_.chance(30) ? input() : random_.any(bits_); }

std::string CaseDraw::comparison(const std::string& joint) {
  static const std::vector<std::string> relations = {"=", "=", ">=", "<=", "<>", ">", "<"};
  const Cell& cell = random_.any(cells_);
  return joint + cell.width + random_.any(relations) + " " + cell.address + ", " +
         std::to_string(random_.any(cell.values));
}

Network CaseDraw::condition(bool inMain) {
  Network lines;
  if (!inMain && !routineBits_.empty() && random_.chance(25)) {
    lines.push_back("LD " + random_.any(routineBits_));
  } else if (random_.chance(inMain ? 12 : 45)) {
    lines.emplace_back("LD SM0.0");
  } else {
    lines.push_back(random_.chance(40) ? comparison("LD") : (random_.chance(25) ? "LDN " : "LD ") + bit());
  }
  for (int n = random_.any(std::vector<int>{0, 0, 0, 1, 1, 2}); n > 0; --n) {
    if (random_.chance(40))
      lines.push_back(comparison(random_.chance(70) ? "A" : "O"));
    else
      lines.push_back(random_.any(std::vector<std::string>{"A ", "AN ", "O ", "A "}) + bit());
  }
  if (inMain && random_.chance(15)) lines.emplace_back(random_.chance(70) ? "EU" : "ED");
  return lines;
}

std::string CaseDraw::action(bool inMain) {
  const std::vector<std::string>& own = inMain ? actions_ : routineActions_;
  if (!own.empty() && random_.chance(20)) return random_.any(own);
  switch (random_.below(inMain ? 9 : 6)) {
    case 0: return "S M0." + std::to_string(random_.below(3)) + ", 1";
    case 1: return "R M0." + std::to_string(random_.below(3)) + ", 1";
    case 2: return "INCB MB1";
    case 3: return random_.chance(50) ? "INCB MB2" : "MOVB " + std::to_string(random_.below(3)) + ", MB1";
    case 4: {
      const Cell& cell = random_.any(cells_);
      return cell.width == 'B' ? "MOVB " + cell.address + ", MB2" : std::string("INCB MB1");
    }
    case 5: return "= M0." + std::to_string(random_.below(3));
    default: return random_.chance(60) ? "= Q0.0" : "= Q0.1";
  }
}

Network CaseDraw::rung(bool inMain) {
  Network lines = condition(inMain);
  lines.push_back(action(inMain));
  if (random_.chance(30)) lines.push_back(action(inMain));
  return lines;
}

Case CaseDraw::program() {
  std::vector<Topic> chosen;
  for (int n = random_.between(1, 3); n > 0; --n) {
    const Topic topic = random_.any(topics_);
    if (std::find(chosen.begin(), chosen.end(), topic) == chosen.end()) chosen.push_back(topic);
  }
  std::sort(chosen.begin(), chosen.end(),
            [](Topic a, Topic b) { return (a == Topic::HighSpeed) > (b == Topic::HighSpeed); });
  // One port, one protocol.
  const auto has = [&](Topic t) { return std::find(chosen.begin(), chosen.end(), t) != chosen.end(); };
  if (has(Topic::Network)) std::erase_if(chosen, [](Topic t) { return t == Topic::Receive || t == Topic::Transmit; });
  for (const Topic topic : chosen) use(topic);
  if (interrupts_ && random_.chance(85)) setup_.emplace_back("ENI");
  for (int n = random_.between(1, 3); n > 0; --n) networkOf(rung(true));
  for (std::size_t n = main_.size(); n > 1; --n)
    std::swap(main_[n - 1], main_[static_cast<std::size_t>(random_.below(static_cast<int>(n)))]);
  Case drawn;
  Block main = {"ORGANIZATION_BLOCK MAIN:OB1", "END_ORGANIZATION_BLOCK", {}};
  if (!setup_.empty()) {
    Network first = {"LD SM0.1"};
    first.insert(first.end(), setup_.begin(), setup_.end());
    main.networks.push_back(first);
  }
  main.networks.insert(main.networks.end(), main_.begin(), main_.end());
  drawn.blocks.push_back(main);
  for (std::size_t n = 0; n < routines_.size(); ++n) {
    Block block = {"INTERRUPT_BLOCK INT_" + std::to_string(n) + ":INT" + std::to_string(n), "END_INTERRUPT_BLOCK", {}};
    for (int k = random_.between(1, 2); k > 0; --k) block.networks.push_back(rung(false));
    if (random_.chance(15)) block.networks.insert(block.networks.begin() + 1, {"LD " + bit(), "CRETI"});
    drawn.blocks.push_back(block);
  }
  // What is read is written somewhere, so that less of the program is dead.
  for (const char* name : {"M0.0", "M0.1", "Q0.0"}) {
    text_ = drawn.text();
    const std::string written = text_ + "\n";
    if (text_.find(name) == std::string::npos || written.find("= " + std::string(name)) != std::string::npos ||
        written.find("S " + std::string(name)) != std::string::npos)
      continue;
    Block& block = drawn.blocks[static_cast<std::size_t>(random_.below(static_cast<int>(drawn.blocks.size())))];
    Network lines = condition(&block == &drawn.blocks.front());
    lines.push_back((random_.chance(50) ? "= " : "S ") + std::string(name));
    if (lines.back()[0] == 'S') lines.back() += ", 1";
    block.networks.push_back(lines);
  }
  text_ = drawn.text();
  return drawn;
}

std::string CaseDraw::atom() {
  for (int tries = 0; tries < 20; ++tries) {
    if (random_.chance(50)) {
      const std::string& name = random_.chance(30) ? std::string("Q0.0") : random_.any(bits_);
      if (text_.find(" " + name) == std::string::npos ||
          (name.compare(0, 2, "SM") == 0 && name.compare(0, 3, "SM0") != 0))
        continue;
      return random_.chance(25) ? "not " + name : name;
    }
    const Cell& cell = random_.any(cells_);
    if (cell.address.compare(0, 2, "SM") == 0 || text_.find(cell.address) == std::string::npos) continue;
    const std::string address =
        cell.address[0] == 'T' || cell.address[0] == 'C' ? cell.address + ".value" : cell.address;
    return address + random_.any(std::vector<std::string>{" = ", " <= ", " >= ", " <> "}) +
           std::to_string(random_.any(cell.values));
  }
  return input();
}

std::string CaseDraw::propertyTerm() {
  const std::string one = atoms_.empty() || random_.chance(10) ? atom() : random_.any(atoms_);
  switch (random_.below(10)) {
    case 0: return "prev(" + one + ")";
    case 1: return "once(" + one + ")";
    case 2: return "rises(" + one + ")";
    case 3: return "not once(" + one + ")";
    default: return one.compare(0, 3, "not") == 0 ? "(" + one + ")" : one;
  }
}

std::string CaseDraw::property(int number) {
  const std::string name = "p" + std::to_string(number) + ": ";
  switch (random_.below(9)) {
    case 0: return "reach " + name + propertyTerm();
    case 1:
    case 2: return "reach " + name + propertyTerm() + " and " + propertyTerm();
    case 3: return "prove " + name + "never " + propertyTerm();
    case 4: return "prove " + name + "never " + propertyTerm() + " and " + propertyTerm();
    case 5: return "prove " + name + propertyTerm() + " implies " + propertyTerm();
    case 6: return "prove " + name + propertyTerm() + " and " + propertyTerm() + " implies " + propertyTerm();
    case 7: return "prove " + name + propertyTerm() + " only after " + propertyTerm();
    default: return "prove " + name + propertyTerm() + " or " + propertyTerm() + " or " + propertyTerm();
  }
}

}  // namespace rungproof::referee
