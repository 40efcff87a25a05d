// The table, and the look back from a call to what prepares its inputs.
#include "analysis/flow/library_use.hpp"

#include <algorithm>
#include <array>

#include "analysis/flow/pulse_bits.hpp"
#include "ir/s7200/special_memory.hpp"

namespace rungproof {

namespace {

using enum LibraryRun;

constexpr std::string_view modbusMaster = "the Modbus master", secondMaster = "the second Modbus master",
                           ussPort = "the USS port", modem = "the modem module", pulseTrain = "the pulse output",
                           positioning = "the positioning module", axis = "the axis";

// clang-format off
constexpr LibraryUse uses[] = {
    {"PTOx_CTRL", EveryScan, {}, true, false, "001:8205"},
    {"PTOx_RUN", Request, pulseTrain, false, true, "001:8231"},
    {"PTOx_LDPOS", Request, pulseTrain, false, true, "001:8291"},
    {"POSx_CTRL", EveryScan, {}, true, false, "001:8599"},
    {"POSx_GOTO", Request, positioning, false, true, "001:8678"},
    {"POSx_RUN", Request, positioning, false, true, "001:8719"},
    {"POSx_RSEEK", Request, positioning, false, true, "001:8756"},
    {"POSx_LDOFF", Request, positioning, false, true, "001:8781"},
    {"POSx_LDPOS", Request, positioning, false, true, "001:8802"},
    {"POSx_SRATE", Request, positioning, false, true, "001:8828"},
    {"POSx_CLR", Request, positioning, false, true, "001:8866"},
    {"POSx_CFG", Request, positioning, false, true, "001:8886"},
    {"MODx_CTRL", EveryScan, {}, true, false, "001:9687"},
    {"MODx_XFR", Request, modem, false, true, "001:9703"},
    {"MODx_MSG", Request, modem, false, true, "001:9727"},
    {"USS_INIT", Once, {}, false, false, "001:10105"},
    {"USS_CTRL", EveryScan, {}, false, false, "001:10149"},
    {"USS_RPM_W", Request, ussPort, false, false, "001:10252"},
    {"USS_RPM_D", Request, ussPort, false, false, "001:10252"},
    {"USS_RPM_R", Request, ussPort, false, false, "001:10252"},
    {"USS_WPM_W", Request, ussPort, false, false, "001:10285"},
    {"USS_WPM_D", Request, ussPort, false, false, "001:10285"},
    {"USS_WPM_R", Request, ussPort, false, false, "001:10285"},
    {"MBUS_INIT", Once, {}, false, false, "001:10726"},
    {"MBUS_SLAVE", EveryScan, {}, true, false, "001:10773"},
    {"RCPx_WRITE", Once, {}, false, false, "001:11056"},
    {"DATx_WRITE", Once, {}, false, false, "001:11251"},
    {"MBUS_CTRL", EveryScan, {}, true},
    {"MBUS_CTRL_Px", EveryScan, {}, true},
    {"MBUS_MSG_Px", Request, modbusMaster},
    {"MB_CTRL2", EveryScan, {}, true},
    {"MBUS_MSG", Request, modbusMaster},
    {"MB_MSG2", Request, secondMaster},
    {"MBUS_SERVER", EveryScan},
    {"PIDx_CTRL", EveryScan, {}, true},
    {"AXISx_CTRL", EveryScan, {}, true},
    {"AXISx_GOTO", Request, axis, false, true},
    {"AXISx_RUN", Request, axis, false, true},
    {"AXISx_RSEEK", Request, axis, false, true},
    {"AXISx_LDOFF", Request, axis, false, true},
    {"AXISx_LDPOS", Request, axis, false, true},
    {"AXISx_SRATE", Request, axis, false, true},
    {"AXISx_CFG", Request, axis, false, true},
};
// clang-format on

constexpr int mostDepth = 4;  ///< of coils behind coils that are looked at

bool isCalledSo(std::string_view pattern, std::string_view name) {
  return pattern.size() == name.size() && std::equal(pattern.begin(), pattern.end(), name.begin(), [](char p, char n) {
           const char big = n >= 'a' && n <= 'z' ? static_cast<char>(n - 'a' + 'A') : n;
           return p == 'x' ? n >= '0' && n <= '9' : p == big;
         });
}

bool isSameBit(const Operand& a, const Operand& b) {
  return a.kind == OperandKind::Direct && b.kind == OperandKind::Direct && a.area == b.area && a.offset == b.offset &&
         a.bit == b.bit && a.width == Width::Bit && b.width == Width::Bit;
}

/// Always on, or a clock.
bool isSteady(const Operand& bit) {
  constexpr const SystemBits& bits = s7200SystemBits;
  return std::ranges::any_of(std::array{bits.alwaysOn, bits.minuteClock, bits.secondClock, bits.scanClock},
                             [&](const SystemBit& steady) { return isBit(bit, steady); });
}

}  // namespace

const LibraryUse* libraryUseNamed(std::string_view name) {
  for (const LibraryUse& use : uses) {
    if (isCalledSo(use.name, name)) return &use;
  }
  return nullptr;
}

std::vector<LibraryCall> libraryCalls(const Facts& facts) {
  std::vector<LibraryCall> calls;
  for (const CallSite& site : facts.calls().sites()) {
    const Instruction& call = *site.instruction;
    if (call.operands.empty() || !facts.execution().at(call.id).isReachable ||
        facts.execution().runs(site.caller) == Runs::Never)
      continue;
    std::string name = call.operands[0].text;
    if (site.callee != noBlock) {
      const Pou& callee = facts.program().pous[site.callee];
      const bool hasText =
          std::ranges::any_of(callee.networks, [](const Network& n) { return !n.instructions.empty(); });
      if (hasText) continue;  // a block of the user's that is called so
      name = callee.name;
    }
    if (const LibraryUse* use = libraryUseNamed(name)) calls.push_back({&call, use, std::move(name)});
  }
  return calls;
}

CallInputs::CallInputs(const Facts& facts) : facts_(facts), pulses_(pulseBits(facts)) {}

const Instruction* CallInputs::coilBefore(const Instruction& call, const Operand& bit) const {
  const InstructionPlace& place = facts_.place(call.id);
  const Flow& flow = facts_.flowOf(call.id);
  for (std::uint32_t at = place.step; at > 0 && flow.steps[at - 1].network == place.network; --at) {
    const Instruction& earlier = *flow.steps[at - 1].instruction;
    if (isCoil(roleOf(earlier)) && !earlier.operands.empty() && isSameBit(earlier.operands[0], bit)) return &earlier;
  }
  return nullptr;
}

Condition CallInputs::enable(const Instruction& call) const {
  const Condition known = facts_.conditionOf(call.id);
  const auto rung = rungOf(call);
  if (rung.size() != 1 || rung[0]->desc->negated || rung[0]->operands.empty()) return known;
  return static_cast<Condition>(known | bit(call, rung[0]->operands[0]));
}

Condition CallInputs::bit(const Instruction& call, const Operand& bit) const {
  if (bit.kind != OperandKind::Direct) return 0;
  if (const Instruction* coil = coilBefore(call, bit)) {
    const Condition flow = facts_.stack().at(coil->id).flow;
    const auto rung = rungOf(*coil);
    // The rung of the coil may be one contact of a bit that another coil has prepared.
    if (flow != 0 || rung.size() != 1 || rung[0]->desc->negated || rung[0]->operands.empty()) return flow;
    return isSameBit(rung[0]->operands[0], bit) ? Condition{0} : this->bit(*coil, rung[0]->operands[0]);
  }
  return conditionOf(bit, false, pulses_);
}

std::vector<const Instruction*> CallInputs::rungOf(const Instruction& output) const {
  const InstructionPlace& place = facts_.place(output.id);
  const Flow& flow = facts_.flowOf(output.id);
  std::vector<const Instruction*> rung;
  for (std::uint32_t at = place.step; at > 0 && flow.steps[at - 1].network == place.network; --at) {
    const Instruction& earlier = *flow.steps[at - 1].instruction;
    if (!isLogic(roleOf(earlier))) {
      if (!rung.empty()) break;
      continue;
    }
    rung.push_back(&earlier);
  }
  std::ranges::reverse(rung);
  return rung;
}

bool CallInputs::isLevel(const Instruction& call, const Operand& bit) const {
  if (bit.kind != OperandKind::Direct || bit.width != Width::Bit) return false;
  if (const Instruction* coil = coilBefore(call, bit)) return isLevelRung(*coil, 0);
  return isLevelBit(bit, facts_.blockOf(call.id), 0);
}

/// No edge, and every contact a level.
bool CallInputs::isLevelRung(const Instruction& output, int depth) const {
  const auto rung = rungOf(output);
  if (rung.empty() || depth > mostDepth) return false;
  return std::ranges::all_of(rung, [&](const Instruction* element) {
    const Role role = roleOf(*element);
    if (isEdge(role) || role == Role::Not) return false;
    if (!isContact(role)) return true;
    if (element->desc->execution == Execution::Compare) return true;
    if (element->operands.empty() || isSameBit(element->operands[0], output.operands[0])) return true;
    return element->desc->negated || isLevelBit(element->operands[0], facts_.blockOf(output.id), depth + 1);
  });
}

bool CallInputs::isLevelBit(const Operand& bit, std::uint32_t block, int depth) const {
  if (bit.kind != OperandKind::Direct || depth > mostDepth) return false;
  if (isSteady(bit) || bit.area == Area::I) return true;
  if ((conditionOf(bit, false, pulses_) & (condition::Pulse | condition::FirstScan | condition::Never)) != 0)
    return false;
  if (hasBitAndWord(bit.area)) return bit.area == Area::T && !facts_.timerBoxes(bit.offset).empty();
  if (bit.area == Area::SM || bit.area == Area::L) return false;
  const std::uint32_t cell = facts_.index().cells().cell(bit.area, bit.offset, block);
  if (cell == facts_.index().cells().size() || bit.bit > 7 || facts_.index().isWrittenAtLarge(cell)) return false;
  const Instruction *coil = nullptr, *set = nullptr, *reset = nullptr;
  for (const std::uint32_t i : facts_.index().at(cell)) {
    const Access& access = facts_.access(i);
    if (!access.write) continue;
    const Instruction& writer = facts_.instruction(access.instruction);
    const bool isBit = access.width == Width::Bit;
    if (isBit && (bit.bit < access.bit || bit.bit >= access.bit + access.count)) continue;
    if (!isBit || access.maybe) return false;
    if (isCoil(roleOf(writer))) {
      if (coil != nullptr) return false;
      coil = &writer;
    } else if (isSet(roleOf(writer))) {
      set = &writer;
    } else if (isReset(roleOf(writer))) {
      // A reset that runs in every scan, or in the network that sets it, makes it a pulse.
      if ((facts_.stack().at(writer.id).flow & condition::Always) != 0) return false;
      reset = &writer;
    } else {
      return false;
    }
  }
  if (coil != nullptr) return set == nullptr && isLevelRung(*coil, depth);
  if (set == nullptr || reset == nullptr) return false;
  // What a reset that asks the bit itself takes back at once is a pulse.
  const auto rung = rungOf(*reset);
  return std::ranges::none_of(rung, [&](const Instruction* contact) {
    return !contact->operands.empty() && isSameBit(contact->operands[0], bit);
  });
}

std::string CallInputs::source(const Instruction& call, const Operand& bit) const {
  const Instruction* coil = coilBefore(call, bit);
  if (coil == nullptr) return toString(bit);
  std::string text;
  for (const Instruction* element : rungOf(*coil)) text += (text.empty() ? "" : "; ") + Facts::text(*element);
  return text;
}

}  // namespace rungproof
